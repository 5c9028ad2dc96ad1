import { type PointerEvent, useEffect, useRef } from "react";
import {
  boxOf,
  centreOf,
  isSide,
  type LineName,
  lineNames,
  lineOf,
  type MapElement,
  ringOf,
  together,
} from "../editor";
import { dragElement, dragNewVertex, dragVertex } from "./dragging";
import { useEditorState, useOverlay, useShownElement, useViewport } from "./useOverlay";
import type { Pixel } from "./viewport";

const NAMES: Readonly<Record<LineName, string>> = {
  left: "Left boundary",
  right: "Right boundary",
  edge1: "First edge",
  edge2: "Second edge",
};
/** Handles nearer to each other than this are left out; keys still reach their vertices. */
const CROWDED_PIXELS = 13;
/** An element smaller than this on the screen has no room for the handle that moves all of it. */
const ROOM_FOR_MOVE_PIXELS = 90;
const ROOM_FOR_MIDPOINT_PIXELS = 34;

/** The handles of the selected element: its vertices, places for new ones, and one to move all of it. */
export function Handles() {
  const selection = useEditorState((state) => state.selection);
  const tool = useEditorState((state) => state.tool);
  const deleted = useEditorState(({ current }) =>
    selection === null
      ? true
      : !(selection.kind === "lane_segment" ? current.lanes : current.crossings).has(selection.id),
  );
  const element = useShownElement(selection);
  if (element === null || deleted || tool !== "select") return null;
  return (
    <g>
      {lineNames(element.kind).map((name) => (
        <LineHandles key={name} element={element} name={name} />
      ))}
      <MoveHandle element={element} />
    </g>
  );
}

function LineHandles({ element, name }: { element: MapElement; name: LineName }) {
  const viewport = useViewport();
  const overlay = useOverlay();
  const selected = useEditorState((state) => state.selection?.vertex ?? null);
  const line = lineOf(element, name) ?? [];
  const pixels = line.map((point) => viewport.toPixel(point));
  const isSelected = (index: number) => selected?.side === name && selected.index === index;
  const shown = uncrowded(pixels, isSelected);
  return (
    <g>
      {element.kind === "lane_segment" &&
        pixels.slice(1).map((pixel, i) => {
          const before = pixels[i];
          if (
            before === undefined ||
            Math.hypot(pixel.x - before.x, pixel.y - before.y) < ROOM_FOR_MIDPOINT_PIXELS
          )
            return null;
          const at = { x: (pixel.x + before.x) / 2, y: (pixel.y + before.y) / 2 };
          // biome-ignore lint/suspicious/noArrayIndexKey: a vertex has no other identity than its place in the line
          return <NewVertexHandle key={i} element={element} name={name} index={i} at={at} />;
        })}
      {pixels.map((pixel, index) =>
        shown[index] ? (
          <VertexHandle
            // biome-ignore lint/suspicious/noArrayIndexKey: as above
            key={index}
            element={element}
            name={name}
            index={index}
            count={line.length}
            at={pixel}
            selected={isSelected(index)}
            reachable={
              isSelected(index) || (selected === null && name === lineNames(element.kind)[0] && index === 0)
            }
            onPress={(event) => {
              const vertex = { kind: element.kind, id: element.id, side: name, index };
              overlay.editor.actions.select(element, { vertex: { side: name, index } });
              dragVertex(overlay, event, vertex);
            }}
          />
        ) : null,
      )}
    </g>
  );
}

/** Ends and the selected vertex always; the others where there is room. */
function uncrowded(pixels: readonly Pixel[], isSelected: (index: number) => boolean): boolean[] {
  let last: Pixel | undefined;
  return pixels.map((pixel, index) => {
    const must = index === 0 || index === pixels.length - 1 || isSelected(index);
    const near = last !== undefined && Math.hypot(pixel.x - last.x, pixel.y - last.y) < CROWDED_PIXELS;
    if (must || !near) last = pixel;
    return must || !near;
  });
}

interface VertexHandleProperties {
  element: MapElement;
  name: LineName;
  index: number;
  count: number;
  at: Pixel;
  selected: boolean;
  reachable: boolean;
  onPress: (event: globalThis.PointerEvent) => void;
}

function VertexHandle({
  element,
  name,
  index,
  count,
  at,
  selected,
  reachable,
  onPress,
}: VertexHandleProperties) {
  const circle = useRef<SVGGElement>(null);
  const { controller, editor } = useOverlay();
  const shared = useEditorState(({ current }) =>
    element.kind === "lane_segment" && isSide(name)
      ? new Set(together(current, { lane: element.id, side: name, index }).map(({ lane }) => lane)).size - 1
      : 0,
  );
  useEffect(() => {
    if (selected && controller.region.contains(document.activeElement))
      circle.current?.focus({ preventScroll: true });
  }, [selected, controller]);
  const sharing = shared > 0 ? `, shared with ${shared} other ${shared === 1 ? "lane" : "lanes"}` : "";
  return (
    // biome-ignore lint/a11y/useSemanticElements: SVG has no button
    <g
      ref={circle}
      className={`map-vertex${selected ? " map-vertex-selected" : ""}${shared > 0 ? " map-vertex-shared" : ""}`}
      transform={`translate(${at.x.toFixed(1)} ${at.y.toFixed(1)})`}
      role="button"
      tabIndex={reachable ? 0 : -1}
      aria-label={`${NAMES[name]}, vertex ${index + 1} of ${count}${sharing}. Arrow keys move it.`}
      aria-pressed={selected}
      data-testid={`vertex-${name}-${index}`}
      onPointerDown={(event) => {
        if (press(event)) onPress(event.nativeEvent);
      }}
      onFocus={() => {
        if (!selected) editor.actions.select(element, { vertex: { side: name, index } });
      }}
    >
      <circle r="11" className="map-reach" />
      <circle r={selected ? 6 : 4.5} className="map-dot" />
      {shared > 0 && <circle r="1.4" className="map-pip" />}
    </g>
  );
}

interface NewVertexProperties {
  element: MapElement;
  name: LineName;
  index: number;
  at: Pixel;
}

function NewVertexHandle({ element, name, index, at }: NewVertexProperties) {
  const overlay = useOverlay();
  return (
    <g
      className="map-new-vertex"
      transform={`translate(${at.x.toFixed(1)} ${at.y.toFixed(1)})`}
      data-testid={`new-vertex-${name}-${index}`}
      onPointerDown={(event) => {
        if (!press(event)) return;
        const after = { kind: element.kind, id: element.id, side: name, index };
        dragNewVertex(overlay, event.nativeEvent, after);
      }}
    >
      <title>Add a vertex here</title>
      <rect x="-9" y="-9" width="18" height="18" className="map-reach" />
      <rect x="-3" y="-3" width="6" height="6" className="map-dot" />
    </g>
  );
}

function MoveHandle({ element }: { element: MapElement }) {
  const viewport = useViewport();
  const overlay = useOverlay();
  const [west, south, east, north] = boxOf(ringOf(element).map((place) => viewport.toPixel(place)));
  if (Math.max(east - west, north - south) < ROOM_FOR_MOVE_PIXELS) return null;
  const centre = centreOf(element);
  const at = viewport.toPixel(centre);
  return (
    <g
      className="map-move"
      transform={`translate(${at.x.toFixed(1)} ${at.y.toFixed(1)})`}
      data-testid="move-element"
      onPointerDown={(event) => {
        if (press(event))
          dragElement(overlay, event.nativeEvent, { kind: element.kind, id: element.id }, centre);
      }}
    >
      <title>Move the whole element</title>
      <circle r="10" className="map-move-disc" />
      <path d="M0-6.5V6.5M-6.5 0H6.5M-2-4.5 0-6.5 2-4.5M-2 4.5 0 6.5 2 4.5M-4.5-2-6.5 0-4.5 2M4.5-2 6.5 0 4.5 2" />
    </g>
  );
}

/** A press with the main button that nobody else shall take; false for other buttons. */
function press(event: PointerEvent): boolean {
  if (event.button !== 0) return false;
  event.preventDefault();
  event.stopPropagation();
  return true;
}
