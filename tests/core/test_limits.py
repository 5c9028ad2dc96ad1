"""What the engine must not trip over: lanes on one place, ids near the limit, one-sided rings, lines close to the limit
of what counts as moved."""

from __future__ import annotations

import dataclasses
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.core.grid import maps
from tests.core.rewriting import EDITS, several
from tests.core.worlds import crossing, straight, street, world

from lanewright.core.attributes import LARGEST_ID
from lanewright.core.canonical import canonicalise
from lanewright.core.edits import apply_edits, edits_between
from lanewright.core.elements import MapState, Mark
from lanewright.core.geometry import MOVED_M, hausdorff_m, moved
from lanewright.core.restore import restore
from lanewright.core.rules import check
from lanewright.demo import demo_maps

steps = st.lists(st.tuples(st.floats(0.01, 30), st.floats(-3, 3)), min_size=1, max_size=12)
nudges = st.sampled_from([0.0, 0.001, 0.0499, 0.05, 0.0501, 0.06, 1.0])


def line_of(walk, shift=0.0):
    x = y = 0.0
    points = [(x, y + shift, 0.0)]
    for ahead, aside in walk:
        x, y = x + ahead, y + aside
        points.append((x, y + shift, 0.0))
    return tuple(points)


@settings(max_examples=300)
@given(steps, nudges, st.integers(0, 12), nudges, st.booleans())
def test_whether_a_line_moved_is_what_its_distance_says(walk, shift, at, by, thinned):
    was, now = line_of(walk), list(line_of(walk, shift))
    at %= len(now)
    now[at] = (now[at][0], now[at][1] + by, 0.0)
    if thinned and len(now) > 2:
        del now[1]
    assert moved(was, tuple(now)) is (hausdorff_m(was, tuple(now)) > MOVED_M)


def test_an_untouched_map_with_lanes_on_one_place_stays_as_it_is():
    twins = world(straight(9, 0, 20), straight(4, 0, 20), crossing(8, 30), crossing(3, 30), straight(30, 40, 60))
    assert canonicalise(twins, twins) == twins
    elsewhere = twins.replaced([dataclasses.replace(twins.lanes[30], left_mark=Mark.SOLID_WHITE)])
    assert canonicalise(twins, elsewhere) == elsewhere


def test_lanes_on_one_place_are_told_apart_by_their_links():
    onward = [straight(30, 20, 40), straight(31, 20, 40, 3.5, 7)]
    base = world(straight(9, 0, 20, successors=(30,)), straight(4, 0, 20, successors=(31,)), *onward)
    renamed = world(straight(77, 0, 20, successors=(31,)), straight(78, 0, 20, successors=(30,)), *onward)
    canonical = canonicalise(base, renamed)
    assert (canonical.lanes[9].successors, canonical.lanes[4].successors) == ((30,), (31,))


def test_new_ids_stay_within_what_a_file_may_hold():
    base = world(*street(), straight(LARGEST_ID, 0, 20, 50, 53.5))
    moved_far = base.replaced([straight(LARGEST_ID, 100, 120, 150, 153.5)])
    (violation,) = check(base, moved_far)
    (inserted,) = (edit.id for edit in violation.fixes[0].edits if edit.operation.value == "insert")
    assert violation.code == "identity.displaced"
    assert 0 < inserted <= LARGEST_ID
    assert inserted not in base.lanes


@pytest.mark.parametrize("side", ["successors", "predecessors"])
def test_an_unedited_ring_written_on_one_side_is_left_alone(side):
    ring = straight(5, 0, 20, 50, 53.5, **{side: (5,)})
    base = world(*street(), ring)
    renamed = world(ring, *(dataclasses.replace(one, id=one.id + 500) for one in street()))
    assert canonicalise(base, renamed).lanes[5] == ring
    assert restore(base, renamed).lanes[5] == ring
    fixes = [fix for one in check(base, renamed) if not one.inherited for fix in one.fixes]
    assert fixes
    assert all(apply_edits(renamed, fix.edits).lanes[5] == ring for fix in fixes)


def test_a_boundary_drawn_the_other_way_round_goes_back_whole():
    lane = street().lanes[1]
    turned = dataclasses.replace(lane, right_boundary=lane.right_boundary[::-1])
    assert restore(street(), street().replaced([turned])) == street()


@pytest.mark.parametrize("seed", [1, 7])
def test_the_demo_updates_are_legal_and_canonical(seed):
    for base, changed in demo_maps(seed):
        assert [one.id for one in check(base, changed) if not one.inherited] == []
        assert canonicalise(base, changed) == changed


@settings(max_examples=60)
@given(maps(), st.integers(0, 10**6))
def test_a_check_after_a_chain_of_edits_equals_the_full_check(base, seed):
    """What is edited again and again, and taken back in part, is judged as if nothing were known of it."""
    random = Random(seed)
    check(base, base)
    state = base
    for _ in range(4):
        goal = several(random, state, EDITS, 2)
        state = restore(base, apply_edits(state, edits_between(state, goal)))
        state = state.replaced([element for element in base if random.random() < 0.1 and element.key in state])
    assert check(base, state) == check(*(MapState.of(list(one)) for one in (base, state)))
