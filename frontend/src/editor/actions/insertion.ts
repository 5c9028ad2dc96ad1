/** New elements: a lane beside another, a lane along a drawn centre line, a crossing. */
import type { MapDocument } from "../document";
import type { Lane, Line, Place, Point, Side } from "../elements";
import { type End, laneEnd, lanesAt, nearestLaneEnd } from "../laneEnds";
import { boundary, drawn, drawnLine, markOf, neighborOf, rounded, samePlace, withNeighbor } from "../lines";
import { mirrored } from "../marks";
import { offsetLine } from "../offset";
import { GONE, type Planned, refuse, selectionOf } from "../plan";
import { planOf } from "../planOf";
import { at, distance, lengthOf, turnedLeft, unit } from "../polyline";
import { smoothLine } from "../spline";
import type { DrawLaneOptions } from "../state";
import { linkedLanes, sharersOf } from "../topology";
import { Workpiece } from "../workpiece";
import { joinLanes } from "./links";

export const LANE_WIDTH_METRES = 3.5;
export const CROSSING_WIDTH_METRES = 3;
/** A new corner this near to that of the lane ahead or behind is put onto it. */
const CORNER_REACH_METRES = 2;
/** A drawn end counts as lying on a lane's end up to here. */
const JOINT_TOLERANCE_METRES = 0.02;

export function planLaneBeside(
  document: MapDocument,
  id: number,
  side: Side,
  newId: number,
  width = LANE_WIDTH_METRES,
): Planned {
  const lane = document.lanes.get(id);
  if (lane === undefined) return refuse(GONE);
  const taken = sharersOf(document, lane, side).find(({ across }) => across);
  if (taken !== undefined) {
    return refuse(
      `Lane ${taken.lane} already lies on the ${side} of lane ${id}. Choose a side that is free.`,
    );
  }
  const inner = boundary(lane, side);
  const sign = side === "left" ? 1 : -1;
  const outward = { start: endDirection(lane, side, "start"), end: endDirection(lane, side, "end") };
  const raw = offsetLine(inner, () => sign * width, outward);
  const outer: Point[] = drawnLine(raw);
  if (outer.length < 2) return refuse("There is no room for a lane on that side: the bend is too tight.");
  const first = cornerNear(document, "end", at(inner, 0), at(outer, 0), side);
  const last = cornerNear(document, "start", at(inner, -1), at(outer, -1), side);
  if (first !== null) outer[0] = first;
  if (last !== null) outer[outer.length - 1] = last;

  const paint = markOf(lane, side);
  const added: Lane = {
    id: newId,
    is_intersection: lane.is_intersection,
    lane_type: lane.lane_type,
    left_lane_boundary: side === "left" ? outer : inner,
    left_lane_mark_type: side === "left" ? paint : mirrored(paint),
    right_lane_boundary: side === "left" ? inner : outer,
    right_lane_mark_type: side === "left" ? mirrored(paint) : paint,
    successors: [],
    predecessors: [],
    left_neighbor_id: side === "left" ? null : id,
    right_neighbor_id: side === "left" ? id : null,
    part_of: null,
  };
  const work = new Workpiece(document);
  const former = neighborOf(lane, side);
  const formerLane = former === null ? null : work.lane(former);
  for (const back of ["left", "right"] as const) {
    if (formerLane !== null && neighborOf(formerLane, back) === id)
      work.putLane(withNeighbor(formerLane, back, null));
  }
  work.putLane(withNeighbor(lane, side, newId), added);
  linkEnds(work, added);
  return inserted(work, newId, `Inserted lane ${newId} ${side} of lane ${id}`);
}

/** Outward along the lane's end line, unless that is far from square. */
function endDirection(lane: Lane, side: Side, end: End): Place | null {
  const { left, right, direction } = laneEnd(lane, end);
  const outward = side === "left" ? unit(right, left) : unit(left, right);
  const square = turnedLeft(direction);
  const sign = side === "left" ? 1 : -1;
  return sign * (outward.x * square.x + outward.y * square.y) > Math.SQRT1_2 ? outward : null;
}

/** The outer corner of the lane that meets the new one at its inner corner, if the new outer corner is near it. */
function cornerNear(document: MapDocument, end: End, inner: Place, outer: Place, side: Side): Point | null {
  let best: Point | null = null;
  for (const lane of document.lanes.values()) {
    const there = laneEnd(lane, end);
    const [innerCorner, outerCorner] =
      side === "left" ? [there.right, there.left] : [there.left, there.right];
    if (!samePlace(innerCorner, inner)) continue;
    const far = distance(outerCorner, outer);
    if (far <= CORNER_REACH_METRES && (best === null || far < distance(best, outer))) best = outerCorner;
  }
  return best;
}

/** Links a new lane to all lanes that end or start on exactly its corners. */
export function linkEnds(work: Workpiece, lane: Lane): void {
  const start = laneEnd(lane, "start");
  const end = laneEnd(lane, "end");
  for (const from of lanesAt(work.document, "end", start.left, start.right)) joinLanes(work, from, lane.id);
  for (const to of lanesAt(work.document, "start", end.left, end.right)) joinLanes(work, lane.id, to);
}

export function planDrawnLane(
  document: MapDocument,
  clicks: readonly Place[],
  newId: number,
  options: DrawLaneOptions = {},
): Planned {
  const width = options.width ?? LANE_WIDTH_METRES;
  const places = clicks.filter((place, index) => index === 0 || distance(place, at(clicks, index - 1)) > 0.1);
  if (places.length < 2) return refuse("A lane needs at least two places.");
  const start = nearestLaneEnd(document, at(places, 0), "end", JOINT_TOLERANCE_METRES);
  const end = nearestLaneEnd(document, at(places, -1), "start", JOINT_TOLERANCE_METRES);
  const line = smoothLine(places, start?.direction ?? null, end?.direction ?? null);
  const widthAt = widthsAlong(line, {
    start: start === null ? width : distance(start.left, start.right),
    end: end === null ? width : distance(end.left, end.right),
  });
  const side = (sign: 1 | -1, first: Point | undefined, last: Point | undefined): Line => {
    const offset = drawnLine(offsetLine(line, (index) => (sign * widthAt(index)) / 2));
    if (first !== undefined) offset[0] = first;
    if (last !== undefined) offset[offset.length - 1] = last;
    return offset.filter((point, index) => index === 0 || !samePlace(point, offset[index - 1]));
  };
  const left = side(1, start?.left, end?.left);
  const right = side(-1, start?.right, end?.right);
  if (left.length < 2 || right.length < 2) return refuse("The lane is too short for its width.");
  const work = new Workpiece(document);
  const added: Lane = {
    id: newId,
    is_intersection: joinsIntersection(document, start?.lanes ?? [], end?.lanes ?? []),
    lane_type:
      options.laneType ?? document.lanes.get(start?.lanes[0] ?? end?.lanes[0] ?? -1)?.lane_type ?? "VEHICLE",
    left_lane_boundary: left,
    left_lane_mark_type: "NONE",
    right_lane_boundary: right,
    right_lane_mark_type: "NONE",
    successors: [],
    predecessors: [],
    left_neighbor_id: null,
    right_neighbor_id: null,
    part_of: null,
  };
  work.putLane(added);
  linkEnds(work, added);
  return inserted(work, newId, `Drew lane ${newId}`);
}

/** Width at each vertex, from one end's to the other's along the length. */
function widthsAlong(
  line: readonly Place[],
  ends: { start: number; end: number },
): (index: number) => number {
  const total = lengthOf(line) || 1;
  return (index) => ends.start + ((ends.end - ends.start) * lengthOf(line.slice(0, index + 1))) / total;
}

/** A lane drawn from a junction's entry or to its exit, like the lanes that are there already. */
function joinsIntersection(document: MapDocument, from: readonly number[], to: readonly number[]): boolean {
  const beside = [
    ...from.flatMap((id) => [...linkedLanes(document, id, "after")]),
    ...to.flatMap((id) => [...linkedLanes(document, id, "before")]),
  ];
  return beside.some((id) => document.lanes.get(id)?.is_intersection ?? false);
}

export function planCrossing(
  document: MapDocument,
  from: Place,
  to: Place,
  newId: number,
  width = CROSSING_WIDTH_METRES,
): Planned {
  if (distance(from, to) < 0.5)
    return refuse("A crossing is at least half a metre long: click on both kerbs.");
  const aside = turnedLeft(unit(from, to));
  const edge = (sign: 1 | -1): Line =>
    [from, to].map(({ x, y }) =>
      drawn(rounded({ x: x + (sign * aside.x * width) / 2, y: y + (sign * aside.y * width) / 2 })),
    );
  const work = new Workpiece(document);
  const attributes = { id: newId, edge1: edge(1), edge2: edge(-1) };
  work.put({ kind: "pedestrian_crossing", id: newId, attributes });
  const key = { kind: "pedestrian_crossing", id: newId } as const;
  return planOf(work, `Inserted crossing ${newId}`, selectionOf(key));
}

function inserted(work: Workpiece, id: number, note: string): Planned {
  return planOf(work, note, selectionOf({ kind: "lane_segment", id }));
}
