import { notifications } from "@mantine/notifications";
import { afterEach, expect, it, vi } from "vitest";
import type { Workspace } from "../../api/types";
import { openWork, serverWith } from "../../work/testServer";
import { createScreen, type WorkspaceValue } from "./context";
import { makeCanonical } from "./makeCanonical";

const MACROS = { shape: true, appearance: false, function: false, lane_graph: false, lane_number: 0 };
const LANE_7 = { kind: "lane_segment" as const, id: 7 };
const form = {
  edits: [{ operation: "update", ...LANE_7, attributes: { lane_type: "BUS" } }],
  renamed: [],
  joined: [],
  cut: [],
};

let work: ReturnType<typeof openWork>;
afterEach(() => {
  work.end();
  notifications.clean();
  vi.unstubAllGlobals();
});

function opened(): WorkspaceValue {
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  const nothing = { changed: { lanes: [], crossings: [] }, revisions: [], events: [] };
  const workspace = { task: { id: 12 }, ...nothing } as unknown as Workspace;
  const screen = createScreen(workspace);
  return { workspace, editor: work.editor, work, screen, mapRef: { current: null }, reopen: () => {} };
}

it("is asked for once, however often the key is pressed meanwhile", async () => {
  const sent = serverWith({ "POST canonical": () => [200, form] });
  const value = opened();
  await Promise.all([makeCanonical(value), makeCanonical(value)]);
  expect(sent.filter(({ path }) => path === "POST canonical")).toHaveLength(1);
  expect(value.editor.getState().current.lanes.get(7)?.lane_type).toBe("BUS");
});

it("leaves a declaration alone that was made while it was asked for", async () => {
  serverWith({ "POST canonical": () => [200, form] });
  const value = opened();
  const made = makeCanonical(value);
  value.editor.actions.declare([LANE_7], MACROS);
  await made;
  expect(value.editor.getState().declarations).toEqual([{ elements: [LANE_7], macros: MACROS }]);
  expect(value.editor.getState().current.lanes.get(7)?.lane_type).toBe("VEHICLE");
});
