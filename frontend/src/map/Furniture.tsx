import { IconFocus2, IconMaximize, IconMinus, IconPlus } from "@tabler/icons-react";
import { CHANGE_COLOURS, CHANGE_NAMES } from "./palette";
import type { MapHandle } from "./properties";
import { useEditorState, useOverlay, useViewport } from "./useOverlay";

const LONGEST_SCALE_PIXELS = 90;

/** Legend and scale. */
export function Legend({ changes }: { changes: boolean }) {
  const viewport = useViewport();
  const room = LONGEST_SCALE_PIXELS / viewport.pixelsPerMetre();
  const step = niceLength(room);
  return (
    <div className="map-legend" data-testid="legend">
      {changes &&
        CHANGE_NAMES.map((name) => (
          <span key={name} className="map-legend-entry">
            <svg width="10" height="10" aria-hidden="true">
              <rect width="10" height="10" rx="2.5" fill={CHANGE_COLOURS[name]} />
            </svg>
            {name}
          </span>
        ))}
      <span className="map-scale">
        {step >= 1 ? `${step} m` : `${Math.round(step * 100)} cm`}
        <svg width={step * viewport.pixelsPerMetre()} height="6" aria-hidden="true">
          <path d={`M.5 0V5.5H${step * viewport.pixelsPerMetre() - 0.5}V0`} />
        </svg>
      </span>
    </div>
  );
}

/** 1, 2 or 5 times a power of ten, at most `room`. */
export function niceLength(room: number): number {
  const power = 10 ** Math.floor(Math.log10(room));
  const factor = [5, 2, 1].find((one) => one * power <= room) ?? 1;
  return factor * power;
}

export function MapButtons({ handle }: { handle: MapHandle }) {
  const { map } = useOverlay().controller;
  const selection = useEditorState((state) => state.selection);
  return (
    <fieldset className="map-buttons" aria-label="View of the map">
      <button
        type="button"
        aria-label="Closer"
        title="Closer (+)"
        onClick={() => map.zoomIn({ duration: 150 })}
      >
        <IconPlus size={16} />
      </button>
      <button
        type="button"
        aria-label="Farther"
        title="Farther (-)"
        onClick={() => map.zoomOut({ duration: 150 })}
      >
        <IconMinus size={16} />
      </button>
      <button
        type="button"
        aria-label="Show the whole log"
        title="Show the whole log (0)"
        onClick={() => handle.fitLog()}
      >
        <IconMaximize size={16} />
      </button>
      <button
        type="button"
        aria-label="Zoom to the selected element"
        title="Zoom to the selected element (Z)"
        disabled={selection === null}
        onClick={() => {
          if (selection !== null) handle.fitElement(selection);
        }}
      >
        <IconFocus2 size={16} />
      </button>
    </fieldset>
  );
}
