/** Which of two kept drafts, this computer's and the server's, is the one to go on with. */
import type { Draft } from "../api/types";
import { type Declaration, sameDeclarations } from "../editor";
import type { LocalDraft } from "./browserStore";

export type DraftChoice =
  | { kind: "none" }
  | { kind: "local"; local: LocalDraft }
  | { kind: "server"; draft: Draft }
  /** Both hold work that the other has not: the user decides. */
  | { kind: "conflict"; local: LocalDraft; draft: Draft };

/** Without edits it holds what was declared, or withdrawn. */
const holdsWork = ({ edits, declarations = null }: Pick<LocalDraft, "edits" | "declarations">) =>
  edits.length > 0 || declarations !== null;

/** `declared`: the declarations of the saved revision. */
export function chooseDraft(
  local: LocalDraft | null,
  server: Draft | null,
  declared: readonly Declaration[] = [],
): DraftChoice {
  if (local === null || (!holdsWork(local) && local.sent === null)) {
    const holds =
      server !== null && (server.edits.length > 0 || !sameDeclarations(server.declarations, declared));
    return holds ? { kind: "server", draft: server } : { kind: "none" };
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
  return (
    local.baseRevision === server.base_revision &&
    canonical(local.edits) === canonical(server.edits) &&
    (local.declarations == null || sameDeclarations(local.declarations, server.declarations))
  );
}

/** JSON with sorted keys, so that two texts are equal when the values are. */
function canonical(value: unknown): string {
  return JSON.stringify(value, (_key, inner: unknown) =>
    typeof inner === "object" && inner !== null && !Array.isArray(inner)
      ? Object.fromEntries(Object.entries(inner).sort(([a], [b]) => (a < b ? -1 : 1)))
      : inner,
  );
}
