"""``identity.not_canonical``: a legal assignment of identity that is not the canonical one (spec §5, §6)."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from lanewright.core.canonical import stands
from lanewright.core.comparison import Comparison, same_crossing
from lanewright.core.crossing_areas import CrossingAreas
from lanewright.core.elements import ElementKey, ElementKind
from lanewright.core.geometry import lines_of
from lanewright.core.macros import update_groups
from lanewright.core.rules.remedy import identity_remedies
from lanewright.core.rules.rule import Rule
from lanewright.core.violations import Severity, Violation
from lanewright.core.wording import crossings_named, lanes_named, listed

CODE = "identity.not_canonical"


def find(comparison: Comparison, told: Collection[ElementKey] = ()) -> Iterator[Violation]:
    """Notes for every structural update whose ids are not the canonical ones, and in which nothing else is wrong
    (``told``: the elements of the violations found already)."""
    for group in update_groups(comparison):
        if not any(key in told for key in group) and _ambiguous(comparison, group) and not stands(comparison, group):
            yield _violation(group)


def _ambiguous(comparison: Comparison, group: Collection[ElementKey]) -> bool:
    """Whether one element may stand in another's place."""
    lanes = [key for key in group if key.kind is ElementKind.LANE_SEGMENT]
    crossings = [key for key in group if key.kind is ElementKind.PEDESTRIAN_CROSSING]
    return _ambiguous_lanes(comparison, lanes) or _ambiguous_crossings(comparison, crossings)


def _ambiguous_lanes(comparison: Comparison, lanes: Collection[ElementKey]) -> bool:
    """Whether two lanes came, went or moved (all of them going is one story), or have the very same lines."""
    came_or_moved = sum(key not in comparison.base or _moved(comparison, key) for key in lanes)
    went = sum(key not in comparison.edited for key in lanes)
    if came_or_moved and came_or_moved + went > 1:
        return True
    lines = [lines_of(lane) for lane in map(comparison.edited.get, lanes) if lane is not None]
    return len(set(lines)) < len(lines)


def _ambiguous_crossings(comparison: Comparison, crossings: Collection[ElementKey]) -> bool:
    """Whether one crossing as it is covers another as it was so far that they may be one."""
    was = [
        key for key in crossings if key in comparison.base and (key not in comparison.edited or _moved(comparison, key))
    ]
    now = {
        key.id: comparison.shape(key, edited=True)
        for key in crossings
        if key in comparison.edited and (key not in comparison.base or _moved(comparison, key))
    }
    areas = CrossingAreas(now)
    return any(
        other != key.id and same_crossing(shape, now[other])
        for key in was
        for shape in (comparison.shape(key, edited=False),)
        for other in areas.near(shape)
    )


def _moved(comparison: Comparison, key: ElementKey) -> bool:
    if key not in comparison.edited:
        return False
    if key.kind is ElementKind.LANE_SEGMENT:
        return any(comparison.moved_sides(key.id))
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
