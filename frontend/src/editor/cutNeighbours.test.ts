import { expect, test } from "vitest";
import type { Lane } from "./elements";
import { createEditor } from "./store";
import { cut, lane, REACH } from "./testCuts";
import { CROSSINGS, idBlocks, LANES, wireMap, workspaceOf } from "./testRoad";

/** The test road with other neighbour ids. */
function openWith(ids: Readonly<Record<number, Partial<Lane>>>) {
  const lanes = LANES.map((one) => ({ ...one, ...ids[one.id] }));
  return createEditor({ ...workspaceOf(), base: wireMap(lanes, CROSSINGS) }, idBlocks());
}

const NONE = { left_neighbor_id: null, right_neighbor_id: null };

test("cut and joined again, a lane keeps its neighbour outside the map", async () => {
  const editor = openWith({ 1: { right_neighbor_id: 777 } });
  const [one, other] = await cut(editor, 1, 16, 2);
  expect([one.right_neighbor_id, other.right_neighbor_id]).toEqual([777, 777]);
  editor.actions.joinLane(one.id);
  expect(editor.actions.netEdits()).toEqual([]);
});

test("lanes that share a line and name no neighbour are not made neighbours", async () => {
  const editor = openWith({ 1: NONE, 3: NONE, 6: NONE });
  const [one] = await cut(editor, 1, 16, 2);
  await editor.actions.cutLane(3, { x: 16, y: 5 }, REACH);
  expect(lane(editor, one.id).left_neighbor_id).toBeNull();
  editor.actions.joinLane(one.id);
  const [part] = [...editor.getState().current.lanes.values()].filter(({ part_of }) => part_of === 3);
  editor.actions.joinLane(part?.id ?? 0);
  expect(editor.actions.netEdits()).toEqual([]);
});

test("a neighbour that only one lane names is named by that one again", async () => {
  const editor = openWith({ 1: NONE });
  const [one] = await cut(editor, 1, 16, 2);
  editor.actions.joinLane(one.id);
  expect(editor.actions.netEdits()).toEqual([]);
});

test("a cut writes nothing on the other side of the lane beside", async () => {
  const editor = openWith({ 3: { left_neighbor_id: null }, 6: NONE });
  await cut(editor, 1, 16, 2);
  expect(lane(editor, 3).left_neighbor_id).toBeNull();
  expect(editor.actions.netEdits().map(({ id }) => id)).not.toContain(6);
});
