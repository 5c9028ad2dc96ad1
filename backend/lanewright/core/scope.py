"""What is looked at anew along with a structural update, so that its canonical form is that of the whole map."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from itertools import chain
from weakref import WeakKeyDictionary

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


_remembered: WeakKeyDictionary[Comparison, dict[ElementKey, frozenset[ElementKey]]] = WeakKeyDictionary()


def worked_out_together(comparison: Comparison, update: Iterable[ElementKey]) -> frozenset[ElementKey]:
    """An update with those that meet the lanes looked at along with it: where a lane between two updates may be the one
    to replace, they are one question."""
    if comparison not in _remembered:
        _remembered[comparison] = _questions(comparison)
    question_of = _remembered[comparison]
    return frozenset(update).union(*(question_of[key] for key in update if key in question_of))


def _questions(comparison: Comparison) -> dict[ElementKey, frozenset[ElementKey]]:
    """For every changed element all those that are one question with it."""
    question_of: dict[ElementKey, set[ElementKey]] = {}
    groups = update_groups(comparison)
    for group in groups:
        question = set(group)
        question_of.update((key, question) for key in group)
    for group in groups:
        scope = widened(comparison, group)
        met = scope.union(*(_joined_to(graph, scope) for graph in (comparison.base_graph, comparison.edited_graph)))
        naming = (comparison.survey.references.get(key, ()) for kind, key in scope if kind is ElementKind.LANE_SEGMENT)
        met.update(map(lane_key, chain.from_iterable(naming)))
        for key in sorted(met):
            one, other = question_of[group[0]], question_of.get(key)
            if other is not None and other is not one:
                larger, smaller = (one, other) if len(one) >= len(other) else (other, one)
                larger |= smaller
                question_of.update((key, larger) for key in smaller)
    frozen = {id(question): frozenset(question) for question in question_of.values()}
    return {key: frozen[id(question)] for key, question in question_of.items()}


def _joined_to(graph: RoadGraph, keys: Iterable[ElementKey]) -> Iterator[ElementKey]:
    """The lanes linked to lanes of one map, or beside them."""
    for kind, key in keys:
        if kind is ElementKind.LANE_SEGMENT and key in graph.lanes:
            lane = graph.lanes[key]
            yield from map(lane_key, (*graph.successors[key], *graph.predecessors[key]))
            yield from (lane_key(one) for one in (lane.left_neighbor_id, lane.right_neighbor_id) if one is not None)
