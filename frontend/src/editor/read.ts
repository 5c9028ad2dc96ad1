/** Maps and edits as they come over the wire, read into elements. */
import type { MapDocument } from "./document";
import type { Crossing, Lane, LaneType, Line, Mark, Point } from "./elements";
import { MARKS } from "./marks";
import type { WireMap } from "./wire";

/** What arrived is not what it should be: names the attribute. */
export class Unreadable extends Error {}

const LANE_TYPES: readonly LaneType[] = ["VEHICLE", "BIKE", "BUS"];

export function readMap(map: WireMap): MapDocument {
  return {
    lanes: new Map(
      map.lanes.map(({ attributes }) => [attributes.id, readLane({ ...attributes }, attributes.id)]),
    ),
    crossings: new Map(
      map.crossings.map(({ attributes }) => [attributes.id, readCrossing({ ...attributes }, attributes.id)]),
    ),
  };
}

type Attributes = Readonly<Record<string, unknown>>;

/** A lane from attributes over a known one; all must be there when there is none. */
export function readLane(attributes: Attributes, id: number, known: Lane | null = null): Lane {
  const read = <T>(name: keyof Lane, parse: (value: unknown, name: string) => T, old: T | undefined): T =>
    name in attributes || old === undefined ? parse(attributes[name], name) : old;
  return {
    id,
    is_intersection: read("is_intersection", readFlag, known?.is_intersection),
    lane_type: read("lane_type", readLaneType, known?.lane_type),
    left_lane_boundary: read("left_lane_boundary", readLine, known?.left_lane_boundary),
    left_lane_mark_type: read("left_lane_mark_type", readMark, known?.left_lane_mark_type),
    right_lane_boundary: read("right_lane_boundary", readLine, known?.right_lane_boundary),
    right_lane_mark_type: read("right_lane_mark_type", readMark, known?.right_lane_mark_type),
    successors: read("successors", readIds, known?.successors),
    predecessors: read("predecessors", readIds, known?.predecessors),
    right_neighbor_id: read("right_neighbor_id", readId, known?.right_neighbor_id),
    left_neighbor_id: read("left_neighbor_id", readId, known?.left_neighbor_id),
    part_of: read("part_of", readId, known === null ? null : known.part_of),
  };
}

export function readCrossing(attributes: Attributes, id: number, known: Crossing | null = null): Crossing {
  const edge = (name: "edge1" | "edge2") =>
    name in attributes || known === null ? readLine(attributes[name], name) : known[name];
  return { id, edge1: edge("edge1"), edge2: edge("edge2") };
}

function fail(name: string, wanted: string): never {
  throw new Unreadable(`${name} is not ${wanted}`);
}

function readFlag(value: unknown, name: string): boolean {
  return typeof value === "boolean" ? value : fail(name, "true or false");
}

function readLaneType(value: unknown, name: string): LaneType {
  return LANE_TYPES.find((type) => type === value) ?? fail(name, "a lane type");
}

function readMark(value: unknown, name: string): Mark {
  return MARKS.find((mark) => mark === value) ?? fail(name, "a lane mark");
}

function readIds(value: unknown, name: string): readonly number[] {
  if (!Array.isArray(value)) return fail(name, "a list of ids");
  return value.map((id: unknown) =>
    Number.isSafeInteger(id) ? (id as number) : fail(name, "a list of ids"),
  );
}

function readId(value: unknown, name: string): number | null {
  if (value === null || Number.isSafeInteger(value)) return value as number | null;
  return fail(name, "an id or null");
}

function readLine(value: unknown, name: string): Line {
  if (!Array.isArray(value) || value.length < 2) return fail(name, "a line of two vertices or more");
  return value.map((point: unknown) => readPoint(point, name));
}

function readPoint(value: unknown, name: string): Point {
  if (typeof value !== "object" || value === null || !("x" in value) || !("y" in value)) {
    return fail(name, "a list of points");
  }
  const { x, y } = value;
  const z = "z" in value ? value.z : null;
  const finite = (number: unknown): number =>
    Number.isFinite(number) ? (number as number) : fail(name, "in metres");
  return { x: finite(x), y: finite(y), z: z === null || z === undefined ? null : finite(z) };
}
