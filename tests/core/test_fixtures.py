"""The 39 scenarios of the contract, exact."""

from __future__ import annotations

import pytest
from tests.core.worlds import scenario, scenario_names

from lanewright.core.diff import diff, invert
from lanewright.core.edits import apply_edits
from lanewright.core.report import diff_document
from lanewright.core.rules import check

SCENARIOS = scenario_names()


def test_all_scenarios_are_there():
    assert len(SCENARIOS) == 39


@pytest.mark.parametrize("name", SCENARIOS)
def test_changes_leaves_and_updates(name):
    case = scenario(name)
    document = diff_document(diff(case.base, case.edited))
    assert {str(one["id"]): one["categories"] for one in document["changes"]} == case.expected["changes"]
    assert {str(one["id"]): one["leaves"] for one in document["changes"] if one["leaves"]} == case.expected["leaves"]
    assert document["updates"] == case.expected["updates"]


@pytest.mark.parametrize("name", SCENARIOS)
def test_the_inverse_is_exact(name):
    case = scenario(name)
    assert invert(diff(case.base, case.edited)) == diff(case.edited, case.base)


@pytest.mark.parametrize("name", SCENARIOS)
def test_violations(name):
    case = scenario(name)
    found = [(one.code, sorted(one.elements)) for one in check(case.base, case.edited) if not one.inherited]
    expected = [(one["code"], sorted(one["elements"])) for one in case.expected["violations"]]
    assert sorted(found) == sorted(expected)


@pytest.mark.parametrize("name", SCENARIOS)
def test_every_fix_applies_as_it_stands_and_leaves_no_violation(name):
    case = scenario(name)
    for violation in check(case.base, case.edited):
        for fix in violation.fixes:
            after = check(case.base, apply_edits(case.edited, fix.edits))
            assert violation.id not in {one.id for one in after}
