import { expect, it } from "vitest";
import { canonicalWords, renamedWords, retoldWords } from "./canonicalWords";

const lane = (from: number, to: number) => ({ kind: "lane_segment" as const, from, to });

it("names the first elements and counts the others", () => {
  expect(renamedWords([lane(12, 7), { kind: "pedestrian_crossing", from: 4, to: 9 }])).toBe(
    "lane 12 is now lane 7, crossing 4 is now crossing 9",
  );
  expect(renamedWords([lane(1, 2), lane(2, 3), lane(3, 4), lane(4, 5)])).toMatch(
    /lane 3 is now lane 4 and 1 more$/,
  );
});

it("tells which imported elements have their ids again", () => {
  const form = { renamed: [lane(12, 7), lane(7, 900)], joined: [], cut: [] };
  expect(canonicalWords(form, ({ id }) => id === 7)).toBe(
    "Made canonical. 1 id exchanged: lane 12 is now lane 7.",
  );
});

it("says how a save told the story", () => {
  expect(retoldWords({ canonical: [lane(12, 7)], joined: [9], cut: [] })).toBe(
    "Told as the simpler story: lane 12 is now lane 7; 1 lane joined with another in series.",
  );
  expect(retoldWords({ canonical: [], joined: [], cut: [] })).toBe("");
});
