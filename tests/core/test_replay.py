"""Round trip: a diff applied with its values gives the edited map, its inverse the base (``update_machine``: any)."""

from __future__ import annotations

import pytest
from tests.core.worlds import scenario, scenario_names, straight, world

from lanewright.core.diff import diff, invert
from lanewright.core.replay import replayed


@pytest.mark.parametrize("name", scenario_names())
def test_scenarios_come_back(name):
    case = scenario(name)
    found = diff(case.base, case.edited)
    assert diff(replayed(case.base, found), case.edited).changes == ()
    assert diff(replayed(case.edited, invert(found)), case.base).changes == ()


def test_a_link_that_stays_but_is_written_by_the_other_lane_comes_back():
    #  1 ── 2 is written by 1 in the base and by 2 in the edited map, in which 2 leads to 3 no more, but to 4
    base = world(
        straight(1, 0, 20, successors=(2,)),
        straight(2, 20, 40, successors=(3,)),
        straight(3, 40, 60),
        straight(4, 40, 60),
    )
    edited = world(
        straight(1, 0, 20), straight(2, 20, 40, predecessors=(1,), successors=(4,)), straight(3, 40, 60), base.lanes[4]
    )
    found = diff(base, edited)
    assert diff(replayed(base, found), edited).changes == ()
    assert diff(replayed(edited, invert(found)), base).changes == ()
    assert invert(found) == diff(edited, base)
