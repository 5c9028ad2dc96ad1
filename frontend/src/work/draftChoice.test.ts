import { describe, expect, it } from "vitest";
import type { Draft } from "../api/types";
import type { Edit } from "../editor";
import type { LocalDraft } from "./browserStore";
import { chooseDraft } from "./draftChoice";

const repaint: Edit = {
  operation: "update",
  kind: "lane_segment",
  id: 7,
  attributes: { left_lane_mark_type: "SOLID_WHITE" },
};
const deletion: Edit = { operation: "delete", kind: "pedestrian_crossing", id: 3, attributes: {} };

const local = (change: Partial<LocalDraft> = {}): LocalDraft => ({
  format: 1,
  baseRevision: 2,
  edits: [repaint],
  history: null,
  serverVersion: 5,
  synced: false,
  changedAt: 0,
  sent: null,
  ...change,
});
const server = (change: Partial<Draft> = {}): Draft => ({
  base_revision: 2,
  edits: [{ ...deletion, attributes: {} }],
  declarations: [],
  version: 5,
  kept_at: "2026-01-01T00:00:00Z",
  ...change,
});

describe("which kept draft a task opens with", () => {
  it("is none where nothing is kept", () => {
    expect(chooseDraft(null, null)).toEqual({ kind: "none" });
    expect(chooseDraft(local({ edits: [] }), server({ edits: [] }))).toEqual({ kind: "none" });
  });

  it("is the server's on a computer that has none", () => {
    expect(chooseDraft(null, server()).kind).toBe("server");
  });

  it("is this computer's when its last edits did not reach the server", () => {
    expect(chooseDraft(local(), server()).kind).toBe("local");
    expect(chooseDraft(local({ serverVersion: 0 }), null).kind).toBe("local");
  });

  it("is the server's when another computer went on from what this one had sent", () => {
    expect(chooseDraft(local({ synced: true }), server({ version: 6 })).kind).toBe("server");
  });

  it("is none when another computer saved what this one had sent", () => {
    expect(chooseDraft(local({ synced: true }), null)).toEqual({ kind: "none" });
  });

  it("is for the user to choose when both hold work that the other has not", () => {
    expect(chooseDraft(local(), server({ version: 6 })).kind).toBe("conflict");
  });

  it("is no question when both hold the same", () => {
    const same = { ...repaint, attributes: { ...repaint.attributes } };
    expect(chooseDraft(local(), server({ version: 6, edits: [same] })).kind).toBe("server");
  });

  it("is one that only declares macros, or withdraws what was declared", () => {
    const macros = { shape: true, appearance: false, function: false, lane_graph: false, lane_number: 0 };
    const declared = [{ elements: [{ kind: "lane_segment" as const, id: 7 }], macros }];
    expect(chooseDraft(null, server({ edits: [], declarations: declared })).kind).toBe("server");
    expect(chooseDraft(null, server({ edits: [] }), declared).kind).toBe("server");
    expect(chooseDraft(local({ edits: [], declarations: declared }), null).kind).toBe("local");
    expect(chooseDraft(local({ edits: [], declarations: [] }), null).kind).toBe("local");
  });

  it("is the save that was sent and never seen answered, whatever the server has", () => {
    const sent = { base_revision: 2, edits: [repaint], declarations: [], changeset_uuid: "u", note: "" };
    expect(chooseDraft(local({ edits: [], sent, synced: true }), null).kind).toBe("local");
  });
});
