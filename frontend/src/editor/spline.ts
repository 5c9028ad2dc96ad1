/** A smooth road line through clicked places. */
import type { Place } from "./elements";
import { at, distance, nearestOnSegment, unit } from "./polyline";

const STEP_METRES = 1.5;
const FLATNESS_METRES = 0.02;

/**
 * Cubic Hermite through the places; at the ends it follows the given directions (unit vectors in driving direction),
 * else the first and last piece. Only the vertices that the bends need.
 */
export function smoothLine(places: readonly Place[], start: Place | null, end: Place | null): Place[] {
  if (places.length < 2) return [...places];
  const directions = places.map((_, index) => {
    if (index === 0) return start ?? (places.length > 2 ? null : unit(at(places, 0), at(places, 1)));
    if (index === places.length - 1) return end ?? null;
    return unit(at(places, index - 1), at(places, index + 1));
  });
  const line: Place[] = [at(places, 0)];
  for (let i = 1; i < places.length; i++) {
    const a = at(places, i - 1);
    const b = at(places, i);
    const chord = distance(a, b);
    const straight = unit(a, b);
    const leaving = directions[i - 1] ?? straight;
    const arriving = directions[i] ?? straight;
    const steps = Math.max(1, Math.ceil(chord / STEP_METRES));
    for (let step = 1; step <= steps; step++) {
      line.push(hermite(a, b, leaving, arriving, chord, step / steps));
    }
  }
  return simplified(line, FLATNESS_METRES);
}

function hermite(a: Place, b: Place, leaving: Place, arriving: Place, chord: number, t: number): Place {
  const [t2, t3] = [t * t, t * t * t];
  const [h00, h10, h01, h11] = [2 * t3 - 3 * t2 + 1, t3 - 2 * t2 + t, -2 * t3 + 3 * t2, t3 - t2];
  return {
    x: h00 * a.x + h10 * chord * leaving.x + h01 * b.x + h11 * chord * arriving.x,
    y: h00 * a.y + h10 * chord * leaving.y + h01 * b.y + h11 * chord * arriving.y,
  };
}

/** Douglas–Peucker. */
export function simplified(line: readonly Place[], tolerance: number): Place[] {
  const first = at(line, 0);
  const last = at(line, -1);
  let worst = 0;
  let index = 0;
  for (let i = 1; i < line.length - 1; i++) {
    const far = distance(at(line, i), nearestOnSegment(at(line, i), first, last));
    if (far > worst) [worst, index] = [far, i];
  }
  if (worst <= tolerance) return line.length < 2 ? [...line] : [first, last];
  return [
    ...simplified(line.slice(0, index + 1), tolerance).slice(0, -1),
    ...simplified(line.slice(index), tolerance),
  ];
}
