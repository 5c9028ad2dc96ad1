/** How the app says the wire's values. */
import type { Action, Category, Direction, ElementKind, LaneType, Role, TaskState } from "../../api/types";

export const STATE_WORDS: Record<TaskState, string> = {
  draft: "draft",
  submitted: "submitted",
  in_review: "in review",
  changes_requested: "changes requested",
  accepted: "accepted",
};

export const DIRECTION_WORDS: Record<Direction, string> = {
  prior_to_current: "prior → current",
  current_to_prior: "current → prior",
};

export const CATEGORY_WORDS: Record<Category, string> = {
  insertion: "insertion",
  deletion: "deletion",
  geometry: "geometry",
  marking: "marking",
  type: "type",
  connectivity: "connectivity",
};

/** In the order of the legend and of every change bar. */
export const CATEGORIES = Object.keys(CATEGORY_WORDS) as Category[];
/** Connectivity alone does not count as a change. */
export const COUNTED_CATEGORIES = CATEGORIES.filter((category) => category !== "connectivity");

/** What somebody did with a task. */
export const ACTION_WORDS: Record<Action | "create", string> = {
  create: "created the task",
  submit: "submitted",
  start_review: "started the review",
  accept: "accepted",
  send_back: "sent back",
  reopen: "reopened",
};

export const ROLE_WORDS: Record<Role, string> = {
  annotator: "annotator",
  reviewer: "reviewer",
  admin: "admin",
};

export const KIND_WORDS: Record<ElementKind, string> = {
  lane_segment: "Lane",
  pedestrian_crossing: "Crossing",
};

export const LANE_TYPE_WORDS: Record<LaneType, string> = { VEHICLE: "Vehicle", BIKE: "Bike", BUS: "Bus" };

/** "1 change", "3 changes". */
export function counted(count: number, noun: string, plural = `${noun}s`): string {
  return `${count} ${count === 1 ? noun : plural}`;
}

const LONGEST_LOG_NAME = 22;

/** A UUID by its first block; other names without TbV's season, and cut where they are long. */
export function shortLogName(logId: string): string {
  if (/^[0-9a-f]{8}-[0-9a-f]{4}-/i.test(logId)) return logId.slice(0, 8);
  const [name = logId] = logId.split("__");
  return name.length <= LONGEST_LOG_NAME ? name : `${name.slice(0, LONGEST_LOG_NAME - 2)}…`;
}

const MINUTE = 60;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;

/** "2 s", "5 min", "3 h", "4 d": how long something took or is ago. */
export function duration(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds));
  if (whole < MINUTE) return `${whole} s`;
  if (whole < HOUR) return `${Math.floor(whole / MINUTE)} min`;
  if (whole < 2 * DAY) return `${Math.floor(whole / HOUR)} h`;
  return `${Math.floor(whole / DAY)} d`;
}

/** "just now", "5 min ago". */
export function ago(instant: string | number, now: number): string {
  const seconds = (now - new Date(instant).getTime()) / 1000;
  return seconds < 5 ? "just now" : `${duration(seconds)} ago`;
}

/** "2026-11-22": the day of an instant, the same in every country. */
export function day(instant: string): string {
  return new Date(instant).toLocaleDateString("en-CA");
}
