"""Round trip: a diff applied with its values gives the edited map, and its inverse the base."""

from __future__ import annotations

from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.core.grid import maps
from tests.core.rewriting import EDITS, REWRITES, several
from tests.core.worlds import scenario, scenario_names

from lanewright.core.diff import diff, invert
from lanewright.core.replay import replayed


@pytest.mark.parametrize("name", scenario_names())
def test_scenarios_come_back(name):
    case = scenario(name)
    found = diff(case.base, case.edited)
    assert diff(replayed(case.base, found), case.edited).changes == ()
    assert diff(replayed(case.edited, invert(found)), case.base).changes == ()


@settings(max_examples=60)
@given(maps(), st.integers(0, 10**6))
def test_any_edit_comes_back(base, seed):
    random = Random(seed)
    edited = several(random, several(random, base, EDITS, 3), REWRITES, 1)
    assert diff(replayed(base, diff(base, edited)), edited).changes == ()
