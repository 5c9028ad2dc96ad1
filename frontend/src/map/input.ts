/** Mouse on the map: hovering, picking, the clicks of drawing tools. */
import type { MapMouseEvent } from "maplibre-gl";
import { besideTarget, cutTarget, type Editor, elementsAt, type Place, snapToLaneEnd } from "../editor";
import type { MapController } from "./mapController";
import type { Pointer } from "./pointer";
import type { DrivePath } from "./properties";

const PICK_PIXELS = 6;
const LANE_END_PIXELS = 16;
const FRAME_PIXELS = 5;
/** Frames are some five metres apart: farther out their dots lie so close that no click would reach the lane. */
const FRAMES_FROM_PIXELS_PER_METRE = 6;

export const NOT_EDITED = "This is the imported map. Go back to the edited one to change it.";

export interface InputOptions {
  readonly drive: DrivePath | null;
  readonly onFrame?: ((index: number) => void) | undefined;
  /** The imported map is on the screen, which nobody edits. */
  readonly showsBase: boolean;
}

/** Returns what takes the listeners off again. `options` is asked at each click. */
export function attachInput(
  { map, viewport, region }: MapController,
  editor: Editor,
  pointer: Pointer,
  options: () => InputOptions,
): () => void {
  const { actions } = editor;

  const placed = (event: MapMouseEvent): Place => {
    const { tool, sketch, current } = editor.getState();
    const place = viewport.toCity(event.point);
    const caught =
      tool === "draw_lane" && !event.originalEvent.altKey
        ? snapToLaneEnd(current, place, viewport.metres(LANE_END_PIXELS), sketch === null)
        : null;
    pointer.setState({ place, caught });
    return caught?.place ?? place;
  };

  const onMove = (event: MapMouseEvent) => {
    if (pointer.getState().dragging) return;
    const place = placed(event);
    const { tool, current, base } = editor.getState();
    const map = options().showsBase ? base : current;
    if (tool === "select") actions.hover(elementsAt(map, place)[0] ?? null);
    else if (tool === "lane_beside") {
      const target = besideTarget(current, place, viewport.metres(PICK_PIXELS));
      actions.hover(target && { kind: "lane_segment", id: target.lane });
    } else if (tool === "cut") {
      const id = cutTarget(current, place, viewport.metres(PICK_PIXELS), editor.getState().selection);
      actions.hover(id === null ? null : { kind: "lane_segment", id });
    } else actions.hover(null);
  };

  const onLeave = () => {
    pointer.setState({ place: null, caught: null });
    actions.hover(null);
  };

  const onClick = (event: MapMouseEvent) => {
    if (event.originalEvent.button !== 0) return;
    const { tool, sketch, current } = editor.getState();
    const place = placed(event);
    const { drive, onFrame, showsBase } = options();
    if (tool === "select") {
      const apart = viewport.pixelsPerMetre() >= FRAMES_FROM_PIXELS_PER_METRE;
      const frame = apart ? nearestFrame(drive, place, viewport.metres(FRAME_PIXELS)) : null;
      if (onFrame !== undefined && frame !== null) onFrame(frame);
      else actions.pick(place, viewport.metres(PICK_PIXELS), showsBase ? "base" : "current");
    } else if (showsBase) {
      actions.say(NOT_EDITED);
    } else if (tool === "lane_beside") {
      const target = besideTarget(current, place, viewport.metres(PICK_PIXELS));
      if (target === null) actions.say("Click on a lane, near the side that the new one shall lie on.");
      else
        void actions.insertLaneBeside(target.lane, target.side).then(({ ok }) => {
          if (ok) actions.setTool("select");
        });
    } else if (tool === "cut") {
      const reach = viewport.metres(PICK_PIXELS);
      const lane = cutTarget(current, place, reach, editor.getState().selection);
      if (lane === null) actions.say("Click on a lane, at the place where it is to be cut.");
      else
        void actions.cutLane(lane, place, reach).then(({ ok }) => {
          if (ok) actions.setTool("select");
        });
    } else {
      const joins = pointer.getState().caught !== null && sketch !== null;
      actions.sketchPoint(place);
      if (joins) void actions.finishSketch();
    }
  };

  const onDoubleClick = (event: MapMouseEvent) => {
    if (editor.getState().tool !== "draw_lane") return;
    event.preventDefault();
    void actions.finishSketch();
  };

  const onDown = () => region.focus({ preventScroll: true });

  map.on("mousemove", onMove);
  map.on("mouseout", onLeave);
  map.on("click", onClick);
  map.on("dblclick", onDoubleClick);
  map.on("mousedown", onDown);
  return () => {
    map.off("mousemove", onMove);
    map.off("mouseout", onLeave);
    map.off("click", onClick);
    map.off("dblclick", onDoubleClick);
    map.off("mousedown", onDown);
  };
}

function nearestFrame(drive: DrivePath | null, place: Place, radius: number): number | null {
  let best: number | null = null;
  let bestFar = radius;
  for (const { index, x, y } of drive?.frames ?? []) {
    const far = Math.hypot(x - place.x, y - place.y);
    if (far <= bestFar) [bestFar, best] = [far, index];
  }
  return best;
}
