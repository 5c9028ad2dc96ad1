/** Boundaries of which another lane holds more than this piece: a cut lane beside one that is whole. */
import type { MapDocument } from "./document";
import type { Lane, Mark, Side } from "./elements";
import { stationOf } from "./joint";
import { boundary, markOf } from "./lines";
import { mirrored } from "./marks";
import { at, lengthOf, nearestOnLine } from "./polyline";

const ON_LINE_METRES = 0.02;
const LONGER_METRES = 0.5;
const SIDES: readonly Side[] = ["left", "right"];

/** Lanes that hold the piece within a longer line, painted otherwise than the lane itself has it now. */
export function paintedOtherwise(document: MapDocument, lane: Lane, side: Side): number[] {
  const line = boundary(lane, side);
  const length = lengthOf(line);
  const found: number[] = [];
  for (const other of document.lanes.values()) {
    if (other.id === lane.id) continue;
    for (const otherSide of SIDES) {
      const longer = boundary(other, otherSide);
      if (lengthOf(longer) < length + LONGER_METRES) continue;
      if (line.some((point) => nearestOnLine(point, longer).distance > ON_LINE_METRES)) continue;
      const reversed = stationOf(longer, at(line, 0)) > stationOf(longer, at(line, -1));
      const across = (side === otherSide) === reversed;
      const seen: Mark = across ? mirrored(markOf(lane, side)) : markOf(lane, side);
      if (markOf(other, otherSide) !== seen) found.push(other.id);
    }
  }
  return found;
}
