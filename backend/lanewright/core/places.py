"""Where places in the road graph persist although ids do not, and where ids persist although places do not (spec §5).

The findings behind the rules of identity, as lanes and chains; the canonical form uses the same ones.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import shapely

from lanewright.core.comparison import Comparison, crossing_key, lane_key, same_crossing
from lanewright.core.lateral import lateral_group
from lanewright.core.roadgraph import FINISH, START, Chain, Link

FAR_M = 3.0
"""A lane that no junction holds and that moved further than this is another lane."""


def coinciding_runs(comparison: Comparison) -> list[tuple[Chain, Chain]]:
    """Contiguous parts of a deleted and an inserted chain whose starts and ends coincide; only the largest."""
    found: list[tuple[Chain, Chain]] = []
    if not comparison.deleted_lanes or not comparison.inserted_lanes:
        return found
    for deleted in comparison.base_graph.chains(comparison.deleted_lanes):
        for inserted in comparison.edited_graph.chains(comparison.inserted_lanes):
            found += coinciding_parts(comparison, deleted, inserted)
    return found


def coinciding_parts(comparison: Comparison, deleted: Chain, inserted: Chain) -> list[tuple[Chain, Chain]]:
    """The largest coinciding parts of two chains, none within another."""
    starts = _pairs(comparison, deleted, inserted, START)
    finishes = _pairs(comparison, deleted, inserted, FINISH) if starts else []
    parts = [((i, k), (j, m)) for i, j in starts for k, m in finishes if i <= k and j <= m]
    largest = [one for one in parts if not any(other != one and _within(one, other) for other in parts)]
    return [(deleted[i : k + 1], inserted[j : m + 1]) for (i, k), (j, m) in largest]


def _pairs(comparison: Comparison, deleted: Chain, inserted: Chain, end: int) -> list[tuple[int, int]]:
    return [
        (i, j)
        for i, was in enumerate(deleted)
        for j, now in enumerate(inserted)
        if comparison.coincide((was, end), (now, end))
    ]


def _within(one: tuple[tuple[int, int], tuple[int, int]], other: tuple[tuple[int, int], tuple[int, int]]) -> bool:
    return all(large[0] <= small[0] and small[1] <= large[1] for small, large in zip(one, other, strict=True))


def unjustified_crossings(comparison: Comparison) -> list[tuple[int, int]]:
    """Deleted and inserted crossings that overlap so far that they are one."""
    return [
        (was, now)
        for was in sorted(comparison.deleted_crossings)
        for now in sorted(comparison.inserted_crossings)
        if same_crossing(
            comparison.shape(crossing_key(was), edited=False), comparison.shape(crossing_key(now), edited=True)
        )
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
            if shapely.distance(was, now) > FAR_M and not comparison.keeps_function(lane):
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
    deleted = [lane for lane in sorted(comparison.deleted_lanes) if comparison.base.lanes[lane].is_intersection]
    inserted = [lane for lane in sorted(comparison.inserted_lanes) if comparison.edited.lanes[lane].is_intersection]
    pairs = {
        (
            comparison.base_graph.chain_through(was, comparison.deleted_lanes),
            comparison.edited_graph.chain_through(now, comparison.inserted_lanes),
        )
        for was in deleted
        for now in inserted
        if comparison.equal_function(was, now)
    }
    return sorted(pairs)
