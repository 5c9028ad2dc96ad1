/** Fixes come with ids that the server made up for new elements; the map takes only ids that it was handed. */
import { elementOf, type MapDocument } from "./document";
import { type ElementKey, type ElementKind, type KeyText, keyText } from "./elements";
import type { ReceivedEdit } from "./wire";

const LISTS = ["successors", "predecessors"];
const REFERENCES = ["left_neighbor_id", "right_neighbor_id", "part_of"];

/** What the edits insert that none of the maps knows. */
export function strangers(edits: readonly ReceivedEdit[], maps: readonly MapDocument[]): ElementKey[] {
  return edits
    .filter(({ operation }) => operation === "insert")
    .map(({ kind, id }) => ({ kind, id }))
    .filter((key) => maps.every((map) => elementOf(map, key) === null));
}

/** The edits under other ids, and every link and neighbour that named the old ones. */
export function renumbered(
  edits: readonly ReceivedEdit[],
  ids: ReadonlyMap<KeyText, number>,
): readonly ReceivedEdit[] {
  if (ids.size === 0) return edits;
  const own = (kind: ElementKind, id: unknown) =>
    typeof id === "number" ? (ids.get(keyText({ kind, id })) ?? id) : id;
  const attribute = (kind: ElementKind, name: string, value: unknown): unknown => {
    if (name === "id") return own(kind, value);
    if (LISTS.includes(name) && Array.isArray(value)) return value.map((id) => own("lane_segment", id));
    return REFERENCES.includes(name) ? own("lane_segment", value) : value;
  };
  return edits.map(({ operation, kind, id, attributes = {} }) => ({
    operation,
    kind,
    id: own(kind, id) as number,
    attributes: Object.fromEntries(
      Object.entries(attributes).map(([name, value]) => [name, attribute(kind, name, value)]),
    ),
  }));
}
