/** Recorded cuts: a lane of the imported map that is there in parts is compared part by part. */
import type { MapDocument } from "./document";
import type { Lane, Line, Point, Side } from "./elements";
import { cutLane, type Joint, SAME_PLACE_METRES, stationOf } from "./joint";
import { boundary, drawn, rounded } from "./lines";
import { alongLine, at, lengthOf, nearestOnLine } from "./polyline";
import { linkedLanes } from "./topology";

/** The parts of a lane in driving order; empty when they are not one series of two or more. */
export function partsOf(document: MapDocument, whole: number): Lane[] {
  const parts = new Map([...document.lanes].filter(([, lane]) => lane.part_of === whole));
  if (parts.size < 2) return [];
  const follows = (lane: Lane) => [...linkedLanes(document, lane.id, "before")].some((id) => parts.has(id));
  let next = [...parts.values()].find((lane) => !follows(lane));
  const series: Lane[] = [];
  while (next !== undefined && !series.includes(next)) {
    series.push(next);
    const after = [...linkedLanes(document, next.id, "after")].filter((id) => parts.has(id));
    next = after.length === 1 ? parts.get(after[0] ?? -1) : undefined;
  }
  return series.length === parts.size ? series : [];
}

const remembered = new WeakMap<MapDocument["lanes"], { base: MapDocument; cut: MapDocument }>();

/** The imported map, each lane of which the edited map has only the parts cut at the same joints. */
export function baseCutAlike(base: MapDocument, current: MapDocument): MapDocument {
  const known = remembered.get(current.lanes);
  if (known?.base === base) return known.cut;
  const cut = cutAlike(base, current);
  remembered.set(current.lanes, { base, cut });
  return cut;
}

function cutAlike(base: MapDocument, current: MapDocument): MapDocument {
  const wholes = new Set<number>();
  for (const { part_of } of current.lanes.values()) {
    if (part_of !== null && base.lanes.has(part_of) && !current.lanes.has(part_of)) wholes.add(part_of);
  }
  if (wholes.size === 0) return base;
  const lanes = new Map(base.lanes);
  for (const id of wholes) {
    const whole = base.lanes.get(id);
    const parts = partsOf(current, id);
    if (whole === undefined || parts.length === 0) continue;
    lanes.delete(id);
    for (const piece of pieces(whole, parts)) lanes.set(piece.id, piece);
  }
  return { ...base, lanes };
}

/** The whole cut where its parts meet, under the parts' ids. */
function pieces(whole: Lane, parts: readonly Lane[]): Lane[] {
  const joints = jointsOn(whole, parts);
  const cut: Lane[] = [];
  let rest = whole;
  parts.forEach((part, index) => {
    const named = { id: part.id, part_of: whole.id };
    const joint = joints[index];
    if (joint === undefined) {
      cut.push({ ...rest, ...named });
      return;
    }
    const [piece, after] = cutLane(rest, joint);
    cut.push({ ...piece, ...named });
    rest = after;
  });
  return cut;
}

/**
 * Where the parts meet, on the whole's lines: a joint moved off them is compared with the nearest place on them. Joints
 * that do not follow one another there are laid out by the parts' lengths, as the server does.
 */
function jointsOn(whole: Lane, parts: readonly Lane[]): Joint[] {
  const near = nearestJoints(whole, parts);
  const orderly =
    follow(
      whole.left_lane_boundary,
      near.map(({ left }) => left),
    ) &&
    follow(
      whole.right_lane_boundary,
      near.map(({ right }) => right),
    );
  return orderly ? near : sharedOut(whole, parts);
}

function nearestJoints(whole: Lane, parts: readonly Lane[]): Joint[] {
  return parts.slice(0, -1).map((part) => ({
    left: cornerOn(whole.left_lane_boundary, at(part.left_lane_boundary, -1)),
    right: cornerOn(whole.right_lane_boundary, at(part.right_lane_boundary, -1)),
  }));
}

function follow(line: Line, corners: readonly Point[]): boolean {
  const stations = [...corners.map((corner) => stationOf(line, corner)), lengthOf(line)];
  return stations.every((station, index) => station > (stations[index - 1] ?? 0) + SAME_PLACE_METRES);
}

function sharedOut(whole: Lane, parts: readonly Lane[]): Joint[] {
  const corner = (side: Side, count: number) => {
    const total = lengthOf(parts.flatMap((part) => boundary(part, side)));
    const before = lengthOf(parts.slice(0, count).flatMap((part) => boundary(part, side)));
    return drawn(rounded(alongLine(boundary(whole, side), before / total)));
  };
  return parts
    .slice(1)
    .map((_, index) => ({ left: corner("left", index + 1), right: corner("right", index + 1) }));
}

function cornerOn(line: Line, corner: Point): Point {
  const { place, distance } = nearestOnLine(corner, line);
  return distance <= SAME_PLACE_METRES ? corner : drawn(rounded(place));
}
