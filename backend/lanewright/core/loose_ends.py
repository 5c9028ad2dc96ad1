"""Lanes that were lengthened or shortened where nothing joins them: still the same place (spec §2, §6)."""

from __future__ import annotations

from collections.abc import Collection, Iterator

import shapely

from lanewright.core.comparison import COINCIDENT_M, Comparison, lane_key
from lanewright.core.elements import LaneSegment
from lanewright.core.geometry import Plan, centreline, readable_element
from lanewright.core.places import coinciding_ends, paired_runs
from lanewright.core.roadgraph import FINISH, START, Chain, RoadGraph

_MOST_PAIRED = 20
"""Chains that are looked at for each loose end."""


def lengthened_runs(comparison: Comparison) -> list[tuple[Chain, Chain]]:
    """Parts of a deleted and an inserted chain in one direction whose ends coincide, or are loose in both maps while
    one chain reaches beyond the end of the other.

    The rules allow such a replacement (spec §5: free ends coincide within 3 m only), but a change of shape is the
    shorter story.
    """
    return [pair for pair in paired_runs(comparison, _ends) if _same_direction(comparison, *pair)]


def freed_runs(comparison: Comparison) -> list[tuple[Chain, Chain]]:
    """As ``lengthened_runs``, where what the deleted lane led to (came from) was deleted as well."""
    return [pair for pair in paired_runs(comparison, _freed_ends) if _same_direction(comparison, *pair)]


def outgrown_runs(comparison: Comparison) -> Iterator[tuple[Chain, Chain, int]]:
    """Deleted chains that end where no survivor holds them, each with the inserted chain that runs on over that end
    from where the deleted one begins (or towards it, up to where that one ends), as far as the lane on which the end
    lies; and which end of the deleted chain it is."""
    for end, first, last in ((FINISH, 0, -1), (START, -1, 0)):
        for was, now in coinciding_ends(comparison, START if end == FINISH else FINISH):
            deleted = comparison.base_graph.chain_through(was, comparison.deleted_lanes)
            inserted = comparison.edited_graph.chain_through(now, comparison.inserted_lanes)
            tip = (deleted[last], end)
            if deleted[first] != was or inserted[first] != now:
                continue
            if comparison.base_graph.anchors(tip, comparison.surviving_lanes):
                continue
            if not _same_direction(comparison, deleted, inserted):
                continue
            x, y, _ = comparison.base_graph.location(tip)
            place = shapely.Point(x, y)
            for index, lane in enumerate(inserted):
                if shapely.dwithin(comparison.shape(lane_key(lane), edited=True), place, COINCIDENT_M):
                    yield deleted, inserted[: index + 1] if end == FINISH else inserted[index:], end
                    break


def _freed_ends(comparison: Comparison, end: int) -> list[tuple[int, int]]:
    return _ends(comparison, end, freed=True)


def _ends(comparison: Comparison, end: int, *, freed: bool = False) -> list[tuple[int, int]]:
    old = _Loose(comparison, comparison.base_graph, comparison.deleted_lanes, end, edited=False, freed=freed)
    new = _Loose(comparison, comparison.edited_graph, comparison.inserted_lanes, end, edited=True)
    beyond = {(was, now) for now, was in old.reaching_to(new)}.union(new.reaching_to(old))
    return sorted(beyond.union(coinciding_ends(comparison, end)))


class _Loose:
    """Deleted (inserted) lanes whose start (finish) nothing joins; ``freed``: or nothing but other deleted ones."""

    def __init__(
        self,
        comparison: Comparison,
        graph: RoadGraph,
        lanes: Collection[int],
        end: int,
        *,
        edited: bool,
        freed: bool = False,
    ):
        # A chain's last lane reaches as far back as the chain, another one as far as itself.
        reaching = {
            lane: chain if lane == chain[-end] else (lane,)
            for chain in graph.chains(lanes)
            if all(readable_element(graph.lanes[lane]) for lane in chain)
            for lane in chain
        }
        self.lanes = [
            lane
            for lane in reaching
            if not graph.meets((lane, end)) or (freed and not graph.anchors((lane, end), comparison.surviving_lanes))
        ]
        self.places = [graph.location((lane, end)) for lane in self.lanes]
        self._owners = [owner for owner in self.lanes for _ in reaching[owner]]
        shapes = [comparison.shape(lane_key(lane), edited=edited) for owner in self.lanes for lane in reaching[owner]]
        self._tree = shapely.STRtree(shapes)

    def reaching_to(self, other: _Loose) -> Iterator[tuple[int, int]]:
        """The other's lanes whose loose end lies on one of these chains, each with that chain's lane."""
        for lane, (x, y, _) in zip(other.lanes, other.places, strict=True):
            near = self._tree.query(shapely.Point(x, y), predicate="dwithin", distance=COINCIDENT_M)
            yield from ((lane, self._owners[index]) for index in sorted(near.tolist())[:_MOST_PAIRED])


def _same_direction(comparison: Comparison, deleted: Chain, inserted: Chain) -> bool:
    """Whether two chains begin or end in one direction."""
    was = [comparison.base.lanes[lane] for lane in (deleted[0], deleted[-1])]
    now = [comparison.edited.lanes[lane] for lane in (inserted[0], inserted[-1])]
    if not all(map(readable_element, (*was, *now))):
        return False
    return any(
        float((_step(one, end) * _step(other, end)).sum()) > 0
        for one, other, end in zip(was, now, (START, FINISH), strict=True)
    )


def _step(lane: LaneSegment, end: int) -> Plan:
    """The first (last) step along a lane's middle, metres east and north."""
    middle = centreline(lane)
    step: Plan = middle[-1] - middle[-2] if end == FINISH else middle[1] - middle[0]
    return step
