/** Links and neighbour ids: what one lane says of another. */
import type { Lane } from "../elements";
import { neighborOf, withNeighbor } from "../lines";
import type { Workpiece } from "../workpiece";

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

/** Takes a lane out, and every mention of it, so that nothing dangles. */
export function removeLane(work: Workpiece, id: number): void {
  work.remove({ kind: "lane_segment", id });
  for (const lane of work.document.lanes.values()) {
    const without = withoutMention(lane, id);
    if (without !== lane) work.putLane(without);
  }
}
