"""The rules of the change mapping, listed one by one, and the check that asks them all (spec §5)."""

from __future__ import annotations

import dataclasses

from lanewright.core.claims import NO_CLAIMS, Claims
from lanewright.core.comparison import Comparison
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
from lanewright.core.rules.precedence import standing_violations
from lanewright.core.rules.rule import Rule
from lanewright.core.rules.trial import FixTrial
from lanewright.core.violations import Violation

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
    fixes = FixTrial(comparison, found, _RULE, findings)
    return tuple(dataclasses.replace(violation, fixes=fixes.of(violation)) for violation in found)


def findings(comparison: Comparison) -> tuple[Violation, ...]:
    """The violations without their fixes, by id."""
    found = [
        violation for rule in RULES if rule is not identity_not_canonical.RULE for violation in rule.find(comparison)
    ]
    standing = standing_violations(found, _RULE)
    # The canonical form is worked out only for updates in which nothing else is wrong: it gives way to all others.
    told = {ElementKey(one.kind, element) for one in standing if not one.inherited for element in one.elements}
    standing += identity_not_canonical.find(comparison, told)
    return tuple(sorted(standing, key=lambda violation: violation.id))
