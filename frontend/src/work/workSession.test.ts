import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { sessionStore } from "../api/sessionStore";
import { readDraft, removeDraft } from "./browserStore";
import { KEY, kept, openWork, saved, serverWith, state } from "./testServer";
import type { WorkSession } from "./workSession";

let work: WorkSession;
beforeEach(() => sessionStore.setState({ session: null }));
afterEach(async () => {
  work.end();
  vi.unstubAllGlobals();
  await removeDraft(KEY);
});

it("keeps an edit on this computer before the server has it, and then on the server", async () => {
  const sent = serverWith({ "PUT draft": kept });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  await vi.waitFor(async () => expect((await readDraft(KEY))?.edits).toHaveLength(1));
  expect(sent.some(({ path }) => path === "PUT draft")).toBe(false);
  expect(state(work)).toMatchObject({ edits: 1, keeping: { where: "computer" } });

  await vi.waitFor(() => expect(state(work).keeping.where).toBe("server"), { timeout: 5_000 });
  expect(sent.find(({ path }) => path === "PUT draft")?.body).toMatchObject({ base_revision: 0, version: 0 });
  await vi.waitFor(async () =>
    expect(await readDraft(KEY)).toMatchObject({ synced: true, serverVersion: 31 }),
  );
});

it("clears the draft only after the server has answered the save", async () => {
  let letGo = () => {};
  const answered = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  serverWith({});
  const fetchAtOnce = globalThis.fetch as unknown as (request: Request) => Promise<Response>;
  vi.stubGlobal("fetch", async (request: Request) => {
    if (!request.url.endsWith("/revisions")) return fetchAtOnce(request);
    await answered;
    const [status, body] = saved();
    return new Response(JSON.stringify(body), { status });
  });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  const outcome = work.save();
  await vi.waitFor(async () => expect((await readDraft(KEY))?.sent).not.toBeNull());
  expect(state(work).saving).toBe("sending");
  letGo();
  expect((await outcome).kind).toBe("saved");
  expect(await readDraft(KEY)).toBeNull();
  expect(state(work)).toMatchObject({ edits: 0, revision: 1, keeping: { where: "nothing" } });
});

it("sends the very same changeset again until the server answers", async () => {
  const answers: [number, unknown][] = [
    [0, null],
    [503, { message: "The database cannot be reached." }],
    saved(),
  ];
  const sent = serverWith({ "POST revisions": () => answers.shift() ?? saved() });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  const outcome = work.save();
  await vi.waitFor(() => expect(state(work).saving).toBe("waiting"));
  globalThis.dispatchEvent(new Event("online"));
  await vi.waitFor(() => expect(sent.filter(({ path }) => path === "POST revisions")).toHaveLength(2));
  await vi.waitFor(() => expect(state(work).saving).toBe("waiting"));
  globalThis.dispatchEvent(new Event("online"));
  expect((await outcome).kind).toBe("saved");
  const saves = sent.filter(({ path }) => path === "POST revisions").map(({ body }) => body);
  expect(saves).toHaveLength(3);
  expect(saves[1]).toEqual(saves[0]);
  expect(saves[2]).toEqual(saves[0]);
});

it("keeps the draft and shows the violations when the rules refuse the save", async () => {
  const violation = { id: "link.gap:lane_segment:7", blocks: true, inherited: false };
  serverWith({
    "POST revisions": () => [
      422,
      {
        code: "save.violations",
        message: "1 error stops the save.",
        mend: "",
        facts: { violations: [violation] },
      },
    ],
  });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  expect((await work.save()).kind).toBe("violations");
  expect(state(work).findings?.violations).toEqual([violation]);
  expect(await readDraft(KEY)).toMatchObject({ sent: null, edits: [{ id: 7 }] });
});

it("keeps edits that are made while the save is under way as the next draft", async () => {
  serverWith({ "POST revisions": saved, "PUT draft": kept });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  const outcome = work.save();
  work.editor.actions.setLaneType(7, "BUS");
  await outcome;
  expect(state(work)).toMatchObject({ edits: 1, revision: 1 });
  expect(await readDraft(KEY)).toMatchObject({
    baseRevision: 1,
    edits: [{ attributes: { lane_type: "BUS" } }],
  });
});

it("offers the newer draft that another computer kept instead of writing over it", async () => {
  const newer = { base_revision: 0, edits: [], version: 40, kept_at: "2026-01-01T00:00:00Z" };
  serverWith({
    "PUT draft": () => [
      409,
      { code: "draft.newer", message: "There is a newer draft.", facts: { draft: newer } },
    ],
  });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  await vi.waitFor(() => expect(state(work).newerDraft).toEqual(newer), { timeout: 5_000 });
  expect(await readDraft(KEY)).toMatchObject({ edits: [{ id: 7 }] });
});

it("keeps and saves what is declared, also without an edit", async () => {
  const macros = { shape: true, appearance: false, function: false, lane_graph: false, lane_number: 0 };
  const declarations = [{ elements: [{ kind: "lane_segment" as const, id: 7 }], macros }];
  const answer = saved()[1] as object;
  const sent = serverWith({
    "PUT draft": kept,
    "POST revisions": () => [201, { ...answer, changed: { lanes: [], crossings: [] }, declarations }],
  });
  work = openWork();
  work.editor.actions.declare([{ kind: "lane_segment", id: 7 }], macros);
  await vi.waitFor(() => expect(state(work).keeping.where).toBe("server"), { timeout: 5_000 });
  expect(sent.find(({ path }) => path === "PUT draft")?.body).toMatchObject({ edits: [], declarations });
  expect((await work.save()).kind).toBe("saved");
  expect(sent.find(({ path }) => path === "POST revisions")?.body).toMatchObject({ edits: [], declarations });
  expect(state(work)).toMatchObject({ edits: 0, keeping: { where: "nothing" } });
});

it("keeps a draft although another device has saved since it was begun", async () => {
  const answers: [number, unknown][] = [
    [409, { code: "draft.superseded", message: "You have saved since.", facts: { version: 9, revision: 1 } }],
    kept(),
  ];
  const sent = serverWith({ "PUT draft": () => answers.shift() ?? kept() });
  work = openWork();
  work.editor.actions.setMark(7, "left", "SOLID_WHITE");
  await vi.waitFor(() => expect(state(work).keeping.where).toBe("server"), { timeout: 5_000 });
  expect(sent.filter(({ path }) => path === "PUT draft").map(({ body }) => body.version)).toEqual([0, 9]);
});
