import type { Mark } from "../../api/types";
import { PAINT } from "./paint";
import classes from "./parts.module.css";

const WIDTH = 64;
const HEIGHT = 18;
const GAP = 5;

/**
 * A mark as paint on asphalt, as seen in driving direction to the right; the lane itself lies below a left mark and
 * above a right one, so a mixed mark shows its first stripe on that side.
 */
export function MarkPaint({ mark, side }: { mark: Mark; side: "left" | "right" }) {
  const { stripes, colour } = PAINT[mark];
  const ordered = side === "left" ? [...stripes].reverse() : stripes;
  const top = HEIGHT / 2 - ((ordered.length - 1) * GAP) / 2;
  return (
    <svg className={classes.paint} width={WIDTH} height={HEIGHT} aria-hidden="true">
      <rect width={WIDTH} height={HEIGHT} rx={3} fill="var(--asphalt)" />
      {ordered.length === 0 && (
        <line x1={4} x2={WIDTH - 4} y1={HEIGHT / 2} y2={HEIGHT / 2} stroke="#69727f" strokeDasharray="1 3" />
      )}
      {ordered.map((stripe, i) => {
        const y = top + i * GAP;
        return (
          <line
            key={y}
            x1={3}
            x2={WIDTH - 3}
            y1={y}
            y2={y}
            stroke={`var(--paint-${colour})`}
            strokeWidth={2.2}
            strokeDasharray={stripe === "dashed" ? (colour === "unknown" ? "2 4" : "9 6") : undefined}
          />
        );
      })}
      {mark === "UNKNOWN" && (
        <text x={WIDTH / 2} y={13} textAnchor="middle" fontSize={11} fill="#fff">
          ?
        </text>
      )}
    </svg>
  );
}
