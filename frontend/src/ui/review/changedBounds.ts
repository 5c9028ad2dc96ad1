import type { Workspace } from "../../api/types";

/** Metres of surroundings that make a change readable. */
const MARGIN = 15;

type Places = readonly { x: number; y: number }[];

/** min x, min y, max x, max y of all that a revision changed, with its surroundings; null: it changed nothing. */
export function changedBounds({
  base,
  changed,
  removed,
}: Pick<Workspace, "base" | "changed" | "removed">): readonly number[] | null {
  const gone = (kind: string, id: number) => removed.some((key) => key.kind === kind && key.id === id);
  const lanes = [
    ...changed.lanes,
    ...base.lanes.filter(({ attributes }) => gone("lane_segment", attributes.id)),
  ];
  const crossings = [
    ...changed.crossings,
    ...base.crossings.filter(({ attributes }) => gone("pedestrian_crossing", attributes.id)),
  ];
  const places: Places = [
    ...lanes.flatMap(({ attributes }) => [
      ...attributes.left_lane_boundary,
      ...attributes.right_lane_boundary,
    ]),
    ...crossings.flatMap(({ attributes }) => [...attributes.edge1, ...attributes.edge2]),
  ];
  if (places.length === 0) return null;
  const xs = places.map(({ x }) => x);
  const ys = places.map(({ y }) => y);
  const min = (values: number[]) => values.reduce((a, b) => Math.min(a, b)) - MARGIN;
  const max = (values: number[]) => values.reduce((a, b) => Math.max(a, b)) + MARGIN;
  return [min(xs), min(ys), max(xs), max(ys)];
}
