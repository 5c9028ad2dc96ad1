/** What the sources hold, and the smallest update when the map or the colours change. */
import type { Feature } from "geojson";
import {
  type ElementKey,
  elementOf,
  type KeyText,
  keyText,
  type MapDocument,
  type MapElement,
} from "../editor";
import { type FeaturesBySource, featuresOf, type Group, type SourceName } from "./features";
import type { Projection } from "./projection";

/** Features out and in, by id; what `GeoJSONSource.updateData` takes. */
export interface SourceUpdate {
  readonly remove: string[];
  readonly add: Feature[];
}

export type Updates = Readonly<Record<SourceName, SourceUpdate>>;

interface Shown {
  readonly base: object | null;
  readonly current: object | null;
  readonly change: string;
  readonly features: readonly FeaturesBySource[];
}

export const SOURCE_NAMES: readonly SourceName[] = ["areas", "paint", "arrows"];

export class ShownElements {
  readonly #projection: Projection;
  readonly #shown = new Map<KeyText, Shown>();

  constructor(projection: Projection) {
    this.#projection = projection;
  }

  /** Brings the shown elements up to date; null when nothing changed. */
  update(
    base: MapDocument,
    current: MapDocument,
    categories: ReadonlyMap<KeyText, readonly string[]>,
  ): Updates | null {
    const updates = { areas: nothing(), paint: nothing(), arrows: nothing() };
    const present = new Set<KeyText>();
    let changed = false;
    for (const key of keysOf(base, current)) {
      const text = keyText(key);
      present.add(text);
      const before = elementOf(base, key);
      const after = elementOf(current, key);
      const visible = (categories.get(text) ?? []).filter((name) => name !== "connectivity");
      const change = visible.join("+");
      const shown = this.#shown.get(text);
      const [baseObject, currentObject] = [before?.attributes ?? null, after?.attributes ?? null];
      if (shown?.base === baseObject && shown.current === currentObject && shown.change === change) continue;
      changed = true;
      const features = this.#features(before, after, visible);
      this.#swap(updates, shown, features);
      this.#shown.set(text, { base: baseObject, current: currentObject, change, features });
    }
    for (const [text, shown] of this.#shown) {
      if (present.has(text)) continue;
      changed = true;
      this.#swap(updates, shown, []);
      this.#shown.delete(text);
    }
    return changed ? updates : null;
  }

  /** All features of a source, to fill it anew. */
  all(source: SourceName): Feature[] {
    return [...this.#shown.values()].flatMap(({ features }) => features.flatMap((one) => [...one[source]]));
  }

  #features(
    before: MapElement | null,
    after: MapElement | null,
    change: readonly string[],
  ): FeaturesBySource[] {
    const make = (element: MapElement, group: Group, categories: readonly string[]) =>
      featuresOf(element, group, categories, this.#projection);
    if (after === null) return before === null ? [] : [make(before, "gone", ["deletion"])];
    if (before === null) return [make(after, "edited", change.length > 0 ? change : ["insertion"])];
    if (change.length === 0) return [make(after, "both", [])];
    return [make(before, "base", []), make(after, "edited", change)];
  }

  #swap(updates: Updates, shown: Shown | undefined, features: readonly FeaturesBySource[]): void {
    for (const source of SOURCE_NAMES) {
      for (const old of shown?.features ?? []) updates[source].remove.push(...old[source].map(featureId));
      for (const fresh of features) updates[source].add.push(...fresh[source]);
    }
  }
}

function nothing(): SourceUpdate {
  return { remove: [], add: [] };
}

function featureId(feature: Feature): string {
  return String(feature.properties?.fid);
}

function* keysOf(base: MapDocument, current: MapDocument): Generator<ElementKey> {
  for (const id of base.lanes.keys()) yield { kind: "lane_segment", id };
  for (const id of current.lanes.keys()) if (!base.lanes.has(id)) yield { kind: "lane_segment", id };
  for (const id of base.crossings.keys()) yield { kind: "pedestrian_crossing", id };
  for (const id of current.crossings.keys())
    if (!base.crossings.has(id)) yield { kind: "pedestrian_crossing", id };
}
