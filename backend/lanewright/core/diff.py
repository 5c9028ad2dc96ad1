"""The atomic changes between two maps, derived and never typed in (spec §3), and their exact inversion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from lanewright.core.attributes import element_attributes
from lanewright.core.changes import AtomicChange, Category, Macros, MapDiff, StructuralUpdate
from lanewright.core.comparison import Comparison
from lanewright.core.elements import Element, ElementKind, LaneSegment, MapState
from lanewright.core.leaves import TOPOLOGY, geometry_leaves, marking_leaves, type_leaves
from lanewright.core.macros import structural_updates
from lanewright.core.roadgraph import RoadGraph

_INVERSE_CATEGORY = {Category.INSERTION: Category.DELETION, Category.DELETION: Category.INSERTION}
_INVERSE_LEAF = {"type.restriction": "type.opening", "type.opening": "type.restriction"}


def diff(base: MapState, edited: MapState) -> MapDiff:
    """The atomic changes and structural updates that turn ``base`` into ``edited``."""
    return diff_of(Comparison(base, edited))


def diff_of(comparison: Comparison) -> MapDiff:
    """``diff`` of maps that are compared already."""
    changes = atomic_changes(comparison)
    return MapDiff(changes, structural_updates(comparison, changes))


def atomic_changes(comparison: Comparison) -> tuple[AtomicChange, ...]:
    """All atomic changes, by kind and id."""
    found: list[AtomicChange] = []
    base, edited = comparison.base, comparison.edited
    for key in comparison.deleted_lanes:
        found.append(_whole(Category.DELETION, base.lanes[key], comparison.base_graph))
    for key in comparison.inserted_lanes:
        found.append(_whole(Category.INSERTION, edited.lanes[key], comparison.edited_graph))
    for key in comparison.deleted_crossings:
        found.append(_whole(Category.DELETION, base.crossings[key], comparison.base_graph))
    for key in comparison.inserted_crossings:
        found.append(_whole(Category.INSERTION, edited.crossings[key], comparison.edited_graph))
    linked = {lane for link, _ in comparison.changed_links for lane in link}
    for key in sorted(linked.union(comparison.differing_lanes)):
        change = _lane_change(comparison, key, key in linked)
        if change is not None:
            found.append(change)
    for key in comparison.differing_crossings:
        if comparison.crossing_moved(key):
            found.append(_crossing_change(comparison, key))
    return tuple(sorted(found, key=lambda change: change.key))


def _attributes(element: Element, graph: RoadGraph) -> dict[str, Any]:
    """The attributes, links as either side says them, so that applying a change brings them back."""
    attributes = element_attributes(element)
    if isinstance(element, LaneSegment):
        for name, linked in (("successors", graph.successors), ("predecessors", graph.predecessors)):
            attributes[name] += [other for other in linked[element.id] if other not in attributes[name]]
    return attributes


def _whole(category: Category, element: Element, graph: RoadGraph) -> AtomicChange:
    """An insertion or deletion."""
    attributes = _attributes(element, graph)
    old, new = (attributes, None) if category is Category.DELETION else (None, attributes)
    return AtomicChange(element.key.kind, element.id, (category,), (), old, new)


def _lane_change(comparison: Comparison, lane: int, linked: bool) -> AtomicChange | None:
    was, now = comparison.base.lanes[lane], comparison.edited.lanes[lane]
    left, right = comparison.moved_sides(lane)
    categories: set[Category] = set()
    leaves: set[str] = set()
    names: set[str] = set()
    if left or right:
        categories.add(Category.GEOMETRY)
        leaves |= geometry_leaves(was, now, left, right)
        names |= {name for name, moved in (("left_lane_boundary", left), ("right_lane_boundary", right)) if moved}
        if comparison.rerouted_in_place(lane):
            leaves.add(TOPOLOGY)
    if was.left_mark is not now.left_mark or was.right_mark is not now.right_mark:
        categories.add(Category.MARKING)
        leaves |= marking_leaves(was, now)
        names |= {"left_lane_mark_type", "right_lane_mark_type"}
    if was.lane_type is not now.lane_type or was.is_intersection != now.is_intersection:
        categories.add(Category.TYPE)
        leaves |= type_leaves(was, now)
        names |= {"lane_type", "is_intersection"}
    if linked:
        categories.add(Category.CONNECTIVITY)
        names |= {"successors", "predecessors"}
    if not categories:
        return None
    old, new = _differing(_attributes(was, comparison.base_graph), _attributes(now, comparison.edited_graph), names)
    return AtomicChange(ElementKind.LANE_SEGMENT, lane, tuple(sorted(categories)), tuple(sorted(leaves)), old, new)


def _crossing_change(comparison: Comparison, crossing: int) -> AtomicChange:
    was = element_attributes(comparison.base.crossings[crossing])
    now = element_attributes(comparison.edited.crossings[crossing])
    old, new = _differing(was, now, {"edge1", "edge2"})
    return AtomicChange(ElementKind.PEDESTRIAN_CROSSING, crossing, (Category.GEOMETRY,), (), old, new)


def _differing(
    was: Mapping[str, Any], now: Mapping[str, Any], names: set[str]
) -> tuple[dict[str, Any], dict[str, Any]]:
    """The attributes of those names that differ, in the order of the file: their old and new values."""
    chosen = [name for name in was if name in names and was[name] != now[name]]
    return {name: was[name] for name in chosen}, {name: now[name] for name in chosen}


def invert(changes: MapDiff) -> MapDiff:
    """The same map update told the other way round; exact: ``invert(diff(B, E)) == diff(E, B)``."""
    return MapDiff(
        tuple(_inverted(change) for change in changes.changes),
        tuple(StructuralUpdate(update.elements, _inverted_macros(update.macros)) for update in changes.updates),
    )


def _inverted(change: AtomicChange) -> AtomicChange:
    return replace(
        change,
        categories=tuple(sorted(_INVERSE_CATEGORY.get(category, category) for category in change.categories)),
        leaves=tuple(sorted(_INVERSE_LEAF.get(leaf, leaf) for leaf in change.leaves)),
        old=change.new,
        new=change.old,
    )


def _inverted_macros(macros: Macros) -> Macros:
    return replace(macros, lane_number=-macros.lane_number)
