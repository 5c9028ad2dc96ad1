"""``identity.rerouted``: a survivor's link comes or goes, and with it the lane's place (spec §5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind
from lanewright.core.places import rerouted
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation

CODE = "identity.rerouted"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each link whose coming or going joins or parts two survivors' endpoints."""
    for link, appeared in comparison.changed_links:
        if not rerouted(comparison, link):
            continue
        upstream, downstream = link
        what = "now leads" if appeared else "no longer leads"
        yield Violation(
            CODE,
            Severity.ERROR,
            ElementKind.LANE_SEGMENT,
            tuple(sorted({upstream, downstream})),
            f"Lane {upstream} {what} to lane {downstream}: one of them has another place in the road graph now, "
            "so it cannot keep its id. Delete it and insert it anew.",
        )


RULE = Rule(
    code=CODE,
    find=find,
    remedies=identity_remedies,
    what="A link between two lanes that stay is added or removed, and with it their ends come to meet or cease to.",
    why="Lanes are the edges of the road graph: an edge between other junctions is another edge (A1). A link that goes "
    "while the junction stays one is a change of connectivity in place, and a turn that keeps its function may be "
    "re-routed in place.",
    mend="Delete the lane that moved to another place and insert it there under a new id. The fix replaces the fewest "
    "lanes: those that leave the fewest other changes, then the one that moved most, then one inside the intersection, "
    "then the downstream one.",
    example="right_turn_rerouted_in_place",
)
