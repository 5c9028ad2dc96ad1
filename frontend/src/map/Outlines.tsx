import { useMemo } from "react";
import {
  centreOf,
  cutPreview,
  type ElementKey,
  keyText,
  lineNames,
  lineOf,
  type MapElement,
  previewOf,
  ringOf,
} from "../editor";
import type { DriveFrame, MapMarker } from "./properties";
import { linePath, ringPath } from "./shapes";
import { useEditorState, usePointer, useShownElement, useViewport } from "./useOverlay";

export function HoverOutline() {
  const viewport = useViewport();
  const hover = useEditorState((state) => state.hover);
  const selection = useEditorState((state) => state.selection);
  const element = useShownElement(hover);
  if (hover === null || element === null || (selection && keyText(selection) === keyText(hover))) return null;
  return <path className="map-hover" d={ringPath(ringOf(element), viewport)} data-testid="hovered" />;
}

export function SelectionOutline() {
  const viewport = useViewport();
  const selection = useEditorState((state) => state.selection);
  const element = useShownElement(selection);
  if (selection === null || element === null) return null;
  return (
    <g data-testid="selected" data-element={keyText(selection)}>
      <path className="map-selected-area" d={ringPath(ringOf(element), viewport)} />
      {lineNames(element.kind).map((name) => (
        <path
          key={name}
          className={selection.side === name ? "map-selected-line map-selected-side" : "map-selected-line"}
          d={linePath(lineOf(element, name) ?? [], viewport)}
        />
      ))}
    </g>
  );
}

/** The other lanes that a drag takes along. */
export function StagedOutlines() {
  const viewport = useViewport();
  const staged = useEditorState((state) => state.staged);
  const selection = useEditorState((state) => state.selection);
  if (staged === null) return null;
  const others = staged.changes.flatMap(({ key, after }) =>
    after === null || (selection && keyText(key) === keyText(selection)) ? [] : [{ key, after }],
  );
  return (
    <g>
      {others.map(({ key, after }) => (
        <path key={keyText(key)} className="map-staged" d={ringPath(ringOf(after), viewport)} />
      ))}
    </g>
  );
}

export function Violations({ markers }: { markers: readonly MapMarker[] }) {
  return (
    <g>
      {markers
        .filter(({ severity }) => severity !== "none")
        .map(({ key, severity }, index) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: one element may be marked several times
          <Violation key={`${keyText(key)} ${index}`} elementKey={key} severity={severity} />
        ))}
    </g>
  );
}

function Violation({ elementKey, severity }: { elementKey: ElementKey; severity: MapMarker["severity"] }) {
  const viewport = useViewport();
  const element = useShownElement(elementKey);
  if (element === null) return null;
  const { x, y } = viewport.toPixel(centreOf(element));
  return (
    <g className={`map-violation map-violation-${severity}`} data-testid={`violation-${keyText(elementKey)}`}>
      <path d={ringPath(ringOf(element), viewport)} />
      <g transform={`translate(${x.toFixed(1)} ${(y - 20).toFixed(1)})`}>
        <circle r="9" />
        <text textAnchor="middle" dy="4.5">
          !
        </text>
      </g>
    </g>
  );
}

/** What the tool in hand would make at the cursor, and the clicks so far. */
export function SketchPreview() {
  const viewport = useViewport();
  const tool = useEditorState((state) => state.tool);
  const sketch = useEditorState((state) => state.sketch);
  const current = useEditorState((state) => state.current);
  const place = usePointer((state) => state.place);
  const caught = usePointer((state) => state.caught);
  const cursor = caught?.place ?? place;
  const tolerance = viewport.metres(6);
  const preview = useMemo(
    () => (tool === "select" ? null : previewOf({ tool, sketch, current }, cursor, tolerance)),
    [tool, sketch, current, cursor, tolerance],
  );
  return (
    <g className="map-sketch">
      {preview !== null && <PreviewShape element={preview} />}
      {sketch?.points.map((point) => {
        const { x, y } = viewport.toPixel(point);
        return <circle key={`${point.x},${point.y}`} cx={x} cy={y} r="3.5" />;
      })}
    </g>
  );
}

/** Where a click would cut the lane under the cursor. */
export function CutPreview() {
  const viewport = useViewport();
  const tool = useEditorState((state) => state.tool);
  const current = useEditorState((state) => state.current);
  const selection = useEditorState((state) => state.selection);
  const place = usePointer((state) => state.place);
  if (tool !== "cut" || place === null) return null;
  const preview = cutPreview({ current, selection }, place, viewport.metres(6));
  if (preview === null) return null;
  const { left, right } = preview.joint;
  return <path className="map-cut" d={linePath([left, right], viewport)} data-testid="cut-preview" />;
}

function PreviewShape({ element }: { element: MapElement }) {
  const viewport = useViewport();
  return <path d={ringPath(ringOf(element), viewport)} data-testid="preview" />;
}

export function CatchMark() {
  const viewport = useViewport();
  const caught = usePointer((state) => state.caught);
  if (caught === null) return null;
  const { x, y } = viewport.toPixel(caught.place);
  return caught.kind === "line" ? (
    <path
      className="map-catch"
      d={`M${x - 5} ${y - 5}L${x + 5} ${y + 5}M${x - 5} ${y + 5}L${x + 5} ${y - 5}`}
    />
  ) : (
    <rect className="map-catch" x={x - 7} y={y - 7} width="14" height="14" />
  );
}

export function ActiveFrame({ frame }: { frame: DriveFrame }) {
  const viewport = useViewport();
  const { x, y } = viewport.toPixel(frame);
  const ahead = viewport.toPixel({
    x: frame.x + Math.cos(frame.heading_rad) * 4,
    y: frame.y + Math.sin(frame.heading_rad) * 4,
  });
  const degrees = (Math.atan2(ahead.y - y, ahead.x - x) * 180) / Math.PI;
  return (
    <g
      className="map-frame"
      transform={`translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${degrees.toFixed(1)})`}
    >
      <path d="M0 0L26-13A29 29 0 0 1 26 13Z" />
      <circle r="5.5" />
    </g>
  );
}
