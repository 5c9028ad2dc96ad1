/** The map's layers, bottom to top, and which of them each view shows. */
import type { ExpressionSpecification, FilterSpecification, LayerSpecification } from "maplibre-gl";
import { GROUPS, type Group } from "./features";
import { CHANGE_COLOURS, CHANGE_NAMES, type Palette } from "./palette";

/** Layers of elements are made once for every group, so that a view is switched by opacity alone, at once. */
const PER_GROUP = ["surface", "bars", "implied", "painted", "arrows"] as const;
type PerGroup = (typeof PER_GROUP)[number];

const OPACITY_PROPERTY: Readonly<Record<PerGroup, string>> = {
  surface: "fill-opacity",
  bars: "fill-opacity",
  implied: "line-opacity",
  painted: "line-opacity",
  arrows: "icon-opacity",
};

/** What is shown: the imported map, the edited one, or the edited one with its changes coloured. */
export type Shown = "base" | "edited" | "difference";

export interface Look {
  readonly shown: Shown;
  /** Lets the image of the ground shine through. */
  readonly overImage: boolean;
  readonly arrows: boolean;
}

const GROUPS_SHOWN: Readonly<Record<Shown, readonly Group[]>> = {
  base: ["both", "base", "gone"],
  edited: ["both", "edited"],
  difference: ["both", "edited", "gone"],
};

const PAINT_WIDTH: ExpressionSpecification = widths(0.7, 1.2, 1.9, 5, 18);
const PAINT_OFFSET: ExpressionSpecification = [
  "interpolate",
  ["exponential", 1.7],
  ["zoom"],
  ...([15, 0.9, 17, 1.4, 19, 2, 21, 5, 23, 19] as const).map((value, i) =>
    i % 2 === 0 ? value : (["*", ["get", "offset"], value] as ExpressionSpecification),
  ),
] as unknown as ExpressionSpecification;

function widths(...values: readonly [number, number, number, number, number]): ExpressionSpecification {
  const stops = values.flatMap((width, i) => [15 + 2 * i, width]);
  return ["interpolate", ["exponential", 1.7], ["zoom"], ...stops] as unknown as ExpressionSpecification;
}

export function layersOf(palette: Palette): LayerSpecification[] {
  const each = (layer: (group: Group) => LayerSpecification) => GROUPS.map(layer);
  return [
    { id: "canvas", type: "background", paint: { "background-color": palette.canvas } },
    {
      id: "drivable",
      type: "fill",
      source: "drivable",
      paint: { "fill-color": palette.drivable, "fill-antialias": false },
    },
    ...each((group) => surfaceLayer(group, palette)),
    ...changeLayers(),
    ...each((group) => ({
      id: `bars-${group}`,
      type: "fill",
      source: "areas",
      filter: isIn(group, "bars"),
      paint: { "fill-color": palette.crossing, "fill-antialias": true },
    })),
    ...each((group) => impliedLayer(group, palette)),
    ...each((group) => paintedLayer(group, palette)),
    ...each(arrowLayer),
    ...driveLayers(palette),
  ];
}

function isIn(group: Group, shape: string): FilterSpecification {
  return ["all", ["==", ["get", "group"], group], ["==", ["get", "shape"], shape]];
}

function surfaceLayer(group: Group, palette: Palette): LayerSpecification {
  const colours = ["BIKE", palette.bike, "BUS", palette.bus, "INTERSECTION", palette.intersection];
  return {
    id: `surface-${group}`,
    type: "fill",
    source: "areas",
    filter: isIn(group, "lane"),
    paint: {
      "fill-color": [
        "match",
        ["get", "surface"],
        ...colours,
        palette.vehicle,
      ] as unknown as ExpressionSpecification,
      "fill-antialias": false,
    },
  };
}

function changeLayers(): LayerSpecification[] {
  const changed: FilterSpecification = [
    "all",
    ["in", ["get", "group"], ["literal", ["edited", "gone"]]],
    ["in", ["get", "shape"], ["literal", ["lane", "crossing"]]],
    ["!=", ["get", "change"], ""],
  ];
  const colours = CHANGE_NAMES.flatMap((name) => [name, CHANGE_COLOURS[name]]);
  return [
    {
      id: "change",
      type: "fill",
      source: "areas",
      filter: [
        "all",
        changed,
        ["in", ["get", "change"], ["literal", [...CHANGE_NAMES]]],
      ] as FilterSpecification,
      paint: {
        "fill-color": ["match", ["get", "change"], ...colours, "#888"] as unknown as ExpressionSpecification,
        "fill-antialias": false,
      },
    },
    {
      id: "change-stripes",
      type: "fill",
      source: "areas",
      filter: ["all", changed, ["in", "+", ["get", "change"]]] as FilterSpecification,
      paint: { "fill-pattern": ["concat", "stripes-", ["get", "change"]], "fill-antialias": false },
    },
  ];
}

function impliedLayer(group: Group, palette: Palette): LayerSpecification {
  return {
    id: `implied-${group}`,
    type: "line",
    source: "paint",
    filter: ["all", ["==", ["get", "group"], group], ["==", ["get", "colour"], "none"]],
    layout: { "line-cap": "butt" },
    paint: {
      "line-color": palette.implied,
      "line-width": widths(0.5, 0.7, 1, 1.2, 1.5),
      "line-dasharray": [2, 3],
    },
  };
}

function paintedLayer(group: Group, palette: Palette): LayerSpecification {
  const colours = ["yellow", palette.yellow, "blue", palette.blue];
  return {
    id: `painted-${group}`,
    type: "line",
    source: "paint",
    filter: ["all", ["==", ["get", "group"], group], ["!=", ["get", "colour"], "none"]],
    layout: { "line-cap": "butt", "line-join": "round" },
    paint: {
      "line-color": [
        "match",
        ["get", "colour"],
        ...colours,
        palette.white,
      ] as unknown as ExpressionSpecification,
      "line-width": PAINT_WIDTH,
      "line-offset": PAINT_OFFSET,
    },
  };
}

function arrowLayer(group: Group): LayerSpecification {
  return {
    id: `arrows-${group}`,
    type: "symbol",
    source: "arrows",
    minzoom: 17, // closer, opposite lanes have room for an arrow each
    // Junctions get theirs only when there is room for them.
    filter: [
      "all",
      ["==", ["get", "group"], group],
      ["any", ["!", ["get", "junction"]], [">=", ["zoom"], 18.5]],
    ],
    layout: {
      "icon-image": ["concat", "arrow-", ["get", "icon"]],
      "icon-rotate": ["get", "bearing"],
      "icon-rotation-alignment": "map",
      "icon-size": ["interpolate", ["linear"], ["zoom"], 16, 0.45, 18, 0.8, 21, 1.6],
      "icon-allow-overlap": true,
      "icon-ignore-placement": true,
    },
  };
}

function driveLayers(palette: Palette): LayerSpecification[] {
  return [
    {
      id: "trajectory",
      type: "line",
      source: "drive",
      filter: ["==", ["geometry-type"], "LineString"],
      layout: { "line-cap": "round", "line-join": "round" },
      paint: { "line-color": palette.trajectory, "line-width": 1, "line-opacity": 0.45 },
    },
    {
      id: "frames",
      type: "circle",
      source: "drive",
      filter: ["==", ["geometry-type"], "Point"],
      paint: { "circle-radius": widths(1.4, 2, 2.6, 4, 6), "circle-color": palette.trajectory },
    },
  ];
}

/** Constant opacities by layer: changing them needs no new tiles. */
export function opacitiesOf({
  shown,
  overImage,
  arrows,
}: Look): [layer: string, property: string, value: number][] {
  const full: Readonly<Record<PerGroup, number>> = {
    surface: 1,
    bars: overImage ? 0.6 : 0.75,
    implied: 0.75,
    painted: 1,
    arrows: arrows ? 0.8 : 0,
  };
  const opacities: [string, string, number][] = [];
  for (const name of PER_GROUP) {
    for (const group of GROUPS) {
      const visible = GROUPS_SHOWN[shown].includes(group);
      const faded = shown === "difference" && group === "gone" ? 0.5 : 1;
      opacities.push([`${name}-${group}`, OPACITY_PROPERTY[name], visible ? full[name] * faded : 0]);
    }
  }
  const tint = shown === "difference" ? (overImage ? 0.5 : 0.6) : 0;
  opacities.push(["change", "fill-opacity", tint], ["change-stripes", "fill-opacity", tint]);
  return opacities;
}
