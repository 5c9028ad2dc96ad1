"""The rules of the change mapping, listed one by one, and the check that asks them all (spec §5)."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable

from lanewright.core.claims import NO_CLAIMS, Claims
from lanewright.core.comparison import Comparison
from lanewright.core.edits import edits_between
from lanewright.core.elements import ElementKey, MapState
from lanewright.core.rules import (
    change_exclusive,
    deletion_not_rightmost,
    element_duplicate,
    geometry_invalid,
    identity_displaced,
    identity_not_canonical,
    identity_rerouted,
    identity_reused,
    insertion_not_rightmost,
    link_dangling,
    link_gap,
    link_one_sided,
    macro_mismatch,
    neighbor_inconsistent,
    replacement_function_preserved,
    replacement_unjustified,
)
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Fix, Violation

RULES: tuple[Rule, ...] = (
    replacement_unjustified.RULE,
    replacement_function_preserved.RULE,
    identity_rerouted.RULE,
    identity_displaced.RULE,
    identity_not_canonical.RULE,
    insertion_not_rightmost.RULE,
    deletion_not_rightmost.RULE,
    element_duplicate.RULE,
    change_exclusive.RULE,
    identity_reused.RULE,
    macro_mismatch.RULE,
    geometry_invalid.RULE,
    link_dangling.RULE,
    link_one_sided.RULE,
    link_gap.RULE,
    neighbor_inconsistent.RULE,
)
_RULE = {rule.code: rule for rule in RULES}


def check(base: MapState, edited: MapState, claims: Claims = NO_CLAIMS) -> tuple[Violation, ...]:
    """All violations of the edited map against its base, by id; inherited ones are marked and never block.

    ``claims``: what others say of the update (retired ids, declared macros, foreign categories), checked along.
    """
    return check_of(Comparison(base, edited, claims))


def check_of(comparison: Comparison) -> tuple[Violation, ...]:
    """``check`` of maps that are compared already."""
    found = findings(comparison)
    return tuple(dataclasses.replace(violation, fixes=_fixes(comparison, violation, found)) for violation in found)


def findings(comparison: Comparison) -> tuple[Violation, ...]:
    """The violations without their fixes, by id."""
    found = [
        violation for rule in RULES if rule is not identity_not_canonical.RULE for violation in rule.find(comparison)
    ]
    standing = _standing(found)
    # The canonical form is worked out only for updates in which nothing else is wrong: it gives way to all others.
    told = {ElementKey(one.kind, element) for one in standing if not one.inherited for element in one.elements}
    standing += identity_not_canonical.find_beside(comparison, told)
    return tuple(sorted(standing, key=lambda violation: violation.id))


def _fixes(comparison: Comparison, violation: Violation, found: tuple[Violation, ...]) -> tuple[Fix, ...]:
    """The first remedy that removes the violation and adds none; failing that, the first that removes it."""
    known = {other.id for other in found if not other.inherited}
    second: tuple[Fix, ...] = ()
    for remedy in _RULE[violation.code].remedies(comparison, violation):
        left = findings(Comparison(comparison.base, remedy.edited, comparison.claims))
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
    """Whether another violation tells the same defect: on the same elements, a part of them, or for duplicates any."""
    if other.kind is not violation.kind or not any(
        other.code == code or (code.endswith(".") and other.code.startswith(code)) for code in codes
    ):
        return False
    mine, theirs = set(violation.elements), set(other.elements)
    if violation.code == element_duplicate.CODE:
        return not mine.isdisjoint(theirs)
    if violation.code == replacement_function_preserved.CODE:
        return theirs <= mine
    return mine <= theirs
