"""``link.gap``: linked lanes whose ends do not meet (spec §5)."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from typing import Any

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind, LaneSegment, Line, MapState
from lanewright.core.geometry import readable_element, same_plan
from lanewright.core.identity import WIDEST_GAP_M, without_link
from lanewright.core.roadgraph import FINISH, START, Link
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.survey import Survey
from lanewright.core.violations import Severity, Violation

CODE = "link.gap"
_SIDES = ("left_boundary", "right_boundary")


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each link of the edited map whose ends lie more than 1 cm apart on a side."""
    graph = comparison.edited_graph
    touched = comparison.touched_lanes
    links = {link for link in comparison.survey.fact(_gapping_links) if touched.isdisjoint(link)}
    for key in touched:
        links.update((key, other) for other in graph.successors[key])
        links.update((other, key) for other in graph.predecessors[key])
    for link in sorted(links):
        lane, other = (graph.lanes.get(key) for key in link)
        if lane is None or other is None or _meets(lane, other):
            continue
        if readable_element(lane) and readable_element(other):
            yield _violation(comparison, link, {side: _gap_m(lane, other, side) for side in _SIDES})


def _gapping_links(state: MapState) -> tuple[Link, ...]:
    graph = Survey(state).graph
    return tuple(
        (upstream, downstream)
        for upstream, others in graph.successors.items()
        for downstream in others
        if not _meets(graph.lanes[upstream], graph.lanes[downstream])
    )


def _meets(lane: LaneSegment, other: LaneSegment) -> bool:
    """The common case, quickly: both sides share their point, or nearly."""
    return _near(lane.left_boundary, other.left_boundary) and _near(lane.right_boundary, other.right_boundary)


def _near(line: Line, other: Line) -> bool:
    if not line or not other:
        return False
    one, two = line[-1], other[0]
    return (one[0] == two[0] and one[1] == two[1]) or math.hypot(one[0] - two[0], one[1] - two[1]) <= WIDEST_GAP_M


def _gap_m(lane: LaneSegment, other: LaneSegment, side: str) -> float:
    one, two = getattr(lane, side)[-1], getattr(other, side)[0]
    return math.hypot(one[0] - two[0], one[1] - two[1])


def _violation(comparison: Comparison, link: Link, gaps: dict[str, float]) -> Violation:
    upstream, downstream = link
    widest = max(gaps.values())
    return Violation(
        CODE,
        Severity.ERROR,
        ElementKind.LANE_SEGMENT,
        tuple(sorted({upstream, downstream})),
        f"Lane {upstream} leads to lane {downstream}, but their ends are {widest:.2f} m apart: they must meet.",
        inherited=all(_inherited(comparison, link, side) for side, gap in gaps.items() if gap > WIDEST_GAP_M),
    )


def _inherited(comparison: Comparison, link: Link, side: str) -> bool:
    """Whether the base has the link and the very same lines on this side."""
    upstream, downstream = link
    base, edited = comparison.base.lanes, comparison.edited.lanes
    return downstream in comparison.base_graph.successors.get(upstream, ()) and all(
        same_plan(getattr(base[lane], side), getattr(edited[lane], side)) for lane in link
    )


def remedies(comparison: Comparison, violation: Violation) -> Iterator[Remedy]:
    """Move the end that was edited back onto the other, else the other; else put an edited lane back where it was;
    else take the link out. Ends that never met and lie further apart than a lane is wide are not moved at first: there
    the link is what is wrong."""
    one, other = violation.elements[0], violation.elements[-1]
    linked = other in comparison.edited_graph.successors[one]
    upstream, downstream = (one, other) if linked else (other, one)
    base, edited = comparison.base.lanes, comparison.edited.lanes
    unlinked = Remedy(
        f"Take out the link from lane {upstream} to lane {downstream}",
        comparison.edited.replaced(without_link(edited, (upstream, downstream))),
    )
    if _is_beside(comparison, (upstream, downstream)):
        yield unlinked
    edits_downstream = base.get(downstream) != edited[downstream] or base.get(upstream) == edited[upstream]
    for moving in (downstream, upstream) if edits_downstream else (upstream, downstream):
        still = upstream if moving == downstream else downstream
        state = _moved_onto(comparison.edited, moving, still, FINISH if moving == upstream else START)
        yield Remedy(f"Move the end of lane {moving} onto lane {still}", state)
    for moved in (downstream, upstream):
        if moved in base and base[moved] != edited[moved]:
            lines: dict[str, Any] = {side: getattr(base[moved], side) for side in _SIDES}
            restored = comparison.edited.replaced([dataclasses.replace(edited[moved], **lines)])
            yield Remedy(f"Put lane {moved} back where it was", restored)
    yield unlinked


def _is_beside(comparison: Comparison, link: Link) -> bool:
    """Whether the linked ends lie at least a lane's width apart and do not meet in the base."""
    base, edited = comparison.base.lanes, comparison.edited.lanes
    upstream, downstream = (edited[lane] for lane in link)
    if all(lane in base for lane in link) and _meets(*(base[lane] for lane in link)):
        return False
    widths = (
        math.dist(lane.left_boundary[end][:2], lane.right_boundary[end][:2])
        for lane, end in ((upstream, -1), (downstream, 0))
    )
    return max(_gap_m(upstream, downstream, side) for side in _SIDES) > min(widths) - WIDEST_GAP_M


def _moved_onto(state: MapState, moving: int, still: int, end: int) -> MapState:
    """One end of a lane on the facing end of another. Whoever shares its points goes along, so that neighbours keep
    their shared line and other links their joint."""
    own, facing = -end, end - 1
    places = {
        getattr(state.lanes[moving], side)[own][:2]: getattr(state.lanes[still], side)[facing]
        for side in _SIDES
        if getattr(state.lanes[moving], side)[own][:2] != getattr(state.lanes[still], side)[facing][:2]
    }
    moved = []
    for lane in state.lanes.values():
        lines: dict[str, Any] = {side: _replaced(getattr(lane, side), places) for side in _SIDES}
        if lane.id != still and any(lines[side] is not getattr(lane, side) for side in _SIDES):
            moved.append(dataclasses.replace(lane, **lines))
    return state.replaced(moved)


def _replaced(line: Line, places: dict[tuple[float, float], tuple[float, float, float]]) -> Line:
    """The line with points at those places moved; the same object when none is."""
    if not line or {line[0][:2], line[-1][:2]}.isdisjoint(places):
        return line
    moved = [places.get(point[:2], point) for point in line]
    distinct = [point for index, point in enumerate(moved) if index == 0 or point[:2] != moved[index - 1][:2]]
    return tuple(distinct) if len(distinct) >= 2 else tuple(moved)


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="A lane leads to another, but the end of the one and the start of the other are more than 1 cm apart.",
    why="In real maps linked lanes meet exactly. A gap would show up as a change of shape that nobody made (A1, B).",
    mend="Move the end back onto the other lane, or remove the link. The fix moves the end that was edited, "
    "or takes the link out where the ends lie a lane's width or more apart.",
    gives_way_to=("replacement.", "identity.", "insertion.", "deletion."),
)
