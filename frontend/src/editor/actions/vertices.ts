/** Moving, adding and removing vertices. Copies of one vertex in several lanes move as one. */
import { elementOf, type MapDocument } from "../document";
import type { ElementKey, Line, Place, Point, VertexRef } from "../elements";
import { isSide } from "../elements";
import { boundary, drawn, lineOf, rounded, samePlace, withBoundary } from "../lines";
import { GONE, nameOf, type Planned, refuse } from "../plan";
import { planOf } from "../planOf";
import { middle } from "../polyline";
import { isJoint, type Occurrence, occurrencesAt, together } from "../topology";
import { Workpiece } from "../workpiece";
import { linkMetEnds } from "./links";

/** Where a drawn vertex comes to lie: exactly on an existing vertex, else rounded to the centimetre. */
export function landing(document: MapDocument, to: Place): Place {
  return occurrencesAt(document, to).length > 0 ? { x: to.x, y: to.y } : rounded(to);
}

export function planVertexMove(document: MapDocument, vertex: VertexRef, to: Place): Planned {
  const element = elementOf(document, vertex);
  const point = element && lineOf(element, vertex.side)?.[vertex.index];
  if (element === null || !point) return refuse(GONE);
  const target = landing(document, to);
  const work = new Workpiece(document);
  if (samePlace(point, target)) return { note: `Moved a vertex of ${nameOf(vertex)}`, changes: [] };
  if (element.kind === "pedestrian_crossing") {
    moveCrossingVertices(work, element, (at) => (at === point ? target : null));
    return planOf(work, `Moved a corner of ${nameOf(vertex)}`);
  }
  if (!isSide(vertex.side)) return refuse(GONE);
  const copies = together(document, { lane: vertex.id, side: vertex.side, index: vertex.index });
  moveCopies(work, copies, drawn(target));
  const linked = linkMetEnds(work, copies);
  const others = new Set(copies.map(({ lane }) => lane)).size - 1;
  const shared = others === 0 ? "" : others === 1 ? " and of 1 other lane" : ` and of ${others} other lanes`;
  const met = linked.length === 0 ? "" : `; ${linked.join(", ")}`;
  return planOf(work, `Moved a vertex of ${nameOf(vertex)}${shared}${met}`);
}

/** Every vertex of the element by the same offset; what joins or borders it follows. */
export function planElementMove(document: MapDocument, key: ElementKey, by: Place): Planned {
  const element = elementOf(document, key);
  if (element === null) return refuse(GONE);
  const work = new Workpiece(document);
  const moved = (point: Place) => rounded({ x: point.x + by.x, y: point.y + by.y });
  if (element.kind === "pedestrian_crossing") {
    moveCrossingVertices(work, element, moved);
    return planOf(work, `Moved ${nameOf(key)}`);
  }
  const targets = new Map<Occurrence, Point>();
  for (const side of ["left", "right"] as const) {
    boundary(element.attributes, side).forEach((point, index) => {
      for (const copy of together(document, { lane: key.id, side, index }))
        targets.set(copy, drawn(moved(point)));
    });
  }
  replacePoints(work, targets);
  return planOf(work, `Moved ${nameOf(key)}`);
}

export function planVertexInsertion(document: MapDocument, vertex: VertexRef, place?: Place): Planned {
  const element = elementOf(document, vertex);
  const line = element && lineOf(element, vertex.side);
  if (element === null || !line) return refuse(GONE);
  if (element.kind === "pedestrian_crossing") return refuse("A crossing's edge has exactly two corners.");
  const from = line[vertex.index];
  const to = line[vertex.index + 1];
  if (from === undefined || to === undefined) return refuse("There is no piece of line after that vertex.");
  const target = drawn(landing(document, place ?? middle(from, to)));
  const work = new Workpiece(document);
  for (const copy of occurrencesAt(document, from)) {
    const lane = work.lane(copy.lane);
    if (lane === null) continue;
    // A lane may hold the piece twice (once on each side), so look the vertex up again in what is there now.
    const current = boundary(lane, copy.side);
    for (let index = 1; index < current.length; index++) {
      const a = current[index - 1];
      const b = current[index];
      if ((samePlace(a, from) && samePlace(b, to)) || (samePlace(a, to) && samePlace(b, from))) {
        work.putLane(withBoundary(lane, copy.side, current.toSpliced(index, 0, target)));
        break;
      }
    }
  }
  return planOf(work, `Added a vertex to ${nameOf(vertex)}`, selected(vertex, vertex.index + 1));
}

export function planVertexRemoval(document: MapDocument, vertex: VertexRef): Planned {
  const element = elementOf(document, vertex);
  const line = element && lineOf(element, vertex.side);
  if (element === null || !line?.[vertex.index]) return refuse(GONE);
  if (element.kind === "pedestrian_crossing" || !isSide(vertex.side)) {
    return refuse("A crossing needs its four corners.");
  }
  const copies = together(document, { lane: vertex.id, side: vertex.side, index: vertex.index });
  const ends = copies.filter(({ where }) => where !== "inside");
  if (ends.length > 0 && (ends.length < copies.length || isJoint(document, copies))) {
    return refuse("Lanes meet at this vertex. Move it instead.");
  }
  const work = new Workpiece(document);
  for (const { lane: id, side, index } of copies) {
    const lane = work.lane(id);
    if (lane === null) continue;
    const shorter = boundary(lane, side).toSpliced(index, 1);
    if (shorter.length < 2) return refuse("A boundary needs at least two vertices.");
    work.putLane(withBoundary(lane, side, shorter));
  }
  const next = Math.min(vertex.index, line.length - 2);
  return planOf(work, `Removed a vertex of ${nameOf(vertex)}`, selected(vertex, next));
}

/** Puts one point in the place of all the given copies. */
export function moveCopies(work: Workpiece, copies: readonly Occurrence[], point: Point): void {
  replacePoints(work, new Map(copies.map((copy) => [copy, point])));
}

function replacePoints(work: Workpiece, targets: ReadonlyMap<Occurrence, Point>): void {
  const lines = new Map<string, { lane: number; side: "left" | "right"; line: Point[] }>();
  for (const [{ lane: id, side, index }, point] of targets) {
    const lane = work.lane(id);
    if (lane === null) continue;
    const text = `${id}:${side}`;
    const entry = lines.get(text) ?? { lane: id, side, line: [...boundary(lane, side)] };
    if (!samePlace(entry.line[index], point)) entry.line[index] = point;
    lines.set(text, entry);
  }
  for (const { lane: id, side, line } of lines.values()) {
    const lane = work.lane(id);
    if (lane !== null) work.putLane(withBoundary(lane, side, line));
  }
}

function moveCrossingVertices(
  work: Workpiece,
  element: Extract<NonNullable<ReturnType<typeof elementOf>>, { kind: "pedestrian_crossing" }>,
  target: (point: Point) => Place | null,
): void {
  const moved = (line: Line) =>
    line.map((point) => {
      const to = target(point);
      return to === null || samePlace(to, point) ? point : drawn(to);
    });
  const { edge1, edge2 } = element.attributes;
  work.put({ ...element, attributes: { ...element.attributes, edge1: moved(edge1), edge2: moved(edge2) } });
}

function selected(vertex: VertexRef, index: number) {
  return { kind: vertex.kind, id: vertex.id, side: vertex.side, vertex: { side: vertex.side, index } };
}
