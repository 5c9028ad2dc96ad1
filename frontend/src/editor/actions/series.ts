/** Lanes in series exchanged for others that cover the same road: what a cut, a join and a cut undone have in common. */
import type { Lane, Side } from "../elements";
import { neighborOf, withNeighbor } from "../lines";
import { sharersOf } from "../topology";
import type { Workpiece } from "../workpiece";

const SIDES: readonly Side[] = ["left", "right"];

/**
 * Takes `old` out and puts `pieces` in their place, both in driving order. Links into the first and out of the last
 * stay, those between the pieces are written on both, and neighbours are found anew.
 */
export function exchangeLanes(work: Workpiece, old: readonly Lane[], pieces: readonly Lane[]): void {
  const [first, last] = [old.at(0), old.at(-1)];
  const [start, end] = [pieces.at(0), pieces.at(-1)];
  if (first === undefined || last === undefined || start === undefined || end === undefined) return;
  const gone = new Set(old.map(({ id }) => id));
  const relinked = (links: readonly number[], from: number, to: number) =>
    links.some((id) => gone.has(id))
      ? links.filter((id) => id === from || !gone.has(id)).map((id) => (id === from ? to : id))
      : links;
  const loose = new Set(pieces.map(({ id }) => id));
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
      loose.add(lane.id);
    }
    if (next !== lane) work.putLane(next);
  }
  for (const id of gone) work.remove({ kind: "lane_segment", id });
  pieces.forEach((piece, index) => {
    const [before, after] = [pieces[index - 1], pieces[index + 1]];
    work.putLane({
      ...piece,
      predecessors: before === undefined ? relinked(first.predecessors, last.id, end.id) : [before.id],
      successors: after === undefined ? relinked(last.successors, first.id, start.id) : [after.id],
      left_neighbor_id: null,
      right_neighbor_id: null,
    });
  });
  for (const id of loose) findNeighbors(work, id);
}

/** Whoever has the same line on its other side, and nobody beside it there, is the lane's neighbour. */
export function findNeighbors(work: Workpiece, id: number): void {
  for (const side of SIDES) {
    const lane = work.lane(id);
    if (lane === null || neighborOf(lane, side) !== null) continue;
    for (const sharer of sharersOf(work.document, lane, side)) {
      const other = work.lane(sharer.lane);
      const oncoming = sharer.side === side;
      if (other === null || !sharer.across || (oncoming && side === "right")) continue;
      if (neighborOf(other, sharer.side) !== null) continue;
      work.putLane(withNeighbor(lane, side, other.id), withNeighbor(other, sharer.side, id));
      break;
    }
  }
}
