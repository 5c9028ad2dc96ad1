/** Lanes of the test road cut in an editor of their own. For tests. */
import { expect } from "vitest";
import { createEditor } from "./store";
import { idBlocks, reasonOf, workspaceOf } from "./testRoad";

export const open = () => createEditor(workspaceOf(), idBlocks());
export type Opened = ReturnType<typeof open>;
export const lane = (editor: Opened, id: number) => {
  const found = editor.getState().current.lanes.get(id);
  if (found === undefined) throw new Error(`no lane ${id}`);
  return found;
};
export const partsOf = (editor: Opened, whole: number) =>
  [...editor.getState().current.lanes.values()].filter(({ part_of }) => part_of === whole);
export const REACH = 0.5;

export async function cut(editor: Opened, id: number, x: number, y: number) {
  const done = await editor.actions.cutLane(id, { x, y }, REACH);
  expect(reasonOf(done)).toBe("");
  const [one, other] = partsOf(editor, id);
  if (one === undefined || other === undefined) throw new Error("not cut");
  return [one, other] as const;
}
