import { expect, test } from "vitest";
import { countChanges, countEdits } from "./workState";

test("a lane drawn between two others counts once, though their links follow", () => {
  const links = { successors: [7] };
  expect(
    countEdits([
      { operation: "update", kind: "lane_segment", id: 1, attributes: links },
      {
        operation: "update",
        kind: "lane_segment",
        id: 2,
        attributes: { predecessors: [7], right_neighbor_id: 7 },
      },
      { operation: "insert", kind: "lane_segment", id: 7, attributes: links },
    ]),
  ).toBe(1);
});

test("a lane that is cut counts once", () => {
  expect(
    countEdits([
      { operation: "delete", kind: "lane_segment", id: 1, attributes: {} },
      { operation: "delete", kind: "pedestrian_crossing", id: 1, attributes: {} },
      { operation: "insert", kind: "lane_segment", id: 7, attributes: { part_of: 1 } },
      { operation: "insert", kind: "lane_segment", id: 8, attributes: { part_of: 1 } },
    ]),
  ).toBe(2);
});

test("links alone are still something to save", () => {
  expect(
    countEdits([{ operation: "update", kind: "lane_segment", id: 1, attributes: { successors: [] } }]),
  ).toBe(1);
});

test("what a kept draft declares counts once, and only where it differs from what stands", () => {
  const macros = { shape: true, appearance: false, function: false, lane_graph: false, lane_number: 0 };
  const declarations = [{ elements: [{ kind: "lane_segment" as const, id: 1 }], macros }];
  expect(countChanges({ edits: [], declarations }, [])).toBe(1);
  expect(countChanges({ edits: [], declarations }, declarations)).toBe(0);
  expect(countChanges({ edits: [], declarations: null }, declarations)).toBe(0);
});
