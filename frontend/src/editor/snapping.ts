/** Where a dragged or drawn place catches: vertices first, then lines, of elements that do not move themselves. */
import type { MapDocument } from "./document";
import type { Lane, Place } from "./elements";
import { nearestLaneEnd } from "./laneEnds";
import { boundary } from "./lines";
import { type Box, boxOf, inBox } from "./polygon";
import { distance, nearestOnLine } from "./polyline";

export interface Catch {
  readonly place: Place;
  readonly kind: "vertex" | "line" | "lane_end";
  readonly lane: number;
}

const SIDES = ["left", "right"] as const;
const boxes = new WeakMap<Lane, Box>();

export function laneBox(lane: Lane): Box {
  const known = boxes.get(lane);
  if (known !== undefined) return known;
  const box = boxOf([...lane.left_lane_boundary, ...lane.right_lane_boundary]);
  boxes.set(lane, box);
  return box;
}

/** The nearest vertex within the radius, else the nearest line; null when nothing is near. */
export function snap(
  document: MapDocument,
  place: Place,
  radius: number,
  moving: ReadonlySet<number> = new Set(),
): Catch | null {
  let vertex: Catch | null = null;
  let line: Catch | null = null;
  let [vertexFar, lineFar] = [radius, radius];
  for (const lane of document.lanes.values()) {
    if (moving.has(lane.id) || !inBox(laneBox(lane), place, radius)) continue;
    for (const side of SIDES) {
      const points = boundary(lane, side);
      for (const point of points) {
        const far = distance(point, place);
        if (far <= vertexFar)
          [vertexFar, vertex] = [far, { place: { x: point.x, y: point.y }, kind: "vertex", lane: lane.id }];
      }
      const near = nearestOnLine(place, points);
      if (near.distance <= lineFar)
        [lineFar, line] = [near.distance, { place: near.place, kind: "line", lane: lane.id }];
    }
  }
  return vertex ?? line;
}

/** The middle of a lane's end that a drawn lane can join: ends for its start, starts for what follows. */
export function snapToLaneEnd(
  document: MapDocument,
  place: Place,
  radius: number,
  first: boolean,
): Catch | null {
  const found = nearestLaneEnd(document, place, first ? "end" : "start", radius);
  const lane = found?.lanes[0];
  return found === null || lane === undefined ? null : { place: found.middle, kind: "lane_end", lane };
}
