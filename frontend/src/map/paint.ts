/** Boundaries as painted: stripes, dashes in metres, and the faint line of what has no paint. */
import {
  boundary,
  colourOf,
  type Lane,
  type MarkColour,
  markOf,
  type Place,
  type Side,
  stripesOf,
} from "../editor";

export const DASH_METRES = 3;
export const GAP_METRES = 4.5;

/** One line to draw. `offset`: -1 left, 1 right of the line's direction, 0 on it. */
export interface PaintedLine {
  readonly colour: MarkColour;
  readonly offset: -1 | 0 | 1;
  readonly parts: readonly (readonly Place[])[];
}

/**
 * The lines of one boundary. Both lanes that share it draw it, so it always runs the same way, whichever lane it is
 * read from: dashes of the two copies fall onto each other.
 */
export function paintedLines(lane: Lane, side: Side): PaintedLine[] {
  const line = boundary(lane, side);
  const mark = markOf(lane, side);
  const turned = runsBackwards(line);
  const places = turned ? line.toReversed() : line;
  const stripes = stripesOf(mark);
  if (stripes.length === 0) return [{ colour: "none", offset: 0, parts: [places] }];
  // A stripe near the lane lies right of a left boundary and left of a right one.
  const towardsLane = (side === "left") === turned ? -1 : 1;
  return stripes.map(({ dashed, place }) => ({
    colour: colourOf(mark),
    offset: place === 0 ? 0 : ((-place * towardsLane) as -1 | 1),
    parts: dashed ? dashes(places) : [places],
  }));
}

function runsBackwards(line: readonly Place[]): boolean {
  const first = line[0];
  const last = line.at(-1);
  if (first === undefined || last === undefined) return false;
  return first.x === last.x ? first.y > last.y : first.x > last.x;
}

/** Cuts a line into dashes, a dash at either end as road crews paint it. */
export function dashes(line: readonly Place[], dash = DASH_METRES, gap = GAP_METRES): Place[][] {
  const steps = line
    .slice(1)
    .map((place, i) => Math.hypot(place.x - (line[i]?.x ?? 0), place.y - (line[i]?.y ?? 0)));
  const total = steps.reduce((sum, step) => sum + step, 0);
  if (total <= dash) return [[...line]];
  const count = Math.max(1, Math.round((total - dash) / (dash + gap)));
  const stretch = total / (count * (dash + gap) + dash);
  return Array.from({ length: count + 1 }, (_, i) =>
    between(line, steps, i * (dash + gap) * stretch, (i * (dash + gap) + dash) * stretch),
  );
}

function between(line: readonly Place[], steps: readonly number[], from: number, to: number): Place[] {
  const part: Place[] = [];
  let start = 0;
  steps.forEach((step, i) => {
    const a = line[i];
    const b = line[i + 1];
    const end = start + step;
    if (a !== undefined && b !== undefined && step > 0 && end > from && start < to) {
      const at = (fraction: number) => ({ x: a.x + (b.x - a.x) * fraction, y: a.y + (b.y - a.y) * fraction });
      if (part.length === 0) part.push(at(Math.max(0, (from - start) / step)));
      part.push(at(Math.min(1, (to - start) / step)));
    }
    start = end;
  });
  return part;
}
