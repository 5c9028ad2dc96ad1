"""What stays below tolerance goes back to the base's exact coordinates (spec §2 normal form, §3).

An element without a change is bit-identical to the base, always. So that joints and shared boundaries stay exact, every
line that goes back takes along whoever has the same point or the same line: a joint between a changed and an unchanged
lane returns in both (it moved by less than the tolerance there), one that only changed lanes use keeps its new place.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Iterable, Iterator
from typing import Any

from lanewright.core.comparison import Comparison
from lanewright.core.elements import Element, ElementKey, ElementKind, LaneSegment, Line, MapState, Point
from lanewright.core.geometry import MOVED_M, distance_m

_SIDES = ("left", "right")
_PASSES = 4
"""Returning a point can bring another line below tolerance; each pass returns at least one more line."""

_JOINT_M = 2 * MOVED_M
"""The ends of a line that did not move are within this distance of where they were."""

Place = tuple[float, float]


def restore(base: MapState, edited: MapState) -> MapState:
    """The edited map with everything that does not count put back as the base has it.

    That is: lines that did not move (points added on the line, z, sub-tolerance edits), the order of link lists, rim
    ids, neighbour ids between unmoved lanes, and the order and direction of crossing edges.
    """
    state = edited
    for _ in range(_PASSES):
        comparison = Comparison(base, state)
        if not comparison.differing_lanes and not comparison.differing_crossings:
            break
        restored = _restored(comparison)
        if not restored.apart(state):
            break
        state = restored
    return state


def _restored(comparison: Comparison) -> MapState:
    changed = comparison.changed_keys
    back = _ReturningLines(comparison, changed)
    elements: list[Element] = []
    for key in sorted(comparison.apart):
        element, known = comparison.edited.get(key), comparison.base.get(key)
        if element is None:
            continue
        if known is not None and known == element:
            elements.append(known)
            continue
        restored = element
        if isinstance(element, LaneSegment):
            restored = back.lane(element)
            if known is not None:
                restored = _with_base_links(comparison, restored)
        elif known is not None and key not in changed:
            restored = known
        elements.append(next((one for one in (known, element) if one == restored), restored))
    return comparison.edited.replaced(elements)


class _ReturningLines:
    """Lines and joints that return to the base, by what they are in the edited map."""

    def __init__(self, comparison: Comparison, changed: Collection[ElementKey]):
        self._lines: dict[tuple[Place, ...], Line] = {}
        self._places: dict[Place, Point] = {}
        self._own: dict[tuple[int, str], Line] = {}
        returning = list(_unmoved_lines(comparison))
        disputed = _disputed_places(returning)
        for lane, side, was, now in returning:
            if lane in changed and not disputed.isdisjoint(_tips(now)):
                continue
            self._own[lane.id, side] = was
            plan = tuple(point[:2] for point in now)
            self._lines[plan] = was
            self._lines[plan[::-1]] = was[::-1]
            # A line drawn the other way round lies where it was, but its ends do not.
            self._places |= {now[end][:2]: was[end] for end in (0, -1) if distance_m(now[end], was[end]) <= _JOINT_M}

    def lane(self, lane: LaneSegment) -> LaneSegment:
        """The lane with its returning lines, and its points at returning joints, put back."""
        lines: dict[str, Any] = {}
        for side in _SIDES:
            name = f"{side}_boundary"
            line: Line = getattr(lane, name)
            restored = self._own.get((lane.id, side)) or self._line(line)
            if restored is not line:
                lines[name] = restored
        return dataclasses.replace(lane, **lines) if lines else lane

    def _line(self, line: Line) -> Line:
        if not self._places:
            return line
        whole = self._lines.get(tuple(point[:2] for point in line))
        if whole is not None:
            return whole
        if not any(point[:2] in self._places for point in line):
            return line
        moved = [self._places.get(point[:2], point) for point in line]
        return tuple(point for index, point in enumerate(moved) if index == 0 or point[:2] != moved[index - 1][:2])


def _tips(line: Line) -> set[Place]:
    return {line[0][:2], line[-1][:2]}


def _unmoved_lines(comparison: Comparison) -> Iterator[tuple[ElementKey, str, Line, Line]]:
    """Boundaries of surviving lanes that differ but did not move: lane, side, base line, edited line."""
    for key in comparison.differing_lanes:
        was, now = comparison.base.lanes[key], comparison.edited.lanes[key]
        for side, moved in zip(_SIDES, comparison.moved_sides(key), strict=True):
            before, after = getattr(was, f"{side}_boundary"), getattr(now, f"{side}_boundary")
            if not moved and before != after and len(after) >= 2:
                yield ElementKey(ElementKind.LANE_SEGMENT, key), side, before, after


def _disputed_places(returning: Iterable[tuple[ElementKey, str, Line, Line]]) -> set[Place]:
    """Joints whose lines would return to different places (lanes newly joined by a small shift)."""
    goals: dict[Place, set[Place]] = {}
    for _, _, was, now in returning:
        for end in (0, -1):
            goals.setdefault(now[end][:2], set()).add(was[end][:2])
    return {place for place, ends in goals.items() if len(ends) > 1}


def _with_base_links(comparison: Comparison, lane: LaneSegment) -> LaneSegment:
    """The lane with link lists and neighbour ids as in the base, where only what does not count differs, and its record
    of a cut (a lane that the base has whole is no part)."""
    known = comparison.base.lanes[lane.id]
    fields: dict[str, Any] = {} if lane.part_of == known.part_of else {"part_of": known.part_of}
    was, now = comparison.base_graph, comparison.edited_graph
    if was.successors[lane.id] == now.successors[lane.id] and was.predecessors[lane.id] == now.predecessors[lane.id]:
        fields |= {"successors": known.successors, "predecessors": known.predecessors}
    for side in _SIDES:
        name = f"{side}_neighbor_id"
        if _neighbor_returns(comparison, lane, known, name):
            fields[name] = getattr(known, name)
    return dataclasses.replace(lane, **fields) if fields else lane


def _neighbor_returns(comparison: Comparison, lane: LaneSegment, known: LaneSegment, name: str) -> bool:
    """Whether a neighbour id differs although neither lane of either pair moved, came or went."""
    before, after = getattr(known, name), getattr(lane, name)
    if before == after:
        return False
    for other in (lane.id, before, after):
        if other in comparison.deleted_lanes or other in comparison.inserted_lanes:
            return False
        if other in comparison.surviving_lanes and any(comparison.moved_sides(other)):
            return False
    return True
