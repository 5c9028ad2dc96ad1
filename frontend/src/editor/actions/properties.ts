/** Marks, types, and taking elements out. */
import { elementOf, type MapDocument } from "../document";
import type { ElementKey, Lane, LaneType, Mark, Side } from "../elements";
import { markOf, withMark } from "../lines";
import { markWords, mirrored } from "../marks";
import { GONE, nameOf, type Planned, refuse } from "../plan";
import { sharersOf } from "../topology";
import { Workpiece } from "../workpiece";
import { removeLane } from "./links";

export function planMark(document: MapDocument, id: number, side: Side, mark: Mark): Planned {
  const lane = document.lanes.get(id);
  if (lane === undefined) return refuse(GONE);
  const work = new Workpiece(document);
  paint(work, lane, side, mark);
  return { note: `Painted the ${side} of lane ${id}: ${markWords(mark)}`, changes: work.changes() };
}

/** Repaints a boundary in every lane that holds it; lanes across it read mixed paint mirrored. */
export function paint(work: Workpiece, lane: Lane, side: Side, mark: Mark): void {
  for (const sharer of sharersOf(work.document, lane, side)) {
    const other = work.lane(sharer.lane);
    const seen = sharer.across ? mirrored(mark) : mark;
    if (other !== null && markOf(other, sharer.side) !== seen)
      work.putLane(withMark(other, sharer.side, seen));
  }
  const own = work.lane(lane.id);
  if (own !== null && markOf(own, side) !== mark) work.putLane(withMark(own, side, mark));
}

export function planLaneType(document: MapDocument, id: number, laneType: LaneType): Planned {
  const lane = document.lanes.get(id);
  if (lane === undefined) return refuse(GONE);
  const work = new Workpiece(document);
  if (lane.lane_type !== laneType) work.putLane({ ...lane, lane_type: laneType });
  return { note: `Made lane ${id} a ${laneType.toLowerCase()} lane`, changes: work.changes() };
}

export function planIntersection(document: MapDocument, id: number, isIntersection: boolean): Planned {
  const lane = document.lanes.get(id);
  if (lane === undefined) return refuse(GONE);
  const work = new Workpiece(document);
  if (lane.is_intersection !== isIntersection) work.putLane({ ...lane, is_intersection: isIntersection });
  const note = isIntersection ? `Lane ${id} is in an intersection` : `Lane ${id} is in no intersection`;
  return { note, changes: work.changes() };
}

export function planDeletion(document: MapDocument, key: ElementKey): Planned {
  if (elementOf(document, key) === null) return refuse(GONE);
  const work = new Workpiece(document);
  if (key.kind === "lane_segment") removeLane(work, key.id);
  else work.remove(key);
  return { note: `Deleted ${nameOf(key)}`, changes: work.changes(), select: null };
}
