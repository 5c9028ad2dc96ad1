/** The editor core: pure TypeScript, no map, no DOM, no fetch. */
export type { Change, MapDocument } from "./document";
export { elementOf } from "./document";
export type {
  Crossing,
  ElementKey,
  ElementKind,
  KeyText,
  Lane,
  LaneType,
  Line,
  LineName,
  MapElement,
  Mark,
  Place,
  Point,
  Side,
  VertexRef,
} from "./elements";
export { keyText, otherSide, parseKey } from "./elements";
export type {
  CreateEditor,
  DrawLaneOptions,
  Editor,
  EditorActions,
  EditorState,
  History,
  HistoryEntry,
  Inserted,
  Notice,
  Outcome,
  QuickCategory,
  SaveSnapshot,
  Selection,
  Sketch,
  Staged,
  Tool,
} from "./state";
export type { Edit, EditorSavedRevision, EditorWorkspace, IdBlock, ReceivedEdit } from "./wire";
