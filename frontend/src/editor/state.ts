/** What the editor's store holds, and the actions that it offers. */
import type { StoreApi } from "zustand/vanilla";
import type { Change, MapDocument } from "./document";
import type { ElementKey, KeyText, LaneType, LineName, Mark, Place, Side, VertexRef } from "./elements";
import type {
  Declaration,
  DraftContent,
  Edit,
  EditorSavedRevision,
  EditorWorkspace,
  IdBlock,
  Macros,
  ReceivedEdit,
} from "./wire";

export type Tool = "select" | "draw_lane" | "lane_beside" | "draw_crossing" | "cut";

/** The selected element, and the line and vertex of it that the next key acts on. */
export interface Selection extends ElementKey {
  readonly side: LineName | null;
  readonly vertex: { readonly side: LineName; readonly index: number } | null;
}

/** One step of undo: in words, what it did; `changes` hold each element before and after, so it has its reverse. */
export interface HistoryEntry {
  readonly note: string;
  readonly changes: readonly Change[];
  /** Declared macros before and after; left out: untouched. */
  readonly declarations?: {
    readonly before: readonly Declaration[];
    readonly after: readonly Declaration[];
  };
}

export interface History {
  readonly done: readonly HistoryEntry[];
  /** The next redo is the last. */
  readonly undone: readonly HistoryEntry[];
}

/** A drag that goes on: shown, but in neither document nor history. */
export interface Staged {
  readonly note: string;
  readonly changes: readonly Change[];
}

/** Clicks of a drawing tool so far. */
export interface Sketch {
  readonly points: readonly Place[];
}

/** Quick classification of an element against the base, for immediate colours; the server's check refines it. */
export type QuickCategory = "insertion" | "deletion" | "geometry" | "marking" | "type";

/** Something to tell the annotator once, e.g. why an edit was refused. `serial` grows with each. */
export interface Notice {
  readonly text: string;
  readonly serial: number;
}

export interface EditorState {
  /** The map as imported. */
  readonly base: MapDocument;
  /** The open revision, as stored. */
  readonly saved: MapDocument;
  readonly savedRevision: number;
  /** What is on the screen. */
  readonly current: MapDocument;
  /** Declared macros as they stand in the draft, and in the open revision. */
  readonly declarations: readonly Declaration[];
  readonly savedDeclarations: readonly Declaration[];
  readonly readOnly: boolean;
  readonly selection: Selection | null;
  readonly hover: ElementKey | null;
  readonly tool: Tool;
  readonly history: History;
  readonly staged: Staged | null;
  readonly sketch: Sketch | null;
  readonly notice: Notice | null;
  /** Elements of the current map (or gone from it) that differ from the base; connectivity alone does not count. */
  readonly changedKeys: ReadonlyMap<KeyText, readonly QuickCategory[]>;
}

/** Whether an edit was made, and if not, why in words (also in `state.notice`). */
export type Outcome = { readonly ok: true } | { readonly ok: false; readonly reason: string };
export type Inserted =
  | { readonly ok: true; readonly key: ElementKey }
  | { readonly ok: false; readonly reason: string };

/** The document at the moment a save was sent: hand it back to `adoptSaved` with the answer. */
export interface SaveSnapshot {
  readonly edits: Edit[];
  readonly declarations: Declaration[];
  readonly document: MapDocument;
}

export interface DrawLaneOptions {
  /** Metres; default 3.5. */
  readonly width?: number;
  readonly laneType?: LaneType;
}

export interface EditorActions {
  select(key: ElementKey | null, detail?: { side?: LineName | null; vertex?: Selection["vertex"] }): void;
  /** Selects at a place: the topmost element, and with each further click there the next one below. */
  pick(at: Place, toleranceMetres: number, of?: "current" | "base"): void;
  /** The same at the place of the last pick. */
  pickUnderneath(): void;
  hover(key: ElementKey | null): void;
  /** Selects the next (+1) or previous (-1) vertex of the selected element. */
  stepVertex(step: 1 | -1): void;
  setTool(tool: Tool): void;
  /** Esc: gives up the drag, then the sketch, then the tool, then the selection. */
  cancel(): void;
  say(text: string): void;

  /** The vertex goes to `to` in every lane that shares it; one undo step. */
  moveVertex(vertex: VertexRef, to: Place): Outcome;
  moveElement(key: ElementKey, by: Place): Outcome;
  /** Moves by an offset: the selected vertex, else the selected element (arrow keys). */
  nudge(by: Place): Outcome;
  stageVertex(vertex: VertexRef, to: Place): void;
  stageElement(key: ElementKey, by: Place): void;
  /** A new vertex after the given one, being dragged to its place. */
  stageNewVertex(after: VertexRef, at: Place): void;
  commitStaged(): Outcome;
  cancelStaged(): void;
  /** A new vertex between `index` and `index + 1`, in every lane that shares that piece of line. */
  addVertex(vertex: VertexRef, at?: Place): Outcome;
  removeVertex(vertex: VertexRef): Outcome;
  /** Delete key: the selected vertex, else the selected element. */
  removeSelected(): Outcome;
  /** Repaints a boundary, in both lanes that it parts. */
  setMark(lane: number, side: Side, mark: Mark): Outcome;
  setLaneType(lane: number, laneType: LaneType): Outcome;
  setIntersection(lane: number, isIntersection: boolean): Outcome;
  insertLaneBeside(lane: number, side: Side, width?: number): Promise<Inserted>;
  /** A lane along a centre line; its ends join the lane ends that they lie on. */
  drawLane(centreline: readonly Place[], options?: DrawLaneOptions): Promise<Inserted>;
  /** A crossing from kerb to kerb; `width` in metres, default 3. */
  insertCrossing(from: Place, to: Place, width?: number): Promise<Inserted>;
  /** Cuts a lane where a property is to change half-way; `reach`: metres to a vertex that the joint goes onto. */
  cutLane(lane: number, at: Place, reach: number): Promise<Inserted>;
  /** Makes the lane and the one in series with it one again. */
  joinLane(lane: number): Outcome;
  /** Takes out the link from one lane to another. Ends that are dragged onto each other are linked. */
  unlink(from: number, to: number): Outcome;
  /** Turns a lane round that was drawn in this task. */
  reverseLane(lane: number): Outcome;
  /** A click of the drawing tool in hand. */
  sketchPoint(at: Place): void;
  sketchBack(): void;
  /** Enter: makes the sketched element. */
  finishSketch(): Promise<Inserted | null>;
  deleteElement(key: ElementKey): Outcome;
  /** The element as it was imported (a deleted one comes back, an inserted one goes). */
  revertElement(key: ElementKey): Outcome;
  /** Applies the edits of a violation's fix as one undo step; what it inserts gets ids of this workspace. */
  applyFix(
    edits: readonly ReceivedEdit[],
    note: string,
    declarations?: readonly Declaration[],
  ): Promise<Outcome>;
  /** Applies edits as they are, all or none, as one undo step. */
  applyEdits(edits: readonly ReceivedEdit[], note: string, declarations?: readonly Declaration[]): Outcome;
  /** States the macros of the update that the elements are in; null: withdraws what was stated. */
  declare(elements: readonly ElementKey[], macros: Macros | null): Outcome;
  /** Back to the open revision, as one undo step. */
  discardDraft(): Outcome;

  /** Puts a kept draft onto the open revision; the history is taken over when it leads to the same map. */
  loadDraft(
    edits: readonly ReceivedEdit[],
    history?: History,
    declarations?: readonly Declaration[] | null,
  ): Outcome;
  /** The smallest edits that turn the saved revision into the current map. */
  netEdits(): Edit[];
  netDraft(): DraftContent;
  takeSnapshot(): SaveSnapshot;
  /**
   * Takes over what the server stored; edits made since the snapshot stay, as does the history where the save touched
   * only what was sent. Returns the edits that do not fit the stored map and are not in the editor any more.
   */
  adoptSaved(saved: EditorSavedRevision, snapshot: SaveSnapshot): readonly ReceivedEdit[];
  undo(): void;
  redo(): void;
}

export interface Editor extends StoreApi<EditorState> {
  readonly actions: EditorActions;
}

/** `createEditor`: an editor of an opened workspace; `takeIds` asks the server for fresh element ids when needed. */
export type CreateEditor = (workspace: EditorWorkspace, takeIds: () => Promise<IdBlock>) => Editor;
