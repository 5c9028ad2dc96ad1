/** Cutting a lane where a property changes half-way, joining what was cut, and taking a cut back. */
import type { MapDocument } from "../document";
import type { Lane, Line, Place, Side } from "../elements";
import { cutLane, jointAt, SAME_PLACE_METRES, SHORTEST_PART_METRES, stationOf } from "../joint";
import { boundary, sameLine, samePlace, withBoundary } from "../lines";
import { partsOf } from "../parts";
import { GONE, type Planned, refuse, selectionOf } from "../plan";
import { planOf } from "../planOf";
import { at, distance, lengthOf, nearestOnLine, nearestOnSegment } from "../polyline";
import { linkedLanes, occurrencesAt } from "../topology";
import { Workpiece } from "../workpiece";
import { removeLane } from "./links";
import { exchangeLanes, restoreNeighbors } from "./series";

type Way = "before" | "after";

const SIDES: readonly Side[] = ["left", "right"];

const NEAR_END = "Cut farther from the ends of the lane: a part is at least half a metre long.";
const TOO_SHORT = "This lane is too short to cut: a part is at least half a metre long on both sides.";

/** How many new ids a cut of the lane takes: the parts of an imported lane are two lanes under new ids. */
export function idsForCut(base: MapDocument, id: number): number {
  return base.lanes.has(id) ? 2 : 1;
}

/** `reach`: metres around the place within which the joint goes onto a vertex. `newIds`: as many as `idsForCut` says. */
export function planCut(
  base: MapDocument,
  document: MapDocument,
  id: number,
  place: Place,
  reach: number,
  newIds: readonly number[],
): Planned {
  const lane = document.lanes.get(id);
  if (lane === undefined) return refuse(GONE);
  const joint = jointAt(document, lane, place, reach);
  if (joint === null) return refuse(tooShort(lane) ? TOO_SHORT : NEAR_END);
  const imported = base.lanes.has(id);
  const part_of = imported ? id : lane.part_of;
  const [one = id, other = id] = imported ? newIds : [id, ...newIds];
  const [before, after] = cutLane(lane, joint);
  const work = new Workpiece(document);
  exchangeLanes(
    work,
    base,
    [lane],
    [
      { ...before, id: one, part_of },
      { ...after, id: other, part_of },
    ],
  );
  const note = `Cut lane ${id} into ${one} and ${other}`;
  return planOf(work, note, selectionOf({ kind: "lane_segment", id: other }));
}

function tooShort(lane: Lane): boolean {
  return SIDES.some((side) => lengthOf(boundary(lane, side)) < 2 * SHORTEST_PART_METRES);
}

/** The lane and the one that it is in series with, behind or before it, made one. */
export function planJoin(base: MapDocument, document: MapDocument, id: number): Planned {
  const lane = document.lanes.get(id);
  if (lane === undefined) return refuse(GONE);
  const pairs = [onlyLink(document, lane, "after"), onlyLink(document, lane, "before")].flatMap(
    (other, index): [Lane, Lane][] => (other === null ? [] : [index === 0 ? [lane, other] : [other, lane]]),
  );
  // What was cut from it comes first, also where it cannot be joined yet: that is what is meant.
  pairs.sort((a, b) => Number(areParts(base, ...b)) - Number(areParts(base, ...a)));
  const [first] = pairs;
  if (first === undefined) {
    return refuse(`Lane ${id} is in series with no lane: only what follows one another alone can be joined.`);
  }
  const fitting = pairs.find((pair) => hindrance(base, ...pair) === null);
  if (fitting === undefined) return refuse(hindrance(base, ...first) ?? GONE);
  const [one, other] = fitting;
  const work = new Workpiece(document);
  const joined = joinedLane(base, document, one, other);
  exchangeLanes(work, base, [one, other], [joined]);
  if (joined.id === one.part_of) restoreNeighbors(work, base, joined.id);
  const note =
    joined.id === one.part_of
      ? `Joined the parts: lane ${joined.id} is whole again`
      : `Joined lanes ${one.id} and ${other.id}: lane ${joined.id}`;
  return planOf(work, note, selectionOf({ kind: "lane_segment", id: joined.id }));
}

/** The lane that alone follows (precedes) another, and that it alone precedes (follows). */
function onlyLink(document: MapDocument, lane: Lane, way: Way): Lane | null {
  const others = [...linkedLanes(document, lane.id, way)];
  const [other = -1] = others;
  const back = linkedLanes(document, other, way === "after" ? "before" : "after");
  return others.length === 1 && back.size === 1 && other !== lane.id
    ? (document.lanes.get(other) ?? null)
    : null;
}

/** Why two lanes in series stay two; null: they can be joined. */
function hindrance(base: MapDocument, one: Lane, other: Lane): string | null {
  const names = `Lanes ${one.id} and ${other.id}`;
  if (!areParts(base, one, other)) {
    return `${names} are not parts of one cut lane: the imported map has two lanes there, so they stay two.`;
  }
  const differing = [
    one.left_lane_mark_type !== other.left_lane_mark_type && "the left mark",
    one.right_lane_mark_type !== other.right_lane_mark_type && "the right mark",
    one.lane_type !== other.lane_type && "the type",
    one.is_intersection !== other.is_intersection && "the intersection",
  ].filter((word) => word !== false);
  if (differing.length === 0) return null;
  return `${names} differ in ${differing.join(", ")}: make that the same first, then join them.`;
}

/** Whether both are parts of one imported lane, or both drawn in this task. */
function areParts(base: MapDocument, one: Lane, other: Lane): boolean {
  return ![one, other].some(({ id }) => base.lanes.has(id)) && one.part_of === other.part_of;
}

/** The whole imported lane when these were its last two parts, else a lane under the first one's id. */
function joinedLane(base: MapDocument, document: MapDocument, one: Lane, other: Lane): Lane {
  const whole = one.part_of === null ? undefined : base.lanes.get(one.part_of);
  const lasts =
    whole !== undefined &&
    partsOf(document, whole.id).length === 2 &&
    reaches(base, document, one, whole, "before") &&
    reaches(base, document, other, whole, "after");
  let joined = one;
  for (const side of SIDES) {
    const imported = whole && boundary(whole, side);
    joined = withBoundary(joined, side, joinedLine(document, [one, other], side, imported));
  }
  return lasts ? { ...joined, id: whole.id, part_of: whole.part_of } : joined;
}

/** Whether a part lies at the whole lane's end; where a part is missing, it does not. */
function reaches(base: MapDocument, document: MapDocument, part: Lane, whole: Lane, way: Way): boolean {
  const imported = linkedLanes(base, whole.id, way);
  if ([...linkedLanes(document, part.id, way)].some((id) => imported.has(id))) return true;
  return SIDES.every((side) => {
    const line = boundary(whole, side);
    const station = stationOf(line, at(boundary(part, side), way === "before" ? 0 : -1));
    return (way === "before" ? station : lengthOf(line) - station) < SHORTEST_PART_METRES;
  });
}

/** The imported line itself where nothing but the joint has come to it. */
function joinedLine(
  document: MapDocument,
  [one, other]: readonly [Lane, Lane],
  side: Side,
  imported: Line | undefined,
): Line {
  const before = boundary(one, side);
  const after = boundary(other, side);
  const joint = before.at(-1);
  const [from, to] = [before.at(-2), after[1]];
  if (joint === undefined || from === undefined || to === undefined) return before;
  const straight = [...before.slice(0, -1), ...after.slice(1)];
  if (imported !== undefined && nearestOnLine(joint, imported).distance <= SAME_PLACE_METRES) {
    const others = imported.filter((point) => distance(point, joint) > SAME_PLACE_METRES);
    if (sameLine(straight, others)) return imported;
  }
  const needed =
    occurrencesAt(document, joint).some(({ lane }) => lane !== one.id && lane !== other.id) ||
    imported?.some((point) => samePlace(point, joint));
  const bends = distance(joint, nearestOnSegment(joint, from, to)) > SAME_PLACE_METRES;
  return needed || bends ? [...before, ...after.slice(1)] : straight;
}

/**
 * Takes the parts of a cut lane out and puts the imported lane back in their place. Parts that are no series any more
 * are only taken out.
 */
export function undoCut(work: Workpiece, base: MapDocument, whole: Lane): void {
  const parts = partsOf(work.document, whole.id);
  if (parts.length > 0) exchangeLanes(work, base, parts, [whole]);
  else
    for (const { id, part_of } of work.document.lanes.values())
      if (part_of === whole.id) removeLane(work, id);
}
