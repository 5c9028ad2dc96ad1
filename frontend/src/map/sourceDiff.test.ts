import { expect, test } from "vitest";
import { createEditor } from "../editor";
import { idBlocks, workspaceOf } from "../editor/testRoad";
import { projectionOf } from "./projection";
import { ShownElements } from "./sourceDiff";

const projection = projectionOf({ city: "PIT", epsg: 32617, origin_east: 583710.007, origin_north: 4477260 });

function shown() {
  const editor = createEditor(workspaceOf(), idBlocks());
  const elements = new ShownElements(projection);
  const update = () => {
    const { base, current, changedKeys } = editor.getState();
    return elements.update(base, current, changedKeys);
  };
  const groups = (id: number) =>
    elements
      .all("areas")
      .filter(({ properties }) => String(properties?.fid).startsWith(`lane_segment:${id}:`))
      .map(({ properties }) => [String(properties?.group), String(properties?.change)]);
  update();
  return { editor, update, groups, elements };
}

test("an unchanged element is one feature for all views, and nothing is sent when nothing changed", () => {
  const { update, groups } = shown();
  expect(groups(1)).toEqual([["both", ""]]);
  expect(update()).toBeNull();
});

test("after an edit only the touched elements are sent anew", () => {
  const { editor, update, groups } = shown();
  editor.actions.setMark(1, "left", "SOLID_YELLOW");
  const updates = update();
  const touched = (ids: readonly string[]) => new Set(ids.map((fid) => fid.split(":")[1]));
  expect(touched(updates?.areas.remove ?? [])).toEqual(new Set(["1", "3"]));
  expect(groups(1)).toEqual([
    ["base", ""],
    ["edited", "marking"],
  ]);
  editor.actions.undo();
  update();
  expect(groups(1)).toEqual([["both", ""]]);
});

test("a deleted element stays as gone, an inserted one is only in the edited map", async () => {
  const { editor, update, groups } = shown();
  editor.actions.deleteElement({ kind: "lane_segment", id: 12 });
  await editor.actions.insertLaneBeside(1, "right");
  update();
  expect(groups(12)).toEqual([["gone", "deletion"]]);
  expect(groups(90_000_001)).toEqual([["edited", "insertion"]]);
  editor.actions.undo();
  update();
  expect(groups(90_000_001)).toEqual([]);
});

test("several changes on one element are told together, for the stripes", () => {
  const { editor, update, groups } = shown();
  editor.actions.setLaneType(12, "BUS");
  editor.actions.setMark(12, "left", "SOLID_WHITE");
  update();
  expect(groups(12)).toEqual([
    ["base", ""],
    ["edited", "marking+type"],
  ]);
});

test("feature ids are unique, as updates need them", () => {
  const { elements } = shown();
  for (const source of ["areas", "paint", "arrows"] as const) {
    const ids = elements.all(source).map(({ properties }) => String(properties?.fid));
    expect(new Set(ids).size).toBe(ids.length);
  }
});
