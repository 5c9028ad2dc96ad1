/** History, drafts and saves. */
import { Adoption } from "./adoption";
import { merged, redeclared, renamed, sameDeclarations } from "./declarations";
import { applyChanges, type Change, differingKeys, elementOf, type MapDocument } from "./document";
import { changesOf, editsBetween } from "./edits";
import { type KeyText, keyText } from "./elements";
import { equalElements } from "./equality";
import { Unreadable } from "./read";
import { renumbered, strangers } from "./renumber";
import { NO_IDS, type Stage } from "./stage";
import type { EditorActions, History } from "./state";
import { storedMap } from "./storedMap";
import type { Declaration, ReceivedEdit } from "./wire";

type SavingActions = Pick<
  EditorActions,
  | "applyEdits"
  | "applyFix"
  | "declare"
  | "discardDraft"
  | "loadDraft"
  | "netEdits"
  | "netDraft"
  | "takeSnapshot"
  | "adoptSaved"
  | "undo"
  | "redo"
>;

export function savingActions(stage: Stage): SavingActions {
  const { store } = stage;

  const netEdits = () => editsBetween(stage.state.saved, stage.state.current);

  const applyEdits: EditorActions["applyEdits"] = (edits, note, declarations) => {
    const changes = readChanges(stage.state.current, edits);
    if (typeof changes === "string")
      return stage.refuse(`This fix does not fit the map any more: ${changes}.`);
    return stage.run(() => ({ note, changes, declarations: declarations ?? stage.state.declarations }));
  };

  return {
    applyEdits,
    applyFix: async (edits, note, declarations) => {
      const { base, saved, current } = stage.state;
      const ids = new Map<KeyText, number>();
      try {
        for (const key of strangers(edits, [base, saved, current])) {
          ids.set(keyText(key), await stage.newId(key.kind));
        }
      } catch {
        return stage.refuse(NO_IDS);
      }
      return applyEdits(renumbered(edits, ids), note, declarations);
    },
    declare: (elements, macros) =>
      stage.run(() => ({
        note: macros === null ? "Withdrew a declaration of macros" : "Declared the macros of an update",
        changes: [],
        declarations: redeclared(stage.state.declarations, elements, macros),
      })),
    discardDraft: () => {
      const { saved, current, savedDeclarations: declarations } = stage.state;
      const changes = differingKeys(current, saved).map((key) => ({
        key,
        before: elementOf(current, key),
        after: elementOf(saved, key),
      }));
      return stage.run(() => ({ note: "Discarded the draft", changes, declarations }));
    },
    loadDraft: (edits, history, kept = null) => {
      const { saved, savedDeclarations } = stage.state;
      const declarations = kept ?? savedDeclarations;
      const changes = readChanges(saved, edits);
      if (typeof changes === "string") {
        return stage.refuse(
          `The kept draft does not fit this revision: ${changes}. It stays where it is kept.`,
        );
      }
      const current = applyChanges(saved, changes);
      const stated = history?.done.findLast((entry) => entry.declarations)?.declarations?.after;
      const whole =
        history &&
        leadsTo(saved, history, current) &&
        sameDeclarations(stated ?? savedDeclarations, declarations);
      const done = whole ? history.done : oneStep(changes, savedDeclarations, declarations);
      stage.show(current, null, declarations);
      store.setState({ history: { done, undone: [] } });
      return { ok: true };
    },
    netEdits,
    netDraft: () => {
      const { declarations, savedDeclarations } = stage.state;
      const same = sameDeclarations(declarations, savedDeclarations);
      return { edits: netEdits(), declarations: same ? null : [...declarations] };
    },
    takeSnapshot: () => ({
      edits: netEdits(),
      declarations: [...stage.state.declarations],
      document: stage.state.current,
    }),
    adoptSaved: (answer, snapshot) => {
      const { saved, current, history, selection, declarations } = stage.state;
      const stored = storedMap(saved, answer);
      const adoption = new Adoption(saved, snapshot.document, stored);
      const renames = new Map(
        answer.canonical.map(({ kind, from, to }) => [keyText({ kind, id: from }), to]),
      );
      const since = adoption.translatesHistory
        ? { document: applyChanges(stored, adoption.current(current, snapshot.document, stored)), unfit: [] }
        : editedSince(snapshot.document, current, stored, renames);
      const sent = renamed(snapshot.declarations, renames);
      const declared = (list: readonly Declaration[]) =>
        merged(sent, answer.declarations, renamed(list, renames));
      store.setState({
        saved: stored,
        savedRevision: answer.revision,
        savedDeclarations: answer.declarations,
        history: adoption.history(history, declared),
      });
      const follows = selection && { ...selection, id: renames.get(keyText(selection)) ?? selection.id };
      stage.show(since.document, follows, declared(declarations));
      return since.unfit;
    },
    undo: () => stage.undo(),
    redo: () => stage.redo(),
  };
}

function readChanges(document: MapDocument, edits: readonly ReceivedEdit[]): Change[] | string {
  try {
    return changesOf(document, edits);
  } catch (error) {
    if (error instanceof Unreadable) return error.message;
    throw error;
  }
}

function oneStep(
  changes: readonly Change[],
  before: readonly Declaration[],
  after: readonly Declaration[],
): History["done"] {
  const declares = !sameDeclarations(before, after);
  if (changes.length === 0 && !declares) return [];
  return [
    { note: "Loaded the kept draft", changes, ...(declares ? { declarations: { before, after } } : {}) },
  ];
}

/**
 * The stored map with what was edited while the save was under way, attribute by attribute, so that what else the save
 * changed stands; `unfit`: the edits of elements that are not there any more.
 */
function editedSince(
  sent: MapDocument,
  current: MapDocument,
  stored: MapDocument,
  renames: ReadonlyMap<KeyText, number>,
): { document: MapDocument; unfit: ReceivedEdit[] } {
  const edits = editsBetween(sent, current).map((edit) => ({ ...edit, attributes: { ...edit.attributes } }));
  const unfit: ReceivedEdit[] = [];
  let document = stored;
  for (const edit of renumbered(edits, renames)) {
    const goneAnyway = edit.operation === "delete" && elementOf(document, edit) === null;
    if (goneAnyway) continue;
    const changes = readChanges(document, [edit]);
    if (typeof changes === "string") unfit.push(edit);
    else document = applyChanges(document, changes);
  }
  return { document, unfit };
}

/** Whether a kept history, step by step, makes the draft out of the saved map. */
function leadsTo(saved: MapDocument, history: History, draft: MapDocument): boolean {
  let document = saved;
  for (const { changes } of history.done) {
    if (changes.some(({ key, before }) => !equalElements(elementOf(document, key), before))) return false;
    document = applyChanges(document, changes);
  }
  return editsBetween(document, draft).length === 0;
}
