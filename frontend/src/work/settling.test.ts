import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { sessionStore } from "../api/sessionStore";
import { parkedDrafts, readDraft, removeDraft, removeParked } from "./browserStore";
import { KEY, kept, openWork, saved, serverWith, state } from "./testServer";
import type { WorkSession } from "./workSession";

const STALE = { head: 1, conflicts: [], declarations: [] };

let work: WorkSession;
beforeEach(() => sessionStore.setState({ session: null }));
afterEach(async () => {
  work.end();
  vi.unstubAllGlobals();
  await removeDraft(KEY);
});

it("leaves no draft behind where settling a stale base leaves nothing of it", async () => {
  const sent = serverWith({ "PUT draft": kept });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  await vi.waitFor(() => expect(state(work).keeping.where).toBe("server"), { timeout: 5_000 });
  await work.rebase(STALE, []);
  expect(await readDraft(KEY)).toBeNull();
  expect(sent.at(-1)?.path).toBe("DELETE draft");
});

it("goes on keeping what is drawn where settling a stale base failed", async () => {
  serverWith({ "PUT draft": kept, "DELETE draft": () => [500, { code: "x", message: "It broke." }] });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  await vi.waitFor(() => expect(state(work).keeping.where).toBe("server"), { timeout: 5_000 });
  await expect(work.rebase(STALE, [])).rejects.toMatchObject({ message: "It broke." });
  work.editor.actions.setLaneType(7, "BUS");
  await vi.waitFor(async () =>
    expect((await readDraft(KEY))?.edits).toMatchObject([{ attributes: { lane_type: "BUS" } }]),
  );
  expect(state(work).edits).toBe(1);
});

it("sets aside what was edited during a save on a lane that the save took out", async () => {
  const answer = saved()[1] as object;
  const removed = [{ kind: "lane_segment", id: 7 }];
  serverWith({
    "POST revisions": () => [201, { ...answer, changed: { lanes: [], crossings: [] }, removed }],
  });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  const outcome = work.save();
  work.editor.actions.setLaneType(7, "BUS");
  await outcome;
  const [parked] = await parkedDrafts(KEY);
  expect(parked?.draft).toMatchObject({
    baseRevision: 1,
    edits: [{ id: 7, attributes: { lane_type: "BUS" } }],
  });
  expect(work.editor.getState().notice?.text).toContain("lane 7 does not fit the saved map: it is set aside");
  await removeParked(parked?.id ?? 0);
});

it("settles a stale base without withdrawing what others declared meanwhile", async () => {
  serverWith({ "PUT draft": kept });
  work = openWork();
  const macros = { shape: true, appearance: false, function: false, lane_graph: false, lane_number: 0 };
  const about = (id: number) => ({ elements: [{ kind: "lane_segment" as const, id }], macros });
  work.editor.actions.declare(about(7).elements, macros);
  await work.rebase({ ...STALE, declarations: [about(8)] }, []);
  expect(await readDraft(KEY)).toMatchObject({ baseRevision: 1, declarations: [about(7), about(8)] });

  await work.rebase({ ...STALE, declarations: [about(7)] }, []);
  expect(await readDraft(KEY)).toBeNull();
});

it("discards a draft on this computer and on the server before the task is opened anew", async () => {
  const sent = serverWith({ "PUT draft": kept });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  await vi.waitFor(() => expect(state(work).keeping.where).toBe("server"), { timeout: 5_000 });
  await work.discard();
  expect(await readDraft(KEY)).toBeNull();
  expect(sent.at(-1)?.path).toBe("DELETE draft");
});
