"""``link.one_sided``: a link written on one side, in a map that writes all of them on both (spec §5)."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator

from lanewright.core.comparison import Comparison
from lanewright.core.elements import ElementKind, LaneSegment, MapState
from lanewright.core.roadgraph import Link
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.survey import Survey
from lanewright.core.violations import Severity, Violation

CODE = "link.one_sided"


def find(comparison: Comparison) -> Iterator[Violation]:
    """Violations for each link of the edited map that one side alone writes, if the base has none such."""
    if comparison.survey.fact(_writes_halves):
        return
    graph = comparison.edited_graph
    halves = {
        link
        for lane in comparison.touched_lanes
        for link in (
            *((lane, other) for other in graph.successors[lane]),
            *((other, lane) for other in graph.predecessors[lane]),
        )
        if not _written_twice(comparison.edited, link)
    }
    for upstream, downstream in sorted(halves):
        says, silent = (
            (upstream, downstream)
            if downstream in comparison.edited.lanes[upstream].successors
            else (downstream, upstream)
        )
        yield Violation(
            CODE,
            Severity.ERROR,
            ElementKind.LANE_SEGMENT,
            tuple(sorted({upstream, downstream})),
            f"Lane {upstream} leads to lane {downstream}, but only lane {says} says so: name it in lane {silent} too.",
        )


def _writes_halves(state: MapState) -> bool:
    return next(one_sided_links(state), None) is not None


def _written_twice(state: MapState, link: Link) -> bool:
    upstream, downstream = link
    return downstream in state.lanes[upstream].successors and upstream in state.lanes[downstream].predecessors


def one_sided_links(state: MapState) -> Iterator[Link]:
    """Links between lanes of the map that one side alone writes."""
    lanes = state.lanes
    for key, lane in lanes.items():
        for other in lane.successors:
            if other in lanes and key not in lanes[other].predecessors:
                yield key, other
        for other in lane.predecessors:
            if other in lanes and key not in lanes[other].successors:
                yield other, key


def with_links_completed(base: MapState, edited: MapState) -> MapState:
    """The edited map with every link written on both sides, if the base writes them so."""
    if Survey(base).fact(_writes_halves):
        return edited
    halves = list(one_sided_links(edited))
    lanes: dict[int, LaneSegment] = {}
    for upstream, downstream in halves:
        before = lanes.get(upstream, edited.lanes[upstream])
        if downstream not in before.successors:
            lanes[upstream] = dataclasses.replace(before, successors=(*before.successors, downstream))
        after = lanes.get(downstream, edited.lanes[downstream])
        if upstream not in after.predecessors:
            lanes[downstream] = dataclasses.replace(after, predecessors=(*after.predecessors, upstream))
    return edited.replaced(lanes.values()) if lanes else edited


def remedies(comparison: Comparison, _violation: Violation) -> Iterator[Remedy]:
    """Write all such links on the other side too."""
    yield Remedy("Write the link on both sides", with_links_completed(comparison.base, comparison.edited))


RULE = Rule(
    code=CODE,
    find=find,
    remedies=remedies,
    what="A link is written by one of its two lanes only, although the base map writes every link on both sides.",
    why="Some real maps list predecessors incompletely, so a link counts when either side says so. In a map that is "
    "complete, one side alone is an oversight, and readers that look at the other side would miss the road (B).",
    mend="Add the missing id on the other side. The fix does.",
    gives_way_to=("replacement.", "identity.", "insertion.", "deletion."),
)
