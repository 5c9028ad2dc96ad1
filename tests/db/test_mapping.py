"""Elements to rows and back: doubles bit for bit, equal elements equal hashes."""

from __future__ import annotations

import dataclasses
import math
import struct

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from lanewright.core.elements import Element, LaneSegment, LaneType, Line, Mark, PedestrianCrossing
from lanewright.db.mapping import element_sha256, from_rows, map_sha256, to_rows

coordinates = st.floats(-1e6, 1e6, allow_nan=False)
points = st.tuples(coordinates, coordinates, coordinates)
lines = st.lists(points, min_size=2, max_size=12).map(tuple)
edges = st.lists(points, min_size=2, max_size=2).map(tuple)
ids = st.integers(0, 2**53 - 1)
links = st.lists(ids, max_size=4).map(tuple)
lanes = st.builds(
    LaneSegment,
    id=ids,
    is_intersection=st.booleans(),
    lane_type=st.sampled_from(LaneType),
    left_boundary=lines,
    left_mark=st.sampled_from(Mark),
    right_boundary=lines,
    right_mark=st.sampled_from(Mark),
    successors=links,
    predecessors=links,
    right_neighbor_id=st.none() | ids,
    left_neighbor_id=st.none() | ids,
    part_of=st.none() | ids,
)
crossings = st.builds(PedestrianCrossing, id=ids, edge1=edges, edge2=edges)
elements = st.one_of(lanes, crossings)


def bits(line: Line) -> bytes:
    return b"".join(struct.pack("<3d", *point) for point in line)


def lines_of(element: Element) -> tuple[Line, Line]:
    if isinstance(element, LaneSegment):
        return element.left_boundary, element.right_boundary
    return element.edge1, element.edge2


@given(st.lists(elements, max_size=6))
def test_what_is_stored_comes_back_bit_for_bit(given_elements: list[Element]) -> None:
    rows = to_rows(given_elements, lambda xy: xy)
    back = from_rows([(row.kind, row.element_id, row.attributes, row.geom) for row in rows])
    assert back == given_elements
    for one, other in zip(given_elements, back, strict=True):
        assert [bits(line) for line in lines_of(one)] == [bits(line) for line in lines_of(other)]
        assert element_sha256(one) == element_sha256(other)


@given(elements, elements)
def test_hashes_are_equal_exactly_where_elements_are(one: Element, other: Element) -> None:
    assert (one == other) == (element_sha256(one) == element_sha256(other))


def test_minus_zero_is_zero() -> None:
    def crossing(x: float) -> PedestrianCrossing:
        return PedestrianCrossing(1, ((x, 5.0, x), (-0.05, x, -0.0)), ((0.0, x, 1.0), (1.0, 2.0, x)))

    assert crossing(0.0) == crossing(-0.0)
    assert element_sha256(crossing(0.0)) == element_sha256(crossing(-0.0))
    assert element_sha256(crossing(0.0)) != element_sha256(crossing(0.05))


@given(lanes, st.data())
def test_every_attribute_counts_in_the_hash(lane: LaneSegment, data: st.DataObject) -> None:
    name = data.draw(st.sampled_from([field.name for field in dataclasses.fields(LaneSegment)]))
    other = dataclasses.replace(lane, **{name: getattr(data.draw(lanes), name)})
    assert (lane == other) == (element_sha256(lane) == element_sha256(other))


@given(st.lists(elements, max_size=5, unique_by=lambda element: element.key))
def test_the_hash_of_a_map_does_not_depend_on_order(given_elements: list[Element]) -> None:
    hashes = [(element.key, element_sha256(element)) for element in given_elements]
    assert map_sha256(hashes) == map_sha256(reversed(hashes))
    if hashes:
        assert map_sha256(hashes) != map_sha256(hashes[1:])


def test_the_display_geometry_is_projected_and_the_stored_one_is_not() -> None:
    lane = PedestrianCrossing(1, ((1.0, 2.0, 3.0), (4.0, 5.0, 6.0)), ((7.0, 8.0, 9.0), (1.5, 2.5, 3.5)))
    (row,) = to_rows([lane], lambda xy: xy + 1000.0)
    shifted = np.frombuffer(row.merc[-16:], dtype="<f8")
    assert shifted.tolist() == [1001.5, 1002.5]
    assert math.isclose(np.frombuffer(row.geom[-24:], dtype="<f8")[2], 3.5)
