"""Matching by place: elements of two maps that have the same lines, whatever their ids (import of foreign pairs)."""

from __future__ import annotations

import itertools
from collections.abc import Hashable, Iterator, Mapping, Sequence

import numpy as np

from lanewright.core.alignment import categories_between
from lanewright.core.comparison import best_edge_distance_m
from lanewright.core.elements import Element, LaneSegment, Line, MapState, PedestrianCrossing
from lanewright.core.geometry import MOVED_M, lines_of, moved, readable_element
from lanewright.core.survey import Survey

Place = tuple[tuple[tuple[float, float], ...], ...]


def same_lanes(base: MapState, edited: MapState, known: Mapping[int, int], own: Mapping[int, int]) -> dict[int, int]:
    """Edited id -> base id for lanes whose lines did not move: first those with equal points, then the others.

    ``known``: edited lanes that are matched already, with what; out of ``own`` (edited id -> the id it came with) are
    those to be matched. Of several lanes on one place those with equal properties and links pair up, then those with
    equal properties, then those with the fewest changed categories; the smallest ids first.
    """
    taken = set(known.values())
    left = {key: base.lanes[key] for key in sorted(base.lanes) if key not in taken}
    rest = {key: edited.lanes[key] for key in sorted(own)}
    matched = dict(known)
    crowded = []
    by_place = lanes_by_place(left)
    for place, keys in lanes_by_place(rest).items():
        olds = by_place.get(place, [])
        if len(olds) == len(keys) == 1:
            matched[keys[0]] = olds[0]
        elif olds:
            crowded.append((olds, keys))
    for olds, keys in sorted(crowded):
        matched |= _paired(base, edited, olds, keys, matched, own)
    taken = set(matched.values())
    left = {key: lane for key, lane in left.items() if key not in taken and readable_element(lane)}
    rest = {key: lane for key, lane in rest.items() if key not in matched and readable_element(lane)}
    return matched | _unmoved(left, rest)


def lanes_by_place(lanes: Mapping[int, LaneSegment]) -> dict[Place, list[int]]:
    """The ids of the lanes on each pair of lines."""
    places: dict[Place, list[int]] = {}
    for key, lane in lanes.items():
        places.setdefault(place_of(lane), []).append(key)
    return places


def place_of(lane: LaneSegment) -> Place:
    """A lane's left and right boundary in the plane."""
    return plan_of(lane.left_boundary), plan_of(lane.right_boundary)


class _Links:
    """Which matched lanes a lane is linked to, by their base ids."""

    def __init__(self, state: MapState, matched: Mapping[int, int]):
        self._graph = Survey(state).graph
        self._matched = matched

    def of(self, lane: int) -> tuple[frozenset[int], ...]:
        sides = self._graph.successors[lane], self._graph.predecessors[lane]
        return tuple(frozenset(self._matched[other] for other in side if other in self._matched) for side in sides)


def _paired(
    base: MapState,
    edited: MapState,
    olds: Sequence[int],
    keys: Sequence[int],
    matched: Mapping[int, int],
    own: Mapping[int, int],
) -> dict[int, int]:
    """Pairs of lanes on one place."""
    was, now = _Links(base, {old: old for old in matched.values()}), _Links(edited, matched)
    pairs = _alike(
        {old: (_properties(base.lanes[old]), was.of(old)) for old in olds},
        {key: (_properties(edited.lanes[key]), now.of(key)) for key in keys},
        own,
    )
    left, rest = set(olds).difference(pairs.values()), [key for key in keys if key not in pairs]
    pairs |= _alike(
        {old: _properties(base.lanes[old]) for old in sorted(left)},
        {key: _properties(edited.lanes[key]) for key in rest},
        own,
    )
    left.difference_update(pairs.values())
    for key in rest:
        if key not in pairs and left:
            pairs[key] = min(left, key=lambda old: (categories_between(base.lanes[old], edited.lanes[key]), old))
            left.remove(pairs[key])
    return pairs


def _alike(olds: Mapping[int, Hashable], keys: Mapping[int, Hashable], own: Mapping[int, int]) -> dict[int, int]:
    """Pairs of elements that look alike, the smallest ids first. As many as nothing tells apart keep their ids."""
    pairs: dict[int, int] = {}
    groups: dict[Hashable, tuple[list[int], list[int]]] = {}
    for old, look in olds.items():
        groups.setdefault(look, ([], []))[0].append(old)
    for key, look in keys.items():
        groups.setdefault(look, ([], []))[1].append(key)
    for left, rest in groups.values():
        if len(left) == len(rest):
            kept = {key: own[key] for key in rest if own[key] in left}
            left = [old for old in left if old not in kept.values()]
            rest = [key for key in rest if key not in kept]
            pairs |= kept
        pairs |= zip(rest, left, strict=False)
    return pairs


def _properties(lane: LaneSegment) -> Hashable:
    return (lane.left_mark, lane.right_mark, lane.lane_type, lane.is_intersection)


class _Boxes:
    """Bounding boxes of elements, to find those about as large at about the same place."""

    def __init__(self, elements: Mapping[int, Element]):
        self._ids = sorted(elements)
        self._boxes = np.array([_box(elements[key]) for key in self._ids]).reshape(-1, 4)

    def near(self, element: Element) -> Iterator[int]:
        """Ids of those whose boxes agree within twice the tolerance, ascending."""
        close = (np.abs(self._boxes - _box(element)) <= 2 * MOVED_M).all(axis=1)
        return (self._ids[index] for index in np.flatnonzero(close))


def _unmoved(base: Mapping[int, LaneSegment], edited: Mapping[int, LaneSegment]) -> dict[int, int]:
    """Matches of lanes that moved by less than the tolerance, or have other points on the same lines."""
    matched: dict[int, int] = {}
    taken: set[int] = set()
    boxes = _Boxes(base)
    for key in sorted(edited):
        candidates = [
            old
            for old in boxes.near(edited[key])
            if old not in taken
            and not moved(base[old].left_boundary, edited[key].left_boundary)
            and not moved(base[old].right_boundary, edited[key].right_boundary)
        ]
        if candidates:
            matched[key] = min(candidates, key=lambda old: (categories_between(base[old], edited[key]), old))
            taken.add(matched[key])
    return matched


def same_crossings(
    base: Mapping[int, PedestrianCrossing], edited: Mapping[int, PedestrianCrossing], own: Mapping[int, int]
) -> dict[int, int]:
    """Edited id -> base id for crossings that did not move: those on the same points, then the others, smallest ids
    first. ``own``: the ids that the edited ones came with."""
    matched = _alike(
        {key: _corners(base[key]) for key in sorted(base)}, {key: _corners(edited[key]) for key in sorted(edited)}, own
    )
    taken = set(matched.values())
    boxes = _Boxes({key: one for key, one in base.items() if key not in taken and readable_element(one)})
    for key in sorted(edited.keys() - matched.keys()):
        if not readable_element(edited[key]):
            continue
        for old in boxes.near(edited[key]):
            if old not in taken and best_edge_distance_m(base[old], edited[key]) <= MOVED_M:
                matched[key] = old
                taken.add(old)
                break
    return matched


def _corners(crossing: PedestrianCrossing) -> Hashable:
    return frozenset(frozenset(plan_of(edge)) for edge in lines_of(crossing))


def plan_of(line: Line) -> tuple[tuple[float, float], ...]:
    return tuple(point[:2] for point in line)


def _box(element: Element) -> tuple[float, float, float, float]:
    x, y, _ = zip(*itertools.chain(*lines_of(element)), strict=True)
    return (min(x), min(y), max(x), max(y))
