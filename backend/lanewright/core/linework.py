"""All boundaries of a map at once, as arrays: the quick look that finds the few lanes worth a slow one."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from itertools import chain

import numpy as np
import numpy.typing as npt
import shapely

from lanewright.core.elements import LaneSegment, Line
from lanewright.core.geometry import FURTHEST_M, quietly

NARROWEST_M = 0.3
WIDEST_M = 15.0
"""A lane's mean width lies between these (spec §5)."""
Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]
Counts = npt.NDArray[np.int64]


class Linework:
    """The boundaries of all lanes of a map.

    Attributes:
        ids: lane ids, shape (n,), in the map's order.
        readable: whether both sides of each lane have two or more finite points, shape (n,). All other arrays hold
            the readable lanes only, in the same order: m of them.
    """

    def __init__(self, lanes: Mapping[int, LaneSegment]):
        self.ids = np.fromiter(lanes, dtype=np.int64, count=len(lanes))
        sides = [lane.left_boundary for lane in lanes.values()] + [lane.right_boundary for lane in lanes.values()]
        counts, points = _flat(sides)
        half = len(lanes)
        bad: Flags = (counts < 2) | ~_every(_within_reach(points), counts)
        self.readable: Flags = ~(bad[:half] | bad[half:])
        if not self.readable.all():
            keep = np.tile(self.readable, 2)
            counts, points = _flat([line for line, kept in zip(sides, keep, strict=True) if kept])
        self._counts, self._points = counts, points
        self._half = len(counts) // 2
        self._starts = np.concatenate([[0], np.cumsum(counts)[:-1]]).astype(np.int64)
        self._owner = np.repeat(np.arange(len(counts)), counts)
        self._within = np.ones(max(len(points) - 1, 0), dtype=bool)
        self._within[self._starts[1:] - 1] = False

    def doubtful(self) -> tuple[int, ...]:
        """Ids of lanes whose geometry is not clearly sound, ascending.

        Sound: no point twice in a row, no side crossing itself or meeting the other, left on the left, between 0.3 m
        and 15 m wide on average.
        """
        bad = ~self.readable
        if self._half:
            bad[self.readable] = self._unsound()
        return tuple(sorted(int(key) for key in self.ids[bad]))

    @quietly
    def _unsound(self) -> Flags:
        half = self._half
        repeated = np.bincount(self._owner[:-1][self._within & (self._steps == 0)], minlength=2 * half) > 0
        width = self.area_m2 / self.mean_length_m
        lines = shapely.linestrings(self._points, indices=self._owner)
        side = repeated | ~shapely.is_simple(lines)
        met = shapely.intersects(lines[:half], lines[half:])
        unsound: Flags = side[:half] | side[half:] | met | ~((width >= NARROWEST_M) & (width <= WIDEST_M))
        return unsound

    @cached_property
    def _steps(self) -> Floats:
        """Length from each point to the next, 0 between lines."""
        return np.where(self._within, np.hypot(*np.diff(self._points, axis=0).T), 0.0)

    @cached_property
    def mean_length_m(self) -> Floats:
        """Mean of the lengths of left and right, shape (m,)."""
        length = np.bincount(self._owner[:-1], weights=self._steps, minlength=2 * self._half)
        return (length[: self._half] + length[self._half :]) / 2

    @cached_property
    def area_m2(self) -> Floats:
        """Signed area, right boundary plus reversed left: positive with left on the left; shape (m,).

        Relative to each lane's first left point, so that city coordinates of kilometres lose no digits.
        """
        half, starts = self._half, self._starts
        local = self._points - self._points[starts[:half]][self._owner % half]
        x, y = local.T
        cross = np.where(self._within, x[:-1] * y[1:] - x[1:] * y[:-1], 0.0)
        swept = np.bincount(self._owner[:-1], weights=cross, minlength=2 * half)
        first, last = local[starts], local[starts + self._counts - 1]
        left, right = slice(0, half), slice(half, None)
        closing = _cross(last[right], last[left]) + _cross(first[left], first[right])
        area: Floats = (swept[right] - swept[left] + closing) / 2
        return area

    @cached_property
    def bounds(self) -> Floats:
        """Smallest x, y and largest x, y of each lane, shape (m, 4)."""
        low = np.minimum.reduceat(self._points, self._starts)
        high = np.maximum.reduceat(self._points, self._starts)
        half = self._half
        return np.hstack([np.minimum(low[:half], low[half:]), np.maximum(high[:half], high[half:])])

    def extent(self, lane: int) -> tuple[Floats, float] | None:
        """Bounds and area of a lane; None if it cannot be read."""
        at = self._row.get(lane)
        return None if at is None else (self.bounds[at], abs(float(self.area_m2[at])))

    @cached_property
    def _row(self) -> dict[int, int]:
        """Readable lane -> its row in the arrays."""
        return {key: row for row, key in enumerate(self.ids[self.readable].tolist())}

    def like(self, bounds: Floats, area_m2: float) -> tuple[int, ...]:
        """Ids of readable lanes that may cover the same ground: boxes meet, areas agree to 15 %; ascending."""
        if not self._half:
            return ()
        near = self._boxes.query(shapely.box(*bounds))
        areas = np.abs(self.area_m2[near])
        alike = np.minimum(areas, area_m2) >= 0.85 * np.maximum(areas, area_m2)
        return tuple(int(key) for key in np.sort(self.ids[self.readable][near[alike]]))

    @cached_property
    def _boxes(self) -> shapely.STRtree:
        return shapely.STRtree(shapely.box(*self.bounds.T))


def _flat(lines: list[Line]) -> tuple[Counts, Floats]:
    """How many points each line has, and all points in the plane one after the other, shape (sum, 2)."""
    counts = np.fromiter(map(len, lines), dtype=np.int64, count=len(lines))
    total = 3 * int(counts.sum())
    flat = np.fromiter(chain.from_iterable(chain.from_iterable(lines)), dtype=np.float64, count=total)
    return counts, flat.reshape(-1, 3)[:, :2]


def _every(flags: Flags, counts: Counts) -> Flags:
    """Whether all flags of each line hold."""
    owner = np.repeat(np.arange(len(counts)), counts)
    failed: Flags = np.bincount(owner[~flags], minlength=len(counts)) == 0
    return failed


def _within_reach(points: Floats) -> Flags:
    near: Flags = np.abs(points) < FURTHEST_M
    return near[:, 0] & near[:, 1]


def _cross(one: Floats, other: Floats) -> Floats:
    product: Floats = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return product
