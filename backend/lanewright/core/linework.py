"""All boundaries of a map at once, as arrays: the quick look that finds the few lanes worth a slow one."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import chain

import numpy as np
import numpy.typing as npt
import shapely

from lanewright.core.elements import LaneSegment, Line

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]
Counts = npt.NDArray[np.int64]


def doubtful_lanes(lanes: Mapping[int, LaneSegment]) -> tuple[int, ...]:
    """Ids of lanes whose geometry is not clearly sound, ascending.

    Sound: two or more finite points a side, no point twice in a row, no side crossing itself or meeting the other,
    left on the left, between 0.3 m and 15 m wide on average.
    """
    ids = np.fromiter(lanes, dtype=np.int64, count=len(lanes))
    if not len(ids):
        return ()
    sides = [lane.left_boundary for lane in lanes.values()] + [lane.right_boundary for lane in lanes.values()]
    doubtful = _unsound(sides)
    return tuple(sorted(int(key) for key in ids[doubtful]))


def _unsound(sides: list[Line]) -> Flags:
    """Which lanes are not clearly sound; ``sides`` holds all left boundaries, then all right ones."""
    half = len(sides) // 2
    counts = np.fromiter(map(len, sides), dtype=np.int64, count=len(sides))
    points = plans(sides, int(counts.sum()))
    bad: Flags = (counts < 2) | ~_every(np.isfinite(points[:, 0]) & np.isfinite(points[:, 1]), counts)
    unreadable: Flags = bad[:half] | bad[half:]
    if unreadable.any():
        kept = [line for line, keep in zip(sides, np.tile(~unreadable, 2), strict=True) if keep]
        unreadable[~unreadable] = _unsound(kept) if kept else False
        return unreadable
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    steps = np.diff(points, axis=0)
    within = np.ones(len(steps), dtype=bool)
    within[starts[1:] - 1] = False
    lengths = np.where(within, np.hypot(*steps.T), 0.0)
    owner = np.repeat(np.arange(len(sides)), counts)
    repeated = np.bincount(owner[:-1][within & (lengths == 0)], minlength=len(sides)) > 0
    length = np.bincount(owner[:-1], weights=lengths, minlength=len(sides))
    area = _area(points, counts, starts, owner, within, half)
    with np.errstate(divide="ignore", invalid="ignore"):
        width = 2 * area / (length[:half] + length[half:])
    lines = shapely.linestrings(points, indices=owner)
    crossed = ~shapely.is_simple(lines)
    met = shapely.intersects(lines[:half], lines[half:])
    side = repeated | crossed
    unsound: Flags = side[:half] | side[half:] | met | ~((width >= 0.3) & (width <= 15.0))
    return unsound


def plans(lines: list[Line], count: int) -> Floats:
    """The points of many lines in the plane, one after the other, shape (count, 2)."""
    flat = np.fromiter(chain.from_iterable(chain.from_iterable(lines)), dtype=np.float64, count=3 * count)
    return flat.reshape(-1, 3)[:, :2]


def _every(flags: Flags, counts: Counts) -> Flags:
    """Whether all flags of each line hold."""
    owner = np.repeat(np.arange(len(counts)), counts)
    failed: Flags = np.bincount(owner[~flags], minlength=len(counts)) == 0
    return failed


def _area(points: Floats, counts: Counts, starts: Counts, owner: Counts, within: Flags, half: int) -> Floats:
    """Signed area of each lane, right boundary plus reversed left: positive with left on the left.

    Relative to each lane's first left point, so that city coordinates of kilometres lose no digits.
    """
    origin = points[starts[:half]]
    local = points - origin[owner % half]
    x, y = local.T
    cross = np.where(within, x[:-1] * y[1:] - x[1:] * y[:-1], 0.0)
    swept = np.bincount(owner[:-1], weights=cross, minlength=2 * half)
    first, last = local[starts], local[starts + counts - 1]
    left, right = slice(0, half), slice(half, None)
    closing = _cross(last[right], last[left]) + _cross(first[left], first[right])
    area: Floats = (swept[right] - swept[left] + closing) / 2
    return area


def _cross(one: Floats, other: Floats) -> Floats:
    product: Floats = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return product
