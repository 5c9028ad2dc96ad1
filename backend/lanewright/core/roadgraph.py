"""The road graph: lanes are edges, their linked endpoints form vertices (spec §2).

A link exists when either side says so; ids outside the map (the rim) are no members. Everything is derived lazily
from the two link indexes, so looking at one place costs by what joins there, not by the size of the map.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Final

from lanewright.core.elements import LaneSegment, MapState, Point
from lanewright.core.geometry import end_midpoint

START: Final = 0
FINISH: Final = 1
Endpoint = tuple[int, int]
"""A lane's id and which end of it: START or FINISH, in driving direction."""
Link = tuple[int, int]
"""Upstream lane, downstream lane."""
Chain = tuple[int, ...]
"""Lanes in series, in driving direction."""


class RoadGraph:
    """Links, vertices, chains and anchors of one map state.

    Attributes:
        lanes: the lanes by id.
        successors, predecessors: in-map links of each lane, as either side says, ascending.
    """

    __slots__ = ("_vertices", "lanes", "predecessors", "successors")

    def __init__(
        self,
        lanes: Mapping[int, LaneSegment],
        successors: dict[int, tuple[int, ...]],
        predecessors: dict[int, tuple[int, ...]],
    ):
        self.lanes = lanes
        self.successors = successors
        self.predecessors = predecessors
        self._vertices: dict[Endpoint, frozenset[Endpoint]] = {}

    @classmethod
    def of(cls, state: MapState) -> RoadGraph:
        """The road graph of a map state."""
        lanes = state.lanes
        after: dict[int, set[int]] = {key: set() for key in lanes}
        before: dict[int, set[int]] = {key: set() for key in lanes}
        for key, lane in lanes.items():
            for other in lane.successors:
                if other in lanes:
                    after[key].add(other)
                    before[other].add(key)
            for other in lane.predecessors:
                if other in lanes:
                    before[key].add(other)
                    after[other].add(key)
        return cls(
            lanes,
            {key: tuple(sorted(ids)) for key, ids in after.items()},
            {key: tuple(sorted(ids)) for key, ids in before.items()},
        )

    def updated(
        self,
        lanes: Mapping[int, LaneSegment],
        touched: Collection[int],
        references: Mapping[int, tuple[int, ...]],
    ) -> RoadGraph:
        """The graph of other lanes that differ from these in the touched ones only (changed, new or gone).

        ``references``: who names an id, in this graph's map.
        """
        after, before = self.successors.copy(), self.predecessors.copy()
        fewer: set[tuple[bool, int]] = set()
        for lane in touched:
            fewer.update((True, other) for other in before.pop(lane, ()))
            fewer.update((False, other) for other in after.pop(lane, ()))
        for forwards, other in fewer:
            index = after if forwards else before
            if other in index:
                index[other] = tuple(key for key in index[other] if key not in touched)
        more: dict[tuple[bool, int], set[int]] = {}
        for lane in touched:
            if lane in lanes:
                after[lane] = before[lane] = ()
        for upstream, downstream in self._links_of(lanes, touched, references):
            more.setdefault((True, upstream), set()).add(downstream)
            more.setdefault((False, downstream), set()).add(upstream)
        for (forwards, lane), others in more.items():
            index = after if forwards else before
            index[lane] = tuple(sorted(others.union(index[lane])))
        return RoadGraph(lanes, after, before)

    @staticmethod
    def _links_of(
        lanes: Mapping[int, LaneSegment], touched: Collection[int], references: Mapping[int, tuple[int, ...]]
    ) -> Iterator[Link]:
        """The links that touched lanes write, or that others write to them."""
        for lane in touched:
            if lane not in lanes:
                continue
            yield from ((lane, other) for other in lanes[lane].successors if other in lanes)
            yield from ((other, lane) for other in lanes[lane].predecessors if other in lanes)
            for other in references.get(lane, ()):
                if other in lanes and other not in touched:
                    yield from [(other, lane)] if lane in lanes[other].successors else ()
                    yield from [(lane, other)] if lane in lanes[other].predecessors else ()

    def links(self) -> frozenset[Link]:
        """All in-map links, upstream first."""
        return frozenset((key, other) for key, others in self.successors.items() for other in others)

    def meets(self, endpoint: Endpoint) -> tuple[Endpoint, ...]:
        """The endpoints directly linked to this one."""
        lane, end = endpoint
        if end == FINISH:
            return tuple((other, START) for other in self.successors[lane])
        return tuple((other, FINISH) for other in self.predecessors[lane])

    def vertex(self, endpoint: Endpoint, among: Collection[int] | None = None) -> frozenset[Endpoint]:
        """All endpoints that share the vertex of this one, itself included (transitive closure of the links).

        ``among`` keeps to links between those lanes alone.
        """
        if among is None and endpoint in self._vertices:
            return self._vertices[endpoint]
        seen = {endpoint}
        queue = [endpoint]
        while queue:
            for other in self.meets(queue.pop()):
                if other not in seen and (among is None or other[0] in among):
                    seen.add(other)
                    queue.append(other)
        members = frozenset(seen)
        if among is None:
            for member in members:
                self._vertices[member] = members
        return members

    def anchors(self, endpoint: Endpoint, survivors: Collection[int]) -> frozenset[Endpoint]:
        """The survivors' endpoints in the vertex of a chain end (spec §5)."""
        return frozenset(member for member in self.vertex(endpoint) if member[0] in survivors)

    def next_in_series(self, lane: int, among: Collection[int]) -> int | None:
        """The lane that follows in series: the vertex between the two holds nothing else. None: the chain ends."""
        after = self.successors[lane]
        if len(after) == 1 and after[0] in among and len(self.vertex((lane, FINISH))) == 2:
            return after[0]
        return None

    def previous_in_series(self, lane: int, among: Collection[int]) -> int | None:
        """The lane that comes before in series, or None."""
        before = self.predecessors[lane]
        if len(before) == 1 and before[0] in among and len(self.vertex((lane, START))) == 2:
            return before[0]
        return None

    def chain_through(self, lane: int, among: Collection[int]) -> Chain:
        """The maximal run of lanes in series that holds this one; a ring is cut at its smallest id."""
        run = [lane]
        while (following := self.next_in_series(run[-1], among)) is not None:
            if following == lane:
                cut = run.index(min(run))
                return tuple(run[cut:] + run[:cut])
            run.append(following)
        before: list[int] = []
        while (previous := self.previous_in_series(before[-1] if before else lane, among)) is not None:
            before.append(previous)
        return (*reversed(before), *run)

    def chains(self, among: Collection[int]) -> tuple[Chain, ...]:
        """The chains that the given lanes form, by their first lane's id."""
        left = set(among)
        found: list[Chain] = []
        for lane in sorted(left):
            if lane in left:
                chain = self.chain_through(lane, among)
                left.difference_update(chain)
                found.append(chain)
        return tuple(sorted(found))

    def location(self, endpoint: Endpoint) -> Point:
        """Where an endpoint lies: the midpoint of left and right."""
        return end_midpoint(self.lanes[endpoint[0]], endpoint[1])
