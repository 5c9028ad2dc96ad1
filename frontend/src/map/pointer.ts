/** Where the cursor is on the map, and what it catches; apart from the editor, for it changes with each movement. */
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Catch, Place } from "../editor";

export interface PointerState {
  /** City metres; null: not over the map. */
  readonly place: Place | null;
  readonly caught: Catch | null;
  readonly dragging: boolean;
}

export type Pointer = StoreApi<PointerState>;

export function createPointer(): Pointer {
  return createStore<PointerState>(() => ({ place: null, caught: null, dragging: false }));
}
