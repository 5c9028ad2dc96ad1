"""Legal ids that tell a longer story than needed: the save settles them."""

from __future__ import annotations

from tests.core.findings import introduced
from tests.core.worlds import scenario, straight, world

from lanewright.core.canonical import canonicalise
from lanewright.core.diff import diff
from lanewright.core.edits import apply_edits
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
