import { type Ref, useEffect, useImperativeHandle, useMemo, useRef, useState } from "react";
import { useStore } from "zustand";
import "maplibre-gl/dist/maplibre-gl.css";
import "./map.css";
import "./overlay.css";
import { elementOf, ringOf } from "../editor";
import { hasWebGl, NO_WEBGL, NO_WORKER } from "./createMap";
import { Legend, MapButtons } from "./Furniture";
import { Handles } from "./Handles";
import { attachInput } from "./input";
import { attachKeyboard, editLane } from "./keyboard";
import type { Shown } from "./layers";
import { MapController } from "./mapController";
import {
  ActiveFrame,
  CatchMark,
  CutPreview,
  HoverOutline,
  SelectionOutline,
  SketchPreview,
  StagedOutlines,
  Violations,
} from "./Outlines";
import { createPointer } from "./pointer";
import type { MapHandle, MapViewMode, MapViewProperties } from "./properties";
import { Readout } from "./Readout";
import { OverlayContext } from "./useOverlay";
import { useShownMap } from "./useShownMap";

/** The imported map is the prior or the current state, as the task runs. */
function shownState(view: MapViewMode, direction: MapViewProperties["direction"]): Shown {
  if (view === "difference") return "difference";
  const baseIs = direction === "prior_to_current" ? "prior" : "current";
  return view === baseIs ? "base" : "edited";
}

const calm = () => window.matchMedia("(prefers-reduced-motion: reduce)").matches;

export function MapView({ ref, ...properties }: MapViewProperties & { ref?: Ref<MapHandle> }) {
  const { editor, frame, bounds } = properties;
  const region = useRef<HTMLElement>(null);
  const canvas = useRef<HTMLDivElement>(null);
  const latest = useRef(properties);
  const [controller, setController] = useState<MapController | null>(null);
  const [trouble, setTrouble] = useState<string | null>(null);
  const [lost, setLost] = useState(false);
  const pointer = useMemo(() => createPointer(), []);

  useEffect(() => {
    latest.current = properties;
  });

  useEffect(() => {
    if (region.current === null || canvas.current === null) return;
    const fail = (reason: string) => {
      setTrouble(reason);
      latest.current.onUnavailable?.(reason);
    };
    if (!hasWebGl()) {
      fail(NO_WEBGL);
      return;
    }
    const made = new MapController(
      region.current,
      canvas.current,
      frame,
      bounds,
      latest.current.theme ?? "dark",
    );
    made.map.on("error", ({ error }) => {
      if (error.message.includes("Worker")) fail(NO_WORKER);
    });
    made.map.on("webglcontextlost", () => setLost(true));
    made.map.on("webglcontextrestored", () => setLost(false));
    setController(made);
    return () => {
      setController(null);
      made.destroy();
    };
  }, [frame, bounds]);

  const handle = useMemo<MapHandle>(
    () => ({
      fitLog: () => {
        const [west = 0, south = 0, east = 0, north = 0] = bounds;
        const corners = [
          { x: west, y: south },
          { x: east, y: south },
          { x: east, y: north },
          { x: west, y: north },
        ];
        controller?.viewport.fit(corners, { animate: !calm() });
      },
      fitElement: (key) => {
        const { current, base } = editor.getState();
        const element = elementOf(current, key) ?? elementOf(base, key);
        if (element === null || controller === null) return;
        controller.viewport.fit(ringOf(element), { animate: !calm(), closest: 20.5, padding: 110 });
      },
      editLane: (command) => {
        const { view, direction } = latest.current;
        editLane(editor, command, shownState(view, direction) === "base");
      },
      focus: () => region.current?.focus({ preventScroll: true }),
    }),
    [controller, editor, bounds],
  );
  useImperativeHandle(ref, () => handle, [handle]);

  const shown = shownState(properties.view, properties.direction);
  useShownMap(controller, properties, shown);

  useEffect(() => {
    if (controller === null) return;
    const options = () => {
      const { drive = null, onFrame, view, direction } = latest.current;
      return { drive, onFrame, showsBase: shownState(view, direction) === "base" };
    };
    const offInput = attachInput(controller, editor, pointer, options);
    const offKeys = attachKeyboard(controller, editor, handle, {
      showsBase: () => options().showsBase,
      onCommand: (command) => latest.current.onCommand?.(command),
    });
    return () => {
      offInput();
      offKeys();
    };
  }, [controller, editor, pointer, handle]);

  const tool = useStore(editor, (state) => state.tool);
  const readOnly = useStore(editor, (state) => state.readOnly);
  const overlay = useMemo(
    () => controller && { controller, editor, pointer, shown },
    [controller, editor, pointer, shown],
  );
  const activeFrame = properties.drive?.frames.find(({ index }) => index === properties.activeFrame);

  return (
    <section
      ref={region}
      className={`map map-tool-${tool}`}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: the map takes keys: it pans, nudges and draws with them
      tabIndex={0}
      aria-label="Map. Arrow keys move what is selected, ? lists all keys."
      data-testid="map"
    >
      <div ref={canvas} className="map-canvas" />
      {overlay !== null && (
        <OverlayContext value={overlay}>
          {/* biome-ignore lint/a11y/useSemanticElements: SVG has no fieldset */}
          <svg className="map-overlay" role="group" aria-label="Handles">
            <Violations markers={properties.violations ?? []} />
            {activeFrame && <ActiveFrame frame={activeFrame} />}
            <HoverOutline />
            <StagedOutlines />
            <SelectionOutline />
            <SketchPreview />
            <CutPreview />
            {!readOnly && shown !== "base" && <Handles />}
            <CatchMark />
          </svg>
          <Readout />
          <Legend changes={shown === "difference"} />
          <MapButtons handle={handle} />
        </OverlayContext>
      )}
      {(trouble !== null || lost) && (
        <div className="map-trouble" role="alert">
          {trouble ?? "The graphics card dropped the map; it is being drawn again. Your edits are safe."}
        </div>
      )}
    </section>
  );
}
