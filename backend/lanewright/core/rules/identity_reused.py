"""``identity.reused``: an id that this map once deleted stands for something else (spec §2, §5)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from lanewright.core.comparison import SAME_CROSSING_OVERLAP, Comparison
from lanewright.core.elements import Element, ElementKey, ElementKind, LaneSegment
from lanewright.core.geometry import overlap, polygon, readable_element
from lanewright.core.identity import fresh_id, renamed
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
    """Whether the element stands where the retired one stood; a lane must lead the same way, too."""
    if overlap(polygon(was), comparison.shape(key, edited=True)) < SAME_CROSSING_OVERLAP:
        return False
    now = comparison.edited.get(key)
    return not (isinstance(was, LaneSegment) and isinstance(now, LaneSegment)) or _same_way(was, now)


def _same_way(was: LaneSegment, now: LaneSegment) -> bool:
    """Whether the lane's start is not the other's end: lanes of both directions may lie on each other."""
    start, finish = was.left_boundary[0], was.left_boundary[-1]
    first, last = now.left_boundary[0], now.left_boundary[-1]
    straight = math.dist(start[:2], first[:2]) + math.dist(finish[:2], last[:2])
    return straight <= math.dist(start[:2], last[:2]) + math.dist(finish[:2], first[:2])


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
