"""Linked lanes whose ends do not meet."""

from __future__ import annotations

import dataclasses

from tests.core.findings import introduced, mended, only
from tests.core.worlds import line, scenario, street

from lanewright.core.rules import check

CODE = "link.gap"


def test_clean_a_gap_below_a_centimetre():
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[1], left_boundary=line("20.009,3.5 60,3.5"))])
    assert introduced(base, edited) == []


def test_broken_an_end_dragged_off_is_moved_back():
    #  100 ──╴ ╶── 1 ── 200
    base = street()
    edited = base.replaced([dataclasses.replace(base.lanes[1], left_boundary=line("21,3.5 60,3.5"))])
    violation = only(base, edited, CODE)
    assert violation.elements == (1, 100)
    assert "1.00 m apart" in violation.message
    assert mended(base, edited, CODE) == base


def test_edge_a_gap_of_the_base_is_inherited_until_its_line_is_edited():
    case = scenario("joint_link_removed")
    inherited = [one for one in check(case.base, case.edited) if one.code == CODE]
    assert [one.inherited for one in inherited] == [True]
    assert not inherited[0].blocks
