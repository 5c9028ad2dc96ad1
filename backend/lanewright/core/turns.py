"""The function of a lane inside an intersection: turn class, approaches and exits (spec §5; paper A.6)."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from enum import StrEnum

from lanewright.core.elements import LaneSegment
from lanewright.core.geometry import centreline, heading, readable_element, turned
from lanewright.core.lateral import lateral_group
from lanewright.core.roadgraph import RoadGraph

_STRAIGHT_BELOW = math.radians(30)
_U_TURN_ABOVE = math.radians(150)


class TurnClass(StrEnum):
    STRAIGHT = "straight"
    LEFT = "left"
    RIGHT = "right"
    U_TURN = "u-turn"


@dataclass(frozen=True, slots=True)
class Access:
    """An approach or exit: a lane outside the intersection, in its lateral group (left to right)."""

    lane: int
    group: tuple[int, ...]

    @property
    def from_left(self) -> int:
        return self.group.index(self.lane)

    @property
    def from_right(self) -> int:
        return len(self.group) - 1 - self.from_left


@dataclass(frozen=True, slots=True)
class TurnFunction:
    """What an intersection lane is for."""

    turn: TurnClass
    approaches: tuple[Access, ...]
    exits: tuple[Access, ...]


def turn_class(lane: LaneSegment) -> TurnClass:
    """Straight below 30°, u-turn above 150°, else left or right: heading over the last 10 % minus the first 10 %."""
    points = centreline(lane)
    angle = turned(heading(points[:3]), heading(points[-3:]))
    if abs(angle) < _STRAIGHT_BELOW:
        return TurnClass.STRAIGHT
    if abs(angle) > _U_TURN_ABOVE:
        return TurnClass.U_TURN
    return TurnClass.LEFT if angle > 0 else TurnClass.RIGHT


def turn_function(graph: RoadGraph, lane: int) -> TurnFunction | None:
    """The function of an intersection lane; None outside intersections, or without approach or exit in the map."""
    segment = graph.lanes[lane]
    if not segment.is_intersection or not readable_element(segment):
        return None
    approaches = _first_outside(graph, lane, graph.predecessors)
    exits = _first_outside(graph, lane, graph.successors)
    if not approaches or not exits:
        return None
    return TurnFunction(turn_class(segment), approaches, exits)


def _first_outside(graph: RoadGraph, lane: int, links: dict[int, tuple[int, ...]]) -> tuple[Access, ...]:
    """The first lane outside the intersection on every path along the links, ascending."""
    found: set[int] = set()
    seen = {lane}
    queue = [lane]
    while queue:
        for other in links[queue.pop()]:
            if not graph.lanes[other].is_intersection:
                found.add(other)
            elif other not in seen:
                seen.add(other)
                queue.append(other)
    return tuple(Access(other, lateral_group(graph.lanes, other)) for other in sorted(found))


def same_function(one: TurnFunction | None, other: TurnFunction | None, survivors: Collection[int]) -> bool:
    """Whether two intersection lanes, one in each map, do the same (spec §5); None equals nothing."""
    if one is None or other is None or one.turn is not other.turn:
        return False
    return _partnered(one.approaches, other.approaches, one.turn, survivors) and _partnered(
        one.exits, other.exits, one.turn, survivors
    )


def _partnered(
    here: tuple[Access, ...], there: tuple[Access, ...], turn: TurnClass, survivors: Collection[int]
) -> bool:
    def partners(one: Access, other: Access) -> bool:
        shared = set(one.group) & set(other.group)
        return _same_rank(one, other, turn) and any(lane in survivors for lane in shared)

    return all(any(partners(one, other) for other in there) for one in here) and all(
        any(partners(one, other) for one in here) for other in there
    )


def _same_rank(one: Access, other: Access, turn: TurnClass) -> bool:
    if turn is TurnClass.RIGHT:
        return one.from_right == other.from_right
    if turn is TurnClass.STRAIGHT:
        return one.from_right == other.from_right or one.from_left == other.from_left
    return one.from_left == other.from_left
