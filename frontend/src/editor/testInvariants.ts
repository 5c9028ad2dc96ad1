/** What must hold of every map that the editor can lead to, given the imported one. For tests. */
import type { MapDocument } from "./document";
import type { Lane, Line, Place, Side } from "./elements";
import {
  boundary,
  hasRepeatedVertex,
  markOf,
  neighborOf,
  sameLine,
  sameLineReversed,
  samePlace,
} from "./lines";
import { mirrored } from "./marks";
import { partsOf } from "./parts";
import { linkedLanes, type Sharer, sharersOf } from "./topology";

const SIDES: readonly Side[] = ["left", "right"];

export function brokenInvariants(base: MapDocument, map: MapDocument): string[] {
  return [
    ...brokenSharing(base, map),
    ...brokenJoints(base, map),
    ...dangling(base, map),
    ...[...map.lanes.values()].flatMap((lane) =>
      SIDES.filter((side) => hasRepeatedVertex(boundary(lane, side))).map(
        (side) => `${lane.id} ${side} repeats`,
      ),
    ),
  ];
}

function brokenSharing(base: MapDocument, map: MapDocument): string[] {
  const broken: string[] = [];
  const compare = (
    lane: Lane,
    side: Side,
    other: Lane,
    otherSide: Side,
    reversed: boolean,
    across: boolean,
  ) => {
    const [a, b] = [boundary(lane, side), boundary(other, otherSide)];
    if (!(reversed ? sameLineReversed(a, b) : sameLine(a, b))) {
      broken.push(`${lane.id} ${side} and ${other.id} ${otherSide} are no longer one line`);
    }
    const seen = across ? mirrored(markOf(lane, side)) : markOf(lane, side);
    if (markOf(other, otherSide) !== seen)
      broken.push(`${lane.id} ${side} is painted otherwise in ${other.id}`);
  };
  for (const imported of base.lanes.values()) {
    for (const side of SIDES) {
      for (const sharer of sharersOf(base, imported, side)) {
        const [lane, other] = [map.lanes.get(imported.id), map.lanes.get(sharer.lane)];
        if (lane && other) compare(lane, side, other, sharer.side, sharer.reversed, sharer.across);
        else broken.push(...partedVertices(map, imported, side, sharer));
      }
    }
  }
  for (const lane of map.lanes.values()) {
    for (const side of SIDES) {
      const other = map.lanes.get(neighborOf(lane, side) ?? -1);
      if (!other || (base.lanes.has(lane.id) && base.lanes.has(other.id))) continue;
      const oncoming = side === "left" && neighborOf(other, "left") === lane.id;
      compare(lane, side, other, oncoming || side === "right" ? "left" : "right", oncoming, true);
    }
  }
  return broken;
}

/** Vertices of a shared imported line that of two lanes, cut or whole, only one still has where it was. */
function partedVertices(map: MapDocument, imported: Lane, side: Side, sharer: Sharer): string[] {
  const [own, others] = [linesOf(map, imported.id, side), linesOf(map, sharer.lane, sharer.side)];
  if (own.length === 0 || others.length === 0) return [];
  return boundary(imported, side)
    .filter((place) => has(own, place) !== has(others, place))
    .map(({ x, y }) => `${imported.id} and ${sharer.lane} no longer share ${x}, ${y}`);
}

/** A boundary of a lane or of its parts; none when some are missing. */
function linesOf(map: MapDocument, id: number, side: Side): Line[] {
  const lane = map.lanes.get(id);
  return (lane === undefined ? partsOf(map, id) : [lane]).map((one) => boundary(one, side));
}

function has(lines: readonly Line[], place: Place): boolean {
  return lines.some((line) => line.some((point) => samePlace(point, place)));
}

function ends(lane: Lane, end: "start" | "end"): (Place | undefined)[] {
  return SIDES.map((side) => boundary(lane, side).at(end === "start" ? 0 : -1));
}

function brokenJoints(base: MapDocument, map: MapDocument): string[] {
  const broken: string[] = [];
  for (const from of map.lanes.values()) {
    for (const id of linkedLanes(map, from.id, "after")) {
      const to = map.lanes.get(id);
      if (to === undefined) continue;
      const [a, b] = [ends(from, "end"), ends(to, "start")];
      if (a.some((place, i) => place?.x !== b[i]?.x || place?.y !== b[i]?.y))
        broken.push(`${from.id} → ${id} gapes`);
    }
  }
  for (const imported of base.lanes.values()) {
    if (!map.lanes.has(imported.id)) continue;
    for (const id of linkedLanes(base, imported.id, "after")) {
      if (map.lanes.has(id) && !linkedLanes(map, imported.id, "after").has(id))
        broken.push(`${imported.id} → ${id} is lost`);
    }
  }
  return broken;
}

function mentionsOf(lane: Lane): number[] {
  return [...lane.successors, ...lane.predecessors, ...SIDES.flatMap((side) => neighborOf(lane, side) ?? [])];
}

function dangling(base: MapDocument, map: MapDocument): string[] {
  const broken: string[] = [];
  const mentioned = [...base.lanes.values()].flatMap(mentionsOf);
  const rim = new Set(mentioned.filter((id) => !base.lanes.has(id)));
  for (const lane of map.lanes.values()) {
    for (const id of mentionsOf(lane)) {
      if (!map.lanes.has(id) && !rim.has(id)) broken.push(`${lane.id} names ${id}, which is gone`);
    }
    if (new Set(lane.successors).size !== lane.successors.length) {
      broken.push(`${lane.id} names a successor twice`);
    }
  }
  return broken;
}
