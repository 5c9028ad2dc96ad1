"""What is known of one map state, found out once: so that checking a save costs by what changed, not by the map's size.

A task's base is compared with many edited maps. Facts about it are remembered with the state itself.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from itertools import chain
from typing import TypeVar

from lanewright.core.elements import Element, ElementKey, LaneSegment, MapState
from lanewright.core.geometry import Shape
from lanewright.core.linework import Linework
from lanewright.core.roadgraph import RoadGraph

Fact = TypeVar("Fact")


class Survey:
    """Facts about one map state, each worked out when first asked for."""

    def __init__(self, state: MapState):
        self.state = state

    def fact(self, find: Callable[[MapState], Fact]) -> Fact:
        """What ``find`` says of the state, asked once."""
        if find not in self.state.facts:
            self.state.facts[find] = find(self.state)
        known: Fact = self.state.facts[find]
        return known

    @property
    def graph(self) -> RoadGraph:
        return self.fact(RoadGraph.of)

    @property
    def linework(self) -> Linework:
        return self.fact(_linework)

    @property
    def shapes(self) -> dict[ElementKey, Shape]:
        """The areas of elements that were asked for so far."""
        return self.fact(_no_shapes)

    @property
    def references(self) -> dict[int, tuple[int, ...]]:
        """Every lane id that is named -> the lanes that name it, as link or neighbour."""
        return self.fact(_references)


def lane_ids(state: MapState) -> frozenset[int]:
    """The ids of all lanes."""
    return frozenset(state.lanes)


def _no_shapes(_: MapState) -> dict[ElementKey, Shape]:
    return {}


def _linework(state: MapState) -> Linework:
    return Linework(state.lanes)


def named_by(lane: LaneSegment) -> Iterator[int]:
    """All ids that a lane names: links and neighbours."""
    yield from lane.successors
    yield from lane.predecessors
    if lane.left_neighbor_id is not None:
        yield lane.left_neighbor_id
    if lane.right_neighbor_id is not None:
        yield lane.right_neighbor_id


def _references(state: MapState) -> dict[int, tuple[int, ...]]:
    found: dict[int, dict[int, None]] = {}
    for key, lane in state.lanes.items():
        for other in named_by(lane):
            found.setdefault(other, {})[key] = None
    return {other: tuple(keys) for other, keys in found.items()}


def ids_named(state: MapState) -> frozenset[int]:
    """All ids that elements have or name."""
    return frozenset(state.lanes).union(state.crossings, *map(named_by, state.lanes.values()))


def largest_id_named(base: MapState, edited: MapState) -> int:
    """No element of either map has or names an id above this one."""
    apart = [element for element in map(edited.get, edited.apart(base)) if element is not None]
    return max(Survey(base).fact(_largest_id), _largest_id(apart))


def _largest_id(elements: Collection[Element] | MapState) -> int:
    named = (named_by(element) for element in elements if isinstance(element, LaneSegment))
    return max((0, *(element.id for element in elements), *chain.from_iterable(named)))


def parts_recorded(state: MapState) -> dict[int, list[int]]:
    """Lanes that were cut -> their parts in this state (spec §2)."""
    parts: dict[int, list[int]] = {}
    for key, lane in state.lanes.items():
        if lane.part_of is not None:
            parts.setdefault(lane.part_of, []).append(key)
    return parts
