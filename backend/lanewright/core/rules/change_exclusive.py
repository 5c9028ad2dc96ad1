"""``change.exclusive``: a foreign annotation gives an inserted or deleted element another category too (spec §5)."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator

from lanewright.core.changes import Category
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff_of
from lanewright.core.elements import ElementKey
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation

CODE = "change.exclusive"
_WHOLE = {Category.INSERTION, Category.DELETION}


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations in the annotated changes; a derived diff cannot have any."""
    for change in sorted(comparison.claims.annotated, key=lambda one: one.key):
        if len(change.categories) > 1 and _WHOLE.intersection(change.categories):
            whole = min(_WHOLE.intersection(change.categories))
            others = ", ".join(sorted(category.value for category in change.categories if category is not whole))
            yield Violation(
                CODE,
                Severity.ERROR,
                change.kind,
                (change.id,),
                f"{change.kind.value.replace('_', ' ').capitalize()} {change.id} is annotated as {whole.value} and as "
                f"{others}: an inserted or deleted element has no counterpart to differ from.",
            )


def remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """The map is right; what is annotated of the element gives way to what is derived."""
    (element,) = violation.elements
    key = ElementKey(violation.kind, element)
    kept = tuple(change for change in comparison.claims.annotated if change.key != key)
    derived = tuple(change for change in diff_of(comparison).changes if change.key == key)
    claims = dataclasses.replace(comparison.claims, annotated=kept + derived)
    yield Remedy("Take the derived categories", comparison.edited, claims)


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="An annotation made elsewhere calls an element inserted (or deleted) and changed at the same time.",
    why="Insertion and deletion have no correspondence, so nothing else can be said of the element (A2).",
    mend="Keep the categories that follow from the two maps. The fix drops the annotated ones.",
)
