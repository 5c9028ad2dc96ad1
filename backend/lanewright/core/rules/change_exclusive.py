"""``change.exclusive``: a foreign annotation gives an inserted or deleted element another category too (spec §5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.changes import Category
from lanewright.core.comparison import Comparison
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


def remedies(comparison: Comparison, _violation: Violation) -> Iterator[Remedy]:
    """The map is right; the annotated categories give way to the derived ones."""
    yield Remedy("Take the categories that the two maps show", comparison.edited)


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="An annotation made elsewhere calls an element inserted (or deleted) and changed at the same time.",
    why="Insertion and deletion have no correspondence, so nothing else can be said of the element (A2).",
    mend="Keep the categories that follow from the two maps. The fix drops the annotated ones.",
)
