"""``replacement.function_preserved``: a turn deleted and inserted although its function stays (spec §5, paper A.6)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind
from lanewright.core.places import preserved_chains
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import capitalised, lanes_named, was_or_were

CODE = "replacement.function_preserved"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each pair of chains that hold lanes of equal function."""
    for deleted, inserted in preserved_chains(comparison):
        yield Violation(
            CODE,
            Severity.ERROR,
            ElementKind.LANE_SEGMENT,
            tuple(sorted({*deleted, *inserted})),
            f"{capitalised(lanes_named(deleted))} {was_or_were(deleted)} deleted and {lanes_named(inserted)} drawn "
            f"with the same function in the intersection: re-route {lanes_named(deleted)} in place.",
        )


RULE = Rule(
    code=CODE,
    find=find,
    remedies=identity_remedies,
    what="A lane inside an intersection is deleted and one inserted that does the same: same turn, from the same "
    "approach to the same exit.",
    why="Inside an intersection the function says which lane it is: the right turn from the rightmost lane stays that "
    "turn when the outer lane goes (A1, B).",
    mend="Re-route the existing lane in place; it counts as geometry with the leaf topology, and the export can turn "
    "it into a deletion and an insertion on request.",
    example="outer_lane_removed_turn_replaced",
    gives_way_to=("replacement.unjustified",),
)
