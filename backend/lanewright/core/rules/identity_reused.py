"""``identity.reused``: an id that this map once deleted stands for something else (spec §2, §5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison, same_crossing
from lanewright.core.elements import Element, ElementKey, ElementKind
from lanewright.core.geometry import apart_m, polygon, readable_element
from lanewright.core.identity import fresh_id, renamed
from lanewright.core.places import FAR_M
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation

CODE = "identity.reused"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for inserted elements under an id that was deleted before, unless the same thing came back."""
    told: set[ElementKey] = set()
    for retired, was in sorted(comparison.claims.retired.items(), key=lambda item: item[0]):
        for kind in ElementKind:
            key = ElementKey(kind, retired.id)
            now = comparison.edited.get(key)
            if now is None or key in comparison.base or key in told or not readable_element(now):
                continue
            if key not in comparison.claims.retired or (key == retired and not _same(comparison, was, key)):
                told.add(key)
                noun = "Lane" if kind is ElementKind.LANE_SEGMENT else "Crossing"
                yield Violation(
                    CODE,
                    Severity.ERROR,
                    kind,
                    (key.id,),
                    f"{noun} {key.id} has the id of an element that was deleted earlier: a new element needs a new id.",
                )


def _same(comparison: Comparison, was: Element, key: ElementKey) -> bool:
    """Whether the element stands where the retired one stood."""
    before, now = polygon(was), comparison.shape(key, edited=True)
    if key.kind is ElementKind.PEDESTRIAN_CROSSING:
        return same_crossing(before, now)
    return apart_m(before, now) <= FAR_M


def remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """Give it an id that neither map nor history knows."""
    key = ElementKey(violation.kind, violation.elements[0])
    new = fresh_id((comparison.base, comparison.edited), comparison.claims.retired)
    if violation.kind is ElementKind.LANE_SEGMENT:
        yield Remedy(f"Call it lane {new}", renamed(comparison.edited, {key.id: new}))
    else:
        yield Remedy(f"Call it crossing {new}", renamed(comparison.edited, {}, {key.id: new}))


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="An element has an id that another element of this map had before it was deleted.",
    why="Ids are for life: a label that refers to the old element would now mean the new one (A1, D).",
    mend="Give the element a new id. The fix does.",
    gives_way_to=("replacement.",),
)
