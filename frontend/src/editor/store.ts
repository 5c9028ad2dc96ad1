/** The editor: a store of the map being edited, and the actions on it. */
import { createStore } from "zustand/vanilla";
import { changedElements } from "./classification";
import { editingActions } from "./editingActions";
import { IdSource } from "./ids";
import { baseCutAlike } from "./parts";
import { readMap } from "./read";
import { savingActions } from "./savingActions";
import { selectionActions } from "./selectionActions";
import { Stage } from "./stage";
import type { CreateEditor, EditorState } from "./state";
import { storedMap } from "./storedMap";

/** An editor of an opened workspace; `takeIds` asks the server for fresh element ids when they run out. */
export const createEditor: CreateEditor = (workspace, takeIds) => {
  const base = readMap(workspace.base);
  const saved = storedMap(base, workspace);
  const store = createStore<EditorState>(() => ({
    base,
    saved,
    savedRevision: workspace.revision,
    current: saved,
    declarations: workspace.declarations,
    savedDeclarations: workspace.declarations,
    readOnly: !workspace.task.can_edit,
    selection: null,
    hover: null,
    tool: "select",
    history: { done: [], undone: [] },
    staged: null,
    sketch: null,
    notice: null,
    changedKeys: changedElements(baseCutAlike(base, saved), saved),
  }));
  const stage = new Stage(store, new IdSource(takeIds));
  const actions = { ...selectionActions(stage), ...editingActions(stage), ...savingActions(stage) };
  return { ...store, actions };
};
