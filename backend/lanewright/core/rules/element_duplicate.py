"""``element.duplicate``: two elements for one thing on the road (spec §5)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice

from lanewright.core.comparison import Comparison, crossing_key, lane_key
from lanewright.core.crossing_areas import CrossingAreas
from lanewright.core.elements import ElementKey, ElementKind, MapState
from lanewright.core.geometry import overlap, overlaps, polygon
from lanewright.core.identity import unlinked
from lanewright.core.lateral import same_direction
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Severity, Violation

CODE = "element.duplicate"
SAME_OVERLAP = 0.9
_MOST_TOLD = 20
"""Of the duplicates of one element; where there are more, the others show when these are gone."""
_AT_ONCE = 50

Pair = tuple[ElementKey, ElementKey]


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


def _duplicate_lanes(comparison: Comparison) -> set[Pair]:
    lanes = comparison.edited.lanes
    changed = comparison.inserted_lanes.union(
        lane for lane in comparison.differing_lanes if comparison.changed_in_place(lane)
    )
    return {
        pair
        for lane in changed
        for pair in _lying_on(
            comparison,
            lane_key(lane),
            (
                lane_key(other)
                for other in _alike(comparison, lane)
                if lanes[lane].lane_type is lanes[other].lane_type and same_direction(lanes[lane], lanes[other])
            ),
        )
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


def _duplicate_crossings(comparison: Comparison) -> set[Pair]:
    changed = comparison.inserted_crossings.union(
        crossing for crossing in comparison.differing_crossings if comparison.crossing_moved(crossing)
    )
    if not changed:
        return set()
    touched = {key: comparison.shape(crossing_key(key), edited=True) for key in comparison.touched_crossings}
    areas = CrossingAreas(touched)
    untouched = comparison.survey.fact(_crossing_areas)
    found: set[Pair] = set()
    for one in changed:
        others = [other for other in areas.near(touched[one]) if other != one]
        others += [
            other
            for other in untouched.near(touched[one])
            if other in comparison.edited.crossings and other not in touched
        ]
        found.update(_lying_on(comparison, crossing_key(one), map(crossing_key, others)))
    return found


def _crossing_areas(state: MapState) -> CrossingAreas:
    return CrossingAreas({key: polygon(crossing) for key, crossing in state.crossings.items()})


def _lying_on(comparison: Comparison, one: ElementKey, others: Iterable[ElementKey]) -> Iterator[Pair]:
    """The element with each of the others that covers the same ground, up to the most that are told."""
    found = 0
    candidates = iter(others)
    while found < _MOST_TOLD and (some := list(islice(candidates, _AT_ONCE))):
        shares = overlaps(comparison.shape(one, edited=True), [comparison.shape(key, edited=True) for key in some])
        for other, share in zip(some, shares, strict=True):
            if share >= SAME_OVERLAP and found < _MOST_TOLD:
                found += 1
                yield min(one, other), max(one, other)


def _inherited(comparison: Comparison, one: ElementKey, other: ElementKey) -> bool:
    """Whether the base has the same pair on each other, both of them in the shapes they have now."""
    if one not in comparison.base or other not in comparison.base:
        return False
    if overlap(comparison.shape(one, edited=False), comparison.shape(other, edited=False)) < SAME_OVERLAP:
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
