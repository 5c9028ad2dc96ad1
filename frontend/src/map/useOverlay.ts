/** What the overlay's parts read: the map's movement, the editor, the cursor. */
import { createContext, useContext, useMemo, useSyncExternalStore } from "react";
import { useStore } from "zustand";
import {
  type Editor,
  type EditorState,
  type ElementKey,
  elementOf,
  keyText,
  type MapElement,
} from "../editor";
import type { Shown } from "./layers";
import type { MapController } from "./mapController";
import type { Pointer, PointerState } from "./pointer";
import type { Viewport } from "./viewport";

export interface OverlayValue {
  readonly controller: MapController;
  readonly editor: Editor;
  readonly pointer: Pointer;
  /** Which state of the map is on the screen. */
  readonly shown: Shown;
}

export const OverlayContext = createContext<OverlayValue | null>(null);

export function useOverlay(): OverlayValue {
  const value = useContext(OverlayContext);
  if (value === null) throw new Error("shown outside of a map");
  return value;
}

/** The viewport; whoever uses it is drawn again whenever the map moves. */
export function useViewport(): Viewport {
  const { viewport } = useOverlay().controller;
  useSyncExternalStore(viewport.subscribe, viewport.version);
  return viewport;
}

export function useEditorState<Part>(select: (state: EditorState) => Part): Part {
  return useStore(useOverlay().editor, select);
}

export function usePointer<Part>(select: (state: PointerState) => Part): Part {
  return useStore(useOverlay().pointer, select);
}

/** The element as it is on the screen: as staged by a drag, else as it stands, else (deleted) as imported; in the view
 * of the imported map as imported. */
export function useShownElement(key: ElementKey | null): MapElement | null {
  const staged = useEditorState((state) => state.staged);
  const current = useEditorState((state) => state.current);
  const base = useEditorState((state) => state.base);
  const { shown } = useOverlay();
  return useMemo(() => {
    if (key === null) return null;
    if (shown === "base") return elementOf(base, key);
    const change = staged?.changes.find((one) => keyText(one.key) === keyText(key));
    return change?.after ?? elementOf(current, key) ?? elementOf(base, key);
  }, [key, staged, current, base, shown]);
}
