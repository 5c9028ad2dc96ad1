"""``replacement.unjustified``: a deletion and an insertion at the same place in the road graph (spec §5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind
from lanewright.core.places import coinciding_runs, unjustified_crossings
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import capitalised, lanes_named, was_or_were

CODE = "replacement.unjustified"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for lanes, then for crossings."""
    for deleted, inserted in coinciding_runs(comparison):
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
