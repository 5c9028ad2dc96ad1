"""Structural updates and their macro-modifications (spec §4, matrix C)."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from weakref import WeakKeyDictionary

import numpy as np
import shapely

from lanewright.core.changes import AtomicChange, Category, Macros, StructuralUpdate
from lanewright.core.comparison import Comparison, lane_key
from lanewright.core.elements import ElementKey, ElementKind
from lanewright.core.geometry import pairs_within, within
from lanewright.core.leaves import TOPOLOGY
from lanewright.core.roadgraph import RoadGraph

TOUCHING_M = 5.0
"""Changes whose polygons are this near belong to one update (spec §4)."""


_FEW = 100
"""Areas of which every pair may be looked at."""


def structural_updates(comparison: Comparison, changes: Iterable[AtomicChange]) -> tuple[StructuralUpdate, ...]:
    """The updates that the changes form, each with its macros, by smallest element."""
    by_key = {change.key: change for change in changes}
    return tuple(
        StructuralUpdate(group, macros(comparison, [by_key[key] for key in group]))
        for group in update_groups(comparison)
    )


_remembered: WeakKeyDictionary[Comparison, tuple[tuple[ElementKey, ...], ...]] = WeakKeyDictionary()


def update_groups(comparison: Comparison) -> tuple[tuple[ElementKey, ...], ...]:
    """The elements of each structural update, by smallest element; worked out once per comparison."""
    if comparison not in _remembered:
        _remembered[comparison] = touching_groups(comparison, comparison.changed_keys)
    return _remembered[comparison]


def touching_groups(comparison: Comparison, keys: Collection[ElementKey]) -> tuple[tuple[ElementKey, ...], ...]:
    """Elements that are linked, neighbours or within 5 m of each other, in base or edited map, transitively."""
    parent = {key: key for key in keys}

    def root(key: ElementKey) -> ElementKey:
        while parent[key] != key:
            parent[key] = parent[parent[key]]
            key = parent[key]
        return key

    for one, other in (*_related(comparison, keys), *_near(comparison, sorted(keys))):
        parent[root(one)] = root(other)
    groups: dict[ElementKey, list[ElementKey]] = {}
    for key in sorted(keys):
        groups.setdefault(root(key), []).append(key)
    return tuple(sorted(tuple(group) for group in groups.values()))


def _related(comparison: Comparison, keys: Collection[ElementKey]) -> Iterable[tuple[ElementKey, ElementKey]]:
    """Pairs of linked lanes and of neighbours among the keys."""
    for graph in (comparison.base_graph, comparison.edited_graph):
        for key in keys:
            if key.kind is ElementKind.LANE_SEGMENT and key.id in graph.lanes:
                lane = graph.lanes[key.id]
                beside = (lane.left_neighbor_id, lane.right_neighbor_id)
                for other in (*graph.successors[key.id], *graph.predecessors[key.id], *beside):
                    if other is not None and lane_key(other) in keys:
                        yield key, lane_key(other)


def _near(comparison: Comparison, keys: list[ElementKey]) -> Iterable[tuple[ElementKey, ElementKey]]:
    """Pairs of elements whose areas, in either map, are within 5 m: as many as hold together all that are."""
    shaped = [(key, shape) for key in keys for shape in comparison.shapes(key) if not shapely.is_empty(shape)]
    if not shaped:
        return
    owners, shapes = [key for key, _ in shaped], np.array([shape for _, shape in shaped])
    if len(shapes) <= _FEW:
        yield from ((owners[one], owners[other]) for one, other in pairs_within(shapes, TOUCHING_M))
        return
    west, south, east, north = shapely.bounds(shapes).T
    around = shapely.box(west - TOUCHING_M, south - TOUCHING_M, east + TOUCHING_M, north + TOUCHING_M)
    tree = shapely.STRtree(shapes)
    left = np.ones(len(shapes), dtype=bool)
    for first in range(len(shapes)):
        queue = [first]
        while queue:
            here = queue.pop()
            left[here] = False
            candidates = tree.query(around[here])
            candidates = candidates[left[candidates]]
            near = candidates[within(shapes[candidates], shapes[here], TOUCHING_M)]
            left[near] = False
            queue += near.tolist()
            yield from ((owners[here], owners[other]) for other in near)


def macros(comparison: Comparison, changes: Collection[AtomicChange]) -> Macros:
    """The macros of one structural update, derived from its atomic changes."""
    categories = {category for change in changes for category in change.categories}
    whole = {Category.INSERTION, Category.DELETION}
    lanes = [change for change in changes if change.kind is ElementKind.LANE_SEGMENT]
    crossings = [change for change in changes if change.kind is ElementKind.PEDESTRIAN_CROSSING]
    inserted = {change.id for change in lanes if Category.INSERTION in change.categories}
    deleted = {change.id for change in lanes if Category.DELETION in change.categories}
    return Macros(
        shape=Category.GEOMETRY in categories,
        appearance=Category.MARKING in categories or any(whole & set(change.categories) for change in crossings),
        function=Category.TYPE in categories,
        lane_graph=bool(inserted or deleted)
        or any(TOPOLOGY in change.leaves for change in lanes)
        or categories == {Category.CONNECTIVITY},
        lane_number=fewest_paths(comparison.edited_graph, inserted) - fewest_paths(comparison.base_graph, deleted),
    )


def fewest_paths(graph: RoadGraph, lanes: Collection[int]) -> int:
    """The fewest disjoint link paths that cover the lanes: as many as have no link to follow in the best choice.

    Maximum matching of lanes to successors by augmenting paths; a ring counts as one path.
    """
    follower: dict[int, int] = {}
    leader: dict[int, int] = {}
    for lane in sorted(lanes):
        _augment(graph.successors, lanes, lane, follower, leader)
    return len(lanes) - len(follower) + _rings(follower)


def _augment(
    successors: Mapping[int, tuple[int, ...]],
    lanes: Collection[int],
    start: int,
    follower: dict[int, int],
    leader: dict[int, int],
) -> None:
    """Find a follower for one more lane, moving others on to their alternatives (breadth first)."""
    came_from: dict[int, int] = {}
    queue = [start]
    while queue:
        lane = queue.pop(0)
        for other in successors[lane]:
            if other not in lanes or other in came_from:
                continue
            came_from[other] = lane
            if other in leader:
                queue.append(leader[other])
                continue
            taken: int | None = other
            while taken is not None:
                lane = came_from[taken]
                before = follower.get(lane)
                follower[lane], leader[taken] = taken, lane
                taken = before if lane != start else None
            return


def _rings(follower: Mapping[int, int]) -> int:
    """How many closed rings the chosen followers form."""
    seen: set[int] = set()
    rings = 0
    for start in follower:
        trail: list[int] = []
        lane: int | None = start
        while lane is not None and lane not in seen:
            seen.add(lane)
            trail.append(lane)
            lane = follower.get(lane)
        rings += lane is not None and lane in trail
    return rings
