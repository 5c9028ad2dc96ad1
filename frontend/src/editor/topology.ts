/**
 * Which vertices and lines are one thing on the ground although several lanes hold a copy: shared boundaries and
 * joints. Real maps duplicate bit for bit, so sharing is found by equal coordinates, not by neighbour ids alone.
 */
import type { MapDocument } from "./document";
import type { Lane, Place, Side } from "./elements";
import { boundary, neighborOf, sameLine, sameLineReversed, samePlace } from "./lines";

/** One lane's copy of a vertex. */
export interface Occurrence {
  readonly lane: number;
  readonly side: Side;
  readonly index: number;
  /** Whether it begins, ends or is inside its boundary. */
  readonly where: "start" | "end" | "inside";
}

/** Another lane's copy of a boundary. */
export interface Sharer {
  readonly lane: number;
  readonly side: Side;
  /** Runs the other way (oncoming lanes). */
  readonly reversed: boolean;
  /** The lanes lie on different sides of the line, so each sees mixed paint mirrored. */
  readonly across: boolean;
}

interface Topology {
  readonly vertices: ReadonlyMap<string, readonly Occurrence[]>;
  readonly before: ReadonlyMap<number, ReadonlySet<number>>;
  readonly after: ReadonlyMap<number, ReadonlySet<number>>;
}

const SIDES: readonly Side[] = ["left", "right"];
const known = new WeakMap<ReadonlyMap<number, Lane>, Topology>();

function placeText(place: Place): string {
  return `${place.x},${place.y}`;
}

function topologyOf(document: MapDocument): Topology {
  const cached = known.get(document.lanes);
  if (cached !== undefined) return cached;
  const vertices = new Map<string, Occurrence[]>();
  const before = new Map<number, Set<number>>();
  const after = new Map<number, Set<number>>();
  for (const lane of document.lanes.values()) {
    for (const side of SIDES) {
      const line = boundary(lane, side);
      line.forEach((point, index) => {
        const where = index === 0 ? "start" : index === line.length - 1 ? "end" : "inside";
        const text = placeText(point);
        const there = vertices.get(text);
        const occurrence: Occurrence = { lane: lane.id, side, index, where };
        if (there === undefined) vertices.set(text, [occurrence]);
        else there.push(occurrence);
      });
    }
    for (const next of lane.successors) link(after, before, lane.id, next);
    for (const previous of lane.predecessors) link(after, before, previous, lane.id);
  }
  const topology = { vertices, before, after };
  known.set(document.lanes, topology);
  return topology;
}

function link(
  after: Map<number, Set<number>>,
  before: Map<number, Set<number>>,
  from: number,
  to: number,
): void {
  const next = after.get(from) ?? new Set();
  after.set(from, next.add(to));
  const previous = before.get(to) ?? new Set();
  before.set(to, previous.add(from));
}

/** All copies of vertices at exactly this place. */
export function occurrencesAt(document: MapDocument, place: Place): readonly Occurrence[] {
  return topologyOf(document).vertices.get(placeText(place)) ?? [];
}

/** Ids that a link leads to (`after`) or comes from (`before`), when either side says so; rim ids included. */
export function linkedLanes(
  document: MapDocument,
  lane: number,
  way: "before" | "after",
): ReadonlySet<number> {
  return topologyOf(document)[way].get(lane) ?? new Set();
}

function intersects(a: ReadonlySet<number>, b: ReadonlySet<number>): boolean {
  for (const id of a) if (b.has(id)) return true;
  return false;
}

/** Whether lanes are joined end to end here: linked, or leaving (entering) the same lane side by side. */
function joined(document: MapDocument, a: Occurrence, b: Occurrence): boolean {
  if (a.where === "inside" || b.where === "inside" || a.side !== b.side) return false;
  const { before, after } = topologyOf(document);
  const none: ReadonlySet<number> = new Set();
  if (a.where !== b.where) {
    const [from, to] = a.where === "end" ? [a, b] : [b, a];
    return after.get(from.lane)?.has(to.lane) ?? false;
  }
  const links = a.where === "start" ? before : after;
  return intersects(links.get(a.lane) ?? none, links.get(b.lane) ?? none);
}

function shareSegment(a: Lane, at: Occurrence, b: Lane, other: Occurrence): boolean {
  const one = boundary(a, at.side);
  const two = boundary(b, other.side);
  return [-1, 1].some((step) =>
    [-1, 1].some((back) => samePlace(one[at.index + step], two[other.index + back])),
  );
}

function areNeighbors(a: Lane, at: Occurrence, b: Lane, other: Occurrence): boolean {
  return neighborOf(a, at.side) === b.id || neighborOf(b, other.side) === a.id;
}

/** The occurrence and all copies of its vertex that must go where it goes. */
export function together(
  document: MapDocument,
  vertex: Pick<Occurrence, "lane" | "side" | "index">,
): Occurrence[] {
  const lane = document.lanes.get(vertex.lane);
  const point = lane && boundary(lane, vertex.side)[vertex.index];
  if (point === undefined) return [];
  const waiting = new Set(occurrencesAt(document, point));
  const found: Occurrence[] = [];
  for (const occurrence of waiting) {
    if (
      occurrence.lane === vertex.lane &&
      occurrence.side === vertex.side &&
      occurrence.index === vertex.index
    ) {
      found.push(occurrence);
      waiting.delete(occurrence);
    }
  }
  for (const one of found) {
    for (const other of waiting) {
      if (!areOne(document, one, other)) continue;
      found.push(other);
      waiting.delete(other);
    }
  }
  return found;
}

function areOne(document: MapDocument, one: Occurrence, other: Occurrence): boolean {
  const a = document.lanes.get(one.lane);
  const b = document.lanes.get(other.lane);
  if (a === undefined || b === undefined || a.id === b.id) return false;
  return joined(document, one, other) || areNeighbors(a, one, b, other) || shareSegment(a, one, b, other);
}

/** Whether lanes are joined end to end at this vertex. */
export function isJoint(document: MapDocument, copies: readonly Occurrence[]): boolean {
  return copies.some((one) => copies.some((other) => one !== other && joined(document, one, other)));
}

/** Other lanes' copies of a whole boundary. */
export function sharersOf(document: MapDocument, lane: Lane, side: Side): Sharer[] {
  const line = boundary(lane, side);
  const first = line[0];
  if (first === undefined) return [];
  const sharers: Sharer[] = [];
  for (const { lane: id, side: otherSide, where } of occurrencesAt(document, first)) {
    const other = document.lanes.get(id);
    if (other === undefined || id === lane.id || where === "inside") continue;
    const copy = boundary(other, otherSide);
    if (where === "start" ? sameLine(line, copy) : sameLineReversed(line, copy)) {
      const reversed = where === "end";
      sharers.push({ lane: id, side: otherSide, reversed, across: (side === otherSide) === reversed });
    }
  }
  return sharers;
}
