/** Elements compared by value: every digit, z included. */
import type { Lane, Line, MapElement } from "./elements";

export function equalLines(a: Line, b: Line): boolean {
  if (a === b) return true;
  return (
    a.length === b.length &&
    a.every((point, index) => {
      const other = b[index];
      return point === other || (point.x === other?.x && point.y === other.y && point.z === other.z);
    })
  );
}

export function equalLists(a: readonly number[], b: readonly number[]): boolean {
  return a === b || (a.length === b.length && a.every((id, index) => id === b[index]));
}

const LANE_EQUALITY: { readonly [Name in keyof Lane]: (a: Lane, b: Lane) => boolean } = {
  id: (a, b) => a.id === b.id,
  is_intersection: (a, b) => a.is_intersection === b.is_intersection,
  lane_type: (a, b) => a.lane_type === b.lane_type,
  left_lane_boundary: (a, b) => equalLines(a.left_lane_boundary, b.left_lane_boundary),
  left_lane_mark_type: (a, b) => a.left_lane_mark_type === b.left_lane_mark_type,
  right_lane_boundary: (a, b) => equalLines(a.right_lane_boundary, b.right_lane_boundary),
  right_lane_mark_type: (a, b) => a.right_lane_mark_type === b.right_lane_mark_type,
  successors: (a, b) => equalLists(a.successors, b.successors),
  predecessors: (a, b) => equalLists(a.predecessors, b.predecessors),
  right_neighbor_id: (a, b) => a.right_neighbor_id === b.right_neighbor_id,
  left_neighbor_id: (a, b) => a.left_neighbor_id === b.left_neighbor_id,
  part_of: (a, b) => a.part_of === b.part_of,
};

export const LANE_ATTRIBUTES = Object.keys(LANE_EQUALITY) as readonly (keyof Lane)[];

export function differingAttributes(a: Lane, b: Lane): (keyof Lane)[] {
  return a === b ? [] : LANE_ATTRIBUTES.filter((name) => !LANE_EQUALITY[name](a, b));
}

export function equalElements(a: MapElement | null, b: MapElement | null): boolean {
  if (a === null || b === null) return a === b;
  if (a.attributes === b.attributes) return true;
  if (a.kind === "lane_segment") {
    return b.kind === "lane_segment" && differingAttributes(a.attributes, b.attributes).length === 0;
  }
  if (b.kind !== "pedestrian_crossing" || a.id !== b.id) return false;
  return (
    equalLines(a.attributes.edge1, b.attributes.edge1) && equalLines(a.attributes.edge2, b.attributes.edge2)
  );
}
