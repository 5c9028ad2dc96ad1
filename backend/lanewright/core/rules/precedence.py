"""Which violation is told when several tell the same defect (spec §5, *gives way to*)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from lanewright.core.elements import ElementKey
from lanewright.core.rules import element_duplicate, replacement_function_preserved
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Violation


def standing_violations(found: Iterable[Violation], rules: Mapping[str, Rule]) -> list[Violation]:
    """The violations that do not give way to another."""
    violations = list(found)
    by_element: dict[ElementKey, dict[str, list[Violation]]] = {}
    for violation in violations:
        for element in violation.elements:
            told = by_element.setdefault(ElementKey(violation.kind, element), {})
            told.setdefault(violation.code, []).append(violation)
    return [
        violation
        for violation in violations
        if not any(
            _silences(other, violation)
            for element in violation.elements
            for code, others in by_element[ElementKey(violation.kind, element)].items()
            if _comes_first(code, rules[violation.code].gives_way_to)
            for other in others
        )
    ]


def _comes_first(code: str, codes: tuple[str, ...]) -> bool:
    return any(code == other or (other.endswith(".") and code.startswith(other)) for other in codes)


def _silences(other: Violation, violation: Violation) -> bool:
    """Whether a violation that comes first tells the same defect: all of the other's elements, a preserved function
    also where it holds the replaced parts, a duplicate wherever they share one."""
    mine, theirs = set(violation.elements), set(other.elements)
    if violation.code == element_duplicate.CODE:
        return True
    if violation.code == replacement_function_preserved.CODE:
        return theirs <= mine
    return mine <= theirs
