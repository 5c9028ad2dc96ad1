import { describe, expect, test } from "vitest";
import type { Line } from "./elements";
import { createEditor } from "./store";
import { at, idBlocks, LANES, reasonOf, wireMap, workspaceOf } from "./testRoad";

const open = () => createEditor(workspaceOf(), idBlocks());
const MIDDLE_OF_1 = { kind: "lane_segment", id: 1, side: "right", index: 2 } as const;
const imported = (id: number) => {
  const lane = LANES.find((one) => one.id === id);
  if (lane === undefined) throw new Error(`no lane ${id}`);
  return lane;
};
const NOTHING_ELSE = { declarations: [], canonical: [] };
const raised = (line: Line, z: number): Line => line.map((point) => ({ ...point, z: point.z ?? z }));

describe("net edits", () => {
  test("hold only what changed, with null for heights that are not known", () => {
    const editor = open();
    editor.actions.moveVertex(MIDDLE_OF_1, { x: 20, y: -0.6 });
    editor.actions.setMark(1, "right", "DASHED_WHITE");
    const edits = editor.actions.netEdits();
    expect(edits).toHaveLength(1);
    expect(edits[0]).toMatchObject({ operation: "update", kind: "lane_segment", id: 1 });
    expect(Object.keys(edits[0]?.attributes ?? {})).toEqual(["right_lane_boundary", "right_lane_mark_type"]);
    expect(edits[0]?.attributes.right_lane_boundary?.[2]).toEqual({ x: 20, y: -0.6, z: null });
    expect(edits[0]?.attributes.right_lane_boundary?.[1]).toEqual(imported(1).right_lane_boundary[1]);
  });

  test("an edit and its opposite are nothing", () => {
    const editor = open();
    editor.actions.setLaneType(1, "BUS");
    editor.actions.setLaneType(1, "VEHICLE");
    expect(editor.actions.netEdits()).toEqual([]);
    expect(editor.getState().changedKeys.size).toBe(0);
  });

  test("an inserted element comes whole but for its id", async () => {
    const editor = open();
    await editor.actions.insertCrossing({ x: 20, y: -1 }, { x: 20, y: 12 });
    const [edit] = editor.actions.netEdits();
    expect(edit).toMatchObject({ operation: "insert", kind: "pedestrian_crossing", id: 90_000_001 });
    expect(Object.keys(edit?.attributes ?? {})).toEqual(["edge1", "edge2"]);
  });
});

describe("a draft", () => {
  test("comes back as it was kept", () => {
    const editor = open();
    editor.actions.moveVertex(MIDDLE_OF_1, { x: 20, y: -0.6 });
    editor.actions.deleteElement({ kind: "pedestrian_crossing", id: 1 });
    const kept = editor.actions.netEdits().map((edit) => ({ ...edit, attributes: { ...edit.attributes } }));
    const again = open();
    again.actions.loadDraft(kept);
    expect(again.actions.netEdits()).toEqual(kept);
    expect(again.getState().history.done.map(({ note }) => note)).toEqual(["Loaded the kept draft"]);
  });

  test("brings its undo steps back when they were kept with it", () => {
    const editor = open();
    editor.actions.moveVertex(MIDDLE_OF_1, { x: 20, y: -0.6 });
    editor.actions.setLaneType(3, "BUS");
    const kept = editor.actions.netEdits().map((edit) => ({ ...edit, attributes: { ...edit.attributes } }));
    const again = open();
    again.actions.loadDraft(kept, structuredClone(editor.getState().history));
    again.actions.undo();
    expect(again.actions.netEdits().map(({ id }) => id)).toEqual([1]);
    again.actions.undo();
    expect(again.actions.netEdits()).toEqual([]);
  });

  test("that does not fit is refused in words and nothing is shown of it", () => {
    const editor = open();
    const outcome = editor.actions.loadDraft([
      { operation: "update", kind: "lane_segment", id: 77, attributes: {} },
    ]);
    expect(reasonOf(outcome)).toContain("lane 77: is not in the map");
    expect(editor.getState().current).toBe(editor.getState().saved);
  });
});

describe("a fix", () => {
  test("is applied as one undo step", () => {
    const editor = open();
    editor.actions.deleteElement({ kind: "lane_segment", id: 12 });
    const attributes = { ...imported(12) };
    editor.actions.applyEdits(
      [{ operation: "insert", kind: "lane_segment", id: 12, attributes }],
      "Kept lane 12",
    );
    expect(editor.getState().history.done.at(-1)?.note).toBe("Kept lane 12");
    expect(editor.getState().current.lanes.get(12)).toEqual(imported(12));
  });

  test("that inserts gets ids of this workspace, in its links too", async () => {
    const editor = open();
    const attributes = { ...imported(12), id: 999_999 };
    await editor.actions.applyFix(
      [
        { operation: "delete", kind: "lane_segment", id: 12 },
        { operation: "insert", kind: "lane_segment", id: 999_999, attributes },
        { operation: "update", kind: "lane_segment", id: 1, attributes: { right_neighbor_id: 999_999 } },
      ],
      "Replaced lane 12",
    );
    const { current, base } = editor.getState();
    const added = [...current.lanes.keys()].filter((id) => !base.lanes.has(id));
    expect(added).toHaveLength(1);
    expect(added[0]).not.toBe(999_999);
    expect(current.lanes.get(1)?.right_neighbor_id).toBe(added[0]);
  });

  test("with an unknown mark is refused whole", () => {
    const editor = open();
    const edits = [
      { operation: "delete", kind: "lane_segment", id: 12 },
      { operation: "update", kind: "lane_segment", id: 1, attributes: { left_lane_mark_type: "WAVY" } },
    ] as const;
    expect(reasonOf(editor.actions.applyEdits(edits, "x"))).toContain(
      "left_lane_mark_type is not a lane mark",
    );
    expect(editor.getState().current.lanes.has(12)).toBe(true);
  });
});

describe("after a save", () => {
  test("the stored heights are taken over and undo still leads back", () => {
    const editor = open();
    editor.actions.moveVertex(MIDDLE_OF_1, { x: 20, y: -0.6 });
    const snapshot = editor.actions.takeSnapshot();
    const sent = snapshot.document.lanes.get(1);
    if (sent === undefined) throw new Error("lane 1 is gone");
    const stored = { ...sent, right_lane_boundary: raised(sent.right_lane_boundary, 12.5) };
    editor.actions.adoptSaved(
      { revision: 1, changed: wireMap([stored], []), removed: [], ...NOTHING_ELSE },
      snapshot,
    );
    expect(editor.getState()).toMatchObject({ savedRevision: 1 });
    expect(editor.actions.netEdits()).toEqual([]);
    expect(editor.getState().current.lanes.get(1)?.right_lane_boundary[2]).toEqual({
      x: 20,
      y: -0.6,
      z: 12.5,
    });
    editor.actions.undo();
    expect(editor.getState().current.lanes.get(1)).toEqual(imported(1));
    editor.actions.redo();
    expect(editor.actions.netEdits()).toEqual([]);
  });

  test("what was edited meanwhile stays, and meets what the server restored", () => {
    //  The shared vertex was moved by 3 cm: the server puts it back in lane 1 while lane 3 is being repainted.
    const editor = open();
    editor.actions.moveVertex({ ...MIDDLE_OF_1, side: "left" }, { x: 20, y: 3.54 });
    const snapshot = editor.actions.takeSnapshot();
    editor.actions.setMark(3, "left", "SOLID_YELLOW");
    editor.actions.adoptSaved(
      { revision: 1, changed: wireMap([], []), removed: [], ...NOTHING_ELSE },
      snapshot,
    );
    const { current } = editor.getState();
    expect(current.lanes.get(3)?.left_lane_mark_type).toBe("SOLID_YELLOW");
    expect(at(current.lanes.get(1)?.left_lane_boundary ?? [], 2)).toEqual([20, 3.51]);
    expect(current.lanes.get(3)?.right_lane_boundary).toEqual(imported(3).right_lane_boundary);
    expect(editor.actions.netEdits().map(({ id, attributes }) => [id, Object.keys(attributes)])).toEqual([
      [3, ["left_lane_mark_type"]],
      [6, ["left_lane_mark_type"]],
    ]);
  });

  test("that exchanged identities the past is closed, for it names other elements", () => {
    const editor = open();
    editor.actions.setLaneType(1, "BUS");
    const snapshot = editor.actions.takeSnapshot();
    const other = { ...imported(10), lane_type: "BUS" as const };
    editor.actions.adoptSaved(
      { revision: 1, changed: wireMap([other], []), removed: [], ...NOTHING_ELSE },
      snapshot,
    );
    expect(editor.getState().history).toEqual({ done: [], undone: [] });
    expect(editor.getState().current.lanes.get(1)?.lane_type).toBe("VEHICLE");
    expect(editor.getState().current.lanes.get(10)?.lane_type).toBe("BUS");
  });
});

test("a revision opens with its changes on the imported map", () => {
  const workspace = workspaceOf();
  const changed = wireMap([{ ...imported(1), lane_type: "BUS" }], []);
  const removed = [{ kind: "pedestrian_crossing", id: 1 } as const];
  const editor = createEditor({ ...workspace, revision: 4, changed, removed }, idBlocks());
  expect([...editor.getState().changedKeys]).toEqual([
    ["lane_segment:1", ["type"]],
    ["pedestrian_crossing:1", ["deletion"]],
  ]);
  expect(editor.actions.netEdits()).toEqual([]);
});
