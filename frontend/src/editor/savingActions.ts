/** History, drafts and saves. */
import { Adoption } from "./adoption";
import { applyChanges, type Change, elementOf, type MapDocument } from "./document";
import { changesOf, editsBetween } from "./edits";
import { type KeyText, keyText } from "./elements";
import { equalElements } from "./equality";
import { Unreadable } from "./read";
import { renumbered, strangers } from "./renumber";
import { NO_IDS, type Stage } from "./stage";
import type { EditorActions, History } from "./state";
import { storedMap } from "./storedMap";
import type { ReceivedEdit } from "./wire";

type SavingActions = Pick<
  EditorActions,
  "applyEdits" | "applyFix" | "loadDraft" | "netEdits" | "takeSnapshot" | "adoptSaved" | "undo" | "redo"
>;

export function savingActions(stage: Stage): SavingActions {
  const { store } = stage;

  const netEdits = () => editsBetween(stage.state.saved, stage.state.current);

  const applyEdits: EditorActions["applyEdits"] = (edits, note) => {
    const changes = readChanges(stage.state.current, edits);
    if (typeof changes === "string")
      return stage.refuse(`This fix does not fit the map any more: ${changes}.`);
    return stage.run(() => ({ note, changes }));
  };

  return {
    applyEdits,
    applyFix: async (edits, note) => {
      const { base, saved, current } = stage.state;
      const ids = new Map<KeyText, number>();
      try {
        for (const key of strangers(edits, [base, saved, current])) {
          ids.set(keyText(key), await stage.newId(key.kind));
        }
      } catch {
        return stage.refuse(NO_IDS);
      }
      return applyEdits(renumbered(edits, ids), note);
    },
    loadDraft: (edits, history) => {
      const { saved } = stage.state;
      const changes = readChanges(saved, edits);
      if (typeof changes === "string") {
        return stage.refuse(
          `The kept draft does not fit this revision: ${changes}. It stays where it is kept.`,
        );
      }
      const current = applyChanges(saved, changes);
      const done = history && leadsTo(saved, history, current) ? history.done : oneStep(changes);
      stage.show(current, null);
      store.setState({ history: { done, undone: [] } });
      return { ok: true };
    },
    netEdits,
    takeSnapshot: () => ({ edits: netEdits(), document: stage.state.current }),
    adoptSaved: (answer, snapshot) => {
      const { saved, current, history, selection } = stage.state;
      const stored = storedMap(saved, answer);
      const adoption = new Adoption(saved, snapshot.document, stored);
      const since = adoption.current(current, snapshot.document, stored);
      store.setState({ saved: stored, savedRevision: answer.revision, history: adoption.history(history) });
      stage.show(applyChanges(stored, since), selection);
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

function oneStep(changes: readonly Change[]): History["done"] {
  return changes.length === 0 ? [] : [{ note: "Loaded the kept draft", changes }];
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
