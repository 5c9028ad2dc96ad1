"""Round trip: a diff applied with its values gives the edited map, its inverse the base (``update_machine``: any)."""

from __future__ import annotations

import pytest
from tests.core.worlds import scenario, scenario_names

from lanewright.core.diff import diff, invert
from lanewright.core.replay import replayed


@pytest.mark.parametrize("name", scenario_names())
def test_scenarios_come_back(name):
    case = scenario(name)
    found = diff(case.base, case.edited)
    assert diff(replayed(case.base, found), case.edited).changes == ()
    assert diff(replayed(case.edited, invert(found)), case.base).changes == ()
