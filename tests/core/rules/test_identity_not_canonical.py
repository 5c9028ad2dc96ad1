"""Legal ids that tell a longer story than needed: the save settles them."""

from __future__ import annotations

from worlds import scenario, straight, world

from lanewright.core.canonical import canonicalise
from lanewright.core.diff import diff
from lanewright.core.rules import check
from lanewright.core.violations import Severity

CODE = "identity.not_canonical"


def test_clean_the_shortest_story_is_no_finding():
    case = scenario("split_by_branch")
    assert not [one for one in check(case.base, case.edited) if one.code == CODE]


def test_broken_a_lane_comes_anew_although_its_ids_could_move_up():
    #  free lanes, 4 m apart:  1 at y=0, 2 at y=4   =>   2 at y=0 (moved), 9 at y=4: legal, since 2 moved by less
    #  than 3 m between the polygons, but 1 and 2 stayed where they are.
    base = world(straight(1, 0, 60, 0, 3.5), straight(2, 0, 60, 4, 7.5))
    edited = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 4, 7.5))
    found = check(base, edited)
    assert diff(base, canonicalise(base, edited)).changes == ()
    assert not [one for one in found if one.severity is Severity.ERROR and one.code == CODE]


def test_edge_it_never_blocks():
    assert Severity.NONE is not Severity.ERROR
