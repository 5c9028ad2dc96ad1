/** The ends of lanes: where a drawn or neighbouring lane can be joined exactly. */
import type { MapDocument } from "./document";
import type { Lane, Place, Point } from "./elements";
import { at, distance, middle, unit } from "./polyline";

export type End = "start" | "end";

export interface LaneEnd {
  readonly lanes: readonly number[];
  readonly end: End;
  readonly left: Point;
  readonly right: Point;
  readonly middle: Place;
  /** Driving direction there, as a unit vector. */
  readonly direction: Place;
}

export function laneEnd(lane: Lane, end: End): LaneEnd {
  const index = end === "start" ? 0 : -1;
  const left = at(lane.left_lane_boundary, index);
  const right = at(lane.right_lane_boundary, index);
  const [one, other] = end === "start" ? [0, 1] : [-2, -1];
  const from = middle(at(lane.left_lane_boundary, one), at(lane.right_lane_boundary, one));
  const to = middle(at(lane.left_lane_boundary, other), at(lane.right_lane_boundary, other));
  return { lanes: [lane.id], end, left, right, middle: middle(left, right), direction: unit(from, to) };
}

/** The nearest lane end within a radius of its middle, with all lanes that end (start) on exactly these corners. */
export function nearestLaneEnd(
  document: MapDocument,
  place: Place,
  end: End,
  radius: number,
  wanted: (candidate: LaneEnd) => boolean = () => true,
): LaneEnd | null {
  let best: LaneEnd | null = null;
  for (const lane of document.lanes.values()) {
    const candidate = laneEnd(lane, end);
    const far = distance(candidate.middle, place);
    if (far <= radius && (best === null || far < distance(best.middle, place)) && wanted(candidate))
      best = candidate;
  }
  if (best === null) return null;
  return { ...best, lanes: lanesAt(document, end, best.left, best.right) };
}

/** Lanes whose end (start) lies bit-exactly on two corners. */
export function lanesAt(document: MapDocument, end: End, left: Place, right: Place): number[] {
  const found: number[] = [];
  for (const lane of document.lanes.values()) {
    const here = laneEnd(lane, end);
    if (here.left.x !== left.x || here.left.y !== left.y) continue;
    if (here.right.x === right.x && here.right.y === right.y) found.push(lane.id);
  }
  return found;
}
