"""Procedural maps for properties: a few streets of parallel lanes in series, some joined by turns."""

from __future__ import annotations

from hypothesis import strategies as st

from lanewright.core.elements import Element, LaneSegment, LaneType, MapState, Mark, PedestrianCrossing
from lanewright.core.identity import with_neighbors_found

WIDTH = 3.5
LENGTH = 25.0
MARKS = [Mark.NONE, Mark.SOLID_WHITE, Mark.DASHED_WHITE, Mark.SOLID_YELLOW]


@st.composite
def maps(draw: st.DrawFn) -> MapState:
    """One to three streets, one to three lanes wide, one to four segments long; links on both sides or on one."""
    lanes: dict[int, LaneSegment] = {}
    one_sided = draw(st.booleans())
    key = draw(st.integers(1, 5))
    for street in range(draw(st.integers(1, 3))):
        wide, long = draw(st.integers(1, 3)), draw(st.integers(1, 4))
        middle = draw(st.integers(0, long - 1)) if draw(st.booleans()) else None
        marks = [draw(st.sampled_from(MARKS)) for _ in range(wide + 1)]
        rows = [[key + row * long + column for column in range(long)] for row in range(wide)]
        for row, ids in enumerate(rows):
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
        key += wide * long + draw(st.integers(1, 3))
    found = with_neighbors_found(lanes, list(lanes))
    crossings = [
        PedestrianCrossing(key + 100 + index, _across(10.0 + 30 * index), _across(13.0 + 30 * index))
        for index in range(draw(st.integers(0, 2)))
    ]
    elements: list[Element] = [*found.values(), *crossings]
    return MapState.of(elements)


def _line(column: int, y: float) -> tuple[tuple[float, float, float], ...]:
    x = column * LENGTH
    return ((x, y, 0.0), (x + LENGTH / 2, y, 0.0), (x + LENGTH, y, 0.0))


def _across(x: float) -> tuple[tuple[float, float, float], ...]:
    return ((x, -2.0, 0.0), (x, 9.0, 0.0))
