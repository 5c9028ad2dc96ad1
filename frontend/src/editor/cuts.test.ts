import { describe, expect, test } from "vitest";
import { baseCutAlike } from "./parts";
import { cut, lane, type Opened, open, partsOf, REACH } from "./testCuts";
import { brokenInvariants } from "./testInvariants";
import { at, reasonOf } from "./testRoad";

describe("a cut", () => {
  test("of a lane that is too short says so, and sends nobody to another place on it", async () => {
    const editor = open();
    const drawn = await editor.actions.drawLane([
      { x: 0, y: 60 },
      { x: 0.8, y: 60 },
    ]);
    if (!drawn.ok) throw new Error(drawn.reason);
    const reason = reasonOf(await editor.actions.cutLane(drawn.key.id, { x: 0.4, y: 60 }, REACH));
    expect(reason).toContain("too short to cut");
    expect(reason).not.toContain("farther");
  });

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
