/** Recorded cuts: a lane of the imported map that is there in parts is compared part by part. */
import type { MapDocument } from "./document";
import type { Lane } from "./elements";
import { cutLane } from "./joint";
import { at } from "./polyline";
import { linkedLanes } from "./topology";

/** The parts of a lane in driving order; empty when they are not one series of two or more. */
export function partsOf(document: MapDocument, whole: number): Lane[] {
  const parts = new Map([...document.lanes].filter(([, lane]) => lane.part_of === whole));
  if (parts.size < 2) return [];
  const follows = (lane: Lane) => [...linkedLanes(document, lane.id, "before")].some((id) => parts.has(id));
  let next = [...parts.values()].find((lane) => !follows(lane));
  const series: Lane[] = [];
  while (next !== undefined && !series.includes(next)) {
    series.push(next);
    const after = [...linkedLanes(document, next.id, "after")].filter((id) => parts.has(id));
    next = after.length === 1 ? parts.get(after[0] ?? -1) : undefined;
  }
  return series.length === parts.size ? series : [];
}

const remembered = new WeakMap<MapDocument["lanes"], { base: MapDocument; cut: MapDocument }>();

/** The imported map, each lane of which the edited map has only the parts cut at the same joints. */
export function baseCutAlike(base: MapDocument, current: MapDocument): MapDocument {
  const known = remembered.get(current.lanes);
  if (known?.base === base) return known.cut;
  const cut = cutAlike(base, current);
  remembered.set(current.lanes, { base, cut });
  return cut;
}

function cutAlike(base: MapDocument, current: MapDocument): MapDocument {
  const wholes = new Set<number>();
  for (const { part_of } of current.lanes.values()) {
    if (part_of !== null && base.lanes.has(part_of) && !current.lanes.has(part_of)) wholes.add(part_of);
  }
  if (wholes.size === 0) return base;
  const lanes = new Map(base.lanes);
  for (const id of wholes) {
    const whole = base.lanes.get(id);
    const parts = partsOf(current, id);
    if (whole === undefined || parts.length === 0) continue;
    lanes.delete(id);
    for (const piece of pieces(whole, parts)) lanes.set(piece.id, piece);
  }
  return { ...base, lanes };
}

/** The whole cut where its parts meet, under the parts' ids. */
function pieces(whole: Lane, parts: readonly Lane[]): Lane[] {
  const cut: Lane[] = [];
  let rest = whole;
  parts.forEach((part, index) => {
    const named = { id: part.id, part_of: whole.id };
    if (index === parts.length - 1) {
      cut.push({ ...rest, ...named });
      return;
    }
    const joint = { left: at(part.left_lane_boundary, -1), right: at(part.right_lane_boundary, -1) };
    const [piece, after] = cutLane(rest, joint);
    cut.push({ ...piece, ...named });
    rest = after;
  });
  return cut;
}
