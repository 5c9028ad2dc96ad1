import { describe, expect, test } from "vitest";
import { elementOf } from "./document";
import { equalElements } from "./equality";
import { cut, lane, open, partsOf, REACH } from "./testCuts";
import { brokenInvariants } from "./testInvariants";
import { at, reasonOf } from "./testRoad";

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

  test("of what is left where a part was deleted is a part still, and says so", async () => {
    const editor = open();
    const [one, other] = await cut(editor, 1, 16, 2);
    await editor.actions.cutLane(other.id, { x: 24, y: 2 }, REACH);
    const [last = 0] = lane(editor, other.id).successors;
    editor.actions.deleteElement({ kind: "lane_segment", id: last });
    expect(reasonOf(editor.actions.joinLane(one.id))).toBe("");
    expect(editor.getState().notice?.text).toBe(`Joined lanes ${one.id} and ${other.id}: lane ${one.id}.`);
    expect(at(lane(editor, one.id).left_lane_boundary, -1)).toEqual([24, 3.51]);
    expect(editor.getState().current.lanes.has(1)).toBe(false);
  });

  test("of a lane whose end was moved with what follows makes it whole again", async () => {
    const editor = open();
    const [one, other] = await cut(editor, 1, 16, 2);
    for (const side of ["left", "right"] as const) {
      const index = (side === "left" ? other.left_lane_boundary : other.right_lane_boundary).length - 1;
      editor.actions.moveVertex(
        { kind: "lane_segment", id: other.id, side, index },
        { x: 36, y: side === "left" ? 3.51 : 0.07 },
      );
    }
    editor.actions.joinLane(one.id);
    expect(at(lane(editor, 1).right_lane_boundary, -1)).toEqual([36, 0.07]);
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

test("reverting a part reaches what it shares with the parts of a lane cut beside it", async () => {
  const editor = open();
  const [one] = await cut(editor, 1, 16, 2);
  const [beside] = await cut(editor, 3, 16, 5);
  const shared = { kind: "lane_segment", id: one.id, side: "left", index: 1 } as const;
  editor.actions.moveVertex(shared, { x: 10, y: 4.5 });
  editor.actions.setMark(one.id, "left", "SOLID_WHITE");
  expect(at(lane(editor, beside.id).right_lane_boundary, 1)).toEqual([10, 4.5]);
  editor.actions.revertElement({ kind: "lane_segment", id: one.id });
  expect(at(lane(editor, beside.id).right_lane_boundary, 1)).toEqual([10, 3.51]);
  expect(lane(editor, beside.id).right_lane_mark_type).toBe("DASH_SOLID_WHITE");
  expect(brokenInvariants(editor.getState().base, editor.getState().current)).toEqual([]);
});
