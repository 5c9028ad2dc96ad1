"""``deletion.not_rightmost``: the right-hand-side rule for lanes that are deleted (spec §5; paper A.5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind
from lanewright.core.rightmost import ambiguous_insertions
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import capitalised, lanes_named

CODE = "deletion.not_rightmost"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each chain that was deleted on the left where the right was as possible."""
    if not comparison.deleted_lanes:
        return
    for chain, part in ambiguous_insertions(comparison.inverse):
        yield Violation(
            CODE,
            Severity.ERROR,
            ElementKind.LANE_SEGMENT,
            tuple(sorted(chain)),
            f"{capitalised(lanes_named(chain))} went on the left of {lanes_named(part)}, which took the room: "
            "it could be either that went. By convention the rightmost lane goes, so exchange their ids.",
        )


RULE = Rule(
    code=CODE,
    find=find,
    remedies=identity_remedies,
    what="A lane is deleted on the left of one that takes over its room, and either could be the one that went.",
    why="Two stories would explain the same map. The convention that the rightmost lane is deleted makes it one (A1); "
    "where links or an unmoved neighbour tell the lanes apart, nothing is unclear and the rule is silent.",
    mend="Delete the lane on the right and let the left one widen. The fix exchanges their ids.",
    example="lane_removed_left",
)
