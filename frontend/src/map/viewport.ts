/** Where city places are on the screen, kept in step with the map; React reads it as an external store. */
import type { Map as MapLibreMap } from "maplibre-gl";
import type { Place } from "../editor";
import type { LngLat, Projection } from "./projection";

export interface Pixel {
  readonly x: number;
  readonly y: number;
}

export class Viewport {
  readonly #map: MapLibreMap;
  readonly #projection: Projection;
  readonly #listeners = new Set<() => void>();
  #version = 0;

  constructor(map: MapLibreMap, projection: Projection) {
    this.#map = map;
    this.#projection = projection;
    const moved = () => {
      this.#version++;
      for (const listener of this.#listeners) listener();
    };
    map.on("move", moved);
    map.on("resize", moved);
  }

  readonly subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  };

  /** Grows with each movement of the map. */
  readonly version = (): number => this.#version;

  toPixel(place: Place): Pixel {
    return this.#map.project(this.#projection.toLngLat(place));
  }

  toCity(pixel: Pixel): Place {
    const { lng, lat } = this.#map.unproject([pixel.x, pixel.y]);
    return this.#projection.toCity(lng, lat);
  }

  /** CSS pixels per metre at the middle of the map. */
  pixelsPerMetre(): number {
    const { lng, lat } = this.#map.getCenter();
    const here = this.#projection.toCity(lng, lat);
    const a = this.toPixel(here);
    const b = this.toPixel({ x: here.x + 10, y: here.y });
    return Math.hypot(b.x - a.x, b.y - a.y) / 10;
  }

  metres(pixels: number): number {
    return pixels / this.pixelsPerMetre();
  }

  /** a, b, c, d, e, f of x' = a·x + c·y + e, y' = b·x + d·y + f, from city metres to CSS pixels of the map's box. */
  matrix(): number[] {
    const { lng, lat } = this.#map.getCenter();
    const origin = this.#projection.toCity(lng, lat);
    const p = this.toPixel(origin);
    const east = this.toPixel({ x: origin.x + 10, y: origin.y });
    const north = this.toPixel({ x: origin.x, y: origin.y + 10 });
    const [a, b] = [(east.x - p.x) / 10, (east.y - p.y) / 10];
    const [c, d] = [(north.x - p.x) / 10, (north.y - p.y) / 10];
    return [a, b, c, d, p.x - a * origin.x - c * origin.y, p.y - b * origin.x - d * origin.y];
  }

  /** CSS pixels of the map that lie under a panel at its right, as the page's styles say. */
  #coveredRight(): number {
    const covered = getComputedStyle(this.#map.getContainer()).getPropertyValue("--covered-right");
    return Number.parseFloat(covered) || 0;
  }

  /** Shows a box of places, with room for what floats over the map. */
  fit(places: readonly Place[], options: { animate: boolean; closest?: number; padding?: number }): void {
    const positions: LngLat[] = places.map((place) => this.#projection.toLngLat(place));
    if (positions.length === 0) return;
    const longitudes = positions.map(([longitude]) => longitude);
    const latitudes = positions.map(([, latitude]) => latitude);
    const padding = options.padding ?? 48;
    this.#map.fitBounds(
      [
        [Math.min(...longitudes), Math.min(...latitudes)],
        [Math.max(...longitudes), Math.max(...latitudes)],
      ],
      {
        padding: { top: padding, bottom: padding, left: padding, right: padding + this.#coveredRight() },
        maxZoom: options.closest ?? 21,
        duration: options.animate ? 350 : 0,
      },
    );
  }
}
