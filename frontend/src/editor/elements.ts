/**
 * Map elements of one driving log under AV2's own attribute names, in the city frame (metres, x grid east, y grid
 * north). All values are immutable; an element that no edit touched stays the very object that was received, so
 * identity tells "unchanged" and digits stay bit-exact.
 */

/** A vertex. `z` null: not known yet (a new or moved vertex); the server takes it from the ground. */
export interface Point {
  readonly x: number;
  readonly y: number;
  readonly z: number | null;
}

/** A place in the plane, city metres. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

export type Line = readonly Point[];
export type ElementKind = "lane_segment" | "pedestrian_crossing";
export type LaneType = "VEHICLE" | "BIKE" | "BUS";
export type Side = "left" | "right";
export type CrossingEdge = "edge1" | "edge2";
/** A line of an element: a lane's boundary or a crossing's edge. */
export type LineName = Side | CrossingEdge;

export type Mark =
  | "DASH_SOLID_YELLOW"
  | "DASH_SOLID_WHITE"
  | "DASHED_WHITE"
  | "DASHED_YELLOW"
  | "DOUBLE_SOLID_YELLOW"
  | "DOUBLE_SOLID_WHITE"
  | "DOUBLE_DASH_YELLOW"
  | "DOUBLE_DASH_WHITE"
  | "SOLID_YELLOW"
  | "SOLID_WHITE"
  | "SOLID_DASH_WHITE"
  | "SOLID_DASH_YELLOW"
  | "SOLID_BLUE"
  | "NONE"
  | "UNKNOWN";

/** A lane segment; both boundaries run in driving direction. Links may name ids outside the map (the rim). */
export interface Lane {
  readonly id: number;
  readonly is_intersection: boolean;
  readonly lane_type: LaneType;
  readonly left_lane_boundary: Line;
  readonly left_lane_mark_type: Mark;
  readonly right_lane_boundary: Line;
  readonly right_lane_mark_type: Mark;
  readonly successors: readonly number[];
  readonly predecessors: readonly number[];
  readonly right_neighbor_id: number | null;
  readonly left_neighbor_id: number | null;
  /** The imported lane of which a cut made this a part; null: no part. */
  readonly part_of: number | null;
}

/** A pedestrian crossing: two edges of two points along the walking direction. */
export interface Crossing {
  readonly id: number;
  readonly edge1: Line;
  readonly edge2: Line;
}

export interface LaneElement {
  readonly kind: "lane_segment";
  readonly id: number;
  readonly attributes: Lane;
}
export interface CrossingElement {
  readonly kind: "pedestrian_crossing";
  readonly id: number;
  readonly attributes: Crossing;
}
export type MapElement = LaneElement | CrossingElement;

/** Ids are unique within a kind only. */
export interface ElementKey {
  readonly kind: ElementKind;
  readonly id: number;
}

/** `lane_segment:123`: an element key as text, for maps, sets and URLs. */
export type KeyText = `${ElementKind}:${number}`;

export function keyText(key: ElementKey): KeyText {
  return `${key.kind}:${key.id}`;
}

/** The key that a text names, or null. */
export function parseKey(text: string): ElementKey | null {
  const match = /^(lane_segment|pedestrian_crossing):(\d+)$/.exec(text);
  if (match === null) return null;
  return { kind: match[1] as ElementKind, id: Number(match[2]) };
}

export function isSide(line: LineName): line is Side {
  return line === "left" || line === "right";
}

export function otherSide(side: Side): Side {
  return side === "left" ? "right" : "left";
}

/** One vertex of one element. */
export interface VertexRef {
  readonly kind: ElementKind;
  readonly id: number;
  readonly side: LineName;
  readonly index: number;
}
