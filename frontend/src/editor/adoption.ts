/**
 * Taking over what the server stored. It fills heights, restores what stayed below tolerance and may bring identities
 * into canonical form, so the stored elements differ from those that were sent; undo must still lead to what was there.
 */
import { type Change, differingKeys, elementOf, type MapDocument } from "./document";
import { type ElementKey, type KeyText, keyText, type Line, type MapElement, type Point } from "./elements";
import { equalElements } from "./equality";
import { lineNames, lineOf } from "./lines";
import type { History } from "./state";
import type { Declaration } from "./wire";

/** Translates elements of before a save into what they are after it. */
export class Adoption {
  readonly #stored = new Map<object, MapElement | null>();
  readonly #points = new Map<string, Point>();
  /**
   * Whether the save touched only what was sent; if not (ids exchanged, lanes joined, others' work merged in), neither
   * the past nor what was edited meanwhile can be translated element by element.
   */
  readonly translatesHistory: boolean;

  constructor(savedBefore: MapDocument, sent: MapDocument, stored: MapDocument) {
    const edited = new Set<KeyText>(differingKeys(savedBefore, sent).map(keyText));
    let faithful = true;
    for (const key of differingKeys(sent, stored)) {
      const was = elementOf(sent, key);
      const now = elementOf(stored, key);
      if (was === null || now === null || !edited.has(keyText(key))) {
        if (!equalElements(was, now)) faithful = false;
        continue;
      }
      this.#stored.set(was.attributes, now);
      this.#notePoints(was, now);
    }
    this.translatesHistory = faithful;
  }

  #notePoints(was: MapElement, now: MapElement): void {
    for (const name of lineNames(was.kind)) {
      const before = lineOf(was, name);
      const after = lineOf(now, name);
      if (before === null || after === null || before.length !== after.length) continue;
      before.forEach((point, index) => {
        const to = after[index];
        if (point.z === null && to !== undefined) this.#points.set(`${point.x},${point.y}`, to);
      });
    }
  }

  /** The element as stored if it is the one that was sent, else with its drawn vertices where the server put them. */
  element(element: MapElement | null): MapElement | null {
    if (element === null) return null;
    const stored = this.#stored.get(element.attributes);
    if (stored !== undefined) return stored;
    if (element.kind === "lane_segment") {
      const { left_lane_boundary, right_lane_boundary } = element.attributes;
      const left = this.#line(left_lane_boundary);
      const right = this.#line(right_lane_boundary);
      if (left === left_lane_boundary && right === right_lane_boundary) return element;
      const attributes = { ...element.attributes, left_lane_boundary: left, right_lane_boundary: right };
      this.#stored.set(element.attributes, { ...element, attributes });
      return { ...element, attributes };
    }
    const edge1 = this.#line(element.attributes.edge1);
    const edge2 = this.#line(element.attributes.edge2);
    if (edge1 === element.attributes.edge1 && edge2 === element.attributes.edge2) return element;
    const attributes = { ...element.attributes, edge1, edge2 };
    this.#stored.set(element.attributes, { ...element, attributes });
    return { ...element, attributes };
  }

  #line(line: Line): Line {
    const stored = (point: Point) =>
      point.z === null ? this.#points.get(`${point.x},${point.y}`) : undefined;
    return line.some((point) => stored(point) !== undefined)
      ? line.map((point) => stored(point) ?? point)
      : line;
  }

  changes(changes: readonly Change[]): Change[] {
    return changes.map(({ key, before, after }) => ({
      key,
      before: this.element(before),
      after: this.element(after),
    }));
  }

  /** Undo steps as they are after the save; `declared` translates the declarations that a step leads between. */
  history(history: History, declared: (list: readonly Declaration[]) => Declaration[]): History {
    if (!this.translatesHistory) return { done: [], undone: [] };
    const translated = (entries: History["done"]) =>
      entries.map(({ note, changes, declarations }) => ({
        note,
        changes: this.changes(changes),
        ...(declarations
          ? { declarations: { before: declared(declarations.before), after: declared(declarations.after) } }
          : {}),
      }));
    return { done: translated(history.done), undone: translated(history.undone) };
  }

  /** What was edited since the save was sent, where the save touched only what was sent. */
  current(current: MapDocument, sent: MapDocument, stored: MapDocument): Change[] {
    const since = differingKeys(sent, current).filter(
      (key) => !equalElements(elementOf(sent, key), elementOf(current, key)),
    );
    return since.map((key: ElementKey) => ({
      key,
      before: elementOf(stored, key),
      after: this.element(elementOf(current, key)),
    }));
  }
}
