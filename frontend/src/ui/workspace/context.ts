import { createContext, type RefObject, useContext } from "react";
import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Revision, SavedRevision, Task, TaskEvent, Workspace } from "../../api/types";
import type { Editor, EditorState, KeyText } from "../../editor";
import { keyText } from "../../editor";
import type { MapHandle, MapViewMode } from "../../map";
import type { WorkSession } from "../../work/workSession";

export type LeftTab = "changes" | "issues" | "history" | "find";

/** What the workspace shows, apart from the map's elements. */
export interface ScreenState {
  view: MapViewMode;
  /** While the flicker key is held, the other state is shown. */
  flicker: boolean;
  tab: LeftTab;
  lidarOpacity: number;
  arrows: boolean;
  frame: number | null;
  keysShown: boolean;
  staleShown: boolean;
  /** The canonical form is being asked for. */
  canonicalising: boolean;
  /** The rule whose page is shown beside the map. */
  rule: string | null;
  inspectorShown: boolean;
  leftShown: boolean;
  task: Task;
  revisions: readonly Revision[];
  events: readonly TaskEvent[];
  /** The revision that wrote each element; the imported ones are left out. */
  versions: ReadonlyMap<KeyText, number>;
}

export function createScreen(workspace: Workspace): StoreApi<ScreenState> {
  return createStore<ScreenState>(() => ({
    view: "difference",
    flicker: false,
    tab: "changes",
    lidarOpacity: 0.6,
    arrows: true,
    frame: null,
    keysShown: false,
    staleShown: false,
    canonicalising: false,
    rule: null,
    inspectorShown: true,
    leftShown: true,
    task: workspace.task,
    revisions: workspace.revisions,
    events: workspace.events,
    versions: versionsOf(workspace.changed, new Map()),
  }));
}

function versionsOf(
  changed: Workspace["changed"],
  before: ReadonlyMap<KeyText, number>,
): ReadonlyMap<KeyText, number> {
  const versions = new Map(before);
  for (const { version, attributes } of changed.lanes) {
    versions.set(keyText({ kind: "lane_segment", id: attributes.id }), version);
  }
  for (const { version, attributes } of changed.crossings) {
    versions.set(keyText({ kind: "pedestrian_crossing", id: attributes.id }), version);
  }
  return versions;
}

/** The screen after a save: the new revision stands in the history, its elements under its number. */
export function withRevision(
  state: ScreenState,
  saved: SavedRevision,
  author: Revision["author"],
): Partial<ScreenState> {
  const revision: Revision = {
    number: saved.revision,
    author,
    created_at: saved.created_at,
    note: "",
    changed_elements: saved.changed.lanes.length + saved.changed.crossings.length + saved.removed.length,
  };
  return {
    task: { ...state.task, head: saved.revision },
    revisions: [...state.revisions.filter(({ number }) => number !== revision.number), revision],
    versions: versionsOf(saved.changed, state.versions),
  };
}

export interface WorkspaceValue {
  workspace: Workspace;
  editor: Editor;
  /** null: only to look at. */
  work: WorkSession | null;
  screen: StoreApi<ScreenState>;
  mapRef: RefObject<MapHandle | null>;
  /** Opens the task anew, e.g. after a step changed what may be done with it. */
  reopen: () => void;
}

export const WorkspaceContext = createContext<WorkspaceValue | null>(null);

export function useWorkspace(): WorkspaceValue {
  const value = useContext(WorkspaceContext);
  if (value === null) throw new Error("shown outside of a workspace");
  return value;
}

export function useEditor<Part>(select: (state: EditorState) => Part): Part {
  return useStore(useWorkspace().editor, select);
}

export function useScreen<Part>(select: (state: ScreenState) => Part): Part {
  return useStore(useWorkspace().screen, select);
}
