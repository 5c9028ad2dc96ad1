/** A map state while one action works on it; what it did comes out as changes. */
import { applyChanges, type Change, elementOf, type MapDocument } from "./document";
import { type ElementKey, type KeyText, keyText, type Lane, type MapElement } from "./elements";

export class Workpiece {
  readonly start: MapDocument;
  #document: MapDocument;
  readonly #touched = new Map<KeyText, ElementKey>();

  constructor(document: MapDocument) {
    this.start = document;
    this.#document = document;
  }

  get document(): MapDocument {
    return this.#document;
  }

  lane(id: number): Lane | null {
    return this.#document.lanes.get(id) ?? null;
  }

  put(...elements: MapElement[]): void {
    this.#apply(elements.map((element) => ({ key: { kind: element.kind, id: element.id }, after: element })));
  }

  putLane(...lanes: Lane[]): void {
    this.put(...lanes.map((lane): MapElement => ({ kind: "lane_segment", id: lane.id, attributes: lane })));
  }

  remove(key: ElementKey): void {
    this.#apply([{ key, after: null }]);
  }

  #apply(steps: readonly { key: ElementKey; after: MapElement | null }[]): void {
    for (const { key } of steps) this.#touched.set(keyText(key), key);
    this.#document = applyChanges(
      this.#document,
      steps.map(({ key, after }) => ({ key, before: null, after })),
    );
  }

  /** The elements that are other objects now than at the start. */
  changes(): Change[] {
    const changes: Change[] = [];
    for (const key of this.#touched.values()) {
      const before = elementOf(this.start, key);
      const after = elementOf(this.#document, key);
      if (before?.attributes !== after?.attributes) changes.push({ key, before, after });
    }
    return changes;
  }
}
