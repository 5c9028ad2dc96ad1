import { describe, expect, it } from "vitest";
import type { ConflictingElement } from "../api/types";
import type { Edit } from "../editor";
import { differingNames, type Side, settledEdits } from "./settle";

const edit = (id: number, change: Partial<Edit> = {}): Edit => ({
  operation: "update",
  kind: "lane_segment",
  id,
  attributes: { lane_type: "BUS" },
  ...change,
});
const conflict = (change: Partial<ConflictingElement> = {}): ConflictingElement => ({
  kind: "lane_segment",
  id: 7,
  base: { id: 7, lane_type: "VEHICLE", is_intersection: false },
  mine: { id: 7, lane_type: "BUS", is_intersection: false },
  theirs: { id: 7, lane_type: "BIKE", is_intersection: false },
  ...change,
});
const choose = (side: Side) => new Map([["lane_segment:7", side]]);

describe("settling a stale save", () => {
  it("keeps edits that nobody contradicts as they are", () => {
    expect(settledEdits([edit(1), edit(7)], [conflict()], choose("theirs"))).toEqual([edit(1)]);
  });

  it("keeps mine by changing only what differs from theirs", () => {
    expect(settledEdits([edit(7)], [conflict()], choose("mine"))).toEqual([edit(7)]);
  });

  it("inserts mine again where they deleted it", () => {
    expect(settledEdits([edit(7)], [conflict({ theirs: null })], choose("mine"))).toEqual([
      edit(7, { operation: "insert", attributes: { lane_type: "BUS", is_intersection: false } }),
    ]);
  });

  it("deletes theirs where mine is the deletion", () => {
    const mine = edit(7, { operation: "delete", attributes: {} });
    expect(settledEdits([mine], [conflict({ mine: null })], choose("mine"))).toEqual([mine]);
  });

  it("has nothing to do where both did the same", () => {
    const both = conflict().mine;
    expect(settledEdits([edit(7)], [conflict({ theirs: both })], choose("mine"))).toEqual([]);
  });

  it("takes the parts away with a cut lane that stays theirs, and links to the lane again", () => {
    const part = (id: number) => edit(id, { operation: "insert", attributes: { part_of: 7 } });
    const cut = [
      edit(7, { operation: "delete", attributes: {} }),
      edit(1, { attributes: { successors: [901, 5], left_neighbor_id: 902 } }),
      part(901),
      part(902),
    ];
    const lost = conflict({ mine: null });
    const linked = (attributes: Edit["attributes"]) => [edit(1, { attributes })];
    expect(settledEdits(cut, [lost], choose("theirs"))).toEqual(
      linked({ successors: [7, 5], left_neighbor_id: 7 }),
    );
    expect(settledEdits(cut, [{ ...lost, theirs: null }], choose("theirs"))).toEqual(
      linked({ successors: [5], left_neighbor_id: null }),
    );
    expect(settledEdits(cut, [lost], choose("mine"))).toHaveLength(4);
  });

  it("names what differs between two versions", () => {
    expect(differingNames(conflict().base, conflict().mine)).toEqual(["lane_type"]);
  });
});
