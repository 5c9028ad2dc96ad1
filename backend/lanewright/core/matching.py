"""Matching by place: elements of two maps that have the same lines, whatever their ids (import of foreign pairs)."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from lanewright.core.alignment import categories_between
from lanewright.core.comparison import best_edge_distance_m
from lanewright.core.elements import LaneSegment, Line, PedestrianCrossing
from lanewright.core.geometry import MOVED_M, moved, readable_element

Place = tuple[tuple[tuple[float, float], ...], ...]


def same_lanes(base: Mapping[int, LaneSegment], edited: Mapping[int, LaneSegment]) -> dict[int, int]:
    """Edited id -> base id for lanes whose lines did not move: first those with equal points, then the others.

    Of several lanes on one place those with the fewest changed categories pair up, then the smallest ids.
    """
    matched: dict[int, int] = {}
    by_place: dict[Place, list[int]] = {}
    for key in sorted(base):
        by_place.setdefault(_place(base[key]), []).append(key)
    for key in sorted(edited):
        candidates = by_place.get(_place(edited[key]), [])
        best = min(candidates, key=lambda old: (categories_between(base[old], edited[key]), old), default=None)
        if best is not None:
            matched[key] = best
            candidates.remove(best)
    taken = set(matched.values())
    left = {key: lane for key, lane in base.items() if key not in taken and readable_element(lane)}
    rest = {key: lane for key, lane in edited.items() if key not in matched and readable_element(lane)}
    return matched | _unmoved(left, rest)


def _unmoved(base: Mapping[int, LaneSegment], edited: Mapping[int, LaneSegment]) -> dict[int, int]:
    """Matches of lanes that moved by less than the tolerance, or have other points on the same lines."""
    if not base or not edited:
        return {}
    matched: dict[int, int] = {}
    ids = sorted(base)
    boxes = np.array([_box(base[key]) for key in ids])
    for key in sorted(edited):
        near = np.flatnonzero((np.abs(boxes - _box(edited[key])) <= 2 * MOVED_M).all(axis=1))
        candidates = [
            ids[index]
            for index in near
            if ids[index] not in matched.values()
            and not moved(base[ids[index]].left_boundary, edited[key].left_boundary)
            and not moved(base[ids[index]].right_boundary, edited[key].right_boundary)
        ]
        if candidates:
            matched[key] = min(candidates, key=lambda old: (categories_between(base[old], edited[key]), old))
    return matched


def same_crossings(base: Mapping[int, PedestrianCrossing], edited: Mapping[int, PedestrianCrossing]) -> dict[int, int]:
    """Edited id -> base id for crossings that did not move, smallest ids first."""
    matched: dict[int, int] = {}
    for key in sorted(edited):
        for old in sorted(base):
            if old not in matched.values() and best_edge_distance_m(base[old], edited[key]) <= MOVED_M:
                matched[key] = old
                break
    return matched


def _place(lane: LaneSegment) -> Place:
    return (_plan(lane.left_boundary), _plan(lane.right_boundary))


def _plan(line: Line) -> tuple[tuple[float, float], ...]:
    return tuple(point[:2] for point in line)


def _box(lane: LaneSegment) -> tuple[float, float, float, float]:
    x, y, _ = zip(*lane.left_boundary, *lane.right_boundary, strict=True)
    return (min(x), min(y), max(x), max(y))
