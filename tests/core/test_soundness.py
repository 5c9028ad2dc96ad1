"""What real maps must and must not set off (the real logs are their own oracle)."""

from __future__ import annotations

import pytest

from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff
from lanewright.core.identity import fresh_id, renamed, unlinked
from lanewright.core.rules import check, findings

IDENTITY = ("identity.", "replacement.", "insertion.", "deletion.", "element.")
EVERY = 4
"""Every fourth lane; all of them pass, in four times the time."""

pytestmark = pytest.mark.shared


def codes(base, edited):
    return [(one.code, one.elements) for one in findings(Comparison(base, edited)) if not one.inherited]


def test_a_real_map_against_itself_gives_nothing(real_maps):
    for real in real_maps:
        assert check(real, real) == ()
        assert diff(real, real).changes == ()


def test_deleting_or_inserting_any_lane_is_no_violation_of_identity(real_maps):
    for real in real_maps:
        for lane in list(real.lanes)[::EVERY]:
            without = unlinked(real, [lane])
            assert codes(real, without) == []
            assert not [code for code, _ in codes(without, real) if code.startswith(IDENTITY)]


def test_any_lane_under_a_new_id_is_exactly_an_unjustified_replacement(real_maps):
    for real in real_maps:
        new = fresh_id([real])
        for lane in list(real.lanes)[1::EVERY]:
            assert codes(real, renamed(real, {lane: new})) == [("replacement.unjustified", (lane, new))]


def test_the_same_for_crossings(real_maps):
    for real in real_maps:
        new = fresh_id([real])
        for crossing in real.crossings:
            without = unlinked(real, [], [crossing])
            assert codes(real, without) == []
            assert codes(without, real) == []
            assert codes(real, renamed(real, {}, {crossing: new})) == [("replacement.unjustified", (crossing, new))]
