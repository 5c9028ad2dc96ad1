/** Which of two kept drafts, this computer's and the server's, is the one to go on with. */
import type { Draft } from "../api/types";
import type { LocalDraft } from "./browserStore";

export type DraftChoice =
  | { kind: "none" }
  | { kind: "local"; local: LocalDraft }
  | { kind: "server"; draft: Draft }
  /** Both hold work that the other has not: the user decides. */
  | { kind: "conflict"; local: LocalDraft; draft: Draft };

const holdsWork = (draft: { edits: readonly unknown[] } | null) => draft !== null && draft.edits.length > 0;

export function chooseDraft(local: LocalDraft | null, server: Draft | null): DraftChoice {
  if (local === null || (!holdsWork(local) && local.sent === null)) {
    return server !== null && holdsWork(server) ? { kind: "server", draft: server } : { kind: "none" };
  }
  // A save without an answer goes first: it may have been carried out, and then the server has no draft any more.
  if (local.sent !== null) return { kind: "local", local };
  if (server === null) {
    // The server had these very edits and has them no more: another device saved or discarded them.
    return local.synced ? { kind: "none" } : { kind: "local", local };
  }
  if (server.version === local.serverVersion) return { kind: "local", local };
  if (local.synced || sameEdits(local, server)) return { kind: "server", draft: server };
  return { kind: "conflict", local, draft: server };
}

function sameEdits(local: LocalDraft, server: Draft): boolean {
  return local.baseRevision === server.base_revision && canonical(local.edits) === canonical(server.edits);
}

/** JSON with sorted keys, so that two texts are equal when the values are. */
function canonical(value: unknown): string {
  return JSON.stringify(value, (_key, inner: unknown) =>
    typeof inner === "object" && inner !== null && !Array.isArray(inner)
      ? Object.fromEntries(Object.entries(inner).sort(([a], [b]) => (a < b ? -1 : 1)))
      : inner,
  );
}
