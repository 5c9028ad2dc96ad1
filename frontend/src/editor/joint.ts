/** Where a lane is cut: one corner on each boundary, and the lines that come out. */
import type { MapDocument } from "./document";
import type { Lane, Line, Place, Point, Side } from "./elements";
import { boundary, drawn, rounded, samePlace } from "./lines";
import { centreline, distance, lengthOf, nearestOnLine } from "./polyline";
import { occurrencesAt } from "./topology";

export interface Joint {
  readonly left: Point;
  readonly right: Point;
}

/** No part is shorter on either side. */
export const SHORTEST_PART_METRES = 0.5;
/** Vertices farther than this from the click are never taken for the joint. */
const LONGEST_REACH_METRES = 1;
/** A vertex this near to the joint gives way to it; a joint this near to a line is on it. */
export const SAME_PLACE_METRES = 0.02;

/**
 * The joint nearest to a place: square across the lane, on a vertex where one is within reach (of others' ends first,
 * so that lanes side by side are cut alike). Null: too near to the lane's ends.
 */
export function jointAt(document: MapDocument, lane: Lane, place: Place, reach: number): Joint | null {
  const middle = centreline(lane.left_lane_boundary, lane.right_lane_boundary, 50);
  const here = nearestOnLine(place, middle).place;
  const left = cornerAt(document, lane, "left", here, Math.min(reach, LONGEST_REACH_METRES));
  const right = cornerAt(document, lane, "right", here, Math.min(reach, LONGEST_REACH_METRES));
  return left === null || right === null ? null : { left, right };
}

function cornerAt(document: MapDocument, lane: Lane, side: Side, place: Place, reach: number): Point | null {
  const line = boundary(lane, side);
  const nearest = nearestOnLine(place, line).place;
  const total = lengthOf(line);
  const inside = (point: Place) => {
    const station = stationOf(line, point);
    return station >= SHORTEST_PART_METRES && station <= total - SHORTEST_PART_METRES;
  };
  const candidates = [
    ...line.map((point) => ({ point, rank: endsHere(document, lane, point) ? 0 : 1 })),
    ...[...endsAlong(document, lane, line)].map((point) => ({ point, rank: 0 })),
  ].filter(({ point }) => distance(point, nearest) <= reach && inside(point));
  candidates.sort((a, b) => a.rank - b.rank || distance(a.point, nearest) - distance(b.point, nearest));
  const point = candidates[0]?.point ?? drawn(rounded(nearest));
  return inside(point) ? point : null;
}

function endsHere(document: MapDocument, lane: Lane, vertex: Place): boolean {
  return occurrencesAt(document, vertex).some(({ lane: id, where }) => id !== lane.id && where !== "inside");
}

/** Ends of other lanes that lie on the line. */
function* endsAlong(document: MapDocument, lane: Lane, line: Line): Generator<Point> {
  for (const other of document.lanes.values()) {
    if (other.id === lane.id) continue;
    for (const points of [other.left_lane_boundary, other.right_lane_boundary]) {
      for (const end of [points.at(0), points.at(-1)]) {
        if (end !== undefined && nearestOnLine(end, line).distance <= SAME_PLACE_METRES) yield end;
      }
    }
  }
}

/** Metres along the line to the place on it that is nearest. */
export function stationOf(line: readonly Place[], place: Place): number {
  const { segment, place: foot } = nearestOnLine(place, line);
  const from = line[segment];
  return lengthOf(line.slice(0, segment + 1)) + (from === undefined ? 0 : distance(from, foot));
}

/** The line up to a corner on it, and from there on. */
export function cutLine(line: Line, corner: Point): readonly [Line, Line] {
  const at = stationOf(line, corner);
  const before: Point[] = [];
  const after: Point[] = [];
  let station = 0;
  line.forEach((point, index) => {
    const previous = line[index - 1];
    if (previous !== undefined) station += distance(previous, point);
    if (samePlace(point, corner) || distance(point, corner) <= SAME_PLACE_METRES) return;
    (station < at ? before : after).push(point);
  });
  return [
    [...before, corner],
    [corner, ...after],
  ];
}

/** The lane's two boundaries cut at the joint: what lies before it, and what after. */
export function cutLane(lane: Lane, joint: Joint): readonly [Lane, Lane] {
  const [leftBefore, leftAfter] = cutLine(lane.left_lane_boundary, joint.left);
  const [rightBefore, rightAfter] = cutLine(lane.right_lane_boundary, joint.right);
  return [
    { ...lane, left_lane_boundary: leftBefore, right_lane_boundary: rightBefore },
    { ...lane, left_lane_boundary: leftAfter, right_lane_boundary: rightAfter },
  ];
}
