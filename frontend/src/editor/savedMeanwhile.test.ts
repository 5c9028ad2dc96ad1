import { describe, expect, test } from "vitest";
import { createEditor } from "./store";
import { idBlocks, LANES, wireMap, workspaceOf } from "./testRoad";

const open = () => createEditor(workspaceOf(), idBlocks());
const imported = (id: number) => {
  const lane = LANES.find((one) => one.id === id);
  if (lane === undefined) throw new Error(`no lane ${id}`);
  return lane;
};
const NOTHING_ELSE = { declarations: [], canonical: [] };

test("a save that exchanges ids takes the selection and later edits along", () => {
  const editor = open();
  editor.actions.setLaneType(1, "BUS");
  const snapshot = editor.actions.takeSnapshot();
  editor.actions.select({ kind: "lane_segment", id: 20 });
  editor.actions.setLaneType(20, "BIKE");
  const [one, other] = [imported(20), imported(21)];
  const canonical = [
    { kind: "lane_segment", from: 20, to: 21 },
    { kind: "lane_segment", from: 21, to: 20 },
  ] as const;
  const changed = wireMap(
    [
      { ...imported(1), lane_type: "BUS" },
      { ...one, id: 21 },
      { ...other, id: 20 },
    ],
    [],
  );
  editor.actions.adoptSaved({ revision: 1, changed, removed: [], declarations: [], canonical }, snapshot);
  expect(editor.getState().selection?.id).toBe(21);
  expect(editor.actions.netEdits()).toMatchObject([{ id: 21, attributes: { lane_type: "BIKE" } }]);
});

test("of edits made during a save that exchanges ids those that fit stay, the others are handed back", () => {
  const editor = open();
  editor.actions.setLaneType(1, "BUS");
  const snapshot = editor.actions.takeSnapshot();
  editor.actions.setLaneType(20, "BIKE");
  editor.actions.setLaneType(12, "BIKE");
  const canonical = [{ kind: "lane_segment", from: 20, to: 21 }] as const;
  const removed = [20, 12].map((id) => ({ kind: "lane_segment", id }) as const);
  const changed = wireMap(
    [
      { ...imported(1), lane_type: "BUS" },
      { ...imported(20), id: 21 },
    ],
    [],
  );
  const unfit = editor.actions.adoptSaved(
    { revision: 1, changed, removed, declarations: [], canonical },
    snapshot,
  );
  expect(editor.actions.netEdits()).toMatchObject([{ id: 21, attributes: { lane_type: "BIKE" } }]);
  expect(unfit).toMatchObject([{ id: 12, attributes: { lane_type: "BIKE" } }]);
});

test("a lane that a save joined to another does not come back by an edit made meanwhile", () => {
  const editor = open();
  editor.actions.setLaneType(1, "BUS");
  const snapshot = editor.actions.takeSnapshot();
  editor.actions.setLaneType(2, "BIKE");
  const joined = wireMap([{ ...imported(1), lane_type: "BUS", successors: [] }], []);
  const removed = [{ kind: "lane_segment", id: 2 } as const];
  const unfit = editor.actions.adoptSaved(
    { revision: 1, changed: joined, removed, ...NOTHING_ELSE },
    snapshot,
  );
  expect(editor.getState().current.lanes.has(2)).toBe(false);
  expect(unfit.map(({ id }) => id)).toEqual([2]);
});

test("an edit made during a save leaves what the save merged in from others on the same lane", () => {
  const editor = open();
  editor.actions.setLaneType(1, "BUS");
  const snapshot = editor.actions.takeSnapshot();
  editor.actions.setLaneType(20, "BIKE");
  const theirs = { ...imported(20), right_lane_mark_type: "SOLID_YELLOW" as const };
  const changed = wireMap([{ ...imported(1), lane_type: "BUS" }, theirs], []);
  editor.actions.adoptSaved({ revision: 1, changed, removed: [], ...NOTHING_ELSE }, snapshot);
  expect(editor.getState().current.lanes.get(20)).toMatchObject({
    lane_type: "BIKE",
    right_lane_mark_type: "SOLID_YELLOW",
  });
});

test("a draft that was loaded as it was sent counts as edited no further", () => {
  const editor = open();
  editor.actions.addVertex({ kind: "lane_segment", id: 1, side: "right", index: 1 });
  const sent = editor.actions.netEdits().map((edit) => ({ ...edit, attributes: { ...edit.attributes } }));
  const snapshot = editor.actions.takeSnapshot();
  editor.actions.loadDraft(sent);
  //  The server takes a vertex that bends nothing out again.
  editor.actions.adoptSaved(
    { revision: 1, changed: wireMap([], []), removed: [], ...NOTHING_ELSE },
    snapshot,
  );
  expect(editor.actions.netEdits()).toEqual([]);
});

describe("declarations and a save", () => {
  const SHAPE = { shape: true, appearance: false, function: false, lane_graph: false, lane_number: 0 };
  const of = (id: number) => ({ elements: [{ kind: "lane_segment" as const, id }], macros: SHAPE });

  test("those made meanwhile join what the save merged in, under the ids of the save", () => {
    const editor = open();
    editor.actions.declare(of(1).elements, SHAPE);
    const snapshot = editor.actions.takeSnapshot();
    editor.actions.declare(of(20).elements, SHAPE);
    const canonical = [
      { kind: "lane_segment", from: 20, to: 21 },
      { kind: "lane_segment", from: 21, to: 20 },
    ] as const;
    const declarations = [of(1), of(3)];
    const changed = wireMap(
      [
        { ...imported(20), id: 21 },
        { ...imported(21), id: 20 },
      ],
      [],
    );
    editor.actions.adoptSaved({ revision: 1, changed, removed: [], declarations, canonical }, snapshot);
    const stated = editor.getState().declarations.map(({ elements }) => elements[0]?.id);
    expect(stated.toSorted((a, b) => (a ?? 0) - (b ?? 0))).toEqual([1, 3, 21]);
  });

  test("undoing one afterwards withdraws it alone", () => {
    const editor = open();
    editor.actions.declare(of(1).elements, SHAPE);
    const snapshot = editor.actions.takeSnapshot();
    const declarations = [of(1), of(3)];
    editor.actions.adoptSaved(
      { revision: 1, changed: wireMap([], []), removed: [], declarations, canonical: [] },
      snapshot,
    );
    editor.actions.undo();
    expect(editor.getState().declarations).toEqual([of(3)]);
  });
});
