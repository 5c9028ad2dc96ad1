"""``identity.reused``: an id that this map once deleted stands for something else (spec §2, §5)."""

from __future__ import annotations

from collections.abc import Iterator

import shapely

from lanewright.core.comparison import Comparison, same_crossing
from lanewright.core.elements import ElementKey, ElementKind
from lanewright.core.geometry import polygon
from lanewright.core.identity import fresh_id, renamed
from lanewright.core.places import FAR_M
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation

CODE = "identity.reused"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for inserted elements under an id that was deleted before, unless the same thing came back."""
    for key, retired in sorted(comparison.claims.retired.items(), key=lambda item: item[0]):
        now = comparison.edited.get(key)
        if now is None or comparison.base.get(key) is not None:
            continue
        was, is_now = polygon(retired), comparison.shape(key, edited=True)
        same = (
            same_crossing(was, is_now)
            if key.kind is ElementKind.PEDESTRIAN_CROSSING
            else shapely.distance(was, is_now) <= FAR_M
        )
        if not same:
            noun = "Lane" if key.kind is ElementKind.LANE_SEGMENT else "Crossing"
            yield Violation(
                CODE,
                Severity.ERROR,
                key.kind,
                (key.id,),
                f"{noun} {key.id} has the id of an element that was deleted earlier: a new element needs a new id.",
            )


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
