"""``macro.mismatch``: declared macros that differ from the derived ones (spec §4)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.changes import Macros, StructuralUpdate
from lanewright.core.claims import DeclaredMacros
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff_of
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import listed

CODE = "macro.mismatch"
_NAMES = ("shape", "appearance", "function", "lane_graph")
_NONE = Macros(shape=False, appearance=False, function=False, lane_graph=False, lane_number=0)


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each declaration that the update it is about does not bear out."""
    if not comparison.claims.declared:
        return
    updates = diff_of(comparison).updates
    for declared in comparison.claims.declared:
        derived = _update_of(declared, updates)
        words = _difference(declared.macros, derived.macros if derived else _NONE)
        if words:
            elements = (derived or declared).elements
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
    """The map is right; the declaration gives way to the derived macros."""
    yield Remedy("Declare the derived macros", comparison.edited)


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="Macros declared for a structural update differ from those that follow from its atomic changes.",
    why="The coarse and the fine level must tell one story (C, D).",
    mend="Declare the derived macros, or edit the map until it shows what was meant.",
)
