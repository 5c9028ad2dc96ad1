/** Lanes in series exchanged for others that cover the same road: what a cut, a join and a cut undone have in common. */
import type { MapDocument } from "../document";
import type { Lane, Side } from "../elements";
import { neighborOf, withNeighbor } from "../lines";
import { sharersOf } from "../topology";
import type { Workpiece } from "../workpiece";

const SIDES: readonly Side[] = ["left", "right"];

/**
 * Takes `old` out and puts `pieces` in their place, both in driving order. Links into the first and out of the last
 * stay, those between the pieces are written on both, and neighbours are found anew on the sides that had one. Ids
 * outside the map are its rim and stay.
 */
export function exchangeLanes(
  work: Workpiece,
  base: MapDocument,
  old: readonly Lane[],
  pieces: readonly Lane[],
): void {
  const [first, last] = [old.at(0), old.at(-1)];
  const [start, end] = [pieces.at(0), pieces.at(-1)];
  if (first === undefined || last === undefined || start === undefined || end === undefined) return;
  const gone = new Set(old.map(({ id }) => id));
  const relinked = (links: readonly number[], from: number, to: number) =>
    links.some((id) => gone.has(id))
      ? links.filter((id) => id === from || !gone.has(id)).map((id) => (id === from ? to : id))
      : links;
  const loose: [id: number, side: Side][] = [];
  for (const lane of work.document.lanes.values()) {
    if (gone.has(lane.id)) continue;
    const successors = relinked(lane.successors, first.id, start.id);
    const predecessors = relinked(lane.predecessors, last.id, end.id);
    let next = lane;
    if (successors !== lane.successors || predecessors !== lane.predecessors)
      next = { ...lane, successors, predecessors };
    for (const side of SIDES) {
      if (!gone.has(neighborOf(next, side) ?? -1)) continue;
      next = withNeighbor(next, side, null);
      loose.push([lane.id, side]);
    }
    if (next !== lane) work.putLane(next);
  }
  const rim = (id: number | null) =>
    id !== null && !base.lanes.has(id) && work.lane(id) === null ? id : null;
  pieces.forEach((piece, index) => {
    const [before, after] = [pieces[index - 1], pieces[index + 1]];
    work.putLane({
      ...piece,
      predecessors: before === undefined ? relinked(first.predecessors, last.id, end.id) : [before.id],
      successors: after === undefined ? relinked(last.successors, first.id, start.id) : [after.id],
      left_neighbor_id: rim(piece.left_neighbor_id),
      right_neighbor_id: rim(piece.right_neighbor_id),
    });
    for (const side of SIDES) if (hadNeighbor(base, piece, old, side)) loose.push([piece.id, side]);
  });
  const replaced = new Set(pieces.map(({ id }) => id));
  for (const id of gone) if (!replaced.has(id)) work.remove({ kind: "lane_segment", id });
  for (const [id, side] of loose) findNeighbor(work, id, side);
}

/** Whether a lane's side may look for a neighbour: it had one, now or as imported, or was drawn in this task. */
function hadNeighbor(base: MapDocument, piece: Lane, old: readonly Lane[], side: Side): boolean {
  const imported = base.lanes.get(piece.part_of ?? piece.id);
  return [imported, ...old].some((lane) => lane === undefined || neighborOf(lane, side) !== null);
}

export function findNeighbors(work: Workpiece, id: number): void {
  for (const side of SIDES) findNeighbor(work, id, side);
}

/** Whoever has the same line on its other side, and nobody beside it there, is the lane's neighbour. */
function findNeighbor(work: Workpiece, id: number, side: Side): void {
  const lane = work.lane(id);
  if (lane === null || neighborOf(lane, side) !== null) return;
  for (const sharer of sharersOf(work.document, lane, side)) {
    const other = work.lane(sharer.lane);
    const oncoming = sharer.side === side;
    if (other === null || !sharer.across || (oncoming && side === "right")) continue;
    if (neighborOf(other, sharer.side) !== null) continue;
    work.putLane(withNeighbor(lane, side, other.id), withNeighbor(other, sharer.side, id));
    return;
  }
}

/** Neighbour ids as imported on a lane that is whole again, and on those beside it; drawn lanes and parts stay. */
export function restoreNeighbors(work: Workpiece, base: MapDocument, id: number): void {
  for (const imported of base.lanes.values()) {
    for (const side of SIDES) {
      const lane = work.lane(imported.id);
      const was = neighborOf(imported, side);
      const now = lane && neighborOf(lane, side);
      if (lane === null || now === was || ![imported.id, was, now].includes(id)) continue;
      if (now !== null && !base.lanes.has(now)) continue;
      const missing = was !== null && base.lanes.has(was) && work.lane(was) === null;
      work.putLane(withNeighbor(lane, side, missing ? null : was));
    }
  }
}
