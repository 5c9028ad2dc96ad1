/** Links and neighbour ids: what one lane says of another. */
import type { MapDocument } from "../document";
import type { Lane } from "../elements";
import { laneEnd, lanesAt } from "../laneEnds";
import { neighborOf, samePlace, withNeighbor } from "../lines";
import type { Planned } from "../plan";
import { linkedLanes, type Occurrence } from "../topology";
import { Workpiece } from "../workpiece";

/** The lane without any mention of another; the same object when it had none. */
export function withoutMention(lane: Lane, id: number): Lane {
  let result = lane;
  if (lane.successors.includes(id)) {
    result = { ...result, successors: result.successors.filter((other) => other !== id) };
  }
  if (lane.predecessors.includes(id)) {
    result = { ...result, predecessors: result.predecessors.filter((other) => other !== id) };
  }
  for (const side of ["left", "right"] as const) {
    if (neighborOf(result, side) === id) result = withNeighbor(result, side, null);
  }
  return result;
}

/** Links two lanes end to start, written on both. */
export function joinLanes(work: Workpiece, from: number, to: number): void {
  const before = work.lane(from);
  if (before !== null && !before.successors.includes(to)) {
    work.putLane({ ...before, successors: [...before.successors, to] });
  }
  const after = work.lane(to);
  if (after !== null && !after.predecessors.includes(from)) {
    work.putLane({ ...after, predecessors: [...after.predecessors, from] });
  }
}

/** Takes the link from one lane to another out, on both. */
export function planUnlink(document: MapDocument, from: number, to: number): Planned {
  const work = new Workpiece(document);
  const before = work.lane(from);
  if (before !== null) {
    work.putLane({ ...before, successors: before.successors.filter((id) => id !== to) });
  }
  const after = work.lane(to);
  if (after !== null) {
    work.putLane({ ...after, predecessors: after.predecessors.filter((id) => id !== from) });
  }
  return { note: `Lane ${from} no longer leads to lane ${to}`, changes: work.changes() };
}

/** Links lanes of which an end has just come to lie exactly on the facing end of others; returns what it linked. */
export function linkMetEnds(work: Workpiece, moved: Iterable<Pick<Occurrence, "lane" | "where">>): string[] {
  const told: string[] = [];
  for (const { lane: id, where } of moved) {
    const lane = work.lane(id);
    const was = work.start.lanes.get(id);
    if (lane === null || was === undefined || where === "inside") continue;
    const here = laneEnd(lane, where);
    const before = laneEnd(was, where);
    const facing = where === "start" ? "end" : "start";
    for (const other of lanesAt(work.document, facing, here.left, here.right)) {
      const there = work.start.lanes.get(other);
      const met = there && samePlace(laneEnd(there, facing).left, before.left);
      if (other === id || (met && samePlace(laneEnd(there, facing).right, before.right))) continue;
      const [from, to] = where === "start" ? [other, id] : [id, other];
      if (linkedLanes(work.document, from, "after").has(to)) continue;
      joinLanes(work, from, to);
      told.push(`lane ${from} leads to lane ${to}`);
    }
  }
  return told;
}

/** Takes a lane out, and every mention of it, so that nothing dangles. */
export function removeLane(work: Workpiece, id: number): void {
  work.remove({ kind: "lane_segment", id });
  for (const lane of work.document.lanes.values()) {
    const without = withoutMention(lane, id);
    if (without !== lane) work.putLane(without);
  }
}
