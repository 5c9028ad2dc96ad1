"""Where places in the road graph persist although ids do not, and where ids persist although places do not (spec §5).

The findings behind the rules of identity, as lanes and chains; the canonical form uses the same ones.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Collection, Iterator
from itertools import combinations, product

from lanewright.core.comparison import COINCIDENT_M, Comparison, crossing_key, lane_key, same_crossing
from lanewright.core.crossing_areas import CrossingAreas
from lanewright.core.elements import LaneSegment, Point
from lanewright.core.geometry import apart_m, distance_m, moved, readable_element
from lanewright.core.identity import joined
from lanewright.core.lateral import lateral_group
from lanewright.core.roadgraph import FINISH, START, Chain, Endpoint, Link

Cell = tuple[int, int]
"""A square of a grid, or the positions of two lanes in their chains."""
_MOST_AT_ONE_PLACE = 20
"""Chains that coincide with one chain; where there are more, the others show when these are settled."""
_MOST_PAIRED = 200
"""Lanes at one place that are looked at for each lane that was there."""
FAR_M = 3.0
"""A lane that no junction holds and that moved further than this is another lane."""


def coinciding_runs(comparison: Comparison) -> list[tuple[Chain, Chain]]:
    """Contiguous parts of a deleted and an inserted chain whose starts and ends coincide; only the largest."""
    return paired_runs(comparison, coinciding_ends)


def same_runs(comparison: Comparison) -> list[tuple[Chain, Chain]]:
    """Contiguous parts of a deleted and an inserted chain that lie on the same lines, however they are cut."""
    return [
        (deleted, inserted)
        for deleted, inserted in paired_runs(comparison, _same_corners)
        if _unmoved(comparison, deleted, inserted)
    ]


def _unmoved(comparison: Comparison, deleted: Chain, inserted: Chain) -> bool:
    was = joined([comparison.base.lanes[lane] for lane in deleted])
    now = joined([comparison.edited.lanes[lane] for lane in inserted])
    return not moved(was.left_boundary, now.left_boundary) and not moved(was.right_boundary, now.right_boundary)


def _same_corners(comparison: Comparison, end: int) -> list[tuple[int, int]]:
    """Pairs of a deleted and an inserted lane that start (finish) at the very same points, ascending."""
    by_corner: dict[tuple[Point, Point], list[int]] = {}
    for now in sorted(comparison.inserted_lanes):
        by_corner.setdefault(_corners(comparison.edited.lanes[now], end), []).append(now)
    return sorted(
        (was, now)
        for was in comparison.deleted_lanes
        for now in by_corner.get(_corners(comparison.base.lanes[was], end), ())[:_MOST_PAIRED]
        if readable_element(comparison.base.lanes[was])
    )


def _corners(lane: LaneSegment, end: int) -> tuple[Point, Point]:
    nowhere = (math.nan, math.nan, 0.0)
    left, right = ((*line[-end][:2], 0.0) if line else nowhere for line in (lane.left_boundary, lane.right_boundary))
    return left, right


def paired_runs(
    comparison: Comparison, ends: Callable[[Comparison, int], list[tuple[int, int]]]
) -> list[tuple[Chain, Chain]]:
    """The largest parts of a deleted and an inserted chain whose starts and finishes ``ends`` pairs up."""
    if not comparison.deleted_lanes or not comparison.inserted_lanes:
        return []
    deleted = _members(comparison.base_graph.chains(comparison.deleted_lanes))
    inserted = _members(comparison.edited_graph.chains(comparison.inserted_lanes))
    starts: dict[tuple[Chain, Chain], list[Cell]] = {}
    finishes: dict[tuple[Chain, Chain], list[Cell]] = {}
    for end, found in ((START, starts), (FINISH, finishes)):
        for was, now in ends(comparison, end):
            (one, i), (other, j) = deleted[was], inserted[now]
            found.setdefault((one, other), []).append((i, j))
    runs: list[tuple[Chain, Chain]] = []
    told: Counter[Chain] = Counter()
    for pair in sorted(starts.keys() & finishes.keys()):
        one, other = pair
        if max(told[one], told[other]) >= _MOST_AT_ONE_PLACE:
            continue
        told.update(pair)
        runs += [
            (one[i : k + 1], other[j : m + 1])
            for (i, j), (k, m) in _largest(_undominated(starts[pair], -1), _undominated(finishes[pair], 1))
        ]
    return runs


def _members(chains: tuple[Chain, ...]) -> dict[int, tuple[Chain, int]]:
    """Lane -> its chain, and where in it the lane is."""
    return {lane: (chain, index) for chain in chains for index, lane in enumerate(chain)}


def coinciding_ends(comparison: Comparison, end: int) -> list[tuple[int, int]]:
    """Pairs of a deleted and an inserted lane whose starts (finishes) are the same place, ascending."""
    survivors = comparison.surviving_lanes
    by_anchor: dict[Endpoint, list[int]] = {}
    by_cell: dict[Cell, list[int]] = {}
    for now in sorted(comparison.inserted_lanes):
        anchors = comparison.edited_graph.anchors((now, end), survivors)
        for anchor in anchors:
            by_anchor.setdefault(anchor, []).append(now)
        if not anchors and readable_element(comparison.edited.lanes[now]):
            by_cell.setdefault(_cell(comparison.edited_graph.location((now, end))), []).append(now)
    pairs: set[tuple[int, int]] = set()
    for was in comparison.deleted_lanes:
        anchors = comparison.base_graph.anchors((was, end), survivors)
        pairs.update((was, now) for anchor in anchors for now in by_anchor.get(anchor, ())[:_MOST_PAIRED])
        if not anchors and readable_element(comparison.base.lanes[was]):
            here = comparison.base_graph.location((was, end))
            x, y = _cell(here)
            pairs.update(
                (was, now)
                for cell in product((x - 1, x, x + 1), (y - 1, y, y + 1))
                for now in by_cell.get(cell, ())[:_MOST_PAIRED]
                if distance_m(here, comparison.edited_graph.location((now, end))) <= COINCIDENT_M
            )
    return sorted(pairs)


def _cell(place: Point) -> Cell:
    return (math.floor(place[0] / COINCIDENT_M), math.floor(place[1] / COINCIDENT_M))


def _undominated(cells: list[Cell], sign: int) -> list[Cell]:
    """Of starts (sign -1) those that no other lies before in both chains; of ends (sign 1) those none lies beyond."""
    kept: list[Cell] = []
    for i, j in sorted(set(cells), key=lambda cell: (-sign * cell[0], -sign * cell[1])):
        if not kept or sign * j > max(sign * other for _, other in kept):
            kept.append((i, j))
    return kept


def _largest(starts: list[Cell], finishes: list[Cell]) -> list[tuple[Cell, Cell]]:
    parts = [
        (start, finish) for start in starts for finish in finishes if start[0] <= finish[0] and start[1] <= finish[1]
    ]
    return [one for one in parts if not any(other != one and _within(one, other) for other in parts)]


def _within(one: tuple[Cell, Cell], other: tuple[Cell, Cell]) -> bool:
    (start, finish), (first, last) = one, other
    return first[0] <= start[0] and first[1] <= start[1] and finish[0] <= last[0] and finish[1] <= last[1]


def unjustified_crossings(comparison: Comparison) -> list[tuple[int, int]]:
    """Deleted and inserted crossings that overlap so far that they are one, ascending."""
    if not comparison.deleted_crossings or not comparison.inserted_crossings:
        return []
    inserted = {now: comparison.shape(crossing_key(now), edited=True) for now in comparison.inserted_crossings}
    areas = CrossingAreas(inserted)
    return [
        (was, now)
        for was in sorted(comparison.deleted_crossings)
        for now in areas.near(comparison.shape(crossing_key(was), edited=False))
        if same_crossing(comparison.shape(crossing_key(was), edited=False), inserted[now])
    ]


def rerouted_links(comparison: Comparison) -> list[Link]:
    """Links between survivors that come or go and with it join or part their endpoints."""
    return [link for link, _ in comparison.changed_links if rerouted(comparison, link)]


def rerouted(comparison: Comparison, link: Link) -> bool:
    """Whether the two linked endpoints come to share a vertex or cease to, and no lane merely keeps its function."""
    finish, start = (link[0], FINISH), (link[1], START)
    survivors = comparison.surviving_lanes
    was = start in comparison.base_graph.vertex(finish, survivors)
    now = start in comparison.edited_graph.vertex(finish, survivors)
    return was != now and not any(comparison.keeps_function(lane) for lane in link)


def displaced_lanes(comparison: Comparison) -> Iterator[int]:
    """Survivors more than 3 m away that no junction holds and that do not merely keep their function."""
    for lane in comparison.differing_lanes:
        if any(comparison.moved_sides(lane)) and not held(comparison, lane):
            was, now = (comparison.shape(lane_key(lane), edited=edited) for edited in (False, True))
            if apart_m(was, now) > FAR_M and not comparison.keeps_function(lane):
                yield lane


def held(comparison: Comparison, lane: int) -> bool:
    """Whether an end shares its vertex with the same survivor's endpoint in base and edited map."""
    return any(
        not comparison.held_by((lane, end), edited=False).isdisjoint(comparison.held_by((lane, end), edited=True))
        for end in (START, FINISH)
    )


def exchanged_lanes(comparison: Comparison) -> list[tuple[int, int]]:
    """Pairs of survivors whose order from left to right in a lateral group is reversed."""
    found: set[tuple[int, int]] = set()
    seen: set[int] = set()
    for lane in comparison.differing_lanes:
        if lane in seen:
            continue
        group = lateral_group(comparison.edited.lanes, lane)
        seen.update(group)
        survivors = [member for member in group if member in comparison.surviving_lanes]
        if len(survivors) < 2:
            continue
        rank = {member: index for index, member in enumerate(survivors)}
        left = set(survivors)
        while left:
            before = lateral_group(comparison.base.lanes, left.pop())
            left.difference_update(before)
            found.update(
                (min(one, other), max(one, other))
                for one, other in combinations([member for member in before if member in rank], 2)
                if rank[one] > rank[other]
            )
    return sorted(found)


def displaced_crossings(comparison: Comparison) -> Iterator[int]:
    """Surviving crossings that overlap their old place by less than 0.3 of the union."""
    for crossing in comparison.differing_crossings:
        key = crossing_key(crossing)
        if comparison.crossing_moved(crossing) and not same_crossing(
            comparison.shape(key, edited=False), comparison.shape(key, edited=True)
        ):
            yield crossing


def preserved_chains(comparison: Comparison) -> list[tuple[Chain, Chain]]:
    """Deleted and inserted chains with a pair of intersection lanes of equal function."""
    return _preserved_runs(comparison, comparison.deleted_lanes, comparison.inserted_lanes)


def preserved_turns(comparison: Comparison) -> list[tuple[Chain, Chain]]:
    """Deleted and inserted runs inside an intersection with a pair of lanes of equal function."""
    deleted = {lane for lane in comparison.deleted_lanes if comparison.base.lanes[lane].is_intersection}
    inserted = {lane for lane in comparison.inserted_lanes if comparison.edited.lanes[lane].is_intersection}
    return _preserved_runs(comparison, deleted, inserted)


def _preserved_runs(
    comparison: Comparison, deleted: Collection[int], inserted: Collection[int]
) -> list[tuple[Chain, Chain]]:
    pairs = {
        (
            comparison.base_graph.chain_through(was, deleted),
            comparison.edited_graph.chain_through(now, inserted),
        )
        for was, now in preserved_lanes(comparison)
    }
    return sorted(pairs)


def preserved_lanes(comparison: Comparison) -> list[tuple[int, int]]:
    """Deleted and inserted intersection lanes of equal function, ascending."""
    if not comparison.deleted_lanes or not comparison.inserted_lanes:
        return []
    by_approach: dict[int, set[int]] = {}
    for now in comparison.inserted_lanes:
        for lane in _approached_from(comparison, now, edited=True):
            by_approach.setdefault(lane, set()).add(now)
    return sorted(
        (was, now)
        for was in comparison.deleted_lanes
        for now in set().union(*(by_approach.get(lane, ()) for lane in _approached_from(comparison, was, edited=False)))
        if comparison.equal_function(was, now)
    )


def _approached_from(comparison: Comparison, lane: int, *, edited: bool) -> set[int]:
    """The survivors that approach an intersection lane, and those beside them: lanes of equal function share some."""
    function = comparison.function(lane, edited=edited)
    approaches = function.approaches if function else ()
    return {beside for access in approaches for beside in access.group if beside in comparison.surviving_lanes}
