/** The bars of a crossing: across the walk, from edge to edge. */
import type { Crossing, Place } from "../editor";

const BAR_METRES = 0.9;

export function barsOf(crossing: Crossing): Place[][] {
  const [a, b] = crossing.edge1;
  const [p, q] = crossing.edge2;
  if (a === undefined || b === undefined || p === undefined || q === undefined) return [];
  const sameWay = (b.x - a.x) * (q.x - p.x) + (b.y - a.y) * (q.y - p.y) >= 0;
  const [c, d] = sameWay ? [p, q] : [q, p];
  const length = Math.max(Math.hypot(b.x - a.x, b.y - a.y), Math.hypot(d.x - c.x, d.y - c.y));
  const count = Math.max(1, Math.round(length / (2 * BAR_METRES) + 0.5));
  const slots = 2 * count - 1;
  const along = (from: Place, to: Place, t: number) => ({
    x: from.x + (to.x - from.x) * t,
    y: from.y + (to.y - from.y) * t,
  });
  return Array.from({ length: count }, (_, i) => {
    const [from, to] = [(2 * i) / slots, (2 * i + 1) / slots];
    return [along(a, b, from), along(a, b, to), along(c, d, to), along(c, d, from)];
  });
}
