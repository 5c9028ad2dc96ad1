/** Elements as GeoJSON for the sources: areas, painted lines, arrows. */
import type { Feature, Position } from "geojson";
import { centreline, type Lane, laneLength, type MapElement, type Place, ringOf } from "../editor";
import { paintedLines } from "./paint";
import type { Projection } from "./projection";
import { barsOf } from "./zebra";

/**
 * In which states of the map a feature is shown: `both` (unchanged), `base` and `edited` (the two versions of a
 * changed element), `gone` (deleted: in the base, and marked in the difference).
 */
export type Group = "both" | "base" | "edited" | "gone";
export const GROUPS: readonly Group[] = ["both", "base", "edited", "gone"];

export type SourceName = "areas" | "paint" | "arrows";
export type FeaturesBySource = Readonly<Record<SourceName, readonly Feature[]>>;

const ARROW_SPACING_METRES = 30;
const SHORTEST_WITH_ARROW_METRES = 7;

export function featuresOf(
  element: MapElement,
  group: Group,
  categories: readonly string[],
  projection: Projection,
): FeaturesBySource {
  const prefix = `${element.kind}:${element.id}:${group}`;
  const change = categories.join("+");
  const area = (
    id: string,
    properties: Record<string, unknown>,
    rings: readonly (readonly Place[])[],
  ): Feature => ({
    type: "Feature",
    properties: { fid: `${prefix}:${id}`, group, change, ...properties },
    geometry: { type: "MultiPolygon", coordinates: rings.map((ring) => [closed(ring, projection)]) },
  });
  if (element.kind === "pedestrian_crossing") {
    return {
      areas: [
        area("area", { shape: "crossing" }, [ringOf(element)]),
        area("bars", { shape: "bars" }, barsOf(element.attributes)),
      ],
      paint: [],
      arrows: [],
    };
  }
  const lane = element.attributes;
  const surface = lane.lane_type === "VEHICLE" && lane.is_intersection ? "INTERSECTION" : lane.lane_type;
  return {
    areas: [area("area", { shape: "lane", surface }, [ringOf(element)])],
    paint: paintFeatures(lane, prefix, group, projection),
    arrows: arrowFeatures(lane, prefix, group, projection),
  };
}

function paintFeatures(lane: Lane, prefix: string, group: Group, projection: Projection): Feature[] {
  return (["left", "right"] as const).flatMap((side) =>
    paintedLines(lane, side).map(({ colour, offset, parts }, index) => ({
      type: "Feature" as const,
      properties: { fid: `${prefix}:${side}:${index}`, group, colour, offset },
      geometry: {
        type: "MultiLineString" as const,
        coordinates: parts.map((part) => part.map((place): Position => projection.toLngLat(place))),
      },
    })),
  );
}

function arrowFeatures(lane: Lane, prefix: string, group: Group, projection: Projection): Feature[] {
  const length = laneLength(lane);
  if (length < SHORTEST_WITH_ARROW_METRES) return [];
  const count = Math.max(1, Math.round(length / ARROW_SPACING_METRES));
  const middle = centreline(lane.left_lane_boundary, lane.right_lane_boundary, 2 * count * 4 + 1);
  return Array.from({ length: count }, (_, i) => {
    const at = (2 * i + 1) * 4;
    const [before, here, after] = [middle[at - 1], middle[at], middle[at + 1]];
    if (before === undefined || here === undefined || after === undefined) return [];
    return {
      type: "Feature" as const,
      properties: {
        fid: `${prefix}:arrow:${i}`,
        group,
        icon: lane.lane_type,
        junction: lane.is_intersection,
        bearing: bearing(before, after, projection),
      },
      geometry: { type: "Point" as const, coordinates: projection.toLngLat(here) },
    };
  }).flat();
}

/** Clockwise from true north, degrees, as drawn on the map. */
function bearing(from: Place, to: Place, projection: Projection): number {
  const [west, south] = projection.toLngLat(from);
  const [east, north] = projection.toLngLat(to);
  const squeeze = Math.cos((south * Math.PI) / 180);
  return (Math.atan2((east - west) * squeeze, north - south) * 180) / Math.PI;
}

function closed(ring: readonly Place[], projection: Projection): Position[] {
  const positions = ring.map((place): Position => projection.toLngLat(place));
  const [first] = positions;
  return first === undefined ? positions : [...positions, first];
}
