"""A stretch of road in the edited map, and where lanes of the base say that it is to be cut (see ``segmentation``)."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from lanewright.core.elements import LaneSegment, MapState
from lanewright.core.geometry import MOVED_M
from lanewright.core.identity import joinable
from lanewright.core.lane_ends import LaneEnds, NearEnd
from lanewright.core.roadgraph import FINISH, START, Chain, Endpoint, RoadGraph
from lanewright.core.series import CLOSE_M, NEAR_M, SAME_POINT_M, Run, Station, apart_m, at_vertex
from lanewright.core.survey import Survey


@dataclass(slots=True)
class _Cut:
    """A station, and the ends of base lanes that are there."""

    station: Station
    ends: set[Endpoint] = field(default_factory=set)


class Stretch:
    """Lanes in series between which nothing differs.

    Attributes:
        lanes: as they were drawn, in driving direction.
    """

    def __init__(self, base: MapState, edited: RoadGraph, lanes: Chain):
        self.lanes = lanes
        self._base = Survey(base)
        self._edited = edited
        self._run = Run.of([edited.lanes[lane] for lane in lanes])
        self._near = self._base.fact(LaneEnds).near(self._run.whole, NEAR_M)
        self._cuts = [_Cut((0.0, 0.0)), _Cut(self._run.ends)]

    def cut_at_lanes_on_it(self) -> None:
        """Cut where a lane of the base that lies on this stretch begins or ends."""
        self._cut_at([one for one in self._near if one.away_m <= MOVED_M], 2 * MOVED_M)

    def lanes_on_it(self) -> set[int]:
        """The lanes of the base that run from one cut to the next."""
        return set().union(*map(_from_to, self._cuts, self._cuts[1:]))

    def cut_at_lanes_near(self, placed: Collection[int]) -> None:
        """Cut the pieces on which no lane of the base lies where one begins or ends near it; but not where those lanes
        do that are in the edited map as they were (``placed``)."""
        taken = [(one.station, other.station) for one, other in pairwise(self._cuts) if _from_to(one, other)]
        self._cut_at(
            [
                one._replace(station=self._at_vertices(one.station))
                for one in self._near
                if one.end[0] not in placed and not any(start <= one.station <= finish for start, finish in taken)
            ],
            NEAR_M,
        )

    def pieces(self, new: Collection[int], fresh: Callable[[int], int]) -> list[LaneSegment] | None:
        """The stretch cut anew; None if it is cut like that already. ``new``: lanes that are where none was before;
        ``fresh``: gives an id to one more piece of a drawn lane."""
        stations = [cut.station for cut in self._kept(new)]
        joints = self._run.joints
        if len(stations) == len(joints) and all(map(_same_station, stations, joints)):
            return None
        ends = self._run.ends
        owners = _owners([(0.0, 0.0), *joints, ends], [(0.0, 0.0), *stations, ends])
        return [
            dataclasses.replace(piece, id=lane if first else fresh(lane), part_of=None)
            for piece, (index, first) in zip(self._run.pieces(stations), owners, strict=True)
            for lane in (self.lanes[index],)
        ]

    def _at_vertices(self, station: Station) -> Station:
        """The station, moved to vertices close by, where drawn lanes and lanes beside them have their ends."""
        left, right = station
        whole = self._run.whole
        return at_vertex(whole.left_boundary, left, CLOSE_M), at_vertex(whole.right_boundary, right, CLOSE_M)

    def _cut_at(self, places: Sequence[NearEnd], margin_m: float) -> None:
        """Cut there, the nearest ends first; ends within the margin of a cut are that cut's."""
        for _, station, end in places:
            here = [cut for cut in self._cuts if apart_m(cut.station, station) <= margin_m]
            if here:
                min(here, key=lambda cut: apart_m(cut.station, station)).ends.add(end)
            elif all(_clear(cut.station, station, margin_m) for cut in self._cuts):
                self._cuts.append(_Cut(station, {end}))
                self._cuts.sort(key=lambda cut: cut.station)

    def _kept(self, new: Collection[int]) -> list[_Cut]:
        """The inner cuts but for joints that moved and loose ends that were lengthened, up to where only new lanes go
        on."""
        cuts = [cut for cut in self._cuts[1:-1] if not self._moved_on(cut)]
        for end in (FINISH, START):
            met = self._edited.meets((self.lanes[-end], end))
            if cuts and self._are_loose(cuts[-end], end) and all(lane in new for lane, _ in met):
                del cuts[-end]
        return cuts

    def _moved_on(self, cut: _Cut) -> bool:
        """Whether properties changed there in the base that change at an end of this stretch now."""
        was, now = self._base.state.lanes, self._edited.lanes
        before = self._edited.previous_in_series(self.lanes[0], now)
        after = self._edited.next_in_series(self.lanes[-1], now)
        here = self._run.whole
        for one, other in self._joints(cut):
            if joinable(was[one], was[other]):
                continue
            if after is not None and joinable(was[one], here) and joinable(was[other], now[after]):
                return True
            if before is not None and joinable(was[other], here) and joinable(was[one], now[before]):
                return True
        return False

    def _joints(self, cut: _Cut) -> Iterator[tuple[int, int]]:
        """Base lanes that meet there."""
        for one, end in sorted(cut.ends):
            if end == FINISH:
                yield from ((one, other) for other in self._base.graph.successors[one] if (other, START) in cut.ends)

    def _are_loose(self, cut: _Cut, end: int) -> bool:
        """Whether base lanes only end (begin) there, and nothing joined them."""
        return all(other == end and not self._base.graph.meets((lane, end)) for lane, other in cut.ends)


def _from_to(start: _Cut, finish: _Cut) -> set[int]:
    """The base lanes that begin at one cut and end at the next."""
    beginning = {lane for lane, end in start.ends if end == START}
    return {lane for lane, end in finish.ends if end == FINISH and lane in beginning}


def _clear(one: Station, other: Station, margin_m: float) -> bool:
    """Whether one station is before the other on both sides, by more than the margin."""
    left, right = other[0] - one[0], other[1] - one[1]
    return min(left, right) > margin_m or max(left, right) < -margin_m


def _same_station(one: Station, other: Station) -> bool:
    return apart_m(one, other) <= SAME_POINT_M


def _owners(drawn: Sequence[Station], cut: Sequence[Station]) -> list[tuple[int, bool]]:
    """For each piece between two cuts which piece between two drawn joints it is: the one with which it shares most and
    that no other is; or, since it is one more piece, the one with which it shares most, and False."""
    owners: dict[int, tuple[int, bool]] = {}
    taken: set[int] = set()
    shared = sorted(_shared([sum(station) for station in drawn], [sum(station) for station in cut]))
    for _, piece, index in shared:
        if piece not in owners and index not in taken:
            owners[piece] = (index, True)
            taken.add(index)
    for _, piece, index in shared:
        owners.setdefault(piece, (index, False))
    return [owners[piece] for piece in range(len(cut) - 1)]


def _shared(drawn: Sequence[float], cut: Sequence[float]) -> Iterator[tuple[float, int, int]]:
    """Pieces of two divisions of one line that overlap: minus how much, and which."""
    index = 0
    for piece, (start, finish) in enumerate(pairwise(cut)):
        while index + 2 < len(drawn) and drawn[index + 1] <= start:
            index += 1
        for other in range(index, len(drawn) - 1):
            if other > index and drawn[other] >= finish:
                break
            yield max(start, drawn[other]) - min(finish, drawn[other + 1]), piece, other
