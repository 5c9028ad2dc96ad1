/** Makes the MapLibre map: its worker, an empty calm style, the sources that the workspace fills. */

import type { FeatureCollection } from "geojson";
import { Map as MapLibreMap, type StyleSpecification, setWorkerUrl } from "maplibre-gl";
import workerUrl from "maplibre-gl/dist/maplibre-gl-worker.mjs?worker&url";
import { layersOf } from "./layers";
import { PALETTES } from "./palette";
import type { LngLat } from "./projection";

setWorkerUrl(workerUrl);

/** Tiles of sources are quantised: at this zoom to a tenth of a millimetre. */
const SOURCE_MAX_ZOOM = 24;

export const NO_WEBGL =
  "This browser cannot draw the map: WebGL 2 is missing or switched off. Switch on hardware acceleration in the browser's settings, or open Lanewright in a current Chrome, Edge or Firefox.";
export const NO_WORKER =
  "The map's worker could not be loaded. Reload the page; if it happens again, ask whoever runs this server to rebuild the frontend.";

export function hasWebGl(): boolean {
  try {
    return document.createElement("canvas").getContext("webgl2") !== null;
  } catch {
    return false;
  }
}

const EMPTY: FeatureCollection = { type: "FeatureCollection", features: [] };

export function createMap(
  container: HTMLElement,
  theme: "dark" | "light",
  bounds: [LngLat, LngLat],
): MapLibreMap {
  const source = () => ({
    type: "geojson" as const,
    data: EMPTY,
    maxzoom: SOURCE_MAX_ZOOM,
    promoteId: "fid",
  });
  const style: StyleSpecification = {
    version: 8,
    sources: { drivable: source(), areas: source(), paint: source(), arrows: source(), drive: source() },
    layers: layersOf(PALETTES[theme]),
    transition: { duration: 0, delay: 0 },
  };
  const map = new MapLibreMap({
    container,
    style,
    bounds,
    fitBoundsOptions: { padding: 48 },
    minZoom: 12,
    maxZoom: 24,
    maxPitch: 0,
    dragRotate: false,
    touchPitch: false,
    pitchWithRotate: false,
    keyboard: false,
    attributionControl: false,
    fadeDuration: 0,
    renderWorldCopies: false,
  });
  map.touchZoomRotate.disableRotation();
  return map;
}
