/** Reading and replacing the lines and marks of elements by name. */
import type { Crossing, Lane, Line, LineName, MapElement, Mark, Place, Point, Side } from "./elements";

export function boundary(lane: Lane, side: Side): Line {
  return side === "left" ? lane.left_lane_boundary : lane.right_lane_boundary;
}

export function withBoundary(lane: Lane, side: Side, line: Line): Lane {
  return side === "left" ? { ...lane, left_lane_boundary: line } : { ...lane, right_lane_boundary: line };
}

export function markOf(lane: Lane, side: Side): Mark {
  return side === "left" ? lane.left_lane_mark_type : lane.right_lane_mark_type;
}

export function withMark(lane: Lane, side: Side, mark: Mark): Lane {
  return side === "left" ? { ...lane, left_lane_mark_type: mark } : { ...lane, right_lane_mark_type: mark };
}

export function neighborOf(lane: Lane, side: Side): number | null {
  return side === "left" ? lane.left_neighbor_id : lane.right_neighbor_id;
}

export function withNeighbor(lane: Lane, side: Side, id: number | null): Lane {
  return side === "left" ? { ...lane, left_neighbor_id: id } : { ...lane, right_neighbor_id: id };
}

/** A line of an element by name; null when that kind has no such line. */
export function lineOf(element: MapElement, name: LineName): Line | null {
  if (element.kind === "lane_segment") {
    if (name === "left" || name === "right") return boundary(element.attributes, name);
    return null;
  }
  if (name === "edge1" || name === "edge2") return element.attributes[name];
  return null;
}

export function lineNames(kind: MapElement["kind"]): readonly LineName[] {
  return kind === "lane_segment" ? ["left", "right"] : ["edge1", "edge2"];
}

/** The ring of an element's area, not closed. */
export function ringOf(element: MapElement): Place[] {
  return element.kind === "lane_segment" ? laneRing(element.attributes) : crossingRing(element.attributes);
}

export function laneRing(lane: Lane): Place[] {
  return [...lane.right_lane_boundary, ...lane.left_lane_boundary.toReversed()];
}

/** Edges are undirected: they are joined the way round that does not cross. */
export function crossingRing(crossing: Crossing): Place[] {
  const [a, b] = crossing.edge1;
  const [c, d] = crossing.edge2;
  if (a === undefined || b === undefined || c === undefined || d === undefined) return [];
  const along = (b.x - a.x) * (d.x - c.x) + (b.y - a.y) * (d.y - c.y);
  return along >= 0 ? [a, b, d, c] : [a, b, c, d];
}

export function samePlace(a: Place | undefined, b: Place | undefined): boolean {
  return a !== undefined && b !== undefined && a.x === b.x && a.y === b.y;
}

/** Bit-equal in x and y, vertex by vertex. */
export function sameLine(a: Line, b: Line): boolean {
  return a.length === b.length && a.every((point, index) => samePlace(point, b[index]));
}

/** Bit-equal in x and y, read backwards. */
export function sameLineReversed(a: Line, b: Line): boolean {
  const last = b.length - 1;
  return a.length === b.length && a.every((point, index) => samePlace(point, b[last - index]));
}

/** A drawn coordinate: rounded to the centimetre. */
export function rounded(place: Place): Place {
  return { x: Math.round(place.x * 100) / 100, y: Math.round(place.y * 100) / 100 };
}

/** A vertex whose height is not known yet. */
export function drawn(place: Place): Point {
  return { x: place.x, y: place.y, z: null };
}

/** A drawn line: rounded to the centimetre, without the repeated vertices that rounding may bring. */
export function drawnLine(places: readonly Place[]): Point[] {
  const line: Point[] = [];
  for (const place of places) {
    const point = drawn(rounded(place));
    if (!samePlace(point, line.at(-1))) line.push(point);
  }
  return line;
}

export function hasRepeatedVertex(line: Line): boolean {
  return line.some((point, index) => index > 0 && samePlace(point, line[index - 1]));
}
