"""``identity.not_canonical``: a legal assignment of identity that is not the canonical one (spec §5, §6)."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from lanewright.core.canonical import canonical_update
from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKey, ElementKind
from lanewright.core.macros import update_groups
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import crossings_named, lanes_named, listed

CODE = "identity.not_canonical"


def find(comparison: Comparison, told: Collection[ElementKey] = ()) -> Iterator[Violation]:
    """Notes for every structural update whose ids are not the canonical ones, and in which nothing else is wrong
    (``told``: the elements of the violations found already).

    Only an update in which something came, something went and something else moved as a whole can have several
    legal assignments.
    """
    if not _came_and_went(comparison):
        return
    for group in update_groups(comparison):
        if (
            not any(key in told for key in group)
            and _ambiguous(comparison, group)
            and canonical_update(comparison, group).edited is not comparison.edited
        ):
            yield _violation(group)


def _came_and_went(comparison: Comparison) -> bool:
    return bool(comparison.deleted_lanes and comparison.inserted_lanes) or bool(
        comparison.deleted_crossings and comparison.inserted_crossings
    )


def _ambiguous(comparison: Comparison, group: Collection[ElementKey]) -> bool:
    """Whether something came, something went, and something else moved as a whole: it may stand in another's place."""
    return any(
        any(key.kind is kind and key in comparison.base and key not in comparison.edited for key in group)
        and any(key.kind is kind and key in comparison.edited and key not in comparison.base for key in group)
        and any(key.kind is kind and _moved_as_a_whole(comparison, key) for key in group)
        for kind in ElementKind
    )


def _moved_as_a_whole(comparison: Comparison, key: ElementKey) -> bool:
    if key not in comparison.base or key not in comparison.edited:
        return False
    if key.kind is ElementKind.LANE_SEGMENT:
        return all(comparison.moved_sides(key.id))
    return comparison.crossing_moved(key.id)


def _violation(group: tuple[ElementKey, ...]) -> Violation:
    kind = group[0].kind
    lanes = [key.id for key in group if key.kind is ElementKind.LANE_SEGMENT]
    crossings = [key.id for key in group if key.kind is ElementKind.PEDESTRIAN_CROSSING]
    names = [named(ids) for named, ids in ((lanes_named, lanes), (crossings_named, crossings)) if ids]
    return Violation(
        CODE,
        Severity.NONE,
        kind,
        tuple(key.id for key in group if key.kind is kind),
        f"The ids of {listed(names)} are legal, but there is a simpler story of this update: the save tells that one.",
    )


RULE = Rule(
    code=CODE,
    find=find,
    remedies=identity_remedies,
    what="The rules allow the ids of a structural update, but another assignment explains it with fewer changes.",
    why="The rules alone leave several legal stories, such as a lane drawn anew while its neighbours exchange "
    "ids. The canonical one is the one with the fewest insertions and deletions, then the fewest categories, then the "
    "least displacement, then the smallest ids (A1).",
    mend="Nothing to do: the save applies the canonical form and says so.",
    gives_way_to=(
        "replacement.",
        "identity.",
        "insertion.",
        "deletion.",
        "element.",
        "geometry.",
        "link.",
        "neighbor.",
    ),
)
