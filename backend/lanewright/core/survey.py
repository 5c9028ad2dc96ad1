"""What is known of one map state, found out once: so that checking a save costs by what changed, not by the map's size.

A task's base is compared with many edited maps. Facts about it are remembered for the last few states by identity;
map states are immutable, so a fact once found stays true.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Iterator
from threading import Lock
from typing import Any, TypeVar

from lanewright.core.elements import LaneSegment, MapState
from lanewright.core.linework import Linework
from lanewright.core.roadgraph import RoadGraph

Fact = TypeVar("Fact")
_MOST_REMEMBERED = 4
_recent: OrderedDict[int, Survey] = OrderedDict()
_lock = Lock()


class Survey:
    """Facts about one map state, each worked out when first asked for."""

    def __init__(self, state: MapState):
        self.state = state
        self._facts: dict[Callable[..., Any], Any] = {}

    @classmethod
    def of(cls, state: MapState) -> Survey:
        """The survey of a state, the same one as last time if that is recent."""
        with _lock:
            known = _recent.get(id(state))
            if known is None or known.state is not state:
                known = _recent[id(state)] = cls(state)
            _recent.move_to_end(id(state))
            while len(_recent) > _MOST_REMEMBERED:
                _recent.popitem(last=False)
            return known

    def fact(self, find: Callable[[MapState], Fact]) -> Fact:
        """What ``find`` says of the state, asked once."""
        if find not in self._facts:
            self._facts[find] = find(self.state)
        known: Fact = self._facts[find]
        return known

    @property
    def graph(self) -> RoadGraph:
        return self.fact(RoadGraph.of)

    @property
    def linework(self) -> Linework:
        return self.fact(_linework)

    @property
    def references(self) -> dict[int, tuple[int, ...]]:
        """Every lane id that is named -> the lanes that name it, as link or neighbour."""
        return self.fact(_references)


def lane_ids(state: MapState) -> frozenset[int]:
    """The ids of all lanes."""
    return frozenset(state.lanes)


def renewed_lanes(base: MapState, edited: MapState) -> list[int]:
    """Lanes of the edited map that are not the base's own objects: the only ones that can differ."""
    if base is edited:
        return []
    known = Survey.of(base).fact(_lanes).get
    return [key for key, lane in edited.lanes.items() if known(key) is not lane]


def _lanes(state: MapState) -> dict[int, LaneSegment]:
    return dict(state.lanes)


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
    found: dict[int, tuple[int, ...]] = {}
    for key, lane in state.lanes.items():
        for other in named_by(lane):
            found[other] = (*found.get(other, ()), key)
    return found


def parts_recorded(state: MapState) -> dict[int, list[int]]:
    """Lanes that were cut -> their parts in this state (spec §2)."""
    parts: dict[int, list[int]] = {}
    for key, lane in state.lanes.items():
        if lane.part_of is not None:
            parts.setdefault(lane.part_of, []).append(key)
    return parts
