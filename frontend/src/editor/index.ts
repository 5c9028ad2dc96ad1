/** The editor core: pure TypeScript, no map, no DOM, no fetch. */

export { classify } from "./classification";
export { declarationOf, merged, renamed, sameDeclarations } from "./declarations";
export type { Change, MapDocument } from "./document";
export { elementOf } from "./document";
export { editsBetween } from "./edits";
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
export { isSide, keyText, otherSide, parseKey } from "./elements";
export { equalElements } from "./equality";
export { type Joint, stationOf } from "./joint";
export { commandOf, KEY_TABLE, type KeyBinding, type KeyCommand, type KeyPress, nudgeOf } from "./keys";
export { boundary, lineNames, lineOf, markOf, neighborOf, ringOf } from "./lines";
export {
  colourOf,
  MARKS,
  type MarkColour,
  markWords,
  mirrored,
  patternOf,
  type Stripe,
  stripesOf,
} from "./marks";
export { centreOf, laneLength, laneWidth, measuresOf, widthAt } from "./measure";
export { baseCutAlike } from "./parts";
export { elementsAt } from "./picking";
export { boxOf } from "./polygon";
export { centreline } from "./polyline";
export { besideTarget, cutPreview, cutTarget, previewOf } from "./preview";
export { type Catch, snap, snapToLaneEnd } from "./snapping";
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
export { createEditor } from "./store";
export { linkedLanes, together } from "./topology";
export type {
  Declaration,
  DraftContent,
  Edit,
  EditorSavedRevision,
  EditorWorkspace,
  IdBlock,
  Macros,
  ReceivedEdit,
  Renamed,
} from "./wire";
