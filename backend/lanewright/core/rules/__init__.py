"""The rules of the change mapping, listed one by one, and the check that asks them all (spec §5)."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable

from lanewright.core.comparison import Comparison
from lanewright.core.edits import edits_between
from lanewright.core.elements import MapState
from lanewright.core.rules import geometry_invalid, link_gap, replacement_unjustified
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Fix, Violation

RULES: tuple[Rule, ...] = (
    replacement_unjustified.RULE,
    geometry_invalid.RULE,
    link_gap.RULE,
)
_RULE = {rule.code: rule for rule in RULES}


def check(base: MapState, edited: MapState) -> tuple[Violation, ...]:
    """All violations of the edited map against its base, by id; inherited ones are marked and never block."""
    return check_of(Comparison(base, edited))


def check_of(comparison: Comparison) -> tuple[Violation, ...]:
    """``check`` of maps that are compared already."""
    found = findings(comparison)
    return tuple(dataclasses.replace(violation, fixes=_fixes(comparison, violation, found)) for violation in found)


def findings(comparison: Comparison) -> tuple[Violation, ...]:
    """The violations without their fixes, by id."""
    found = [violation for rule in RULES for violation in rule.find(comparison)]
    return tuple(sorted(_standing(found), key=lambda violation: violation.id))


def _fixes(comparison: Comparison, violation: Violation, found: tuple[Violation, ...]) -> tuple[Fix, ...]:
    """The first remedy that removes the violation and adds none; failing that, the first that removes it."""
    known = {other.id for other in found if not other.inherited}
    second: tuple[Fix, ...] = ()
    for remedy in _RULE[violation.code].remedies(comparison, violation):
        left = findings(Comparison(comparison.base, remedy.edited))
        if any(other.id == violation.id for other in left):
            continue
        fix = Fix(remedy.title, edits_between(comparison.edited, remedy.edited))
        if all(other.inherited or other.id in known for other in left):
            return (fix,)
        second = second or (fix,)
    return second


def _standing(found: Iterable[Violation]) -> list[Violation]:
    """The violations that do not give way to another (spec §5): one defect is told once."""
    violations = list(found)
    return [
        violation
        for violation in violations
        if not any(_silences(other, violation, _RULE[violation.code].gives_way_to) for other in violations)
    ]


def _silences(other: Violation, violation: Violation, codes: tuple[str, ...]) -> bool:
    return (
        other.kind is violation.kind
        and any(other.code == code or (code.endswith(".") and other.code.startswith(code)) for code in codes)
        and set(violation.elements) <= set(other.elements)
    )
