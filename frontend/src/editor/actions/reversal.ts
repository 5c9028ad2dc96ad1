/** Turning round a lane that was drawn the wrong way. */
import type { MapDocument } from "../document";
import { GONE, type Planned, refuse } from "../plan";
import { planOf } from "../planOf";
import { Workpiece } from "../workpiece";
import { linkEnds } from "./insertion";
import { removeLane } from "./links";
import { findNeighbors } from "./series";

/** Each side keeps its paint on the ground; links and neighbours are those that fit the new direction. */
export function planReversal(base: MapDocument, document: MapDocument, id: number): Planned {
  const lane = document.lanes.get(id);
  if (lane === undefined) return refuse(GONE);
  if (base.lanes.has(id) || lane.part_of !== null) {
    return refuse(
      "An imported lane keeps its direction. Where a street turned round, delete it and draw it anew.",
    );
  }
  const work = new Workpiece(document);
  removeLane(work, id);
  work.putLane({
    ...lane,
    left_lane_boundary: lane.right_lane_boundary.toReversed(),
    left_lane_mark_type: lane.right_lane_mark_type,
    right_lane_boundary: lane.left_lane_boundary.toReversed(),
    right_lane_mark_type: lane.left_lane_mark_type,
    successors: [],
    predecessors: [],
    left_neighbor_id: null,
    right_neighbor_id: null,
  });
  const turned = work.lane(id);
  if (turned !== null) linkEnds(work, turned);
  findNeighbors(work, id);
  return planOf(work, `Turned lane ${id} round`);
}
