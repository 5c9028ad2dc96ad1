/** Net edits between two map states, and edits put onto one. */
import { type Change, differingKeys, elementOf, type MapDocument } from "./document";
import type { Crossing, ElementKey, Lane, Line, MapElement } from "./elements";
import { differingAttributes, equalElements, equalLines, LANE_ATTRIBUTES } from "./equality";
import { nameOf } from "./plan";
import { readCrossing, readLane, Unreadable } from "./read";
import type { Edit, EditAttributes, ReceivedEdit, WirePoint } from "./wire";
import { Workpiece } from "./workpiece";

/** The smallest edits that turn `before` into `after`: deletes, updates, inserts, each by kind and id. */
export function editsBetween(before: MapDocument, after: MapDocument): Edit[] {
  const deletes: Edit[] = [];
  const updates: Edit[] = [];
  const inserts: Edit[] = [];
  for (const key of differingKeys(before, after)) {
    const was = elementOf(before, key);
    const now = elementOf(after, key);
    if (now === null) deletes.push({ operation: "delete", ...key, attributes: {} });
    else if (was === null) inserts.push({ operation: "insert", ...key, attributes: allAttributes(now) });
    else if (!equalElements(was, now)) {
      updates.push({ operation: "update", ...key, attributes: changedAttributes(was, now) });
    }
  }
  return [...deletes, ...updates, ...inserts];
}

function wireLine(line: Line): WirePoint[] {
  return line.map(({ x, y, z }) => ({ x, y, z }));
}

function allAttributes(element: MapElement): EditAttributes {
  if (element.kind === "pedestrian_crossing") {
    return { edge1: wireLine(element.attributes.edge1), edge2: wireLine(element.attributes.edge2) };
  }
  const omitted = element.attributes.part_of === null ? ["id", "part_of"] : ["id"];
  return laneAttributes(
    element.attributes,
    LANE_ATTRIBUTES.filter((name) => !omitted.includes(name)),
  );
}

function changedAttributes(was: MapElement, now: MapElement): EditAttributes {
  if (was.kind === "lane_segment" && now.kind === "lane_segment") {
    return laneAttributes(now.attributes, differingAttributes(was.attributes, now.attributes));
  }
  if (was.kind === "pedestrian_crossing" && now.kind === "pedestrian_crossing") {
    return changedEdges(was.attributes, now.attributes);
  }
  return {};
}

function changedEdges(was: Crossing, now: Crossing): EditAttributes {
  return {
    ...(equalLines(was.edge1, now.edge1) ? {} : { edge1: wireLine(now.edge1) }),
    ...(equalLines(was.edge2, now.edge2) ? {} : { edge2: wireLine(now.edge2) }),
  };
}

function laneAttributes(lane: Lane, names: readonly (keyof Lane)[]): EditAttributes {
  const wire: Required<Omit<EditAttributes, "edge1" | "edge2">> = {
    is_intersection: lane.is_intersection,
    lane_type: lane.lane_type,
    left_lane_boundary: wireLine(lane.left_lane_boundary),
    left_lane_mark_type: lane.left_lane_mark_type,
    right_lane_boundary: wireLine(lane.right_lane_boundary),
    right_lane_mark_type: lane.right_lane_mark_type,
    successors: [...lane.successors],
    predecessors: [...lane.predecessors],
    right_neighbor_id: lane.right_neighbor_id,
    left_neighbor_id: lane.left_neighbor_id,
    part_of: lane.part_of,
  };
  const wanted: ReadonlySet<string> = new Set(names);
  return Object.fromEntries(Object.entries(wire).filter(([name]) => wanted.has(name)));
}

/** The changes that received edits make to a document, all or none. Throws Unreadable, naming element and mend. */
export function changesOf(document: MapDocument, edits: readonly ReceivedEdit[]): Change[] {
  const work = new Workpiece(document);
  for (const edit of edits) {
    try {
      applyOne(work, edit);
    } catch (error) {
      if (error instanceof Unreadable)
        throw new Unreadable(`${nameOf(edit)}: ${error.message}`, { cause: error });
      throw error;
    }
  }
  return work.changes().filter(({ before, after }) => !equalElements(before, after));
}

function applyOne(work: Workpiece, { operation, kind, id, attributes = {} }: ReceivedEdit): void {
  const key: ElementKey = { kind, id };
  const known = elementOf(work.document, key);
  if (operation === "insert" && known !== null) throw new Unreadable("is inserted but already there");
  if (operation !== "insert" && known === null) throw new Unreadable("is not in the map");
  if (operation === "delete") work.remove(key);
  else if (kind === "lane_segment") {
    work.putLane(readLane(attributes, id, known?.kind === "lane_segment" ? known.attributes : null));
  } else {
    const old = known?.kind === "pedestrian_crossing" ? known.attributes : null;
    work.put({ kind, id, attributes: readCrossing(attributes, id, old) });
  }
}
