/** What the tool in hand would make if the cursor were clicked (or Enter pressed) here. */
import { planCrossing, planDrawnLane, planLaneBeside } from "./actions/insertion";
import type { MapDocument } from "./document";
import { type ElementKey, isSide, type MapElement, type Place, type Side } from "./elements";
import { type Joint, jointAt } from "./joint";
import { elementsAt, nearestLineName } from "./picking";
import { isRefusal, type Planned } from "./plan";
import type { EditorState } from "./state";

const NO_ID = -1;

/** The lane under a place, and the side of it that the place is nearer to. */
export function besideTarget(
  document: MapDocument,
  place: Place,
  tolerance: number,
): { lane: number; side: Side } | null {
  for (const key of elementsAt(document, place, tolerance)) {
    const attributes = key.kind === "lane_segment" ? document.lanes.get(key.id) : undefined;
    if (attributes === undefined) continue;
    const side = nearestLineName({ kind: "lane_segment", id: key.id, attributes }, place)?.name;
    if (side !== undefined && isSide(side)) return { lane: key.id, side };
  }
  return null;
}

/** The lane that a click would cut: the selected one if it lies there, else the topmost. */
export function cutTarget(
  document: MapDocument,
  place: Place,
  tolerance: number,
  selected: ElementKey | null,
): number | null {
  const lanes = elementsAt(document, place, tolerance).filter(({ kind }) => kind === "lane_segment");
  const there = lanes.find(({ id }) => selected?.kind === "lane_segment" && id === selected.id);
  return (there ?? lanes[0])?.id ?? null;
}

/** Where a click would cut which lane; null: nowhere. */
export function cutPreview(
  { current, selection }: Pick<EditorState, "current" | "selection">,
  cursor: Place,
  tolerance: number,
): { lane: number; joint: Joint } | null {
  const id = cutTarget(current, cursor, tolerance, selection);
  const lane = id === null ? undefined : current.lanes.get(id);
  const joint = lane && jointAt(current, lane, cursor, tolerance);
  return lane && joint ? { lane: lane.id, joint } : null;
}

export function previewOf(
  state: Pick<EditorState, "tool" | "sketch" | "current">,
  cursor: Place | null,
  tolerance: number,
): MapElement | null {
  const planned = plan(state, cursor, tolerance);
  if (planned === null || isRefusal(planned)) return null;
  return planned.changes.find(({ key }) => key.id === NO_ID)?.after ?? null;
}

function plan(
  { tool, sketch, current }: Pick<EditorState, "tool" | "sketch" | "current">,
  cursor: Place | null,
  tolerance: number,
): Planned | null {
  if (tool === "lane_beside") {
    const target = cursor && besideTarget(current, cursor, tolerance);
    return target && planLaneBeside(current, target.lane, target.side, NO_ID);
  }
  const points = [...(sketch?.points ?? []), ...(cursor === null ? [] : [cursor])];
  const [first, second] = points;
  if (sketch === null || first === undefined || second === undefined) return null;
  if (tool === "draw_crossing") return planCrossing(current, first, second, NO_ID);
  return tool === "draw_lane" ? planDrawnLane(current, points, NO_ID) : null;
}
