"""Maps that nobody would draw, as AV2 documents: every one can be read, hardly one makes sense.

Few ids and few places, so that lanes meet, lie on each other, link to themselves and name what is not there.
"""

from __future__ import annotations

import copy
from typing import Any

from hypothesis import strategies as st

from lanewright.core.attributes import LARGEST_COORDINATE_M, LARGEST_ID

Document = dict[str, Any]

IDS = st.integers(0, 7)
RIM = st.sampled_from([8, 9, LARGEST_ID - 20])
COORDINATES = st.one_of(
    st.sampled_from([0.0, 3.5, 7.0, 20.0, 20.02, 20.06, 40.0, 60.0, -3.5, -0.0, 1e-9, 5e-324]),
    st.sampled_from([LARGEST_COORDINATE_M, -LARGEST_COORDINATE_M, LARGEST_COORDINATE_M - 3.5]),
    st.floats(-100, 100, width=16),
    st.integers(-50, 50),
)
MARKS = st.sampled_from(["NONE", "UNKNOWN", "SOLID_WHITE", "DASH_SOLID_YELLOW", "SOLID_DASH_YELLOW", "SOLID_BLUE"])
STREET_YS = st.sampled_from([0.0, 3.5, 3.52, 7.0, 10.5, 12.0])


@st.composite
def points(draw: st.DrawFn) -> Document:
    z = draw(st.sampled_from([0.0, 1.0, -LARGEST_COORDINATE_M]))
    return {"x": draw(COORDINATES), "y": draw(COORDINATES), "z": z}


@st.composite
def lines(draw: st.DrawFn, exactly: int | None = None) -> list[Document]:
    """A line; sometimes one point over and over, sometimes one that comes back."""
    line = draw(st.lists(points(), min_size=exactly or 2, max_size=exactly or 5))
    shape = draw(st.sampled_from(["as drawn", "one point", "there and back"]))
    if shape == "one point":
        return [line[0]] * len(line)
    if shape == "there and back" and exactly is None:
        return [*line, *reversed(line)]
    return line


@st.composite
def street_sides(draw: st.DrawFn) -> tuple[list[Document], list[Document]]:
    """Two sides of a straight lane on a grid, either way round: so that much meets exactly."""
    start, finish = draw(st.sampled_from([(0.0, 20.0), (20.0, 40.0), (40.0, 60.0), (0.0, 60.0), (20.0, 0.0)]))
    left, right = ([{"x": x, "y": draw(STREET_YS), "z": 0.0} for x in (start, finish)] for _ in range(2))
    return left, right


@st.composite
def lane_documents(draw: st.DrawFn, key: int) -> Document:
    left, right = draw(st.one_of(street_sides(), st.tuples(lines(), lines())))
    links = st.lists(st.one_of(IDS, RIM), max_size=4)
    neighbor = st.one_of(st.none(), IDS, RIM)
    return {
        "id": key,
        "is_intersection": draw(st.booleans()),
        "lane_type": draw(st.sampled_from(["VEHICLE", "VEHICLE", "BIKE", "BUS"])),
        "left_lane_boundary": left,
        "left_lane_mark_type": draw(MARKS),
        "right_lane_boundary": right,
        "right_lane_mark_type": draw(MARKS),
        "successors": draw(links),
        "predecessors": draw(links),
        "right_neighbor_id": draw(neighbor),
        "left_neighbor_id": draw(neighbor),
    }


@st.composite
def crossing_documents(draw: st.DrawFn, key: int) -> Document:
    return {"edge1": draw(lines(exactly=2)), "edge2": draw(lines(exactly=2)), "id": key}


@st.composite
def map_documents(draw: st.DrawFn) -> Document:
    lanes = draw(st.lists(IDS, max_size=7, unique=True))
    crossings = draw(st.lists(IDS, max_size=3, unique=True))
    return {
        "pedestrian_crossings": {str(key): draw(crossing_documents(key)) for key in crossings},
        "lane_segments": {str(key): draw(lane_documents(key)) for key in lanes},
        "drivable_areas": {},
    }


@st.composite
def pairs_of_documents(draw: st.DrawFn) -> tuple[Document, Document]:
    """A map and what somebody made of it: some elements gone, some redrawn, some under another id, some new."""
    base = draw(map_documents())
    edited = copy.deepcopy(base)
    for group, drawn in (("lane_segments", lane_documents), ("pedestrian_crossings", crossing_documents)):
        elements = edited[group]
        for key in list(elements):
            what = draw(st.sampled_from(["keep", "keep", "delete", "redraw", "rename", "touch", "reshape"]))
            if what == "delete":
                del elements[key]
            elif what == "redraw":
                elements[key] = draw(drawn(int(key)))
            elif what == "rename":
                other = draw(IDS)
                elements[str(other)] = elements.pop(key) | {"id": other}
            elif what == "touch":
                name = "left_lane_boundary" if group == "lane_segments" else "edge1"
                elements[key][name][-1]["x"] += draw(st.sampled_from([0.02, -0.06, 0.11, 4.0]))
            elif what == "reshape" and group == "lane_segments":
                changed = draw(lane_documents(int(key)))
                name = draw(st.sampled_from(sorted(changed)))
                elements[key][name] = changed[name]
        for key in draw(st.lists(IDS, max_size=2)):
            elements[str(key)] = draw(drawn(key))
    for elements in (edited["lane_segments"], edited["pedestrian_crossings"]):
        for element in elements.values():
            _keep_within_the_cap(element)
    return base, edited


def _keep_within_the_cap(element: Document) -> None:
    for value in element.values():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            for point in value:
                point["x"] = max(-LARGEST_COORDINATE_M, min(LARGEST_COORDINATE_M, point["x"]))
