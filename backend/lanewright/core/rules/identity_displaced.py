"""``identity.displaced``: an element keeps its id at another place (spec §5)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import shapely

from lanewright.core.comparison import Comparison, crossing_key, lane_key, same_crossing
from lanewright.core.elements import ElementKind
from lanewright.core.lateral import lateral_group
from lanewright.core.roadgraph import FINISH, START
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation

CODE = "identity.displaced"
FAR_M = 3.0
"""A lane that no junction holds and that moved further than this is another lane."""


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for lanes that moved far, lanes that exchanged their order, and crossings that moved away."""
    for lane in displaced_lanes(comparison):
        yield _violation(
            ElementKind.LANE_SEGMENT,
            (lane,),
            f"Lane {lane} keeps its id more than {FAR_M:.0f} m from where it was, and no junction holds it: it is not "
            "the same lane. Delete it and insert a new one.",
        )
    for one, other in exchanged_lanes(comparison):
        yield _violation(
            ElementKind.LANE_SEGMENT,
            (one, other),
            f"Lanes {one} and {other} exchanged their order from left to right: each must keep its own place.",
        )
    for crossing in displaced_crossings(comparison):
        yield _violation(
            ElementKind.PEDESTRIAN_CROSSING,
            (crossing,),
            f"Crossing {crossing} keeps its id where it hardly overlaps its old place: it is not the same crossing. "
            "Delete it and insert a new one.",
        )


def _violation(kind: ElementKind, elements: tuple[int, ...], message: str) -> Violation:
    return Violation(CODE, Severity.ERROR, kind, elements, message)


def displaced_lanes(comparison: Comparison) -> Iterator[int]:
    """Survivors more than 3 m away that no junction holds and that do not merely keep their function."""
    for lane in comparison.differing_lanes:
        if any(comparison.moved_sides(lane)) and not held(comparison, lane):
            was, now = (comparison.shape(lane_key(lane), edited=edited) for edited in (False, True))
            if shapely.distance(was, now) > FAR_M and not comparison.keeps_function(lane):
                yield lane


def held(comparison: Comparison, lane: int) -> bool:
    """Whether an end shares its vertex with the same survivor's endpoint in base and edited map."""
    return any(
        not comparison.held_by((lane, end), edited=False).isdisjoint(comparison.held_by((lane, end), edited=True))
        for end in (START, FINISH)
    )


def exchanged_lanes(comparison: Comparison) -> list[tuple[int, int]]:
    """Pairs of survivors whose order from left to right in a lateral group is reversed."""
    found: set[tuple[int, int]] = set()
    seen: set[int] = set()
    for lane in comparison.differing_lanes:
        if lane in seen:
            continue
        group = lateral_group(comparison.edited.lanes, lane)
        seen.update(group)
        survivors = [member for member in group if member in comparison.surviving_lanes]
        rank = {member: index for index, member in enumerate(survivors)}
        for member in survivors:
            before = [one for one in lateral_group(comparison.base.lanes, member) if one in rank]
            found.update(
                (min(one, other), max(one, other)) for one, other in combinations(before, 2) if rank[one] > rank[other]
            )
    return sorted(found)


def displaced_crossings(comparison: Comparison) -> Iterator[int]:
    """Surviving crossings that overlap their old place by less than 0.3 of the union."""
    for crossing in comparison.differing_crossings:
        key = crossing_key(crossing)
        if comparison.crossing_moved(crossing) and not same_crossing(
            comparison.shape(key, edited=False), comparison.shape(key, edited=True)
        ):
            yield crossing


RULE = Rule(
    code=CODE,
    find=find,
    remedies=identity_remedies,
    what="A lane that no junction holds keeps its id more than 3 m away; two lanes side by side exchange their ids; or "
    "a crossing keeps its id where it hardly overlaps its old place.",
    why="An id at another place would hide a deletion and an insertion in a change of shape (A1), and what is new for "
    "traffic would count as the old road (B).",
    mend="Delete the element and insert it at the new place under a new id; or exchange the ids back.",
    example="lanes_exchanged",
)
