/** One element as it was imported, with the lines and joints that it shares. */
import { elementOf, type MapDocument } from "../document";
import type { ElementKey, Lane, Line, Side } from "../elements";
import { boundary, markOf, neighborOf, sameLine, samePlace, withBoundary, withNeighbor } from "../lines";
import { baseCutAlike, partsOf } from "../parts";
import { GONE, nameOf, type Planned, refuse, selectionOf } from "../plan";
import { planOf } from "../planOf";
import { sharersOf, together } from "../topology";
import { Workpiece } from "../workpiece";
import { undoCut } from "./cuts";
import { withoutMention } from "./links";
import { paint, planDeletion } from "./properties";
import { moveCopies } from "./vertices";

const SIDES: readonly Side[] = ["left", "right"];

export function planRevert(base: MapDocument, document: MapDocument, element: ElementKey): Planned {
  const key = wholeOf(base, document, element);
  const original = elementOf(base, key);
  if (original === null) {
    const deletion = planDeletion(document, key);
    return "refused" in deletion
      ? deletion
      : { ...deletion, note: `Took back the insertion of ${nameOf(key)}` };
  }
  const note = `Reverted ${nameOf(key)} to the imported map`;
  const work = new Workpiece(document);
  if (original.kind === "pedestrian_crossing") {
    work.put(original);
    return planOf(work, note, selectionOf(key));
  }
  revertParts(work, base, key.id);
  undoCut(work, base, original.attributes);
  if (work.lane(key.id) === null) work.putLane(withoutMentionOfMissing(original.attributes, base, document));
  revertLinks(work, base, original.attributes);
  for (const side of SIDES) {
    revertBoundary(work, base, original.attributes, side);
    const lane = work.lane(key.id);
    if (lane === null) return refuse(GONE);
    paint(work, lane, side, markOf(original.attributes, side));
  }
  const { lane_type, is_intersection } = original.attributes;
  const lane = work.lane(key.id);
  if (lane === null) return refuse(GONE);
  if (lane.lane_type !== lane_type || lane.is_intersection !== is_intersection) {
    work.putLane({ ...lane, lane_type, is_intersection });
  }
  return planOf(work, note, selectionOf(key));
}

/** The imported lane of a part; any other element itself. */
function wholeOf(base: MapDocument, document: MapDocument, key: ElementKey): ElementKey {
  const whole = key.kind === "lane_segment" ? (document.lanes.get(key.id)?.part_of ?? null) : null;
  return whole !== null && base.lanes.has(whole) && !base.lanes.has(key.id)
    ? { kind: key.kind, id: whole }
    : key;
}

/** The parts' lines and paint as imported, while parts of lanes beside them still share these. */
function revertParts(work: Workpiece, base: MapDocument, whole: number): void {
  const alike = baseCutAlike(base, work.document);
  for (const { id } of partsOf(work.document, whole)) {
    const piece = alike.lanes.get(id);
    if (piece === undefined) continue;
    for (const side of SIDES) {
      revertBoundary(work, alike, piece, side);
      const part = work.lane(id);
      if (part !== null) paint(work, part, side, markOf(piece, side));
    }
  }
}

/** Ids outside the imported map are its rim and stay; ids of lanes deleted since go. */
function withoutMentionOfMissing(lane: Lane, base: MapDocument, document: MapDocument): Lane {
  const mentioned = [
    ...lane.successors,
    ...lane.predecessors,
    ...SIDES.flatMap((side) => neighborOf(lane, side) ?? []),
  ];
  return mentioned
    .filter((id) => base.lanes.has(id) && !document.lanes.has(id))
    .reduce((result, id) => withoutMention(result, id), lane);
}

/** Links as imported, on both lanes; links with lanes inserted since stay, they are those lanes' story. */
function revertLinks(work: Workpiece, base: MapDocument, original: Lane): void {
  const id = original.id;
  for (const imported of base.lanes.values()) {
    const other = work.lane(imported.id);
    if (other === null || imported.id === id) continue;
    const reverted = mentionsAs(imported, other, id);
    if (reverted !== other) work.putLane(reverted);
  }
  const lane = work.lane(id);
  if (lane === null) return;
  const wanted = withoutMentionOfMissing(original, base, work.document);
  const added = (ids: readonly number[]) =>
    ids.filter((other) => !base.lanes.has(other) && work.lane(other) !== null);
  const together = (imported: readonly number[], now: readonly number[]) => {
    const all = [...imported, ...added(now).filter((other) => !imported.includes(other))];
    return all.length === now.length && all.every((other, index) => other === now[index]) ? now : all;
  };
  let result: Lane = {
    ...lane,
    successors: together(wanted.successors, lane.successors),
    predecessors: together(wanted.predecessors, lane.predecessors),
  };
  for (const side of SIDES) {
    const now = neighborOf(lane, side);
    if (now === null || added([now]).length === 0)
      result = withNeighbor(result, side, neighborOf(wanted, side));
  }
  work.putLane(same(result, lane) ? lane : same(result, original) ? original : result);
}

function same(a: Lane, b: Lane): boolean {
  const lists = (one: readonly number[], other: readonly number[]) =>
    one.length === other.length && one.every((id, index) => id === other[index]);
  return (
    lists(a.successors, b.successors) &&
    lists(a.predecessors, b.predecessors) &&
    a.left_neighbor_id === b.left_neighbor_id &&
    a.right_neighbor_id === b.right_neighbor_id &&
    a.left_lane_boundary === b.left_lane_boundary &&
    a.right_lane_boundary === b.right_lane_boundary &&
    a.left_lane_mark_type === b.left_lane_mark_type &&
    a.right_lane_mark_type === b.right_lane_mark_type &&
    a.lane_type === b.lane_type &&
    a.is_intersection === b.is_intersection
  );
}

/** `other` with its mentions of `id` as imported, in the imported order. */
function mentionsAs(imported: Lane, other: Lane, id: number): Lane {
  const list = (was: readonly number[], now: readonly number[]) => {
    if (was.includes(id) === now.includes(id)) return now;
    if (!was.includes(id)) return now.filter((one) => one !== id);
    const place = was.slice(0, was.indexOf(id)).filter((one) => now.includes(one)).length;
    return now.toSpliced(place, 0, id);
  };
  const successors = list(imported.successors, other.successors);
  const predecessors = list(imported.predecessors, other.predecessors);
  let result =
    successors === other.successors && predecessors === other.predecessors
      ? other
      : { ...other, successors, predecessors };
  for (const side of SIDES) {
    const was = neighborOf(imported, side);
    const now = neighborOf(result, side);
    if (was === id && now === null) result = withNeighbor(result, side, id);
    if (was !== id && now === id) result = withNeighbor(result, side, null);
  }
  return result;
}

/** The boundary as imported, in all lanes that shared it then or share it now; joints follow. */
function revertBoundary(work: Workpiece, base: MapDocument, original: Lane, side: Side): void {
  const line = boundary(original, side);
  const now = work.lane(original.id);
  if (now === null) return;
  const copies: Restored[] = [{ lane: original.id, side, line }];
  for (const sharer of sharersOf(base, original, side)) {
    const imported = base.lanes.get(sharer.lane);
    if (imported !== undefined)
      copies.push({ lane: sharer.lane, side: sharer.side, line: boundary(imported, sharer.side) });
  }
  for (const sharer of sharersOf(work.document, now, side)) {
    if (copies.some((copy) => copy.lane === sharer.lane && copy.side === sharer.side)) continue;
    copies.push({ lane: sharer.lane, side: sharer.side, line: sharer.reversed ? line.toReversed() : line });
  }
  const isCopy = (lane: number, name: Side) =>
    copies.some((copy) => copy.lane === lane && copy.side === name);
  for (const copy of copies) moveOthersAlong(work, copy, isCopy);
  for (const copy of copies) {
    const lane = work.lane(copy.lane);
    if (lane === null || sameLine(boundary(lane, copy.side), copy.line)) continue;
    work.putLane(withBoundary(lane, copy.side, copy.line));
  }
  for (const index of [0, -1] as const) pullJoint(work, base, original, side, index);
}

interface Restored {
  readonly lane: number;
  readonly side: Side;
  readonly line: Line;
}

/** Vertices of other lines that lie on this one go to where its vertices go. */
function moveOthersAlong(
  work: Workpiece,
  { lane: id, side, line }: Restored,
  isCopy: (lane: number, side: Side) => boolean,
): void {
  const lane = work.lane(id);
  if (lane === null) return;
  const current = boundary(lane, side);
  const indices = current.length === line.length ? current.map((_, index) => index) : [0, current.length - 1];
  for (const index of indices) {
    const target = index === current.length - 1 ? line.at(-1) : line[index];
    if (target === undefined || samePlace(current[index], target)) continue;
    const others = together(work.document, { lane: id, side, index }).filter(
      (copy) => !isCopy(copy.lane, copy.side),
    );
    moveCopies(work, others, target);
  }
}

/** A lane that comes back, or whose joint others have moved: they meet it again at the imported place. */
function pullJoint(work: Workpiece, base: MapDocument, original: Lane, side: Side, index: 0 | -1): void {
  const line = boundary(original, side);
  const target = line.at(index);
  if (target === undefined) return;
  const at = index === 0 ? 0 : line.length - 1;
  for (const copy of together(base, { lane: original.id, side, index: at })) {
    const other = work.lane(copy.lane);
    if (other === null || copy.where === "inside") continue;
    const current = boundary(other, copy.side);
    const place = copy.where === "start" ? 0 : current.length - 1;
    if (samePlace(current[place], target)) continue;
    moveCopies(work, together(work.document, { lane: copy.lane, side: copy.side, index: place }), target);
  }
}
