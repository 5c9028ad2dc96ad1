import { describe, expect, test } from "vitest";
import { createEditor } from "./store";
import { at, idBlocks, reasonOf, workspaceOf } from "./testRoad";

const open = () => createEditor(workspaceOf(), idBlocks());
type Opened = ReturnType<typeof open>;
const lane = (editor: Opened, id: number) => {
  const found = editor.getState().current.lanes.get(id);
  if (found === undefined) throw new Error(`no lane ${id}`);
  return found;
};
const LANE_1 = { kind: "lane_segment", id: 1 } as const;

describe("marks", () => {
  test("mixed paint is mirrored in the lane beside", () => {
    const editor = open();
    editor.actions.setMark(1, "left", "DASH_SOLID_YELLOW");
    expect(lane(editor, 3).right_lane_mark_type).toBe("SOLID_DASH_YELLOW");
  });

  test("the centre line is painted in the oncoming lane too", () => {
    const editor = open();
    editor.actions.setMark(5, "left", "SOLID_DASH_YELLOW");
    expect(lane(editor, 4).left_lane_mark_type).toBe("DASH_SOLID_YELLOW");
    expect([...editor.getState().changedKeys]).toEqual([
      ["lane_segment:4", ["marking"]],
      ["lane_segment:5", ["marking"]],
    ]);
  });

  test("painting what is painted so already is no undo step", () => {
    const editor = open();
    editor.actions.setMark(1, "right", "SOLID_WHITE");
    expect(editor.getState().history.done).toEqual([]);
  });
});

describe("a lane beside another", () => {
  test("shares its boundary point for point, is 3.5 m wide, and each names the other", async () => {
    const editor = open();
    const done = await editor.actions.insertLaneBeside(1, "right");
    expect(done).toEqual({ ok: true, key: { kind: "lane_segment", id: 90_000_001 } });
    const added = lane(editor, 90_000_001);
    expect(added.left_lane_boundary).toEqual(lane(editor, 1).right_lane_boundary);
    expect(added.right_lane_boundary.map(({ y }) => y)).toEqual([-3.43, -3.43, -3.43, -3.43, -3.43]);
    expect(added.left_neighbor_id).toBe(1);
    expect(lane(editor, 1).right_neighbor_id).toBe(90_000_001);
    expect([added.left_lane_mark_type, added.right_lane_mark_type]).toEqual(["SOLID_WHITE", "SOLID_WHITE"]);
    expect(editor.getState().selection?.id).toBe(90_000_001);
    expect([...editor.getState().changedKeys.keys()]).toEqual(["lane_segment:90000001"]);
  });

  test("three in a row join corner to corner and are linked", async () => {
    const editor = open();
    await editor.actions.insertLaneBeside(1, "right");
    editor.actions.moveVertex(
      { kind: "lane_segment", id: 90_000_001, side: "right", index: 4 },
      { x: 40.3, y: -2.9 },
    );
    await editor.actions.insertLaneBeside(2, "right");
    const [first, second] = [lane(editor, 90_000_001), lane(editor, 90_000_002)];
    expect(at(second.right_lane_boundary, 0)).toEqual(at(first.right_lane_boundary, -1));
    expect(first.successors).toEqual([90_000_002]);
    expect(second.predecessors).toEqual([90_000_001]);
  });

  test("is refused where a lane lies already, naming it", async () => {
    const editor = open();
    const done = await editor.actions.insertLaneBeside(3, "right");
    expect(reasonOf(done)).toContain("Lane 1 already lies on the right");
    expect(await open().actions.insertLaneBeside(3, "left")).toMatchObject({ ok: false });
  });

  test("says so when the server gives no ids", async () => {
    const editor = createEditor(workspaceOf(), () => Promise.reject(new Error("offline")));
    expect(await editor.actions.insertLaneBeside(1, "right")).toMatchObject({ ok: false });
    expect(editor.getState().notice?.text).toContain("connection");
  });
});

describe("a drawn lane", () => {
  test("from a lane's end to another's start joins both exactly and is linked with them", async () => {
    //  2 ──●          the drawn lane leaves the end of 2 …
    //       ╲
    //        ● 12     … and enters 12
    const editor = open();
    const done = await editor.actions.drawLane([
      { x: 80, y: (3.51 + 0.07) / 2 },
      { x: 87.75, y: -6 },
    ]);
    if (!done.ok) throw new Error(done.reason);
    const drawn = lane(editor, done.key.id);
    expect(at(drawn.left_lane_boundary, 0)).toEqual([80, 3.51]);
    expect(at(drawn.right_lane_boundary, -1)).toEqual([86, -6]);
    expect(drawn.predecessors).toEqual([2]);
    expect(drawn.successors).toEqual([12]);
    expect(lane(editor, 12).predecessors).toEqual([8, drawn.id]);
    expect(drawn.is_intersection).toBe(true);
    expect(drawn.left_lane_boundary.length).toBeGreaterThan(4);
  });

  test("in the open is straight and as wide as asked", async () => {
    const editor = open();
    const done = await editor.actions.drawLane(
      [
        { x: 0, y: 80 },
        { x: 30, y: 80 },
      ],
      { width: 3, laneType: "BIKE" },
    );
    if (!done.ok) throw new Error(done.reason);
    const { left_lane_boundary, right_lane_boundary, lane_type } = lane(editor, done.key.id);
    expect(left_lane_boundary).toEqual([
      { x: 0, y: 81.5, z: null },
      { x: 30, y: 81.5, z: null },
    ]);
    expect(right_lane_boundary.map(({ y }) => y)).toEqual([78.5, 78.5]);
    expect(lane_type).toBe("BIKE");
  });

  test("by clicks: Enter finishes it, and the tool is put down", async () => {
    const editor = open();
    editor.actions.setTool("draw_lane");
    for (const x of [0, 10, 25]) editor.actions.sketchPoint({ x, y: 80 });
    editor.actions.sketchBack();
    expect(editor.getState().sketch?.points).toHaveLength(2);
    await editor.actions.finishSketch();
    expect(editor.getState()).toMatchObject({ tool: "select", sketch: null });
    expect(lane(editor, 90_000_001).left_lane_boundary.at(-1)?.x).toBe(10);
  });
});

test("a crossing has two parallel edges along the walk, the first on the left", async () => {
  const editor = open();
  await editor.actions.insertCrossing({ x: 20, y: -1 }, { x: 20, y: 12 }, 4);
  expect(editor.getState().current.crossings.get(90_000_001)).toEqual({
    id: 90_000_001,
    edge1: [
      { x: 18, y: -1, z: null },
      { x: 18, y: 12, z: null },
    ],
    edge2: [
      { x: 22, y: -1, z: null },
      { x: 22, y: 12, z: null },
    ],
  });
});

test("after a deletion nothing names the lane any more, and undo brings all back", () => {
  const editor = open();
  editor.actions.deleteElement({ kind: "lane_segment", id: 2 });
  const { current, base } = editor.getState();
  for (const one of current.lanes.values()) {
    expect([
      ...one.successors,
      ...one.predecessors,
      one.left_neighbor_id,
      one.right_neighbor_id,
    ]).not.toContain(2);
  }
  expect([...editor.getState().changedKeys]).toEqual([["lane_segment:2", ["deletion"]]]);
  editor.actions.undo();
  expect([...editor.getState().current.lanes]).toEqual(expect.arrayContaining([...base.lanes]));
});

describe("reverting one element", () => {
  test("puts the shared line back in the neighbour, and leaves other edits alone", () => {
    const editor = open();
    editor.actions.moveVertex({ ...LANE_1, side: "left", index: 2 }, { x: 20, y: 4.4 });
    editor.actions.setLaneType(3, "BUS");
    editor.actions.revertElement(LANE_1);
    expect([...editor.getState().changedKeys]).toEqual([["lane_segment:3", ["type"]]]);
  });

  test("brings a deleted lane back with its links", () => {
    const editor = open();
    editor.actions.deleteElement(LANE_1);
    editor.actions.revertElement(LANE_1);
    expect(editor.actions.netEdits()).toEqual([]);
  });

  test("takes an inserted lane away", async () => {
    const editor = open();
    await editor.actions.insertLaneBeside(1, "right");
    editor.actions.revertElement({ kind: "lane_segment", id: 90_000_001 });
    expect(editor.actions.netEdits()).toEqual([]);
  });
});
