"""From drafts to a map: ids by name, links where ends meet exactly, neighbours where lines are shared."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping

import numpy as np

from lanewright.core.elements import LaneSegment, Line, MapState, PedestrianCrossing, Point
from lanewright.demo.network import Drafts
from lanewright.demo.street import LaneDraft

Joint = tuple[Point, Point]


class Names:
    """Gives every lane and crossing name its id, in a random order with gaps, as in real maps.

    Names met later (those that only the changed map has) get higher ids: new elements get new ids.
    """

    def __init__(self, generator: np.random.Generator) -> None:
        self._generator = generator
        self._next = {"lane": int(generator.integers(36_000_000, 44_000_000)), "crossing": 0}
        self._next["crossing"] = int(generator.integers(2_000_000, 2_900_000))
        self.ids: dict[str, int] = {}

    def give(self, kind: str, names: Iterable[str]) -> None:
        """Give ids to those of the names that have none."""
        fresh = sorted(set(names) - self.ids.keys())
        for index in self._generator.permutation(len(fresh)):
            self._next[kind] += int(self._generator.integers(1, 40))
            self.ids[fresh[index]] = self._next[kind]


def assemble(drafts: Drafts, names: Names, *, one_sided: bool = False) -> MapState:
    """The uncropped map of the drafts.

    ``one_sided``: list a predecessor only when its id is smaller than the lane's own, as 3 of 5 real maps do.
    """
    names.give("lane", drafts.lanes)
    names.give("crossing", drafts.crossings)
    ids = names.ids
    starts: dict[Joint, list[str]] = defaultdict(list)
    for name, lane in drafts.lanes.items():
        starts[lane.left[0], lane.right[0]].append(name)
    successors = {
        name: sorted(ids[other] for other in starts[lane.left[-1], lane.right[-1]])
        for name, lane in drafts.lanes.items()
    }
    predecessors: dict[int, list[int]] = defaultdict(list)
    for name, followers in successors.items():
        for follower in followers:
            if not one_sided or ids[name] < follower:
                predecessors[follower].append(ids[name])
    right, left = _neighbors(drafts.lanes)
    lanes = (
        LaneSegment(
            id=ids[name],
            is_intersection=lane.is_intersection,
            lane_type=lane.lane_type,
            left_boundary=lane.left,
            left_mark=lane.left_mark,
            right_boundary=lane.right,
            right_mark=lane.right_mark,
            successors=tuple(successors[name]),
            predecessors=tuple(sorted(predecessors[ids[name]])),
            right_neighbor_id=ids[right[name]] if name in right else None,
            left_neighbor_id=ids[left[name]] if name in left else None,
        )
        for name, lane in drafts.lanes.items()
    )
    crossings = (_crossing(ids[name], *edges) for name, edges in drafts.crossings.items())
    return MapState.of([*sorted(lanes, key=lambda lane: lane.id), *sorted(crossings, key=lambda zebra: zebra.id)])


def _neighbors(lanes: Mapping[str, LaneDraft]) -> tuple[dict[str, str], dict[str, str]]:
    """Right and left neighbours: same direction across a shared line, or oncoming lanes that share their left lines."""
    right: dict[str, str] = {}
    left: dict[str, str] = {}
    by_left: dict[Line, list[str]] = defaultdict(list)
    for name, lane in lanes.items():
        by_left[lane.left].append(name)
    for name, lane in lanes.items():
        for other in by_left.get(lane.right, ()):
            if other not in left and name not in right:
                right[name], left[other] = other, name
    for name, lane in lanes.items():
        for other in by_left.get(lane.left[::-1], ()):
            if other != name and name not in left and other not in left:
                left[name], left[other] = other, name
    return right, left


def _crossing(id_: int, edge1: Line, edge2: Line) -> PedestrianCrossing:
    """Half of the real rings run clockwise, half counter-clockwise: the id decides which edge is named first."""
    return PedestrianCrossing(id_, *((edge1, edge2) if id_ % 2 else (edge2, edge1)))
