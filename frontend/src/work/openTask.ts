/** Opens a task with whatever unsaved work of the user is kept anywhere. */
import type { Draft, Workspace } from "../api/types";
import { openWorkspace, type SaveBody, takeIdBlock } from "../api/workspace";
import {
  createEditor,
  type Declaration,
  type Edit,
  type Editor,
  type History,
  type ReceivedEdit,
} from "../editor";
import { type LocalDraft, parkDraft, readDraft, removeDraft, type WorkKey } from "./browserStore";
import { chooseDraft, type DraftChoice } from "./draftChoice";
import { WorkSession } from "./workSession";
import { countChanges } from "./workState";

export interface Reading {
  kind: "reading";
  workspace: Workspace;
  editor: Editor;
  /** Unsaved work on this computer that the task, as it stands, does not take. */
  leftover: LocalDraft | null;
}

export interface Editing {
  kind: "editing";
  workspace: Workspace;
  editor: Editor;
  work: WorkSession;
  /** Why the kept draft could not be loaded; it is set aside. */
  unusable: string | null;
  /** How many kept changes were loaded. */
  restored: number;
}

/** Two drafts hold different work; the user decides. */
export interface Choosing {
  kind: "choosing";
  workspace: Workspace;
  local: LocalDraft;
  server: Draft;
}

export type Opened = Reading | Editing | Choosing;

interface Chosen {
  baseRevision: number;
  edits: readonly ReceivedEdit[];
  /** null: those of the base revision. */
  declarations: Declaration[] | null;
  history: History | null;
  serverVersion: number;
  synced: boolean;
  keptAt: number | null;
  sent: LocalDraft["sent"];
}

/** What this computer kept is read as carefully as what comes from the server. */
const received = (edits: readonly (Edit | SaveBody["edits"][number])[]): ReceivedEdit[] =>
  edits.map((edit) => ({ ...edit, attributes: { ...edit.attributes } }));

const NOTHING_KEPT = {
  edits: [],
  declarations: null,
  history: null,
  serverVersion: 0,
  synced: true,
  keptAt: null,
  sent: null,
};

/** A task as it was at some revision, only to look at. */
export async function openRevision(task: number, revision: number): Promise<Reading> {
  const workspace = await openWorkspace(task, revision);
  return { kind: "reading", workspace, editor: readOnlyEditor(workspace), leftover: null };
}

/** The map of a workspace, only to look at. */
export const readOnlyEditor = (workspace: Workspace): Editor =>
  createEditor({ ...workspace, task: { ...workspace.task, can_edit: false } }, () =>
    Promise.reject(new Error("a read-only map needs no new ids")),
  );

export async function openTask(key: WorkKey, decision: "local" | "server" | null = null): Promise<Opened> {
  // Read first: what another tab still writes while the server answers is then not missed but newer.
  const local = await readDraft(key).catch(() => null);
  const workspace = await openWorkspace(key.task);
  if (!workspace.task.can_edit) {
    const leftover = local !== null && (local.edits.length > 0 || local.declarations != null) ? local : null;
    return { kind: "reading", workspace, editor: readOnlyEditor(workspace), leftover };
  }
  let choice = chooseDraft(local, workspace.draft, workspace.declarations);
  if (choice.kind === "conflict") {
    if (decision === null) return { kind: "choosing", workspace, local: choice.local, server: choice.draft };
    choice = await decided(key, choice, decision);
  }
  return await edit(key, workspace, chosenDraft(choice, workspace));
}

/** Sets aside the draft that was not chosen. */
async function decided(
  key: WorkKey,
  { local, draft }: Extract<DraftChoice, { kind: "conflict" }>,
  decision: "local" | "server",
): Promise<DraftChoice> {
  if (decision === "local") {
    const reason = "kept by another window or computer";
    const { base_revision: baseRevision, edits, declarations } = draft;
    await parkDraft(key, { reason, baseRevision, edits, declarations });
    return { kind: "local", local: { ...local, serverVersion: draft.version } };
  }
  const reason = "kept by this computer";
  const { baseRevision, edits, declarations = null } = local;
  await parkDraft(key, { reason, baseRevision, edits, declarations });
  return { kind: "server", draft };
}

function chosenDraft(choice: DraftChoice, workspace: Workspace): Chosen {
  if (choice.kind === "local") {
    const {
      baseRevision,
      declarations = null,
      history,
      serverVersion,
      synced,
      changedAt,
      sent,
    } = choice.local;
    const edits = received(choice.local.edits);
    return { baseRevision, edits, declarations, history, serverVersion, synced, keptAt: changedAt, sent };
  }
  if (choice.kind === "server") {
    const { base_revision, edits, declarations, version, kept_at } = choice.draft;
    return {
      baseRevision: base_revision,
      edits,
      declarations,
      history: null,
      serverVersion: version,
      synced: true,
      keptAt: new Date(kept_at).getTime(),
      sent: null,
    };
  }
  return { ...NOTHING_KEPT, baseRevision: workspace.revision, serverVersion: workspace.draft?.version ?? 0 };
}

async function edit(key: WorkKey, head: Workspace, chosen: Chosen): Promise<Editing> {
  const base = chosen.sent?.base_revision ?? chosen.baseRevision;
  // A draft lies on the revision that it was made on; the save merges it with what came after.
  const workspace = base === head.revision ? head : await openWorkspace(key.task, base);
  const editor = createEditor(workspace, () => takeIdBlock(key.task));
  let pending: ConstructorParameters<typeof WorkSession>[3] = null;
  if (chosen.sent !== null) {
    const { edits, declarations } = chosen.sent;
    const loaded = editor.actions.loadDraft(received(edits), undefined, declarations);
    if (loaded.ok) pending = { body: chosen.sent, snapshot: editor.actions.takeSnapshot() };
  }
  const { declarations } = chosen;
  const loaded = editor.actions.loadDraft(chosen.edits, chosen.history ?? undefined, declarations);
  let unusable: string | null = null;
  if (!loaded.ok) {
    unusable = loaded.reason;
    const { baseRevision, edits } = chosen;
    await parkDraft(key, { reason: loaded.reason, baseRevision, edits, declarations });
    await removeDraft(key);
  }
  const work = new WorkSession(key, editor, chosen, pending);
  return {
    kind: "editing",
    workspace,
    editor,
    work,
    unusable,
    restored: countChanges(editor.actions.netDraft()),
  };
}
