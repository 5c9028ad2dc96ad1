"""``replacement.unjustified``: a deletion and an insertion at the same place in the road graph (spec §5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison, crossing_key, same_crossing
from lanewright.core.elements import ElementKind
from lanewright.core.roadgraph import FINISH, START, Chain
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import capitalised, lanes_named, was_or_were

CODE = "replacement.unjustified"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for lanes, then for crossings."""
    for deleted, inserted in unjustified_parts(comparison):
        elements = tuple(sorted({*deleted, *inserted}))
        yield Violation(
            CODE,
            Severity.ERROR,
            ElementKind.LANE_SEGMENT,
            elements,
            f"{capitalised(lanes_named(deleted))} {was_or_were(deleted)} deleted and {lanes_named(inserted)} drawn "
            "between the same junctions: "
            f"the road graph did not change here, so edit {lanes_named(deleted)} in place.",
        )
    for was, now in unjustified_crossings(comparison):
        yield Violation(
            CODE,
            Severity.ERROR,
            ElementKind.PEDESTRIAN_CROSSING,
            tuple(sorted((was, now))),
            f"Crossing {was} was deleted and crossing {now} drawn in its place: edit crossing {was} in place.",
        )


def unjustified_parts(comparison: Comparison) -> list[tuple[Chain, Chain]]:
    """Contiguous parts of a deleted and an inserted chain whose starts and ends coincide; only the largest."""
    found: list[tuple[Chain, Chain]] = []
    if not comparison.deleted_lanes or not comparison.inserted_lanes:
        return found
    for deleted in comparison.base_graph.chains(comparison.deleted_lanes):
        for inserted in comparison.edited_graph.chains(comparison.inserted_lanes):
            found += coinciding_parts(comparison, deleted, inserted)
    return found


def coinciding_parts(comparison: Comparison, deleted: Chain, inserted: Chain) -> list[tuple[Chain, Chain]]:
    """The largest coinciding parts of two chains, none within another."""
    starts = _pairs(comparison, deleted, inserted, START)
    finishes = _pairs(comparison, deleted, inserted, FINISH) if starts else []
    parts = [((i, k), (j, m)) for i, j in starts for k, m in finishes if i <= k and j <= m]
    largest = [one for one in parts if not any(other != one and _within(one, other) for other in parts)]
    return [(deleted[i : k + 1], inserted[j : m + 1]) for (i, k), (j, m) in largest]


def _pairs(comparison: Comparison, deleted: Chain, inserted: Chain, end: int) -> list[tuple[int, int]]:
    return [
        (i, j)
        for i, was in enumerate(deleted)
        for j, now in enumerate(inserted)
        if comparison.coincide((was, end), (now, end))
    ]


def _within(one: tuple[tuple[int, int], tuple[int, int]], other: tuple[tuple[int, int], tuple[int, int]]) -> bool:
    return all(large[0] <= small[0] and small[1] <= large[1] for small, large in zip(one, other, strict=True))


def unjustified_crossings(comparison: Comparison) -> list[tuple[int, int]]:
    """Deleted and inserted crossings that overlap so far that they are one."""
    return [
        (was, now)
        for was in sorted(comparison.deleted_crossings)
        for now in sorted(comparison.inserted_crossings)
        if same_crossing(
            comparison.shape(crossing_key(was), edited=False), comparison.shape(crossing_key(now), edited=True)
        )
    ]


RULE = Rule(
    code=CODE,
    find=find,
    remedies=identity_remedies,
    what="A lane is deleted and another drawn whose start and end lie at the same places in the road graph; "
    "or a crossing is deleted and one drawn that covers mostly the same ground.",
    why="An element keeps its id if its place persists. Deleting and drawing anew would tell one map update in two "
    "ways (A1: each change has one interpretable outcome) and hide which property changed (A2).",
    mend="Edit the existing element instead. The fix gives the new geometry, marks and type to the old id.",
    example="replaced_same_place",
)
