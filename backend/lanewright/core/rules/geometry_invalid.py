"""``geometry.invalid``: lines that cannot be a lane or a crossing (spec §5)."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np
import shapely

from lanewright.core.comparison import Comparison
from lanewright.core.elements import Element, LaneSegment, Line, MapState, PedestrianCrossing
from lanewright.core.geometry import Plan, length_m, lines_of, plan, quietly, readable, same_plan
from lanewright.core.linework import NARROWEST_M, WIDEST_M
from lanewright.core.rules.rule import Rule, no_remedies
from lanewright.core.survey import Survey
from lanewright.core.violations import Severity, Violation

CODE = "geometry.invalid"
_ENDS_ALONE = "FF*F*****"
"""DE-9IM: two lines meet in no point but an end of both."""
_MOST_MEETING = 200

Defect = tuple[str, tuple[int, ...]]
"""What is wrong, in words, and which of the two lines it is about."""


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for every element of the edited map that has a defect."""
    edited = comparison.edited
    touched = comparison.touched_lanes
    known = [key for key in comparison.survey.fact(_defective_lanes) if key in edited.lanes and key not in touched]
    for key in (*comparison.touched_linework.doubtful(), *known):
        yield from _violation(comparison.base, edited.lanes[key], "Lane")
    crossings = comparison.touched_crossings.union(comparison.survey.fact(_defective_crossings))
    for key in sorted(crossings & edited.crossings.keys()):
        yield from _violation(comparison.base, edited.crossings[key], "Crossing")


def _defective_lanes(state: MapState) -> tuple[int, ...]:
    return tuple(key for key in Survey(state).linework.doubtful() if defects_of(state.lanes[key]))


def _defective_crossings(state: MapState) -> tuple[int, ...]:
    return tuple(key for key, crossing in state.crossings.items() if defects_of(crossing))


def _violation(base: MapState, element: Element, noun: str) -> Iterator[Violation]:
    defects = defects_of(element)
    if not defects:
        return
    known = base.get(element.key)
    introduced = [defect for defect in defects if known is None or not _inherited(defect, known, element)]
    words = "; ".join(problem for problem, _ in (introduced or defects))
    yield Violation(
        CODE,
        Severity.ERROR,
        element.key.kind,
        (element.id,),
        f"{noun} {element.id}: {words}. Redraw it there.",
        inherited=not introduced,
    )


def _inherited(defect: Defect, known: Element, element: Element) -> bool:
    """Whether the base has this very defect on the same lines."""
    before, after = lines_of(known), lines_of(element)
    return all(same_plan(before[line], after[line]) for line in defect[1]) and defect in defects_of(known)


def defects_of(element: Element) -> list[Defect]:
    """All that is wrong with the geometry of an element."""
    lane = isinstance(element, LaneSegment)
    names = ("left boundary", "right boundary") if lane else ("first edge", "second edge")
    lines = lines_of(element)
    unreadable: list[Defect] = [
        (f"the {names[index]} {problem}", (index,))
        for index, line in enumerate(lines)
        if (problem := _unreadable(line)) is not None
    ]
    if unreadable:
        return unreadable
    defects: list[Defect] = [
        (f"the {names[index]} {problem}", (index,))
        for index, line in enumerate(lines)
        for problem in _line_problems(line)
    ]
    return defects + [(problem, (0, 1)) for problem in _pair_problems(element)]


def _unreadable(line: Line) -> str | None:
    if len(line) < 2:
        return "has fewer than two points"
    if not readable(line):
        return "has a coordinate that is not a finite number of metres"
    return None


def _line_problems(line: Line) -> Iterator[str]:
    for index, (one, other) in enumerate(itertools.pairwise(line)):
        if one[:2] == other[:2]:
            yield f"repeats its point {index + 1}"
            return
    if _crosses_itself(plan(line)):
        yield "crosses itself"


@quietly
def _crosses_itself(points: Plan) -> bool:
    return not shapely.is_simple(shapely.linestrings(points))


def _pair_problems(element: Element) -> Iterator[str]:
    one, other = (plan(line) for line in lines_of(element))
    if isinstance(element, PedestrianCrossing):
        if crosses(one, other):
            yield "its edges cross each other"
        return
    if crosses(one, other):
        yield "its boundaries cross each other"
        return
    ring = np.vstack([one, other[::-1]])
    if signed_area_m2(ring) >= 0:
        yield "its left boundary is not on the left in driving direction"
        return
    mean_length = (length_m(one) + length_m(other)) / 2
    width = -signed_area_m2(ring) / mean_length if mean_length > 0 else 0.0
    if not NARROWEST_M <= width <= WIDEST_M:
        yield f"it is {width:.2f} m wide on average, outside {NARROWEST_M} m to {WIDEST_M:.0f} m"


def signed_area_m2(ring: Plan) -> float:
    """Area of a ring (closed or not), positive counter-clockwise."""
    x, y = (ring - ring[0]).T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2)


@quietly
def crosses(one: Plan, other: Plan) -> bool:
    """Whether two lines meet anywhere but in a common end (a lane may taper to a point)."""
    lines = shapely.linestrings(one), shapely.linestrings(other)
    if shapely.relate_pattern(*lines, _ENDS_ALONE):
        return False
    if len(one) + len(other) > _MOST_MEETING:
        return True  # they may meet as often as their points multiplied
    tips = {tuple(one[0]), tuple(one[-1])} & {tuple(other[0]), tuple(other[-1])}
    meeting = shapely.intersection(*lines)
    if shapely.length(meeting) > 0:
        return True
    return any(tuple(point) not in tips for point in shapely.get_coordinates(meeting))


RULE = Rule(
    code=CODE,
    find=find,
    remedies=no_remedies,
    what="A boundary has fewer than two points, a coordinate that is not finite, or the same point twice in a row; it "
    "crosses itself or its partner; left is not on the left; or the lane's mean width is outside 0.3 m to 15 m.",
    why="A lane that cannot be driven cannot be compared either: every other rule reads these lines (D).",
    mend="Redraw the boundary named in the message. There is no automatic fix, since only you see the road.",
    gives_way_to=("replacement.", "identity.", "insertion.", "deletion."),
)
