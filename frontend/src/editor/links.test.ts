import { expect, test } from "vitest";
import { createEditor } from "./store";
import { idBlocks, workspaceOf } from "./testRoad";

const open = () => createEditor(workspaceOf(), idBlocks());
type Opened = ReturnType<typeof open>;
const lane = (editor: Opened, id: number) => {
  const found = editor.getState().current.lanes.get(id);
  if (found === undefined) throw new Error(`no lane ${id}`);
  return found;
};
const corner = (side: "left" | "right") => ({ kind: "lane_segment", id: 8, side, index: 0 }) as const;

test("a link is taken out on both lanes, and their ends can be dragged apart", () => {
  const editor = open();
  editor.actions.unlink(2, 8);
  expect(lane(editor, 2).successors).toEqual([7]);
  expect(lane(editor, 8).predecessors).toEqual([]);
  editor.actions.moveVertex(corner("right"), { x: 81, y: -1 });
  expect(lane(editor, 2).right_lane_boundary.at(-1)).toMatchObject({ x: 80, y: 0.07 });
});

test("an end dragged onto the end of another lane is linked with it once both corners meet", () => {
  const editor = open();
  editor.actions.unlink(2, 8);
  editor.actions.moveVertex(corner("left"), { x: 80, y: 7.03 });
  expect(lane(editor, 8).predecessors).toEqual([]);
  editor.actions.moveVertex(corner("right"), { x: 80, y: 3.51 });
  expect(lane(editor, 8).predecessors).toEqual([4]);
  expect(lane(editor, 4).successors).toEqual([9, 8]);
  editor.actions.undo();
  expect(lane(editor, 4).successors).toEqual([9]);
});
