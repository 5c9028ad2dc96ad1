/** What must hold of every map that the editor can lead to, given the imported one. For tests. */
import type { MapDocument } from "./document";
import type { Lane, Place, Side } from "./elements";
import { boundary, hasRepeatedVertex, markOf, neighborOf, sameLine, sameLineReversed } from "./lines";
import { mirrored } from "./marks";
import { linkedLanes, sharersOf } from "./topology";

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
