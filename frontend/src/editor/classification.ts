/** A quick look at what changed on an element, for colours at once; the server's rules have the last word. */
import { differingKeys, elementOf, type MapDocument } from "./document";
import { type KeyText, keyText, type Line, type MapElement } from "./elements";
import { sameLine, sameLineReversed } from "./lines";
import { hausdorff } from "./polyline";
import type { QuickCategory } from "./state";

/** Below it a boundary has not moved (change-mapping §3). */
const MOVED_METRES = 0.05;

const remembered = new WeakMap<object, { before: object; categories: readonly QuickCategory[] }>();

export function changedElements(
  base: MapDocument,
  current: MapDocument,
): ReadonlyMap<KeyText, readonly QuickCategory[]> {
  const changed = new Map<KeyText, readonly QuickCategory[]>();
  for (const key of differingKeys(base, current)) {
    const categories = classify(elementOf(base, key), elementOf(current, key));
    if (categories.length > 0) changed.set(keyText(key), categories);
  }
  return changed;
}

export function classify(before: MapElement | null, after: MapElement | null): readonly QuickCategory[] {
  if (before === null) return after === null ? [] : ["insertion"];
  if (after === null) return ["deletion"];
  const known = remembered.get(after.attributes);
  if (known?.before === before.attributes) return known.categories;
  const categories = compare(before, after);
  remembered.set(after.attributes, { before: before.attributes, categories });
  return categories;
}

function compare(before: MapElement, after: MapElement): QuickCategory[] {
  if (before.kind === "pedestrian_crossing" && after.kind === "pedestrian_crossing") {
    const [a, b] = [before.attributes, after.attributes];
    return moved(a.edge1, b.edge1) || moved(a.edge2, b.edge2) ? ["geometry"] : [];
  }
  if (before.kind !== "lane_segment" || after.kind !== "lane_segment") return [];
  const [a, b] = [before.attributes, after.attributes];
  const categories: QuickCategory[] = [];
  if (
    moved(a.left_lane_boundary, b.left_lane_boundary) ||
    moved(a.right_lane_boundary, b.right_lane_boundary)
  ) {
    categories.push("geometry");
  }
  if (a.left_lane_mark_type !== b.left_lane_mark_type || a.right_lane_mark_type !== b.right_lane_mark_type) {
    categories.push("marking");
  }
  if (a.lane_type !== b.lane_type || a.is_intersection !== b.is_intersection) categories.push("type");
  return categories;
}

function moved(before: Line, after: Line): boolean {
  if (before === after || sameLine(before, after) || sameLineReversed(before, after)) return false;
  return hausdorff(before, after) > MOVED_METRES;
}
