/**
 * A small road for tests, with the traps of real maps: shared and oncoming boundaries, a fork, one-sided
 * predecessors, rim ids, a two-way street of two lanes lying on each other.
 *
 *      x = 0        40        80     100        140
 *   y 10.5  ───6◄───┬───5◄────┐
 *      7.0  ════════╪═════════╪─9►────┬──11►─────    (centre line, painted double yellow)
 *      3.5  ─ ─3►─ ─┼─ ─4►─ ─ ┼       │
 *             ─1►───┼───2►────┼─7►────┴──10►─────
 *      0.0  ════════╧═════════╧ 8 turns right ──► 12 southwards
 *
 * Crossing 1 (same id as lane 1) runs north at x = 60. Lanes 20 and 21 lie on each other at y = 40.
 */
import type { Crossing, Lane, Line, Place } from "./elements";
import type { EditorWorkspace, WireMap } from "./wire";

export function line(...places: readonly (readonly [number, number])[]): Line {
  return places.map(([x, y]) => ({ x, y, z: 12.25 + x / 64 }));
}

function straight(y: number, from: number, to: number): Line {
  const step = (to - from) / 4;
  return line(...[0, 1, 2, 3, 4].map((i): [number, number] => [from + i * step, y]));
}

type LaneSketch = Pick<Lane, "id"> & Partial<Lane> & { left: Line; right: Line };

function lane({ left, right, ...rest }: LaneSketch): Lane {
  return {
    is_intersection: false,
    lane_type: "VEHICLE",
    left_lane_boundary: left,
    left_lane_mark_type: "NONE",
    right_lane_boundary: right,
    right_lane_mark_type: "NONE",
    successors: [],
    predecessors: [],
    right_neighbor_id: null,
    left_neighbor_id: null,
    part_of: null,
    ...rest,
  };
}

const DIVIDER = {
  outer: { left_lane_mark_type: "SOLID_DASH_WHITE" },
  inner: { right_lane_mark_type: "DASH_SOLID_WHITE" },
} as const;
const CENTRE = { left_lane_mark_type: "DOUBLE_SOLID_YELLOW" } as const;
const EDGE = { right_lane_mark_type: "SOLID_WHITE" } as const;

export const LANES: readonly Lane[] = [
  lane({
    id: 1,
    left: straight(3.51, 0, 40),
    right: straight(0.07, 0, 40),
    ...DIVIDER.outer,
    ...EDGE,
    successors: [2],
    predecessors: [901],
    left_neighbor_id: 3,
  }),
  lane({
    id: 2,
    left: straight(3.51, 40, 80),
    right: straight(0.07, 40, 80),
    ...DIVIDER.outer,
    ...EDGE,
    successors: [7, 8],
    predecessors: [1],
    left_neighbor_id: 4,
  }),
  lane({
    id: 3,
    left: straight(7.03, 0, 40),
    right: straight(3.51, 0, 40),
    ...DIVIDER.inner,
    ...CENTRE,
    successors: [4],
    predecessors: [],
    left_neighbor_id: 6,
    right_neighbor_id: 1,
  }),
  lane({
    id: 4,
    left: straight(7.03, 40, 80),
    right: straight(3.51, 40, 80),
    ...DIVIDER.inner,
    ...CENTRE,
    successors: [9],
    predecessors: [3],
    left_neighbor_id: 5,
    right_neighbor_id: 2,
  }),
  lane({
    id: 5,
    left: straight(7.03, 40, 80).toReversed(),
    right: straight(10.49, 80, 40),
    ...CENTRE,
    ...EDGE,
    successors: [6],
    left_neighbor_id: 4,
  }),
  lane({
    id: 6,
    left: straight(7.03, 0, 40).toReversed(),
    right: straight(10.49, 40, 0),
    ...CENTRE,
    ...EDGE,
    successors: [902],
    predecessors: [5],
    left_neighbor_id: 3,
  }),
  lane({
    id: 7,
    is_intersection: true,
    left: line([80, 3.51], [100, 3.51]),
    right: line([80, 0.07], [90, 0.07], [100, 0.07]),
    successors: [10],
    predecessors: [2],
    left_neighbor_id: 9,
  }),
  lane({
    id: 8,
    is_intersection: true,
    left: line([80, 3.51], [85.2, 2.33], [88.4, -1.1], [89.5, -6]),
    right: line([80, 0.07], [83.1, -0.8], [85.3, -3.1], [86, -6]),
    successors: [12],
    predecessors: [2],
  }),
  lane({
    id: 9,
    is_intersection: true,
    left: line([80, 7.03], [100, 7.03]),
    right: line([80, 3.51], [100, 3.51]),
    successors: [11],
    predecessors: [4],
    right_neighbor_id: 7,
  }),
  lane({
    id: 10,
    left: line([100, 3.51], [140, 3.51]),
    right: line([100, 0.07], [120, 0.02], [140, 0.07]),
    left_lane_mark_type: "DASHED_WHITE",
    ...EDGE,
    successors: [903],
    predecessors: [7],
    left_neighbor_id: 11,
  }),
  lane({
    id: 11,
    left: line([100, 7.03], [140, 7.03]),
    right: line([100, 3.51], [140, 3.51]),
    right_lane_mark_type: "DASHED_WHITE",
    successors: [],
    predecessors: [9],
    right_neighbor_id: 10,
  }),
  lane({ id: 12, left: line([89.5, -6], [89.5, -30]), right: line([86, -6], [86, -30]), predecessors: [8] }),
  lane({ id: 20, left: straight(43.2, 0, 40), right: straight(40, 0, 40) }),
  lane({ id: 21, left: straight(40, 0, 40).toReversed(), right: straight(43.2, 0, 40).toReversed() }),
];

export const CROSSINGS: readonly Crossing[] = [
  { id: 1, edge1: line([58.5, -1], [58.5, 11.2]), edge2: line([61.5, -1], [61.5, 11.2]) },
];

export function wireMap(lanes: readonly Lane[], crossings: readonly Crossing[]): WireMap {
  const copy = (points: Line) => points.map(({ x, y, z }) => ({ x, y, z }));
  return {
    lanes: lanes.map((one) => ({
      version: 0,
      attributes: {
        ...one,
        left_lane_boundary: copy(one.left_lane_boundary),
        right_lane_boundary: copy(one.right_lane_boundary),
      },
    })),
    crossings: crossings.map((one) => ({
      version: 0,
      attributes: { id: one.id, edge1: copy(one.edge1), edge2: copy(one.edge2) },
    })),
  };
}

export function workspaceOf(options: { canEdit?: boolean } = {}): EditorWorkspace {
  return {
    task: { can_edit: options.canEdit ?? true },
    revision: 0,
    base: wireMap(LANES, CROSSINGS),
    changed: { lanes: [], crossings: [] },
    removed: [],
    declarations: [],
  };
}

/** Hands out 1000 ids a block, from 90,000,001 on. */
export function idBlocks(): () => Promise<{ first_id: number; last_id: number }> {
  let next = 90_000_001;
  return () => {
    const block = { first_id: next, last_id: next + 999 };
    next += 1000;
    return Promise.resolve(block);
  };
}

export function at(lineOfPlaces: readonly Place[], index: number): [number, number] {
  const place = lineOfPlaces.at(index);
  if (place === undefined) throw new RangeError(`no vertex ${index}`);
  return [place.x, place.y];
}

/** Why an action was refused; empty when it was not. */
export function reasonOf(outcome: { readonly ok: boolean; readonly reason?: string }): string {
  return outcome.reason ?? "";
}
