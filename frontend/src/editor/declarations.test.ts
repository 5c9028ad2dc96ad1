import { describe, expect, test } from "vitest";
import { createEditor } from "./store";
import { idBlocks, workspaceOf } from "./testRoad";

const open = () => createEditor(workspaceOf(), idBlocks());

describe("declared macros", () => {
  const SHAPE = { shape: true, appearance: false, function: false, lane_graph: false, lane_number: 0 };
  const LANE_1 = { kind: "lane_segment", id: 1 } as const;
  const LANE_3 = { kind: "lane_segment", id: 3 } as const;

  test("are part of the draft, undone and redone like edits", () => {
    const editor = open();
    editor.actions.declare([LANE_1, LANE_3], SHAPE);
    const declared = [{ elements: [LANE_1, LANE_3], macros: SHAPE }];
    expect(editor.actions.netDraft()).toEqual({ edits: [], declarations: declared });
    editor.actions.undo();
    expect(editor.actions.netDraft()).toEqual({ edits: [], declarations: null });
    editor.actions.redo();
    expect(editor.actions.netDraft().declarations).toEqual(declared);
  });

  test("of an update replace what was declared of it before, or are withdrawn", () => {
    const editor = open();
    editor.actions.declare([LANE_1, LANE_3], SHAPE);
    editor.actions.declare([LANE_3], { ...SHAPE, lane_number: 1 });
    expect(editor.getState().declarations).toEqual([
      { elements: [LANE_3], macros: { ...SHAPE, lane_number: 1 } },
    ]);
    editor.actions.declare([LANE_3], null);
    expect(editor.actions.netDraft().declarations).toBeNull();
  });

  test("come back with a kept draft, and with its undo steps", () => {
    const editor = open();
    editor.actions.declare([LANE_1], SHAPE);
    const { declarations } = editor.actions.netDraft();
    const again = open();
    again.actions.loadDraft([], structuredClone(editor.getState().history), declarations);
    expect(again.actions.netDraft().declarations).toEqual(declarations);
    again.actions.undo();
    expect(again.actions.netDraft().declarations).toBeNull();
  });
});

test("a draft is discarded as one step that can be undone", () => {
  const editor = open();
  editor.actions.setLaneType(1, "BUS");
  editor.actions.deleteElement({ kind: "pedestrian_crossing", id: 1 });
  editor.actions.discardDraft();
  expect(editor.actions.netEdits()).toEqual([]);
  editor.actions.undo();
  expect(editor.actions.netEdits()).toHaveLength(2);
});
