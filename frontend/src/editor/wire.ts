/** The parts of the REST API's bodies that the editor reads and writes; the generated types are assignable to them. */
import type { ElementKey, ElementKind } from "./elements";

export interface WirePoint {
  x: number;
  y: number;
  z: number | null;
}

/** Coordinates received always have their z; null is only sent. */
interface WireLane {
  readonly id: number;
  readonly is_intersection: boolean;
  readonly lane_type: string;
  readonly left_lane_boundary: readonly WirePoint[];
  readonly left_lane_mark_type: string;
  readonly right_lane_boundary: readonly WirePoint[];
  readonly right_lane_mark_type: string;
  readonly successors: readonly number[];
  readonly predecessors: readonly number[];
  readonly right_neighbor_id: number | null;
  readonly left_neighbor_id: number | null;
  /** Left out: no part. */
  readonly part_of?: number | null;
}

interface WireCrossing {
  readonly id: number;
  readonly edge1: readonly WirePoint[];
  readonly edge2: readonly WirePoint[];
}

export interface WireMap {
  readonly lanes: readonly { readonly version: number; readonly attributes: WireLane }[];
  readonly crossings: readonly { readonly version: number; readonly attributes: WireCrossing }[];
}

/** How a structural update changes the local road (change-mapping §4). */
export interface Macros {
  shape: boolean;
  appearance: boolean;
  function: boolean;
  lane_graph: boolean;
  lane_number: number;
}

/** The macros that an annotator states for the update that these elements are in. */
export interface Declaration {
  elements: ElementKey[];
  macros: Macros;
}

/** An element that a save gave another id, because the update is told more simply so. */
export interface Renamed {
  readonly kind: ElementKind;
  readonly from: number;
  readonly to: number;
}

/** What the editor needs of an opened workspace. */
export interface EditorWorkspace {
  readonly task: { readonly can_edit: boolean };
  readonly revision: number;
  readonly base: WireMap;
  readonly changed: WireMap;
  readonly removed: readonly ElementKey[];
  readonly declarations: readonly Declaration[];
}

/** What the editor needs of the answer to a save. */
export interface EditorSavedRevision {
  readonly revision: number;
  readonly changed: WireMap;
  readonly removed: readonly ElementKey[];
  readonly declarations: readonly Declaration[];
  readonly canonical: readonly Renamed[];
}

/** Fresh element ids, both ends included. */
export interface IdBlock {
  readonly first_id: number;
  readonly last_id: number;
}

export type Operation = "insert" | "update" | "delete";

/** The attributes of an edit: the changed ones (update), all but the id (insert), none (delete). */
export interface EditAttributes {
  is_intersection?: boolean;
  lane_type?: string;
  left_lane_boundary?: WirePoint[];
  left_lane_mark_type?: string;
  right_lane_boundary?: WirePoint[];
  right_lane_mark_type?: string;
  successors?: number[];
  predecessors?: number[];
  right_neighbor_id?: number | null;
  left_neighbor_id?: number | null;
  part_of?: number | null;
  edge1?: WirePoint[];
  edge2?: WirePoint[];
}

/** One net edit of one element, as the server takes it (`EditIn`). */
export interface Edit {
  operation: Operation;
  kind: ElementKind;
  id: number;
  attributes: EditAttributes;
}

/** What is not saved yet; `declarations` null: those of the saved revision stand. */
export interface DraftContent {
  readonly edits: Edit[];
  readonly declarations: Declaration[] | null;
}

/** An edit as it comes: from the server (a fix, a stored draft) or this computer's storage. Not trusted. */
export interface ReceivedEdit {
  readonly operation: Operation;
  readonly kind: ElementKind;
  readonly id: number;
  readonly attributes?: { readonly [name: string]: unknown };
}
