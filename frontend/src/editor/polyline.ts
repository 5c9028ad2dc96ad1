/** Plane geometry of polylines, in metres; z plays no part. */
import type { Place } from "./elements";

export function distance(a: Place, b: Place): number {
  return Math.hypot(b.x - a.x, b.y - a.y);
}

export function middle(a: Place, b: Place): Place {
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}

export function lengthOf(line: readonly Place[]): number {
  let sum = 0;
  for (let i = 1; i < line.length; i++) sum += distance(at(line, i - 1), at(line, i));
  return sum;
}

/** The vertex at an index counted from the end when negative; throws outside the line. */
export function at<T extends Place>(line: readonly T[], index: number): T {
  const place = line.at(index);
  if (place === undefined) throw new RangeError(`a line of ${line.length} vertices has none at ${index}`);
  return place;
}

export interface Nearest {
  readonly place: Place;
  readonly distance: number;
  /** The vertex before the nearest place. */
  readonly segment: number;
}

export function nearestOnSegment(from: Place, a: Place, b: Place): Place {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const square = dx * dx + dy * dy;
  if (square === 0) return a;
  const fraction = Math.min(1, Math.max(0, ((from.x - a.x) * dx + (from.y - a.y) * dy) / square));
  return { x: a.x + fraction * dx, y: a.y + fraction * dy };
}

export function nearestOnLine(from: Place, line: readonly Place[]): Nearest {
  let best: Nearest = { place: at(line, 0), distance: distance(from, at(line, 0)), segment: 0 };
  for (let i = 1; i < line.length; i++) {
    const place = nearestOnSegment(from, at(line, i - 1), at(line, i));
    const far = distance(from, place);
    if (far < best.distance) best = { place, distance: far, segment: i - 1 };
  }
  return best;
}

/** The place at a fraction (0 to 1) of the line's length. */
export function alongLine(line: readonly Place[], fraction: number): Place {
  let rest = lengthOf(line) * Math.min(1, Math.max(0, fraction));
  for (let i = 1; i < line.length; i++) {
    const a = at(line, i - 1);
    const b = at(line, i);
    const step = distance(a, b);
    if (rest <= step && step > 0) {
      return { x: a.x + ((b.x - a.x) * rest) / step, y: a.y + ((b.y - a.y) * rest) / step };
    }
    rest -= step;
  }
  return at(line, -1);
}

/** `count` places at equal steps along the line, ends included. */
export function resampled(line: readonly Place[], count: number): Place[] {
  return Array.from({ length: count }, (_, i) => alongLine(line, i / (count - 1)));
}

/** The lane's middle line, from boundaries that both run in driving direction. */
export function centreline(left: readonly Place[], right: readonly Place[], count = 10): Place[] {
  const one = resampled(left, count);
  const other = resampled(right, count);
  return one.map((place, i) => middle(place, at(other, i)));
}

/** 2-D Hausdorff distance, taken at vertices: exact enough to tell whether a line moved. */
export function hausdorff(a: readonly Place[], b: readonly Place[]): number {
  const oneWay = (from: readonly Place[], to: readonly Place[]) =>
    Math.max(...from.map((place) => nearestOnLine(place, to).distance));
  return Math.max(oneWay(a, b), oneWay(b, a));
}

export function unit(from: Place, to: Place): Place {
  const size = distance(from, to);
  return size === 0 ? { x: 1, y: 0 } : { x: (to.x - from.x) / size, y: (to.y - from.y) / size };
}

/** The direction turned left by 90°. */
export function turnedLeft(direction: Place): Place {
  return { x: -direction.y, y: direction.x };
}

/** Where the inner parts of two segments cross, or null. */
export function crossingOf(a: Place, b: Place, c: Place, d: Place): Place | null {
  const cross = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
  if (cross === 0) return null;
  const t = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / cross;
  const u = ((c.x - a.x) * (b.y - a.y) - (c.y - a.y) * (b.x - a.x)) / cross;
  if (t <= 0 || t >= 1 || u <= 0 || u >= 1) return null;
  return { x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y) };
}
