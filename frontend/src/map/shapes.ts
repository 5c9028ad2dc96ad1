/** SVG paths of places. */
import type { Place } from "../editor";
import type { Pixel, Viewport } from "./viewport";

export function linePath(places: readonly Place[], viewport: Viewport): string {
  return places.map((place, i) => `${i === 0 ? "M" : "L"}${pixelText(viewport.toPixel(place))}`).join("");
}

export function ringPath(ring: readonly Place[], viewport: Viewport): string {
  return ring.length === 0 ? "" : `${linePath(ring, viewport)}Z`;
}

function pixelText({ x, y }: Pixel): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
