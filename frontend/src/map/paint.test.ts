import { describe, expect, test } from "vitest";
import { mirrored } from "../editor";
import { LANES } from "../editor/testRoad";
import { dashes, paintedLines } from "./paint";

const lane = (id: number) => {
  const found = LANES.find((one) => one.id === id);
  if (found === undefined) throw new Error(`no lane ${id}`);
  return found;
};

describe("a line that two lanes share is painted once, not twice askew", () => {
  test("for neighbours, with mixed paint", () => {
    expect(paintedLines(lane(1), "left")).toEqual(
      paintedLines(lane(3), "right").toSorted((a, b) => Number(a.offset === b.offset) - 1),
    );
  });

  test("for oncoming lanes, whose copies run against each other", () => {
    const one = { ...lane(4), left_lane_mark_type: "SOLID_DASH_YELLOW" } as const;
    const other = { ...lane(5), left_lane_mark_type: mirrored("SOLID_DASH_YELLOW") };
    const strokes = (lines: ReturnType<typeof paintedLines>) =>
      lines
        .map(
          ({ offset, parts }) =>
            `${offset} ${parts.length} ${JSON.stringify(parts[0]?.map(({ x, y }) => [x, y]))}`,
        )
        .sort();
    expect(strokes(paintedLines(one, "left"))).toEqual(strokes(paintedLines(other, "left")));
  });
});

test("the first word of mixed paint lies nearer to the lane", () => {
  //  lane 1 runs east; its left boundary has the lane on the right of the line
  const [solid, dashed] = paintedLines(lane(1), "left");
  expect(solid).toMatchObject({ offset: 1, parts: { length: 1 } });
  expect(dashed?.offset).toBe(-1);
  expect(dashed?.parts.length).toBeGreaterThan(3);
});

test("what has no paint is one faint line", () => {
  expect(paintedLines(lane(12), "left")).toMatchObject([{ colour: "none", offset: 0 }]);
});

test("dashes begin and end a line and follow its bends", () => {
  const bent = [
    { x: 0, y: 0 },
    { x: 10, y: 0 },
    { x: 10, y: 10 },
  ];
  const parts = dashes(bent, 4, 4);
  expect(parts).toHaveLength(3);
  expect(parts[0]?.[0]).toEqual({ x: 0, y: 0 });
  expect(parts[1]).toHaveLength(3);
  expect(parts.at(-1)?.at(-1)?.y).toBeCloseTo(10);
});
