"""``macro.mismatch``: declared macros that differ from the derived ones (spec §4)."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator

from lanewright.core.changes import Macros, StructuralUpdate
from lanewright.core.claims import DeclaredMacros
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff_of
from lanewright.core.elements import ElementKey
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import listed

CODE = "macro.mismatch"
_NAMES = ("shape", "appearance", "function", "lane_graph")
_NONE = Macros(shape=False, appearance=False, function=False, lane_graph=False, lane_number=0)


def find(comparison: Comparison) -> Iterator[Violation]:
    """A violation for each update (or what is none any more) that its declarations do not describe."""
    if not comparison.claims.declared:
        return
    updates = diff_of(comparison).updates
    told: set[tuple[ElementKey, ...]] = set()
    for declared in comparison.claims.declared:
        derived = _update_of(declared, updates)
        words = _difference(declared.macros, derived.macros if derived else _NONE)
        elements = (derived or declared).elements
        if words and elements not in told:
            told.add(elements)
            kind = min(elements).kind
            yield Violation(
                CODE,
                Severity.ERROR,
                kind,
                tuple(key.id for key in elements if key.kind is kind),
                f"The declared macros do not match the update: {words}.",
            )


def _update_of(declared: DeclaredMacros, updates: tuple[StructuralUpdate, ...]) -> StructuralUpdate | None:
    """The update that shares the most elements with the declaration."""
    mine = set(declared.elements)
    best = max(updates, key=lambda update: len(mine.intersection(update.elements)), default=None)
    return best if best is not None and mine.intersection(best.elements) else None


def _difference(declared: Macros, derived: Macros) -> str:
    missing = [name.replace("_", " ") for name in _NAMES if getattr(derived, name) and not getattr(declared, name)]
    extra = [name.replace("_", " ") for name in _NAMES if getattr(declared, name) and not getattr(derived, name)]
    words = []
    if missing:
        words.append(f"{listed(missing)} {'is' if len(missing) == 1 else 'are'} missing")
    if extra:
        words.append(f"{listed(extra)} {'is' if len(extra) == 1 else 'are'} extra")
    if declared.lane_number != derived.lane_number:
        words.append(f"lane number is {derived.lane_number:+d}, not {declared.lane_number:+d}")
    return "; ".join(words)


def remedies(comparison: Comparison, _violation: Violation) -> Iterator[Remedy]:
    """The map is right; declarations give way to the derived macros, and go where there is no update any more."""
    updates = diff_of(comparison).updates
    derived: dict[DeclaredMacros, None] = {}
    for declared in comparison.claims.declared:
        update = _update_of(declared, updates)
        if update is None:
            continue
        fits = declared.macros == update.macros
        derived[declared if fits else DeclaredMacros(update.elements, update.macros)] = None
    claims = dataclasses.replace(comparison.claims, declared=tuple(derived))
    yield Remedy("Declare the derived macros", comparison.edited, claims)


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="Macros declared for a structural update differ from those that follow from its atomic changes.",
    why="The coarse and the fine level must tell one story (C, D).",
    mend="Declare the derived macros, or edit the map until it shows what was meant.",
)
