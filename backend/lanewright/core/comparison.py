"""Two states of one map side by side: who survives, what differs, which places persist.

The one context that the diff and every rule read. Equal elements are skipped by identity, then by value; geometry is
looked at only where something differs, and remembered.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from functools import cached_property

from lanewright.core import geometry
from lanewright.core.claims import NO_CLAIMS, Claims
from lanewright.core.cuts import cut_alike
from lanewright.core.elements import ElementKey, ElementKind, MapState, PedestrianCrossing
from lanewright.core.geometry import Shape, distance_m, hausdorff_m, moved, overlap, polygon, readable_element
from lanewright.core.linework import Linework
from lanewright.core.roadgraph import FINISH, START, Endpoint, Link, RoadGraph
from lanewright.core.survey import Survey, lane_ids
from lanewright.core.turns import TurnFunction, same_function, turn_function

COINCIDENT_M = 3.0
"""Free chain ends within this distance are the same place (spec §5)."""
SAME_CROSSING_OVERLAP = 0.3
"""Crossings with at least this intersection over union are one crossing (spec §5)."""


_Apart = tuple[list[int], list[int], list[int]]
"""Ids of elements that are not one object in both maps: those of the base alone, of the edited map alone, of both."""


class Comparison:
    """Base and edited map compared (spec §2: B, E, survivors, deleted, inserted).

    ``base`` is cut as the edited map records; ``uncut_base`` is the one that came.
    """

    def __init__(self, base: MapState, edited: MapState, claims: Claims = NO_CLAIMS):
        self.uncut_base = base
        self.apart = edited.apart(base)
        self.base, self.edited = cut_alike(base, edited, self.apart)
        if self.base is not base or self.edited is not edited:
            self.apart = self.edited.apart(self.base)
        self.claims = claims
        self._moved: dict[int, tuple[bool, bool]] = {}
        self._moved_crossings: dict[int, bool] = {}
        self._polygons: dict[ElementKey, Shape] = {}
        self._functions: dict[tuple[bool, int], TurnFunction | None] = {}

    @cached_property
    def survey(self) -> Survey:
        """What is known of the base."""
        return Survey(self.base)

    @cached_property
    def base_graph(self) -> RoadGraph:
        return self.survey.graph

    @cached_property
    def edited_graph(self) -> RoadGraph:
        return self.base_graph.updated(
            self.edited.lanes, self.deleted_lanes.union(self.touched_lanes), self.survey.references
        )

    @cached_property
    def touched_lanes(self) -> frozenset[int]:
        """Lanes of the edited map that are new or not equal to the base's."""
        return self.inserted_lanes.union(self.differing_lanes)

    @cached_property
    def touched_linework(self) -> Linework:
        """The boundaries of the touched lanes as arrays."""
        return Linework({lane: self.edited.lanes[lane] for lane in sorted(self.touched_lanes)})

    @cached_property
    def surviving_lanes(self) -> frozenset[int]:
        ids = self.survey.fact(lane_ids)
        return ids.difference(self.deleted_lanes) if self.deleted_lanes else ids

    @cached_property
    def deleted_lanes(self) -> frozenset[int]:
        return frozenset(self._lanes_apart[0])

    @cached_property
    def inserted_lanes(self) -> frozenset[int]:
        return frozenset(self._lanes_apart[1])

    @cached_property
    def deleted_crossings(self) -> frozenset[int]:
        return frozenset(self._crossings_apart[0])

    @cached_property
    def inserted_crossings(self) -> frozenset[int]:
        return frozenset(self._crossings_apart[1])

    @cached_property
    def differing_lanes(self) -> tuple[int, ...]:
        """Surviving lanes that are not equal by value, ascending."""
        base, edited = self.base.lanes, self.edited.lanes
        return tuple(sorted(key for key in self._lanes_apart[2] if base[key] != edited[key]))

    @cached_property
    def _lanes_apart(self) -> _Apart:
        lanes = [key.id for key in self.apart if key.kind is ElementKind.LANE_SEGMENT]
        return _parted(lanes, self.base.lanes, self.edited.lanes)

    @cached_property
    def _crossings_apart(self) -> _Apart:
        crossings = [key.id for key in self.apart if key.kind is ElementKind.PEDESTRIAN_CROSSING]
        return _parted(crossings, self.base.crossings, self.edited.crossings)

    @cached_property
    def touched_crossings(self) -> frozenset[int]:
        """Crossings of the edited map that are new or not equal to the base's."""
        return self.inserted_crossings.union(self.differing_crossings)

    @cached_property
    def differing_crossings(self) -> tuple[int, ...]:
        """Surviving crossings that are not equal by value, ascending."""
        base, edited = self.base.crossings, self.edited.crossings
        return tuple(sorted(key for key in self._crossings_apart[2] if base[key] != edited[key]))

    @cached_property
    def inverse(self) -> Comparison:
        """The same two maps, told the other way round."""
        return _Inverse(self)

    def moved_sides(self, lane: int) -> tuple[bool, bool]:
        """Whether the left and the right boundary of a surviving lane moved."""
        if lane not in self._moved:
            was, now = self.base.lanes[lane], self.edited.lanes[lane]
            self._moved[lane] = (
                moved(was.left_boundary, now.left_boundary),
                moved(was.right_boundary, now.right_boundary),
            )
        return self._moved[lane]

    def crossing_moved(self, crossing: int) -> bool:
        """Whether an edge of a surviving crossing moved, edges assigned to each other at their best."""
        if crossing not in self._moved_crossings:
            was, now = self.base.crossings[crossing], self.edited.crossings[crossing]
            self._moved_crossings[crossing] = best_edge_distance_m(was, now) > geometry.MOVED_M
        return self._moved_crossings[crossing]

    @cached_property
    def changed_links(self) -> tuple[tuple[Link, bool], ...]:
        """Links between two survivors that differ, ascending, each with whether it appeared (else it went)."""
        survivors = self.surviving_lanes
        found: dict[Link, bool] = {}
        for lane in self.differing_lanes:
            for index, flip in (("successors", False), ("predecessors", True)):
                was = set(getattr(self.base_graph, index)[lane])
                now = set(getattr(self.edited_graph, index)[lane])
                for other in was ^ now:
                    if other in survivors:
                        found[(other, lane) if flip else (lane, other)] = other in now
        return tuple(sorted(found.items()))

    @cached_property
    def changed_keys(self) -> frozenset[ElementKey]:
        """All elements with an atomic change."""
        lanes = {*self.deleted_lanes, *self.inserted_lanes}
        lanes.update(lane for link, _ in self.changed_links for lane in link)
        lanes.update(lane for lane in self.differing_lanes if self.changed_in_place(lane))
        crossings = {*self.deleted_crossings, *self.inserted_crossings}
        crossings.update(crossing for crossing in self.differing_crossings if self.crossing_moved(crossing))
        return frozenset({*map(lane_key, lanes), *map(crossing_key, crossings)})

    def changed_in_place(self, lane: int) -> bool:
        """Whether geometry, marking or type of a surviving lane changed."""
        was, now = self.base.lanes[lane], self.edited.lanes[lane]
        return (
            was.left_mark is not now.left_mark
            or was.right_mark is not now.right_mark
            or was.lane_type is not now.lane_type
            or was.is_intersection != now.is_intersection
            or any(self.moved_sides(lane))
        )

    def shape(self, key: ElementKey, *, edited: bool) -> Shape:
        """The area that an element covers in the edited map (else in the base), remembered."""
        known = self._polygons if edited else self.survey.shapes
        if key not in known:
            element = (self.edited if edited else self.base).get(key)
            assert element is not None
            known[key] = polygon(element)
        return known[key]

    def shapes(self, key: ElementKey) -> tuple[Shape, ...]:
        """The areas of an element in base and edited map, as far as it is in them."""
        return tuple(
            self.shape(key, edited=edited)
            for edited, state in ((False, self.base), (True, self.edited))
            if key in state
        )

    def function(self, lane: int, *, edited: bool) -> TurnFunction | None:
        """The turn function of a lane in the edited map (else in the base), remembered."""
        if (edited, lane) not in self._functions:
            graph = self.edited_graph if edited else self.base_graph
            self._functions[(edited, lane)] = turn_function(graph, lane)
        return self._functions[(edited, lane)]

    def keeps_function(self, lane: int) -> bool:
        """Whether a survivor is an intersection lane in both maps with equal function (spec §5)."""
        return self.equal_function(lane, lane)

    def equal_function(self, was: int, now: int) -> bool:
        """Whether a lane of the base and one of the edited map have equal function."""
        one, other = self.base.lanes[was], self.edited.lanes[now]
        if not (one.is_intersection and other.is_intersection):
            return False
        return same_function(self.function(was, edited=False), self.function(now, edited=True), self.surviving_lanes)

    def held_by(self, endpoint: Endpoint, *, edited: bool) -> frozenset[Endpoint]:
        """Other survivors' endpoints in the vertex of a survivor's, by links among survivors alone."""
        graph = self.edited_graph if edited else self.base_graph
        members = graph.vertex(endpoint, self.surviving_lanes)
        return frozenset(member for member in members if member[0] != endpoint[0])

    def rerouted_in_place(self, lane: int) -> bool:
        """Whether a survivor's place in the road graph changed while its function persists."""
        if not self.edited.lanes[lane].is_intersection or not self.base.lanes[lane].is_intersection:
            return False
        place_changed = any(
            self.held_by((lane, end), edited=False) != self.held_by((lane, end), edited=True)
            or not self.coincide((lane, end), (lane, end))
            for end in (START, FINISH)
        )
        return place_changed and self.keeps_function(lane)

    def coincide(self, was: Endpoint, now: Endpoint) -> bool:
        """Whether an endpoint in the base and one in the edited map are the same place (spec §5)."""
        one = self.base_graph.anchors(was, self.surviving_lanes) - {was}
        other = self.edited_graph.anchors(now, self.surviving_lanes) - {now}
        if one or other:
            return not one.isdisjoint(other)
        if not readable_element(self.base.lanes[was[0]]) or not readable_element(self.edited.lanes[now[0]]):
            return False
        return distance_m(self.base_graph.location(was), self.edited_graph.location(now)) <= COINCIDENT_M


def _parted(ids: Iterable[int], base: Collection[int], edited: Collection[int]) -> _Apart:
    parted: _Apart = ([], [], [])
    for key in ids:
        parted[0 if key not in edited else 2 if key in base else 1].append(key)
    return parted


class _Inverse(Comparison):
    """A comparison told the other way round, from what is known of it already."""

    def __init__(self, other: Comparison):
        self.base, self.edited, self.claims = other.edited, other.base, NO_CLAIMS
        self.apart = other.apart
        self._moved = other._moved
        self._moved_crossings = other._moved_crossings
        self._polygons = {}
        self._functions = {}
        self.base_graph, self.edited_graph = other.edited_graph, other.base_graph
        self.surviving_lanes = other.surviving_lanes


def best_edge_distance_m(was: PedestrianCrossing, now: PedestrianCrossing) -> float:
    """The larger Hausdorff distance of the two edges, in the better of the two assignments."""
    straight = max(hausdorff_m(was.edge1, now.edge1), hausdorff_m(was.edge2, now.edge2))
    crossed = max(hausdorff_m(was.edge1, now.edge2), hausdorff_m(was.edge2, now.edge1))
    return min(straight, crossed)


def same_crossing(one: Shape, other: Shape) -> bool:
    """Whether two crossings overlap so far that they are one."""
    return overlap(one, other) >= SAME_CROSSING_OVERLAP


def lane_key(lane: int) -> ElementKey:
    return ElementKey(ElementKind.LANE_SEGMENT, lane)


def crossing_key(crossing: int) -> ElementKey:
    return ElementKey(ElementKind.PEDESTRIAN_CROSSING, crossing)
