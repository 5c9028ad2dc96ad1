/** Dragging a handle: staged in the editor while the button is down, one undo step when it is let go. */
import { type Editor, type ElementKey, isSide, type Place, snap, together, type VertexRef } from "../editor";
import type { OverlayValue } from "./useOverlay";
import type { Pixel } from "./viewport";

const CLICK_PIXELS = 3;
const SNAP_PIXELS = 9;

type Stage = (place: Place, free: boolean) => void;

/** Follows the pointer from a press to its release; `click` is a press without movement. */
export function follow(
  { editor, controller, pointer }: OverlayValue,
  press: PointerEvent,
  stage: Stage,
  click: () => void = () => undefined,
): void {
  const { viewport, region } = controller;
  region.focus({ preventScroll: true }); // keys that follow are meant for what was pressed
  let moving = false;
  const pixelOf = (event: PointerEvent): Pixel => {
    const box = region.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const onMove = (event: PointerEvent) => {
    if (event.pointerId !== press.pointerId) return;
    const far = Math.hypot(event.clientX - press.clientX, event.clientY - press.clientY);
    if (!moving && far < CLICK_PIXELS) return;
    moving = true;
    pointer.setState({ dragging: true });
    stage(viewport.toCity(pixelOf(event)), event.altKey);
  };
  const end = () => {
    window.removeEventListener("pointermove", onMove);
    window.removeEventListener("pointerup", onUp);
    window.removeEventListener("pointercancel", onCancel);
    window.removeEventListener("keydown", onKey, true);
    pointer.setState({ dragging: false, caught: null });
  };
  const onUp = (event: PointerEvent) => {
    if (event.pointerId !== press.pointerId) return;
    end();
    if (moving) editor.actions.commitStaged();
    else click();
  };
  const onCancel = () => {
    end();
    editor.actions.cancelStaged();
  };
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    onCancel();
  };
  window.addEventListener("pointermove", onMove);
  window.addEventListener("pointerup", onUp);
  window.addEventListener("pointercancel", onCancel);
  window.addEventListener("keydown", onKey, true);
}

export function dragVertex(overlay: OverlayValue, press: PointerEvent, vertex: VertexRef): void {
  const { editor, controller, pointer } = overlay;
  const moving = lanesMovingWith(editor, vertex);
  follow(overlay, press, (place, free) => {
    const radius = controller.viewport.metres(SNAP_PIXELS);
    const caught = free ? null : snap(editor.getState().current, place, radius, moving);
    pointer.setState({ place, caught });
    editor.actions.stageVertex(vertex, caught?.place ?? place);
  });
}

/** A press on a piece of line: let go at once it adds a vertex there, dragged it puts the new vertex elsewhere. */
export function dragNewVertex(overlay: OverlayValue, press: PointerEvent, after: VertexRef): void {
  const { editor, controller, pointer } = overlay;
  const moving = new Set([
    ...lanesMovingWith(editor, after),
    ...lanesMovingWith(editor, { ...after, index: after.index + 1 }),
  ]);
  const stage = (place: Place, free: boolean) => {
    const radius = controller.viewport.metres(SNAP_PIXELS);
    const caught = free ? null : snap(editor.getState().current, place, radius, moving);
    pointer.setState({ place, caught });
    editor.actions.stageNewVertex(after, caught?.place ?? place);
  };
  follow(overlay, press, stage, () => editor.actions.addVertex(after));
}

export function dragElement(overlay: OverlayValue, press: PointerEvent, key: ElementKey, from: Place): void {
  follow(overlay, press, (place) => {
    overlay.pointer.setState({ place, caught: null });
    overlay.editor.actions.stageElement(key, { x: place.x - from.x, y: place.y - from.y });
  });
}

/** A vertex does not catch on the lines that it moves itself. */
function lanesMovingWith(editor: Editor, { kind, id, side, index }: VertexRef): ReadonlySet<number> {
  if (kind !== "lane_segment" || !isSide(side)) return new Set();
  return new Set(together(editor.getState().current, { lane: id, side, index }).map(({ lane }) => lane));
}
