/** Areas: boxes, containment, size. Rings are not closed. */
import type { Place } from "./elements";
import { at } from "./polyline";

/** min x, min y, max x, max y. */
export type Box = readonly [number, number, number, number];

export function boxOf(places: readonly Place[]): Box {
  let [west, south, east, north] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { x, y } of places) {
    west = Math.min(west, x);
    south = Math.min(south, y);
    east = Math.max(east, x);
    north = Math.max(north, y);
  }
  return [west, south, east, north];
}

export function inBox(box: Box, place: Place, margin = 0): boolean {
  return (
    place.x >= box[0] - margin &&
    place.y >= box[1] - margin &&
    place.x <= box[2] + margin &&
    place.y <= box[3] + margin
  );
}

export function signedArea(ring: readonly Place[]): number {
  let sum = 0;
  for (let i = 0; i < ring.length; i++) {
    const a = at(ring, i - 1);
    const b = at(ring, i);
    sum += a.x * b.y - b.x * a.y;
  }
  return sum / 2;
}

export function contains(ring: readonly Place[], place: Place): boolean {
  let inside = false;
  for (let i = 0; i < ring.length; i++) {
    const a = at(ring, i - 1);
    const b = at(ring, i);
    if (a.y > place.y !== b.y > place.y && place.x < a.x + ((place.y - a.y) * (b.x - a.x)) / (b.y - a.y)) {
      inside = !inside;
    }
  }
  return inside;
}
