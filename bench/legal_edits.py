"""Maps as annotators leave them: a number of everyday edits, each of them legal, the same for the same seed."""

from __future__ import annotations

import dataclasses
import random
from collections.abc import Callable

from lanewright.core.elements import Element, LaneSegment, LaneType, Line, MapState, Mark, PedestrianCrossing
from lanewright.core.rules import check

Draw = Callable[[MapState, random.Random], list[Element] | None]


def legally_edited(base: MapState, count: int, seed: int = 7) -> MapState:
    """The map after ``count`` edits that no rule objects to: repainted, moved and re-typed lanes, moved and new
    crossings. An edit of a line changes every lane that has this line."""
    random_ = random.Random(seed)  # noqa: S311  # nothing secret: the same edits in every run
    edited, made = base, 0
    while made < count:
        elements = random_.choice(_DRAWS)(edited, random_)
        if not elements or any(base.get(one.key) is not edited.get(one.key) for one in elements):
            continue
        attempt = edited.replaced(elements)
        if not any(violation.blocks for violation in check(base, attempt)):
            edited, made = attempt, made + 1
    return edited


def _repaint(state: MapState, random_: random.Random) -> list[Element] | None:
    lane = random_.choice(list(state.lanes.values()))
    mark = random_.choice((Mark.SOLID_WHITE, Mark.DASHED_WHITE, Mark.SOLID_YELLOW, Mark.NONE))
    if lane.right_mark is mark:
        return None
    beside = state.lanes.get(lane.right_neighbor_id or -1)
    repainted: list[Element] = [dataclasses.replace(lane, right_mark=mark)]
    return repainted + ([dataclasses.replace(beside, left_mark=mark)] if beside else [])


def _widen(state: MapState, random_: random.Random) -> list[Element] | None:
    """A bulge on a kerb side, joints left as they are."""
    lane = random_.choice(list(state.lanes.values()))
    if lane.right_neighbor_id is not None or lane.is_intersection:
        return None
    return [dataclasses.replace(lane, right_boundary=_bulged(lane, random_.uniform(0.3, 1.0)))]


def _bulged(lane: LaneSegment, by_m: float) -> Line:
    line = lane.right_boundary
    middle = len(line) // 2
    points = list(line) if len(line) > 2 else [line[0], _between(line[0], line[1]), line[1]]
    centre = lane.left_boundary[len(lane.left_boundary) // 2]
    x, y, z = points[middle]
    away = max(((x - centre[0]) ** 2 + (y - centre[1]) ** 2) ** 0.5, 1e-6)
    points[middle] = (x + by_m * (x - centre[0]) / away, y + by_m * (y - centre[1]) / away, z)
    return tuple(points)


def _between(one: tuple[float, float, float], other: tuple[float, float, float]) -> tuple[float, float, float]:
    return ((one[0] + other[0]) / 2, (one[1] + other[1]) / 2, (one[2] + other[2]) / 2)


def _reserve(state: MapState, random_: random.Random) -> list[Element] | None:
    lane = random_.choice(list(state.lanes.values()))
    return [dataclasses.replace(lane, lane_type=LaneType.BUS)] if lane.lane_type is LaneType.VEHICLE else None


def _move_crossing(state: MapState, random_: random.Random) -> list[Element] | None:
    if not state.crossings:
        return None
    crossing = random_.choice(list(state.crossings.values()))
    return [_shifted(crossing, crossing.id, random_.uniform(0.2, 0.6))]


def _add_crossing(state: MapState, random_: random.Random) -> list[Element] | None:
    if not state.crossings:
        return None
    free = max([*state.crossings, *state.lanes]) + 1
    return [_shifted(random_.choice(list(state.crossings.values())), free, random_.uniform(20.0, 30.0))]


def _shifted(crossing: PedestrianCrossing, key: int, by_m: float) -> PedestrianCrossing:
    moved = [tuple((x + by_m, y, z) for x, y, z in edge) for edge in (crossing.edge1, crossing.edge2)]
    return PedestrianCrossing(key, *moved)


_DRAWS: tuple[Draw, ...] = (_repaint, _widen, _reserve, _move_crossing, _add_crossing)
