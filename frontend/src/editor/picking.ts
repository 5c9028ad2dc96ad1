/** Which elements lie at a place, and which line or vertex of one. Worked out from the document, not from pixels. */
import type { MapDocument } from "./document";
import { type ElementKey, keyText, type LineName, type MapElement, type Place } from "./elements";
import { lineNames, lineOf, ringOf } from "./lines";
import { type Box, boxOf, contains, inBox, signedArea } from "./polygon";
import { nearestOnLine } from "./polyline";

interface Shape {
  readonly ring: readonly Place[];
  readonly box: Box;
  readonly area: number;
}

const shapes = new WeakMap<object, Shape>();

function shapeOf(element: MapElement): Shape {
  const known = shapes.get(element.attributes);
  if (known !== undefined) return known;
  const ring = ringOf(element);
  const shape = { ring, box: boxOf(ring), area: Math.abs(signedArea(ring)) };
  shapes.set(element.attributes, shape);
  return shape;
}

/** Elements at a place, the one to take first first: crossings, then the smaller lanes. */
export function elementsAt(document: MapDocument, place: Place, tolerance = 0): ElementKey[] {
  const found: { key: ElementKey; rank: number; area: number }[] = [];
  const look = (element: MapElement, rank: number) => {
    const { ring, box, area } = shapeOf(element);
    if (!inBox(box, place, tolerance)) return;
    const inside = contains(ring, place);
    if (!inside && (tolerance === 0 || nearestOnLine(place, ring).distance > tolerance)) return;
    found.push({ key: { kind: element.kind, id: element.id }, rank: inside ? rank : rank + 2, area });
  };
  for (const [id, attributes] of document.crossings) look({ kind: "pedestrian_crossing", id, attributes }, 0);
  for (const [id, attributes] of document.lanes) look({ kind: "lane_segment", id, attributes }, 1);
  found.sort((a, b) => a.rank - b.rank || a.area - b.area || a.key.id - b.key.id);
  return found.map(({ key }) => key);
}

/** The next of a stack: after the selected one if the stack is still the same, else its first. */
export function nextOfStack(stack: readonly ElementKey[], selected: ElementKey | null): ElementKey | null {
  const index = selected === null ? -1 : stack.findIndex((key) => keyText(key) === keyText(selected));
  return stack[(index + 1) % stack.length] ?? null;
}

/** The element's line that is nearest to a place. */
export function nearestLineName(
  element: MapElement,
  place: Place,
): { name: LineName; distance: number } | null {
  let best: { name: LineName; distance: number } | null = null;
  for (const name of lineNames(element.kind)) {
    const line = lineOf(element, name);
    if (line === null) continue;
    const far = nearestOnLine(place, line).distance;
    if (best === null || far < best.distance) best = { name, distance: far };
  }
  return best;
}
