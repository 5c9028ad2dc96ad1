"""``identity.displaced``: an element keeps its id at another place (spec §5)."""

from __future__ import annotations

from collections.abc import Iterator

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind
from lanewright.core.places import FAR_M, displaced_crossings, displaced_lanes, exchanged_lanes
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation

CODE = "identity.displaced"


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
