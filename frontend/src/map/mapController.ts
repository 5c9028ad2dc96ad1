/** Keeps the MapLibre map in step with what it is told to show. Calls before the style is there are kept. */
import type { Feature, FeatureCollection } from "geojson";
import type { GeoJSONSource, Map as MapLibreMap } from "maplibre-gl";
import type { KeyText, MapDocument, Place } from "../editor";
import { createMap } from "./createMap";
import { addImages } from "./images";
import { type Look, layersOf, opacitiesOf } from "./layers";
import { PALETTES } from "./palette";
import { type Projection, projectionOf } from "./projection";
import type { CityFrame, DrivePath, LidarImage } from "./properties";
import { ShownElements, SOURCE_NAMES } from "./sourceDiff";
import { Viewport } from "./viewport";

export type Theme = "dark" | "light";

const LIDAR = "lidar";
/** Above the lanes' grey, so that it shows on the road, and below tints, paint and arrows. */
const ABOVE_IMAGE = "change";

export class MapController {
  readonly map: MapLibreMap;
  readonly viewport: Viewport;
  readonly projection: Projection;
  /** The focusable box around canvas and overlay; it carries the map's state for tests. */
  readonly region: HTMLElement;
  readonly #elements: ShownElements;
  readonly #waiting: (() => void)[] = [];
  #ready = false;
  #filled = false;
  #lidar: LidarImage | null = null;

  constructor(
    region: HTMLElement,
    container: HTMLElement,
    frame: CityFrame,
    bounds: readonly number[],
    theme: Theme,
  ) {
    this.region = region;
    this.projection = projectionOf(frame);
    const [west = 0, south = 0, east = 0, north = 0] = bounds;
    const corner = (x: number, y: number) => this.projection.toLngLat({ x, y });
    this.map = createMap(container, theme, [corner(west, south), corner(east, north)]);
    this.viewport = new Viewport(this.map, this.projection);
    this.#elements = new ShownElements(this.projection);
    this.map.getCanvas().tabIndex = -1; // the region takes the focus
    this.#state("loading");
    this.map.on("load", () => {
      addImages(this.map, PALETTES[theme].arrow);
      this.#ready = true;
      for (const act of this.#waiting.splice(0)) act();
    });
    this.map.on("movestart", () => this.#state("moving"));
    this.map.on("idle", () => {
      if (this.#ready) this.#state("idle");
    });
  }

  destroy(): void {
    this.map.remove();
  }

  setElements(
    base: MapDocument,
    current: MapDocument,
    categories: ReadonlyMap<KeyText, readonly string[]>,
  ): void {
    this.#whenReady(() => {
      const updates = this.#elements.update(base, current, categories);
      if (updates === null) return;
      this.#state("moving");
      for (const name of SOURCE_NAMES) {
        if (!this.#filled) this.#fill(name, this.#elements.all(name));
        else if (updates[name].remove.length + updates[name].add.length > 0) {
          void this.#source(name).updateData(updates[name]);
        }
      }
      this.#filled = true;
    });
  }

  setLook(look: Look): void {
    this.#whenReady(() => {
      for (const [layer, property, value] of opacitiesOf(look)) this.#paint(layer, property, value);
    });
  }

  setTheme(theme: Theme): void {
    this.#whenReady(() => {
      addImages(this.map, PALETTES[theme].arrow);
      for (const layer of layersOf(PALETTES[theme])) {
        for (const [property, value] of Object.entries(layer.paint ?? {})) {
          if (property.endsWith("-color")) this.#paint(layer.id, property, value);
        }
      }
    });
  }

  setDrivableAreas(areas: readonly (readonly (readonly number[])[])[]): void {
    const features = areas.map((area): Feature => {
      const ring = area.map(([x = 0, y = 0]) => this.projection.toLngLat({ x, y }));
      const [first] = ring;
      const closed = first === undefined ? ring : [...ring, first];
      return { type: "Feature", properties: {}, geometry: { type: "Polygon", coordinates: [closed] } };
    });
    this.#whenReady(() => this.#fill("drivable", features));
  }

  setDrive(drive: DrivePath | null): void {
    const position = (place: Place) => this.projection.toLngLat(place);
    const line: Feature[] =
      drive === null || drive.trajectory.length < 2
        ? []
        : [
            {
              type: "Feature",
              properties: {},
              geometry: {
                type: "LineString",
                coordinates: drive.trajectory.map(([x = 0, y = 0]) => position({ x, y })),
              },
            },
          ];
    const frames = (drive?.frames ?? []).map(
      ({ x, y }): Feature => ({
        type: "Feature",
        properties: {},
        geometry: { type: "Point", coordinates: position({ x, y }) },
      }),
    );
    this.#whenReady(() => this.#fill("drive", [...line, ...frames]));
  }

  setLidar(lidar: LidarImage | null, opacity: number): void {
    this.#whenReady(() => {
      if (this.#lidar?.url !== lidar?.url) this.#placeLidar(lidar);
      if (lidar !== null) this.#paint(LIDAR, "raster-opacity", opacity);
    });
  }

  #placeLidar(lidar: LidarImage | null): void {
    if (this.#lidar !== null) {
      this.map.removeLayer(LIDAR);
      this.map.removeSource(LIDAR);
    }
    this.#lidar = lidar;
    if (lidar === null) return;
    const [west = 0, south = 0, east = 0, north = 0] = lidar.bounds;
    const corner = (x: number, y: number) => this.projection.toLngLat({ x, y });
    this.#state("moving");
    this.map.addSource(LIDAR, {
      type: "image",
      url: lidar.url,
      coordinates: [corner(west, north), corner(east, north), corner(east, south), corner(west, south)],
    });
    const layer = { id: LIDAR, type: "raster", source: LIDAR, paint: { "raster-fade-duration": 0 } } as const;
    this.map.addLayer(layer, ABOVE_IMAGE);
  }

  #whenReady(act: () => void): void {
    if (this.#ready) act();
    else this.#waiting.push(act);
  }

  #source(name: string): GeoJSONSource {
    const source = this.map.getSource<GeoJSONSource>(name);
    if (source === undefined) throw new Error(`the map has no source ${name}`);
    return source;
  }

  #fill(name: string, features: readonly Feature[]): void {
    const data: FeatureCollection = { type: "FeatureCollection", features: [...features] };
    void this.#source(name).setData(data);
  }

  #paint(layer: string, property: string, value: unknown): void {
    type Set = (layer: string, property: string, value: unknown) => void;
    (this.map.setPaintProperty.bind(this.map) as Set)(layer, property, value);
  }

  /** For tests and tools: what the map is doing, and where city metres are on it. */
  #state(state: "loading" | "moving" | "idle"): void {
    this.region.dataset.mapState = state;
    if (state === "idle") this.region.dataset.cityToScreen = this.viewport.matrix().join(" ");
  }
}
