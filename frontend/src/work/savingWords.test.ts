import { expect, it } from "vitest";
import { Problem } from "../api/problem";
import { savingWords } from "./savingWords";
import type { WorkState } from "./workState";

const NOW = Date.UTC(2026, 0, 1);
const words = (state: Partial<WorkState>) =>
  savingWords({ edits: 3, revision: 12, keeping: { where: "computer" }, saving: "no", ...state }, NOW).text;

it("says how much is unsaved since which revision, and how old the server's copy is", () => {
  expect(words({ keeping: { where: "server", at: NOW - 12_000 } })).toBe(
    "3 changes since revision 12 · draft kept 12 s ago",
  );
  expect(words({ edits: 1 })).toBe("1 change since revision 12 · kept on this computer");
});

it("says when the work is on this computer only", () => {
  expect(words({ keeping: { where: "offline" } })).toContain("offline: kept on this computer");
  const problem = new Problem(409, "task.state", "The task was submitted.", "");
  expect(words({ keeping: { where: "refused", problem } })).toContain("only: The task was submitted.");
});

it("says when nothing is unsaved", () => {
  expect(words({ edits: 0 })).toBe("all saved · revision 12");
  expect(words({ edits: 0, revision: 0 })).toBe("no changes yet");
});

it("says that a save waits for the server", () => {
  expect(words({ saving: "waiting" })).toContain("trying again");
});
