"""Procedural maps from a plain random generator: a few streets of parallel lanes in series."""

from __future__ import annotations

from random import Random

from lanewright.core.elements import Element, LaneSegment, LaneType, MapState, Mark, PedestrianCrossing
from lanewright.core.identity import with_neighbors_found

WIDTH = 3.5
LENGTH = 25.0
MARKS = [Mark.NONE, Mark.SOLID_WHITE, Mark.DASHED_WHITE, Mark.SOLID_YELLOW]


def random_map(random: Random) -> MapState:
    """One to three streets, one to three lanes wide, one to four segments long; links on both sides or on one."""
    lanes: dict[int, LaneSegment] = {}
    one_sided = random.random() < 0.5
    key = random.randint(1, 5)
    for street in range(random.randint(1, 3)):
        wide, long = random.randint(1, 3), random.randint(1, 4)
        middle = random.randrange(long) if random.random() < 0.5 else None
        marks = [random.choice(MARKS) for _ in range(wide + 1)]
        for row in range(wide):
            ids = [key + row * long + column for column in range(long)]
            bottom = street * 60.0 + row * WIDTH
            for column, here in enumerate(ids):
                lanes[here] = LaneSegment(
                    here,
                    column == middle,
                    LaneType.VEHICLE,
                    _line(column, bottom + WIDTH),
                    marks[row + 1],
                    _line(column, bottom),
                    marks[row],
                    (ids[column + 1],) if column + 1 < long else (),
                    (ids[column - 1],) if column and not one_sided else (),
                )
        key += wide * long + random.randint(1, 3)
    found = with_neighbors_found(lanes, list(lanes))
    crossings = [
        PedestrianCrossing(key + 100 + index, _across(10.0 + 30 * index), _across(13.0 + 30 * index))
        for index in range(random.randint(0, 2))
    ]
    elements: list[Element] = [*found.values(), *crossings]
    return MapState.of(elements)


def _line(column: int, y: float) -> tuple[tuple[float, float, float], ...]:
    x = column * LENGTH
    return ((x, y, 0.0), (x + LENGTH / 2, y, 0.0), (x + LENGTH, y, 0.0))


def _across(x: float) -> tuple[tuple[float, float, float], ...]:
    return ((x, -2.0, 0.0), (x, 9.0, 0.0))
