/** A map state as an immutable value, and changes of it that can be reversed. */
import {
  type Crossing,
  type ElementKey,
  type KeyText,
  keyText,
  type Lane,
  type MapElement,
  parseKey,
} from "./elements";

export interface MapDocument {
  readonly lanes: ReadonlyMap<number, Lane>;
  readonly crossings: ReadonlyMap<number, Crossing>;
}

/** One element before and after; null: not in the map. */
export interface Change {
  readonly key: ElementKey;
  readonly before: MapElement | null;
  readonly after: MapElement | null;
}

export const emptyDocument: MapDocument = { lanes: new Map(), crossings: new Map() };

export function elementOf(document: MapDocument, key: ElementKey): MapElement | null {
  if (key.kind === "lane_segment") {
    const attributes = document.lanes.get(key.id);
    return attributes === undefined ? null : { kind: "lane_segment", id: key.id, attributes };
  }
  const attributes = document.crossings.get(key.id);
  return attributes === undefined ? null : { kind: "pedestrian_crossing", id: key.id, attributes };
}

/** The document with each change's `after` in place; the other elements stay the same objects. */
export function applyChanges(document: MapDocument, changes: readonly Change[]): MapDocument {
  if (changes.length === 0) return document;
  const lanes = new Map(document.lanes);
  const crossings = new Map(document.crossings);
  for (const { key, after } of changes) {
    if (after === null) (key.kind === "lane_segment" ? lanes : crossings).delete(key.id);
    else if (after.kind === "lane_segment") lanes.set(key.id, after.attributes);
    else crossings.set(key.id, after.attributes);
  }
  return { lanes, crossings };
}

export function reverseChanges(changes: readonly Change[]): Change[] {
  return changes.map(({ key, before, after }) => ({ key, before: after, after: before })).reverse();
}

/** Keys of the elements that are not the very same object in both documents, sorted by kind and id. */
export function differingKeys(a: MapDocument, b: MapDocument): ElementKey[] {
  const texts = new Set<KeyText>();
  collect("lane_segment", a.lanes, b.lanes, texts);
  collect("pedestrian_crossing", a.crossings, b.crossings, texts);
  const keys: ElementKey[] = [];
  for (const text of texts) {
    const key = parseKey(text);
    if (key !== null) keys.push(key);
  }
  return keys.sort((one, other) =>
    one.kind === other.kind ? one.id - other.id : one.kind < other.kind ? -1 : 1,
  );
}

function collect<T>(
  kind: ElementKey["kind"],
  a: ReadonlyMap<number, T>,
  b: ReadonlyMap<number, T>,
  into: Set<KeyText>,
): void {
  if (a === b) return;
  for (const [id, value] of a) if (b.get(id) !== value) into.add(keyText({ kind, id }));
  for (const id of b.keys()) if (!a.has(id)) into.add(keyText({ kind, id }));
}
