import { describe, expect, test } from "vitest";
import type { VertexRef } from "./elements";
import { createEditor } from "./store";
import { at, idBlocks, reasonOf, workspaceOf } from "./testRoad";

const open = () => createEditor(workspaceOf(), idBlocks());
const lane = (editor: ReturnType<typeof open>, id: number) => {
  const found = editor.getState().current.lanes.get(id);
  if (found === undefined) throw new Error(`no lane ${id}`);
  return found;
};
const vertex = (id: number, side: "left" | "right", index: number): VertexRef => ({
  kind: "lane_segment",
  id,
  side,
  index,
});

describe("moving a vertex", () => {
  test("inside a boundary takes the neighbour's copy along, in one undo step", () => {
    const editor = open();
    editor.actions.moveVertex(vertex(1, "left", 2), { x: 20.118, y: 3.913 });
    expect(at(lane(editor, 1).left_lane_boundary, 2)).toEqual([20.12, 3.91]);
    expect(at(lane(editor, 3).right_lane_boundary, 2)).toEqual([20.12, 3.91]);
    expect(lane(editor, 1).left_lane_boundary[2]?.z).toBeNull();
    expect(editor.getState().history.done.map(({ note }) => note)).toEqual([
      "Moved a vertex of lane 1 and of 1 other lane",
    ]);
    editor.actions.undo();
    expect(editor.getState().current.lanes.get(1)).toBe(editor.getState().base.lanes.get(1));
  });

  test("of a centre line takes the oncoming lane's reversed copy along", () => {
    const editor = open();
    editor.actions.moveVertex(vertex(3, "left", 1), { x: 10, y: 7.5 });
    expect(at(lane(editor, 6).left_lane_boundary, -2)).toEqual([10, 7.5]);
  });

  test("at a joint moves it in all lanes that meet there: before, after, beside, and both ways of a fork", () => {
    //  4 ─┐    ┌─ 9
    //     ●────●        ● = the vertex (80, 3.51)
    //  2 ─┘    ├─ 7
    //          └─ 8
    const editor = open();
    editor.actions.moveVertex(vertex(2, "left", 4), { x: 80.5, y: 3.6 });
    expect(at(lane(editor, 2).left_lane_boundary, -1)).toEqual([80.5, 3.6]);
    expect(at(lane(editor, 4).right_lane_boundary, -1)).toEqual([80.5, 3.6]);
    for (const id of [7, 8]) expect(at(lane(editor, id).left_lane_boundary, 0)).toEqual([80.5, 3.6]);
    expect(at(lane(editor, 9).right_lane_boundary, 0)).toEqual([80.5, 3.6]);
    expect(at(lane(editor, 4).left_lane_boundary, -1)).toEqual([80, 7.03]);
  });

  test("moves lanes that lie on each other as one", () => {
    const editor = open();
    editor.actions.moveVertex(vertex(20, "left", 0), { x: -1, y: 43.5 });
    expect(at(lane(editor, 21).right_lane_boundary, -1)).toEqual([-1, 43.5]);
  });

  test("keeps every digit of a vertex that it is put onto", () => {
    const base = workspaceOf();
    const exact = 3.5100000000000002 + 1e-13;
    const lanes = base.base.lanes.map(({ version, attributes }) =>
      attributes.id === 20
        ? {
            version,
            attributes: {
              ...attributes,
              left_lane_boundary: [
                { x: 1 / 3, y: exact, z: 1 },
                { x: 9, y: 44, z: 1 },
              ],
            },
          }
        : { version, attributes },
    );
    const editor = createEditor({ ...base, base: { ...base.base, lanes } }, idBlocks());
    editor.actions.moveVertex(vertex(12, "left", 1), { x: 1 / 3, y: exact });
    expect(at(lane(editor, 12).left_lane_boundary, 1)).toEqual([1 / 3, exact]);
  });

  test("onto the next vertex is refused with the reason", () => {
    const editor = open();
    const outcome = editor.actions.moveVertex(vertex(1, "left", 2), { x: 30, y: 3.51 });
    expect(reasonOf(outcome)).toContain("Two vertices");
    expect(editor.getState().notice?.text).toContain("Two vertices");
    expect(editor.getState().current).toBe(editor.getState().saved);
  });

  test("is refused where the task is open for reading only", () => {
    const editor = createEditor(workspaceOf({ canEdit: false }), idBlocks());
    expect(editor.actions.moveVertex(vertex(1, "left", 2), { x: 20, y: 4 }).ok).toBe(false);
    expect(editor.getState().history.done).toEqual([]);
  });
});

describe("a drag", () => {
  test("is in neither map nor history until it is let go", () => {
    const editor = open();
    editor.actions.stageVertex(vertex(1, "right", 1), { x: 10, y: -0.4 });
    editor.actions.stageVertex(vertex(1, "right", 1), { x: 10, y: -0.5 });
    expect(editor.getState().current).toBe(editor.getState().saved);
    expect(editor.getState().staged?.changes).toHaveLength(1);
    editor.actions.commitStaged();
    expect(at(lane(editor, 1).right_lane_boundary, 1)).toEqual([10, -0.5]);
    expect(editor.getState().history.done).toHaveLength(1);
  });

  test("given up leaves nothing behind", () => {
    const editor = open();
    editor.actions.stageElement({ kind: "lane_segment", id: 12 }, { x: 3, y: 0 });
    editor.actions.cancel();
    expect(editor.getState().staged).toBeNull();
    expect(editor.getState().current).toBe(editor.getState().saved);
  });
});

describe("adding and removing vertices", () => {
  test("a new vertex stands in both copies and is selected", () => {
    const editor = open();
    editor.actions.select({ kind: "lane_segment", id: 3 });
    editor.actions.addVertex(vertex(3, "left", 0));
    expect(at(lane(editor, 3).left_lane_boundary, 1)).toEqual([5, 7.03]);
    expect(at(lane(editor, 6).left_lane_boundary, -2)).toEqual([5, 7.03]);
    expect(editor.getState().selection?.vertex).toEqual({ side: "left", index: 1 });
  });

  test("a removed vertex goes from both copies", () => {
    const editor = open();
    editor.actions.removeVertex(vertex(2, "left", 1));
    expect(lane(editor, 2).left_lane_boundary).toHaveLength(4);
    expect(lane(editor, 4).right_lane_boundary).toHaveLength(4);
  });

  test("a joint stays", () => {
    const editor = open();
    const outcome = editor.actions.removeVertex(vertex(1, "right", 4));
    expect(outcome).toEqual({ ok: false, reason: "Lanes meet at this vertex. Move it instead." });
  });

  test("two vertices are the least", () => {
    const editor = open();
    expect(editor.actions.removeVertex(vertex(12, "left", 1))).toEqual({
      ok: false,
      reason: "A boundary needs at least two vertices.",
    });
  });
});

test("moving a lane takes the lines that it shares and its joints along", () => {
  const editor = open();
  editor.actions.moveElement({ kind: "lane_segment", id: 1 }, { x: 0, y: 0.5 });
  expect(at(lane(editor, 3).right_lane_boundary, 2)).toEqual([20, 4.01]);
  expect(at(lane(editor, 2).right_lane_boundary, 0)).toEqual([40, 0.57]);
  expect(at(lane(editor, 2).right_lane_boundary, 1)).toEqual([50, 0.07]);
  expect(at(lane(editor, 3).left_lane_boundary, 2)).toEqual([20, 7.03]);
});

test("arrow keys nudge the selected vertex, else the selected element", () => {
  const editor = open();
  editor.actions.select({ kind: "pedestrian_crossing", id: 1 }, { vertex: { side: "edge1", index: 0 } });
  editor.actions.nudge({ x: 0.05, y: 0 });
  expect(at(editor.getState().current.crossings.get(1)?.edge1 ?? [], 0)).toEqual([58.55, -1]);
  editor.actions.select({ kind: "pedestrian_crossing", id: 1 });
  editor.actions.nudge({ x: 0, y: 0.5 });
  expect(at(editor.getState().current.crossings.get(1)?.edge2 ?? [], 1)).toEqual([61.5, 11.7]);
});
