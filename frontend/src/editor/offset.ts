/** A line beside a line: mitred joins, never crossing itself. */
import type { Place } from "./elements";
import { at, crossingOf, turnedLeft, unit } from "./polyline";

const LONGEST_MITRE = 2;

export interface OffsetEnds {
  /** Outward unit directions at the ends, e.g. along the lane's end lines; default: square to the line. */
  readonly start?: Place | null;
  readonly end?: Place | null;
}

/**
 * The line at `distanceAt(i)` metres to the left (negative: right) of vertex i.
 *
 * On the inside of a bend tighter than the distance, vertices that would run backwards go, and loops are cut where
 * they cross, so the result may have fewer vertices than the line.
 */
export function offsetLine(
  line: readonly Place[],
  distanceAt: (index: number) => number,
  ends: OffsetEnds = {},
): Place[] {
  const moved = line.map((place, index) => {
    const far = distanceAt(index);
    const direction = joinDirection(line, index);
    const given = index === 0 ? ends.start : index === line.length - 1 ? ends.end : null;
    if (!given) return { x: place.x + direction.x * far, y: place.y + direction.y * far };
    const square = direction.x * given.x + direction.y * given.y;
    const away = Math.abs(far) * Math.min(LONGEST_MITRE, 1 / Math.max(Math.abs(square), 1e-6));
    return { x: place.x + given.x * away, y: place.y + given.y * away };
  });
  return withoutLoops(withoutBackwards(line, moved));
}

/** The direction in which a vertex moves, longer at a bend so that both pieces keep their distance. */
function joinDirection(line: readonly Place[], index: number): Place {
  const before = index > 0 ? turnedLeft(unit(at(line, index - 1), at(line, index))) : null;
  const after = index < line.length - 1 ? turnedLeft(unit(at(line, index), at(line, index + 1))) : null;
  const one = before ?? after;
  const other = after ?? before;
  if (one === null || other === null) throw new RangeError("a line needs two vertices");
  const sum = { x: one.x + other.x, y: one.y + other.y };
  const size = Math.hypot(sum.x, sum.y);
  if (size < 1e-9) return one;
  const half = size / 2; // cosine of half the bend
  const mitre = Math.min(LONGEST_MITRE, 1 / half);
  return { x: (sum.x / size) * mitre, y: (sum.y / size) * mitre };
}

function withoutBackwards(line: readonly Place[], moved: readonly Place[]): Place[] {
  const pairs = moved.map((place, index) => ({ place, from: at(line, index) }));
  for (let i = 1; i < pairs.length; ) {
    const [a, b] = [pairs[i - 1], pairs[i]];
    if (a === undefined || b === undefined) break;
    const runsOn =
      (b.place.x - a.place.x) * (b.from.x - a.from.x) + (b.place.y - a.place.y) * (b.from.y - a.from.y) > 0;
    if (runsOn || pairs.length === 2) i++;
    else {
      // Keep both ends; of two inner vertices the later one goes, and the pair before it is looked at again.
      pairs.splice(i === pairs.length - 1 ? i - 1 : i, 1);
      i = Math.max(1, i - 1);
    }
  }
  return pairs.map(({ place }) => place);
}

function withoutLoops(line: Place[]): Place[] {
  for (let i = 0; i + 1 < line.length; i++) {
    for (let j = line.length - 2; j > i + 1; j--) {
      const cut = crossingOf(at(line, i), at(line, i + 1), at(line, j), at(line, j + 1));
      if (cut !== null) line.splice(i + 1, j - i, cut);
    }
  }
  return line;
}
