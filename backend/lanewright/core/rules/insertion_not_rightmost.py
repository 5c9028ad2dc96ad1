"""``insertion.not_rightmost``: the right-hand-side rule for lanes that are inserted (spec §5; paper A.5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind
from lanewright.core.rightmost import ambiguous_insertions
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import capitalised, lanes_named

CODE = "insertion.not_rightmost"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each chain that was inserted on the left where the right was as possible."""
    for chain, part in ambiguous_insertions(comparison):
        yield Violation(
            CODE,
            Severity.ERROR,
            ElementKind.LANE_SEGMENT,
            tuple(sorted(chain)),
            f"{capitalised(lanes_named(chain))} came in on the left of {lanes_named(part)}, which made room: "
            "it could be either that is new. By convention the rightmost lane is, so exchange their ids.",
        )


RULE = Rule(
    code=CODE,
    find=find,
    remedies=identity_remedies,
    what="A lane is inserted on the left of one that had to make room, and either could be the new one.",
    why="Two stories would explain the same map. The convention that the rightmost lane is inserted makes it one (A1); "
    "where links or an unmoved neighbour tell the lanes apart, nothing is unclear and the rule is silent.",
    mend="Let the existing lane take the left place and insert the new one on its right. The fix exchanges their ids.",
    example="lane_added_left",
)
