"""A survivor's link comes or goes, and with it its place."""

from __future__ import annotations

import dataclasses

from tests.core.findings import introduced, mended, only
from tests.core.worlds import scenario, straight, street, world

from lanewright.core.diff import diff

CODE = "identity.rerouted"


def test_clean_the_junction_stays_one():
    case = scenario("joint_link_removed")
    assert introduced(case.base, case.edited) == []


def test_broken_the_only_link_goes():
    #  100 ── 1 ── 200   =>   100 ── 1   200
    case = scenario("link_cut")
    assert only(case.base, case.edited, CODE).elements == (1, 200)
    after = mended(case.base, case.edited, CODE)
    assert {one.id: one.categories for one in diff(case.base, after).changes} == {
        200: ("deletion",),
        201: ("insertion",),
    }


def test_broken_a_new_link_joins_two_lanes():
    #  1 ──   2 ──   =>   1 ── 2 ──
    base = world(straight(1, 0, 20), straight(2, 20, 40))
    edited = world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40, predecessors=(1,)))
    assert only(base, edited, CODE).elements == (1, 2)
    assert set(mended(base, edited, CODE).lanes) == {1, 3}


def test_edge_a_link_written_on_one_side_only_is_the_same_link():
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[1], predecessors=())])
    one_sided = base.replaced([dataclasses.replace(base.lanes[200], predecessors=())])
    assert diff(base, edited).changes == ()
    assert introduced(one_sided, base) == []


def test_edge_a_lane_linked_to_itself():
    #  a roundabout of one lane opens up: both its own ends part
    ring = straight(1, 0, 20, successors=(1,), predecessors=(1,))
    base, edited = world(ring), world(dataclasses.replace(ring, successors=(), predecessors=()))
    assert (CODE, (1,)) in introduced(base, edited)


def test_broken_beside_a_link_that_goes_for_nothing():
    #  a junction that stays one loses a link (connectivity); far away the only link of two lanes goes
    case = scenario("joint_link_removed")
    far = [straight(801, 5000, 5020, successors=(802,)), straight(802, 5020, 5040, predecessors=(801,))]
    cut = [dataclasses.replace(far[0], successors=()), dataclasses.replace(far[1], predecessors=())]
    base, edited = world(*case.base, *far), world(*case.edited, *cut)
    assert introduced(base, edited) == [(CODE, (801, 802))]
