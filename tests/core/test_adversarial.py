"""Broken and hostile maps: no crash, no hang, whatever the values are."""

from __future__ import annotations

import dataclasses
import math

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.core.worlds import straight, world

from lanewright.core.canonical import canonicalise
from lanewright.core.diff import diff, invert
from lanewright.core.elements import ElementKind, LaneSegment, LaneType, MapState, Mark, PedestrianCrossing
from lanewright.core.elevation import fill_elevation
from lanewright.core.report import check_document, diff_document
from lanewright.core.restore import restore
from lanewright.core.rules import check
from lanewright.core.sentences import sentence

ids = st.integers(0, 6)
coordinates = st.one_of(
    st.sampled_from([0.0, 0.001, 3.5, 7.0, 20.0, 60.0]),
    st.floats(-50, 50),
    st.sampled_from([math.nan, math.inf, -math.inf, 1e6, -1e6, 1e300]),
)
points = st.tuples(coordinates, coordinates, st.one_of(st.just(0.0), st.just(math.nan)))
lines = st.lists(points, max_size=4).map(tuple)
links = st.lists(ids, max_size=3).map(tuple)
neighbors = st.one_of(st.none(), ids)
lanes = st.builds(
    LaneSegment,
    id=ids,
    is_intersection=st.booleans(),
    lane_type=st.sampled_from(list(LaneType)),
    left_boundary=lines,
    left_mark=st.sampled_from(list(Mark)),
    right_boundary=lines,
    right_mark=st.sampled_from(list(Mark)),
    successors=links,
    predecessors=links,
    right_neighbor_id=neighbors,
    left_neighbor_id=neighbors,
    part_of=neighbors,
)
edges = st.lists(points, min_size=2, max_size=2).map(tuple)
crossings = st.builds(PedestrianCrossing, id=ids, edge1=edges, edge2=edges)
states = st.lists(st.one_of(lanes, lanes, crossings), max_size=6).map(MapState.of)


@settings(max_examples=150, suppress_health_check=[HealthCheck.too_slow])
@given(states, states)
def test_the_engine_answers_whatever_it_is_asked(base, edited):
    found = diff(base, edited)
    diff_document(invert(found))
    check_document(check(base, edited))
    canonicalise(base, edited)
    restore(base, edited)
    for change in found.changes:
        assert sentence(change, base, edited).headline


@settings(max_examples=100)
@given(states)
def test_no_height_is_left_open(state):
    filled = fill_elevation(state, lambda x, y: math.nan)
    for element in filled:
        sides = ("left_boundary", "right_boundary")
        names = sides if element.key.kind is ElementKind.LANE_SEGMENT else ("edge1", "edge2")
        assert not any(math.isnan(z) for name in names for _, _, z in getattr(element, name))


def test_a_cut_whose_parts_have_no_length_is_not_made_alike():
    base = world(straight(7, 0, 100))
    point = ((500.0, 500.0, 0.0),) * 2
    parts = [
        dataclasses.replace(straight(101, 0, 50, successors=(102,)), left_boundary=point, part_of=7),
        dataclasses.replace(
            straight(102, 50, 100, predecessors=(101,)), left_boundary=point, left_mark=Mark.NONE, part_of=7
        ),
    ]
    edited = restore(base, world(*parts))
    assert "geometry.invalid" in [one.code for one in check(base, edited)]
    canonicalise(base, edited)


def test_lanes_of_no_length_in_series_can_be_compared():
    point = ((500.0, 500.0, 0.0),) * 2
    broken = [
        dataclasses.replace(straight(1, 0, 50, successors=(2,)), left_boundary=point),
        dataclasses.replace(straight(2, 50, 100, predecessors=(1,)), left_boundary=point),
    ]
    sound = [straight(11, 0, 50, successors=(12,)), straight(12, 50, 100, predecessors=(11,))]
    for base, edited in ((broken, sound), (sound, broken)):
        check_document(check(world(*base), world(*edited)))
        canonicalise(world(*base), world(*edited))
