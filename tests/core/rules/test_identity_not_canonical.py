"""Legal ids that tell a longer story than needed: the save settles them."""

from __future__ import annotations

from tests.core.findings import introduced
from tests.core.worlds import crossing, scenario, straight, world

from lanewright.core.canonical import canonical_map, canonicalise
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff
from lanewright.core.edits import apply_edits
from lanewright.core.elements import ElementKind
from lanewright.core.rules import check
from lanewright.core.violations import Severity

CODE = "identity.not_canonical"
BASE = world(straight(1, 0, 60, 0, 3.5), straight(2, 0, 60, 5, 8.5))


def test_clean_the_shortest_story_is_no_finding():
    case = scenario("split_by_branch")
    assert introduced(case.base, case.edited) == []


def test_broken_ids_move_up_although_every_lane_stayed():
    #  ── 2 ──         ── 9 ──
    #  ── 1 ──   =>    ── 2 ──      2 moved by less than 3 m, 1 went, 9 came: legal, but nothing happened
    edited = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 5, 8.5))
    (violation,) = check(BASE, edited)
    assert (violation.code, violation.severity, violation.blocks) == (CODE, Severity.NONE, False)
    assert apply_edits(edited, violation.fixes[0].edits) == BASE == canonicalise(BASE, edited)


def test_broken_fewer_categories_win_where_insertions_are_equal():
    #  ── 2 ──         ── 9 ──  (10 m up)
    #  ── 1 ──   =>    ── 2 ──
    edited = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 10, 13.5))
    assert [one.code for one in check(BASE, edited)] == [CODE]
    canonical = canonicalise(BASE, edited)
    assert {one.id: one.categories for one in diff(BASE, canonical).changes} == {2: ("deletion",), 9: ("insertion",)}


def test_edge_where_an_error_is_told_the_note_is_not():
    #  as above, and 9 was drawn twice
    twice = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 5, 8.5), straight(10, 0, 60, 5, 8.5))
    assert [code for code, _ in introduced(BASE, twice)] == ["element.duplicate"]


FAR_AWAY = [straight(11, 1000, 1060, 0, 3.5), straight(12, 1000, 1060, 5, 8.5)]


def test_broken_the_note_names_what_came_went_and_moved():
    (violation,) = check(BASE, world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 5, 8.5)))
    assert violation.elements == (1, 2, 9)


def test_broken_each_update_is_judged_by_itself():
    #  near: as above. Far away 12 gives way to 19 and 11 moves up by 1 m: that is the shortest story
    base = world(*BASE, *FAR_AWAY)
    far = [straight(11, 1000, 1060, 1, 4.5), straight(19, 1000, 1060, 12, 15.5)]
    edited = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 5, 8.5), *far)
    (violation,) = check(base, edited)
    assert (violation.code, violation.elements) == (CODE, (1, 2, 9))
    assert apply_edits(edited, violation.fixes[0].edits) == world(*BASE, *far)


def test_broken_crossings_move_up_too():
    #  5 went, 6 took its place, 7 came near the place of 6
    base = world(crossing(5, 30), crossing(6, 31.5))
    edited = world(crossing(6, 30), crossing(7, 33))
    (violation,) = check(base, edited)
    assert (violation.code, violation.kind, violation.elements) == (CODE, ElementKind.PEDESTRIAN_CROSSING, (5, 6, 7))
    assert violation.message.startswith("The ids of crossings 5, 6 and 7 are legal")
    assert apply_edits(edited, violation.fixes[0].edits) == world(crossing(5, 30), crossing(6, 33))


def test_edge_a_crossing_beside_the_lanes_is_named_in_words_only():
    base = world(*BASE, crossing(5, 30))
    edited = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 5, 8.5), crossing(5, 31))
    (violation,) = check(base, edited)
    assert (violation.kind, violation.elements) == (ElementKind.LANE_SEGMENT, (1, 2, 9))
    assert violation.message.startswith("The ids of lanes 1, 2 and 9 and crossing 5 are legal")


def test_clean_a_story_shorter_than_the_one_that_the_save_knows_stands():
    #  ── 2 ──                  (2 moved by 5 m, 1 by 1 m; no other lane is near the old place of 2)
    #  ── 1 ──
    edited = world(straight(1, 0, 60, 1, 4.5), straight(2, 0, 60, 10, 13.5))
    assert len(diff(BASE, edited).changes) < len(diff(BASE, canonicalise(BASE, edited)).changes)
    assert introduced(BASE, edited) == []
    assert canonical_map(Comparison(BASE, edited)).edited == edited


def test_clean_new_lanes_in_series_that_differ_stay_two():
    new = straight(8, 0, 30, 20, 23.5, successors=(9,))
    turn = straight(9, 30, 60, 20, 23.5, predecessors=(8,), is_intersection=True)
    assert introduced(BASE, world(*BASE, new, turn)) == []
