import { describe, expect, test } from "vitest";
import { elementOf } from "./document";
import { equalElements } from "./equality";
import { baseCutAlike } from "./parts";
import { createEditor } from "./store";
import { brokenInvariants } from "./testInvariants";
import { at, idBlocks, reasonOf, workspaceOf } from "./testRoad";

const open = () => createEditor(workspaceOf(), idBlocks());
type Opened = ReturnType<typeof open>;
const lane = (editor: Opened, id: number) => {
  const found = editor.getState().current.lanes.get(id);
  if (found === undefined) throw new Error(`no lane ${id}`);
  return found;
};
const partsOf = (editor: Opened, whole: number) =>
  [...editor.getState().current.lanes.values()].filter(({ part_of }) => part_of === whole);
const REACH = 0.5;

async function cut(editor: Opened, id: number, x: number, y: number) {
  const done = await editor.actions.cutLane(id, { x, y }, REACH);
  expect(reasonOf(done)).toBe("");
  const [one, other] = partsOf(editor, id);
  if (one === undefined || other === undefined) throw new Error("not cut");
  return [one, other] as const;
}

describe("a cut", () => {
  test("gives two parts in series in the lane's place, square across it and rounded to the centimetre", async () => {
    const editor = open();
    const [one, other] = await cut(editor, 1, 16.004, 2);
    expect(at(one.left_lane_boundary, -1)).toEqual([16, 3.51]);
    expect(at(other.right_lane_boundary, 0)).toEqual([16, 0.07]);
    expect(one.left_lane_boundary.at(-1)).toBe(other.left_lane_boundary[0]);
    expect(editor.getState().current.lanes.has(1)).toBe(false);
    expect([one.predecessors, one.successors]).toEqual([[901], [other.id]]);
    expect([other.predecessors, other.successors]).toEqual([[one.id], [2]]);
    expect(lane(editor, 2).predecessors).toEqual([other.id]);
    expect(editor.getState().selection?.id).toBe(other.id);
    expect(brokenInvariants(editor.getState().base, editor.getState().current)).toEqual([]);
  });

  test("is no change by itself, and painting a part is a change of that part alone", async () => {
    const editor = open();
    const [, other] = await cut(editor, 1, 16, 2);
    expect([...editor.getState().changedKeys]).toEqual([]);
    editor.actions.setMark(other.id, "right", "DASHED_WHITE");
    expect([...editor.getState().changedKeys]).toEqual([[`lane_segment:${other.id}`, ["marking"]]]);
  });

  test("whose joint is moved is a change of both parts, and the imported line stays straight", async () => {
    const editor = open();
    const [one, other] = await cut(editor, 1, 16, 2);
    const corner = { kind: "lane_segment", id: other.id, side: "right", index: 0 } as const;
    editor.actions.moveVertex(corner, { x: 16, y: -1.2 });
    const { base, current, changedKeys } = editor.getState();
    expect([...changedKeys]).toEqual([
      [`lane_segment:${one.id}`, ["geometry"]],
      [`lane_segment:${other.id}`, ["geometry"]],
    ]);
    const imported = baseCutAlike(base, current).lanes.get(one.id)?.right_lane_boundary ?? [];
    expect(at(imported, -1)).toEqual([16, 0.07]);
  });

  test("whose joint is moved past the lane's end is still compared part by part", async () => {
    const editor = open();
    const [one] = await cut(editor, 1, 16, 2);
    const corner = { kind: "lane_segment", id: one.id, side: "right", index: 2 } as const;
    editor.actions.moveVertex(corner, { x: -9, y: 0.07 });
    const { base, current } = editor.getState();
    const imported = baseCutAlike(base, current).lanes.get(one.id)?.right_lane_boundary ?? [];
    expect(imported.length).toBeGreaterThan(1);
    expect(at(imported, 0)).toEqual([0, 0.07]);
  });

  test("tells the server which lane the parts were", async () => {
    const editor = open();
    await cut(editor, 1, 16, 2);
    const inserts = editor.actions.netEdits().filter(({ operation }) => operation === "insert");
    expect(inserts.map(({ attributes }) => attributes.part_of)).toEqual([1, 1]);
  });

  test("of a part keeps the part's id and the whole lane's name", async () => {
    const editor = open();
    const [one] = await cut(editor, 1, 16, 2);
    await editor.actions.cutLane(one.id, { x: 8, y: 2 }, REACH);
    const parts = partsOf(editor, 1);
    expect(parts).toHaveLength(3);
    expect(at(lane(editor, one.id).left_lane_boundary, -1)).toEqual([8, 3.51]);
  });

  test("goes onto a vertex within reach", async () => {
    const editor = open();
    const [one] = await cut(editor, 1, 10.3, 2);
    expect(one.left_lane_boundary).toHaveLength(2);
    expect(one.left_lane_boundary.at(-1)).toBe(elementLine(editor, 1)[1]);
  });

  test("beside another makes the parts neighbours whose shared line is painted as one", async () => {
    const editor = open();
    const [, other] = await cut(editor, 1, 16, 2);
    expect(other.left_neighbor_id).toBeNull();
    expect(lane(editor, 3).right_neighbor_id).toBeNull();
    const [, beside] = await cut(editor, 3, 16.3, 5);
    expect(lane(editor, other.id).left_neighbor_id).toBe(beside.id);
    editor.actions.setMark(other.id, "left", "SOLID_WHITE");
    expect(lane(editor, beside.id).right_lane_mark_type).toBe("SOLID_WHITE");
  });

  test("leaves the lane beside whole, and painting the shared piece says so", async () => {
    const editor = open();
    const [, other] = await cut(editor, 1, 16, 2);
    editor.actions.setMark(other.id, "right", "DASHED_WHITE");
    expect(editor.getState().notice?.text).not.toContain("painted otherwise");
    editor.actions.setMark(other.id, "left", "SOLID_WHITE");
    expect(editor.getState().notice?.text).toContain("Lane 3 holds this piece of line too");
  });

  test("of a lane drawn in this task makes two drawn lanes", async () => {
    const editor = open();
    const drawn = await editor.actions.insertLaneBeside(1, "right");
    if (!drawn.ok) throw new Error(drawn.reason);
    await editor.actions.cutLane(drawn.key.id, { x: 16, y: -2 }, REACH);
    const next = lane(editor, drawn.key.id).successors[0] ?? 0;
    expect([lane(editor, drawn.key.id).part_of, lane(editor, next).part_of]).toEqual([null, null]);
  });

  test("is refused near the lane's ends", async () => {
    const editor = open();
    expect(reasonOf(await editor.actions.cutLane(1, { x: 0.2, y: 2 }, 0.1))).toContain("ends");
    expect(editor.getState().history.done).toEqual([]);
  });
});

describe("a join", () => {
  test("of the parts gives back the imported lane", async () => {
    const editor = open();
    const [one] = await cut(editor, 3, 16, 5);
    expect(reasonOf(editor.actions.joinLane(one.id))).toBe("");
    const { base, current } = editor.getState();
    expect(current.lanes.size).toBe(base.lanes.size);
    for (const id of base.lanes.keys()) {
      const key = { kind: "lane_segment", id } as const;
      expect(equalElements(elementOf(base, key), elementOf(current, key))).toBe(true);
    }
    expect(editor.actions.netEdits()).toEqual([]);
  });

  test("leaves what was moved a little where the lanes behind and beside it have it", async () => {
    const editor = open();
    const [one, other] = await cut(editor, 1, 16, 2);
    for (const side of ["left", "right"] as const) {
      const last = (side === "left" ? other.left_lane_boundary : other.right_lane_boundary).length - 1;
      const [x, y] = [40, side === "left" ? 3.54 : 0.1];
      editor.actions.moveVertex({ kind: "lane_segment", id: other.id, side, index: last }, { x, y });
    }
    expect(reasonOf(editor.actions.joinLane(one.id))).toBe("");
    expect(at(lane(editor, 1).left_lane_boundary, -1)).toEqual([40, 3.54]);
    expect(brokenInvariants(editor.getState().base, editor.getState().current)).toEqual([]);
  });

  test("on vertices of the imported line keeps them", async () => {
    const editor = open();
    const [one, other] = await cut(editor, 1, 10, 2);
    await editor.actions.cutLane(other.id, { x: 20, y: 2 }, REACH);
    editor.actions.joinLane(one.id);
    editor.actions.joinLane(one.id);
    expect(editor.actions.netEdits()).toEqual([]);
  });

  test("of two of three parts is a part still", async () => {
    const editor = open();
    const [one, other] = await cut(editor, 1, 16, 2);
    await editor.actions.cutLane(other.id, { x: 24, y: 2 }, REACH);
    editor.actions.joinLane(one.id);
    expect(partsOf(editor, 1).map(({ id }) => id)).toContain(one.id);
    expect(at(lane(editor, one.id).left_lane_boundary, -1)).toEqual([24, 3.51]);
  });

  test("is refused where the parts differ, in words", async () => {
    const editor = open();
    const [one, other] = await cut(editor, 1, 16, 2);
    editor.actions.setLaneType(other.id, "BUS");
    for (const { id } of [one, other])
      expect(reasonOf(editor.actions.joinLane(id))).toContain("differ in the type");
  });

  test("of imported lanes is refused", () => {
    expect(reasonOf(open().actions.joinLane(3))).toContain("two lanes");
  });
});

test("reverting a part takes the cut back", async () => {
  const editor = open();
  const [one, other] = await cut(editor, 1, 16, 2);
  editor.actions.setMark(other.id, "right", "DASHED_WHITE");
  editor.actions.revertElement({ kind: "lane_segment", id: one.id });
  expect(editor.actions.netEdits()).toEqual([]);
});

test("reverting a part whose other parts were deleted or unlinked gives the whole lane alone", async () => {
  for (const spoil of ["delete", "unlink"] as const) {
    const editor = open();
    const [one, other] = await cut(editor, 1, 16, 2);
    if (spoil === "delete") editor.actions.deleteElement({ kind: "lane_segment", id: other.id });
    else editor.actions.unlink(one.id, other.id);
    editor.actions.revertElement({ kind: "lane_segment", id: one.id });
    expect(editor.actions.netEdits()).toEqual([]);
  }
});

test("a drawn lane turned round keeps its paint on the ground and joins what fits its new direction", async () => {
  const editor = open();
  const drawn = await editor.actions.insertLaneBeside(1, "right");
  if (!drawn.ok) throw new Error(drawn.reason);
  const { id } = drawn.key;
  editor.actions.setMark(id, "right", "SOLID_YELLOW");
  editor.actions.reverseLane(id);
  const turned = lane(editor, id);
  expect(turned.left_lane_mark_type).toBe("SOLID_YELLOW");
  expect(at(turned.left_lane_boundary, 0)[0]).toBe(40);
  expect(turned.right_neighbor_id).toBeNull();
  expect(lane(editor, 1).right_neighbor_id).toBeNull();
  expect(reasonOf(editor.actions.reverseLane(1))).toContain("imported");
});

function elementLine(editor: Opened, id: number) {
  const found = editor.getState().base.lanes.get(id);
  if (found === undefined) throw new Error(`no lane ${id}`);
  return found.left_lane_boundary;
}
