import { expect, test } from "vitest";
import { commandOf, KEY_TABLE, nudgeOf } from "./keys";
import { snap, snapToLaneEnd } from "./snapping";
import { createEditor } from "./store";
import { idBlocks, workspaceOf } from "./testRoad";

const open = () => createEditor(workspaceOf(), idBlocks());
const press = (
  key: string,
  held: { ctrl?: boolean; shift?: boolean; alt?: boolean; code?: string } = {},
) => ({
  key,
  code: held.code ?? "",
  ctrlKey: held.ctrl ?? false,
  metaKey: false,
  shiftKey: held.shift ?? false,
  altKey: held.alt ?? false,
});

test("clicking again on a stack takes the next one below, and begins again after the last", () => {
  const editor = open();
  const picked = () => {
    editor.actions.pick({ x: 20, y: 41.6 }, 0.5);
    return editor.getState().selection?.id;
  };
  expect([picked(), picked(), picked()]).toEqual([20, 21, 20]);
});

test("a crossing lies above the lanes that it crosses", () => {
  const editor = open();
  editor.actions.pick({ x: 60, y: 2 }, 0.5);
  expect(editor.getState().selection).toMatchObject({ kind: "pedestrian_crossing", id: 1 });
  editor.actions.pickUnderneath();
  expect(editor.getState().selection).toMatchObject({ kind: "lane_segment", id: 2 });
});

test("a click near a boundary selects that side too, one into the open nothing", () => {
  const editor = open();
  editor.actions.pick({ x: 20, y: 0.3 }, 0.5);
  expect(editor.getState().selection).toMatchObject({ id: 1, side: "right" });
  editor.actions.pick({ x: 20, y: 25 }, 0.5);
  expect(editor.getState().selection).toBeNull();
});

test("a deleted element can still be selected where it was", () => {
  const editor = open();
  editor.actions.deleteElement({ kind: "lane_segment", id: 12 });
  editor.actions.pick({ x: 88, y: -20 }, 0.5);
  expect(editor.getState().selection).toMatchObject({ id: 12 });
});

test("vertices are stepped through on both boundaries and round", () => {
  const editor = open();
  editor.actions.select({ kind: "lane_segment", id: 12 });
  const steps = [1, 1, 1, 1, 1].map(() => {
    editor.actions.stepVertex(1);
    return editor.getState().selection?.vertex;
  });
  expect(steps.map((vertex) => `${vertex?.side} ${vertex?.index}`)).toEqual([
    "left 0",
    "left 1",
    "right 0",
    "right 1",
    "left 0",
  ]);
});

test("Esc gives up the sketch, then the tool, then the vertex, then the selection", () => {
  const editor = open();
  editor.actions.select({ kind: "lane_segment", id: 12 }, { vertex: { side: "left", index: 0 } });
  editor.actions.setTool("draw_lane");
  editor.actions.sketchPoint({ x: 0, y: 0 });
  const seen = [1, 2, 3, 4].map(() => {
    editor.actions.cancel();
    const { sketch, tool, selection } = editor.getState();
    return [sketch !== null, tool, selection?.vertex != null, selection !== null];
  });
  expect(seen).toEqual([
    [false, "draw_lane", true, true],
    [false, "select", true, true],
    [false, "select", false, true],
    [false, "select", false, false],
  ]);
});

test("a dragged place catches on a vertex before a line, but not on lanes that move with it", () => {
  const { current } = open().getState();
  expect(snap(current, { x: 50.2, y: 0.2 }, 0.5)).toMatchObject({
    kind: "vertex",
    place: { x: 50, y: 0.07 },
  });
  expect(snap(current, { x: 45, y: 0.2 }, 0.5)).toMatchObject({ kind: "line", place: { x: 45, y: 0.07 } });
  expect(snap(current, { x: 45, y: 0.2 }, 0.5, new Set([2]))).toBeNull();
});

test("a drawn lane begins at a lane's end and ends at a lane's start", () => {
  const { current } = open().getState();
  expect(snapToLaneEnd(current, { x: 79, y: 2 }, 2, true)).toMatchObject({ lane: 2 });
  expect(snapToLaneEnd(current, { x: 88, y: -5 }, 2, false)).toMatchObject({
    lane: 12,
    place: { x: 87.75, y: -6 },
  });
});

test("keys give their commands, with and without Ctrl and Shift", () => {
  expect(commandOf(press("z", { ctrl: true }))).toBe("undo");
  expect(commandOf(press("Z", { ctrl: true, shift: true }))).toBe("redo");
  expect(commandOf(press("z"))).toBe("fit_element");
  expect(commandOf(press('"', { shift: true, code: "Digit2" }))).toBe("tool_lane_beside");
  expect(commandOf(press("2", { code: "Digit2" }))).toBe("tool_draw_lane");
  expect(commandOf(press("b", { ctrl: true }))).toBeNull();
  expect(commandOf(press("Enter", { alt: true }))).toBeNull();
  expect(nudgeOf(press("ArrowLeft", { shift: true }))).toEqual({ x: -0.5, y: 0 });
});

test("no key stands for two commands", () => {
  const strokes = KEY_TABLE.flatMap(({ keys, control = false, shift }) =>
    [false, true]
      .filter((held) => shift === undefined || shift === held)
      .flatMap((held) => keys.map((key) => `${control} ${held} ${key}`)),
  );
  expect(new Set(strokes).size).toBe(strokes.length);
});
