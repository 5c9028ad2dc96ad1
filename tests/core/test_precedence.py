"""Of several violations that tell one defect, one is told (spec §5, gives way to)."""

from __future__ import annotations

import pytest

from lanewright.core.elements import ElementKind
from lanewright.core.rules import RULES
from lanewright.core.rules.precedence import standing_violations
from lanewright.core.violations import Severity, Violation


def standing(*told):
    violations = [Violation(code, Severity.ERROR, ElementKind.LANE_SEGMENT, elements, "") for code, elements in told]
    rules = {rule.code: rule for rule in RULES}
    return [(one.code, one.elements) for one in standing_violations(violations, rules)]


@pytest.mark.parametrize(
    ("weaker", "stronger"),
    [
        (("link.gap", (1, 2)), ("identity.rerouted", (1, 2))),
        (("link.dangling", (1,)), ("replacement.unjustified", (1, 9))),
        (("neighbor.inconsistent", (1, 2)), ("insertion.not_rightmost", (1, 2))),
        (("geometry.invalid", (9,)), ("replacement.unjustified", (1, 9))),
        (("replacement.function_preserved", (1, 2, 9)), ("replacement.unjustified", (1, 9))),
        (("element.duplicate", (8, 9)), ("replacement.unjustified", (1, 9))),
    ],
)
def test_the_weaker_is_silent(weaker, stronger):
    assert standing(weaker, stronger) == standing(stronger, weaker) == [stronger]


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (("link.gap", (1, 2)), ("identity.displaced", (1,))),
        (("link.gap", (1, 2)), ("identity.rerouted", (2, 3))),
        (("link.gap", (1, 2)), ("link.dangling", (1, 2))),
        (("element.duplicate", (1, 2)), ("identity.displaced", (1, 2))),
        (("replacement.function_preserved", (1, 9)), ("replacement.unjustified", (1, 2, 9))),
        (("identity.displaced", (1,)), ("replacement.unjustified", (1,))),
    ],
)
def test_what_tells_something_else_stands(one, other):
    assert standing(one, other) == [one, other]


def test_a_lane_and_a_crossing_of_one_id_are_two():
    gap = Violation("geometry.invalid", Severity.ERROR, ElementKind.PEDESTRIAN_CROSSING, (1,), "")
    displaced = Violation("identity.displaced", Severity.ERROR, ElementKind.LANE_SEGMENT, (1,), "")
    assert standing_violations([gap, displaced], {rule.code: rule for rule in RULES}) == [gap, displaced]
