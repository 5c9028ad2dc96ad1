"""``element.duplicate``: two elements for one thing on the road (spec §5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison, crossing_key, lane_key
from lanewright.core.elements import ElementKey, ElementKind
from lanewright.core.geometry import overlap, polygon
from lanewright.core.identity import unlinked
from lanewright.core.lateral import same_direction
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation

CODE = "element.duplicate"
SAME_OVERLAP = 0.9


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for pairs of the edited map, at least one of them changed, that cover the same ground."""
    for one, other in sorted(_duplicate_lanes(comparison) | _duplicate_crossings(comparison)):
        noun = "Lanes" if one.kind is ElementKind.LANE_SEGMENT else "Crossings"
        yield Violation(
            CODE,
            Severity.ERROR,
            one.kind,
            (one.id, other.id),
            f"{noun} {one.id} and {other.id} lie on each other: keep one of them.",
            inherited=_inherited(comparison, one, other),
        )


def _duplicate_lanes(comparison: Comparison) -> set[tuple[ElementKey, ElementKey]]:
    lanes = comparison.edited.lanes
    changed = comparison.inserted_lanes.union(
        lane for lane in comparison.differing_lanes if comparison.changed_in_place(lane)
    )
    return {
        (lane_key(min(lane, other)), lane_key(max(lane, other)))
        for lane in changed
        for other in _alike(comparison, lane)
        if lanes[lane].lane_type is lanes[other].lane_type
        and same_direction(lanes[lane], lanes[other])
        and _overlap(comparison, lane_key(lane), lane_key(other)) >= SAME_OVERLAP
    }


def _alike(comparison: Comparison, lane: int) -> Iterator[int]:
    """Other lanes of the edited map about as large and at the same place: touched ones, and the base's untouched."""
    extent = comparison.touched_linework.extent(lane)
    if extent is None:
        return
    for other in comparison.touched_linework.like(*extent):
        if other != lane:
            yield other
    for other in comparison.survey.linework.like(*extent):
        if other in comparison.edited.lanes and other not in comparison.touched_lanes:
            yield other


def _duplicate_crossings(comparison: Comparison) -> set[tuple[ElementKey, ElementKey]]:
    touched = comparison.inserted_crossings.union(
        crossing for crossing in comparison.differing_crossings if comparison.crossing_moved(crossing)
    )
    return {
        (crossing_key(min(one, other)), crossing_key(max(one, other)))
        for one in touched
        for other in comparison.edited.crossings
        if one != other and _overlap(comparison, crossing_key(one), crossing_key(other)) >= SAME_OVERLAP
    }


def _overlap(comparison: Comparison, one: ElementKey, other: ElementKey) -> float:
    return overlap(comparison.shape(one, edited=True), comparison.shape(other, edited=True))


def _inherited(comparison: Comparison, one: ElementKey, other: ElementKey) -> bool:
    """Whether the base has the same pair on each other, both of them in the shapes they have now."""
    before = [comparison.base.get(key) for key in (one, other)]
    if before[0] is None or before[1] is None or overlap(polygon(before[0]), polygon(before[1])) < SAME_OVERLAP:
        return False
    if one.kind is ElementKind.PEDESTRIAN_CROSSING:
        return not any(key.id in comparison.differing_crossings for key in (one, other))
    return not any(
        any(comparison.moved_sides(key.id))
        or comparison.base.lanes[key.id].lane_type is not comparison.edited.lanes[key.id].lane_type
        for key in (one, other)
    )


def remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """Delete the inserted one, else the changed one, else the one with the larger id."""
    if violation.kind is ElementKind.PEDESTRIAN_CROSSING:
        inserted, differing = comparison.inserted_crossings, comparison.differing_crossings
    else:
        inserted, differing = comparison.inserted_lanes, comparison.differing_lanes
    ranked = sorted(violation.elements, key=lambda key: (key not in inserted, key not in differing, -key))
    for key in ranked:
        if violation.kind is ElementKind.PEDESTRIAN_CROSSING:
            yield Remedy(f"Delete crossing {key}", unlinked(comparison.edited, (), [key]))
        else:
            yield Remedy(f"Delete lane {key}", unlinked(comparison.edited, [key]))


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="Two lanes of one type and direction, or two crossings, cover the same ground (overlap 90 % or more), and at "
    "least one of them changed.",
    why="One thing on the road has one element; a second one would be counted as an insertion that nobody drives (A2).",
    mend="Delete one of the two. The fix deletes the one that was inserted last.",
    gives_way_to=("replacement.",),
)
