import { colourOf, type Mark, type Side, stripesOf } from "../../editor";
import classes from "./parts.module.css";

const HEIGHT = 18;
const HALF_GAP = 2.6;
const MIDDLE = HEIGHT / 2;

/**
 * A mark as paint on asphalt, driving to the right: the lane lies below its left mark and above its right one, so the
 * stripe nearer to the lane is drawn on that side.
 */
export function MarkPaint({ mark, side, width = 64 }: { mark: Mark; side: Side; width?: number }) {
  const towardsLane = side === "left" ? 1 : -1;
  const colour = `var(--paint-${colourOf(mark)})`;
  return (
    <svg className={classes.paint} width={width} height={HEIGHT} aria-hidden="true">
      <rect width={width} height={HEIGHT} rx={3} fill="var(--asphalt)" />
      {stripesOf(mark).map(({ dashed, place }) => (
        <line
          key={place}
          x1={3}
          x2={width - 3}
          y1={MIDDLE - place * towardsLane * HALF_GAP}
          y2={MIDDLE - place * towardsLane * HALF_GAP}
          stroke={colour}
          strokeWidth={2.2}
          strokeDasharray={dashed ? "9 6" : undefined}
        />
      ))}
      {mark === "NONE" && (
        <line
          x1={3}
          x2={width - 3}
          y1={MIDDLE}
          y2={MIDDLE}
          stroke="var(--paint-none)"
          strokeDasharray="1 4"
        />
      )}
      {mark === "UNKNOWN" && (
        <text x={width / 2} y={13} textAnchor="middle" fontSize={12} fill="var(--paint-white)">
          ?
        </text>
      )}
    </svg>
  );
}
