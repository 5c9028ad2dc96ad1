import {
  cutPreview,
  isSide,
  keyText,
  laneLength,
  lineOf,
  type MapElement,
  measuresOf,
  previewOf,
  type Selection,
  stationOf,
  widthAt,
} from "../editor";
import { useEditorState, usePointer, useShownElement, useViewport } from "./useOverlay";

const metres = (value: number, digits = 2) => `${value.toFixed(digits)} m`;

/** Live figures beside the cursor while something is dragged or drawn. */
export function Readout() {
  const viewport = useViewport();
  const place = usePointer((state) => state.place);
  const caught = usePointer((state) => state.caught);
  const selection = useEditorState((state) => state.selection);
  const staged = useEditorState((state) => state.staged);
  const tool = useEditorState((state) => state.tool);
  const sketch = useEditorState((state) => state.sketch);
  const current = useEditorState((state) => state.current);
  const element = useShownElement(selection);
  if (place === null) return null;
  const parts: string[] = [];
  if (staged !== null && selection !== null && element !== null) {
    parts.push(...dragFigures(element, selection));
    const others = staged.changes.filter(({ key }) => keyText(key) !== keyText(selection)).length;
    if (others > 0) parts.push(`moves ${others} other ${others === 1 ? "lane" : "lanes"}`);
  } else if (tool === "cut") {
    const preview = cutPreview({ current, selection }, place, viewport.metres(6));
    const lane = preview && current.lanes.get(preview.lane);
    if (preview && lane) {
      const { left, right } = preview.joint;
      const before =
        (stationOf(lane.left_lane_boundary, left) + stationOf(lane.right_lane_boundary, right)) / 2;
      parts.push(`${metres(before, 1)} before`, `${metres(laneLength(lane) - before, 1)} after the cut`);
    }
  } else if (tool !== "select") {
    const preview = previewOf({ tool, sketch, current }, caught?.place ?? place, viewport.metres(6));
    if (preview !== null) {
      const { length, width } = measuresOf(preview);
      parts.push(`${metres(length, 1)} long`, `${metres(width)} wide`);
    }
  }
  if (caught !== null && (staged !== null || tool === "draw_lane")) {
    parts.push(
      caught.kind === "lane_end" ? `joins lane ${caught.lane}` : `on a ${caught.kind} of lane ${caught.lane}`,
    );
  }
  if (parts.length === 0) return null;
  const { x, y } = viewport.toPixel(place);
  return (
    <output className="map-readout" style={{ transform: `translate(${x + 16}px, ${y + 18}px)` }}>
      {parts.map((part) => (
        <span key={part}>{part}</span>
      ))}
    </output>
  );
}

function dragFigures(element: MapElement, { vertex }: Selection): string[] {
  const point = vertex && lineOf(element, vertex.side)?.[vertex.index];
  if (element.kind === "lane_segment" && vertex && isSide(vertex.side) && point) {
    return [
      `${metres(widthAt(element.attributes, vertex.side, point))} wide here`,
      `${metres(laneLength(element.attributes), 1)} long`,
    ];
  }
  const { length, width } = measuresOf(element);
  return [`${metres(length, 1)} long`, `${metres(width)} wide`];
}
