"""What is looked at anew along with a structural update, so that its canonical form is that of the whole map."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from lanewright.core.comparison import Comparison, lane_key
from lanewright.core.elements import ElementKey, ElementKind, LaneSegment
from lanewright.core.macros import update_groups
from lanewright.core.roadgraph import RoadGraph


def widened(comparison: Comparison, update: Collection[ElementKey]) -> set[ElementKey]:
    """An update, lanes linked to those of it that came or went, and the lanes that these are cut from, in all parts."""
    scope = {*update, *_linked(comparison, update)}
    states = (comparison.base, comparison.edited)
    in_scope = [state.get(key) for key in scope for state in states]
    wholes = {lane.part_of for lane in in_scope if isinstance(lane, LaneSegment) and lane.part_of is not None}
    if wholes:
        scope.update(map(lane_key, wholes))
        scope.update(lane.key for state in states for lane in state.lanes.values() if lane.part_of in wholes)
    return scope


def _linked(comparison: Comparison, update: Collection[ElementKey]) -> Iterator[ElementKey]:
    """The lanes linked to those of an update that came or went."""
    for graph, other in (
        (comparison.base_graph, comparison.edited_graph),
        (comparison.edited_graph, comparison.base_graph),
    ):
        for kind, key in update:
            if kind is ElementKind.LANE_SEGMENT and key in graph.lanes and key not in other.lanes:
                yield from map(lane_key, (*graph.successors[key], *graph.predecessors[key]))


def worked_out_together(comparison: Comparison, update: Iterable[ElementKey]) -> frozenset[ElementKey]:
    """An update with those that meet the lanes looked at along with it: where a lane between two updates may be the one
    to replace, they are one question."""
    group_of = {key: group for group in update_groups(comparison) for key in group}
    together = frozenset(update)
    while True:
        scope = widened(comparison, together)
        met = scope.union(*(_joined_to(graph, scope) for graph in (comparison.base_graph, comparison.edited_graph)))
        grown = together.union(*(group_of[key] for key in met if key in group_of))
        if grown == together:
            return together
        together = grown


def _joined_to(graph: RoadGraph, keys: Iterable[ElementKey]) -> Iterator[ElementKey]:
    """The lanes linked to lanes of one map, or beside them."""
    for kind, key in keys:
        if kind is ElementKind.LANE_SEGMENT and key in graph.lanes:
            lane = graph.lanes[key]
            yield from map(lane_key, (*graph.successors[key], *graph.predecessors[key]))
            yield from (lane_key(one) for one in (lane.left_neighbor_id, lane.right_neighbor_id) if one is not None)
