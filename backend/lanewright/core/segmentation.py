"""Where the edited map's lanes begin and end, as it follows from the road alone: cuts in series are no change (spec §2,
§6), so whether a road was drawn in one piece or in five, its story starts from the same lanes.

Lanes in series between which nothing differs are one *stretch*. It is cut where a lane of the base that lies on it
begins or ends, else where one begins or ends near it. Two ends of base lanes are no cut: where properties changed in
the base that now change further on (that joint moved), and the loose end of a lane that was lengthened.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import pairwise

from lanewright.core.comparison import Comparison
from lanewright.core.elements import LaneSegment, MapState
from lanewright.core.geometry import readable_element
from lanewright.core.identity import one_road, with_lanes_exchanged
from lanewright.core.matching import Place, lanes_by_place, place_of
from lanewright.core.roadgraph import Chain, RoadGraph
from lanewright.core.stretch import Stretch
from lanewright.core.survey import Survey


def segmented(
    base: MapState, edited: MapState, free: Collection[int], settled: Collection[int], fresh: Callable[[int], int]
) -> MapState:
    """The edited map with its lanes in that segmentation.

    ``free``: lanes of the edited map that may be cut and joined; as many pieces as possible keep their ids, others get
    ``fresh`` ones (of the lane that they come from). ``settled``: lanes of the base that the edited map has as they
    were.
    """
    comparison = Comparison(base, edited)
    graph = comparison.edited_graph if comparison.edited is edited else RoadGraph.of(edited)
    placed = set(settled)
    new = set(free)
    places = Survey(base).fact(_lanes_by_place)
    stretches = []
    for chain in _stretches(graph, free):
        known = [places.get(place_of(graph.lanes[lane]), ()) for lane in chain]
        if all(known):
            placed.update(*known)
            new.difference_update(chain)
        else:
            stretches.append(Stretch(base, graph, chain))
    for stretch in stretches:
        stretch.cut_at_lanes_on_it()
        found = stretch.lanes_on_it()
        if found:
            placed |= found
            new.difference_update(stretch.lanes)
    for stretch in stretches:
        stretch.cut_at_lanes_near(placed)
        pieces = stretch.pieces(new, fresh)
        if pieces is not None:
            edited = with_lanes_exchanged(edited, stretch.lanes, pieces)
    return edited


def _lanes_by_place(base: MapState) -> dict[Place, list[int]]:
    return lanes_by_place(base.lanes)


def _stretches(graph: RoadGraph, free: Collection[int]) -> Iterator[Chain]:
    """The free lanes in series as far as nothing differs between them; those that cannot be read are left out."""
    readable = {lane for lane in free if readable_element(graph.lanes[lane])}
    for chain in graph.chains(readable):
        ring = graph.next_in_series(chain[-1], readable) == chain[0]
        row = _from_a_joint([graph.lanes[lane] for lane in chain]) if ring else chain
        stretch = [*row[:1]]
        for one, other in pairwise(row):
            if not one_road(graph.lanes[one], graph.lanes[other]):
                yield tuple(stretch)
                stretch = []
            stretch.append(other)
        if stretch:
            yield tuple(stretch)


def _from_a_joint(ring: Sequence[LaneSegment]) -> Chain:
    """A ring from the first lane on that differs from the one before it; nothing where none does: no place to begin."""
    for index, lane in enumerate(ring):
        if not one_road(ring[index - 1], lane):
            return tuple(other.id for other in (*ring[index:], *ring[:index]))
    return ()
