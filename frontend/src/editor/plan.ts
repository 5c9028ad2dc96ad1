/** What an action would do, as a value: the store carries it out, stages it or tells why it cannot be. */
import type { Change } from "./document";
import type { ElementKey } from "./elements";
import type { Selection } from "./state";
import type { Declaration } from "./wire";

export interface Plan {
  readonly note: string;
  readonly changes: readonly Change[];
  /** All declarations afterwards; left out: those that were. */
  readonly declarations?: readonly Declaration[];
  /** What is selected afterwards; left out: what was. */
  readonly select?: Selection | null;
}

export interface Refusal {
  readonly refused: string;
}

export type Planned = Plan | Refusal;

export function isRefusal(planned: Planned): planned is Refusal {
  return "refused" in planned;
}

export function refuse(reason: string): Refusal {
  return { refused: reason };
}

/** "lane 12", "crossing 7". */
export function nameOf(key: ElementKey): string {
  return `${key.kind === "lane_segment" ? "lane" : "crossing"} ${key.id}`;
}

export function selectionOf(key: ElementKey): Selection {
  return { kind: key.kind, id: key.id, side: null, vertex: null };
}

export const GONE = "That element is not in the map any more.";
