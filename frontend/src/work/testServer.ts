/** A server by its answers and a task of one lane, for tests of sessions. */
import { vi } from "vitest";
import { createEditor } from "../editor";
import { WorkSession } from "./workSession";

export const KEY = { account: 1, task: 12 };
const NOTHING_KEPT = { serverVersion: 0, synced: true, sent: null, keptAt: null };

const points = (y: number) => [0, 10].map((x) => ({ x, y, z: 0 }));
const lane = {
  id: 7,
  is_intersection: false,
  lane_type: "VEHICLE",
  left_lane_boundary: points(3),
  left_lane_mark_type: "NONE",
  right_lane_boundary: points(0),
  right_lane_mark_type: "NONE",
  successors: [],
  predecessors: [],
  right_neighbor_id: null,
  left_neighbor_id: null,
};
const repainted = { ...lane, left_lane_mark_type: "SOLID_WHITE" };
const NO_FINDINGS = { changes: [], updates: [], violations: [] };

interface Sent {
  path: string;
  body: Record<string, unknown>;
}
type Reply = () => [status: number, body: unknown];

/** A server by its answers; what it was sent is noted. Every check finds nothing. */
export function serverWith(replies: Record<string, Reply>): Sent[] {
  const sent: Sent[] = [];
  vi.stubGlobal("fetch", async (request: Request) => {
    const path = `${request.method} ${new URL(request.url).pathname.split("/").at(-1) ?? ""}`;
    const text = await request.text();
    sent.push({ path, body: JSON.parse(text || "{}") as Record<string, unknown> });
    const [status, body] = replies[path]?.() ?? [200, NO_FINDINGS];
    if (status === 0) throw new TypeError("Failed to fetch");
    return new Response(JSON.stringify(body), { status });
  });
  return sent;
}

export function openWork(): WorkSession {
  const map = { lanes: [{ version: 0, attributes: lane }], crossings: [] };
  const editor = createEditor(
    {
      task: { can_edit: true },
      revision: 0,
      base: map,
      changed: { lanes: [], crossings: [] },
      removed: [],
      declarations: [],
    },
    () => Promise.reject(new Error("no ids are needed")),
  );
  const work = new WorkSession(KEY, editor, NOTHING_KEPT);
  work.start();
  return work;
}

export const kept = (): [number, unknown] => [200, { version: 31, kept_at: "2026-01-01T00:00:00Z" }];
export const saved = (): [number, unknown] => [
  201,
  {
    task_id: 12,
    revision: 1,
    created_at: "2026-01-01T00:00:00Z",
    changed: { lanes: [{ version: 1, attributes: repainted }], crossings: [] },
    removed: [],
    canonical: [],
    joined: [],
    cut: [],
    declarations: [],
    restored: [],
    findings: NO_FINDINGS,
  },
];
export const state = (work: WorkSession) => work.store.getState();
