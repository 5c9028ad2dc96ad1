"""Which lanes must go anew where links were re-routed (spec §5, the fix of ``identity.rerouted``)."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from itertools import combinations, islice

from lanewright.core.alignment import displacement_m
from lanewright.core.assignment import Assignment
from lanewright.core.comparison import Comparison
from lanewright.core.geometry import readable_element
from lanewright.core.places import coinciding_runs, preserved_chains, rerouted_links
from lanewright.core.roadgraph import FINISH, START, Chain, Link

_MOST_CANDIDATES = 9
_MOST_TRIALS = 100
"""Sets of lanes tried at one place; the first one mostly does."""


def replaced_lanes(assignment: Assignment, comparison: Comparison, links: Collection[Link]) -> tuple[int, ...]:
    """The fewest lanes whose replacement is legal and makes the survivors' vertices agree; among equals the one inside
    the intersection, then the one that moved most, then the downstream one.

    Places are settled one by one: the lanes at the vertices of the first link and of those that share a lane with it.
    """
    links = _connected(sorted(links))
    ends = {end for upstream, downstream in links for end in ((upstream, FINISH), (downstream, START))}
    named = {lane for link in links for lane in link}
    beside = {lane for end in ends for edited in (False, True) for lane, _ in comparison.held_by(end, edited=edited)}
    candidates = [
        lane
        for group in (named, beside - named)
        for lane in sorted(group, key=lambda lane: _preference(comparison, links, lane))
        if assignment.is_free([lane])
    ][:_MOST_CANDIDATES]
    covering = [
        chosen
        for count in range(1, len(candidates) + 1)
        for chosen in combinations(candidates, count)
        if all(link[0] in chosen or link[1] in chosen for link in links)
    ]
    for chosen in islice(covering, _MOST_TRIALS):
        if _is_legal(assignment, links, chosen):
            return chosen
    return covering[0] if covering else tuple(candidates)


def _connected(links: list[Link]) -> list[Link]:
    """The links that hang together with the first one by their lanes."""
    lanes = set(links[0])
    while True:
        found = [link for link in links if not lanes.isdisjoint(link)]
        grown = lanes.union(*found)
        if grown == lanes:
            return found
        lanes = grown


def _is_legal(assignment: Assignment, links: Iterable[Link], chosen: Chain) -> bool:
    """Whether nothing speaks against replacing those lanes: the links agree, and none of them keeps its place or its
    function."""
    trial = assignment.copied()
    trial.part(chosen)
    comparison = trial.comparison()
    if not set(links).isdisjoint(rerouted_links(comparison)):
        return False
    gone = set(chosen)
    return not any(
        not gone.isdisjoint(deleted) and any((now, was) in trial.banned for was in deleted for now in inserted)
        for find in (coinciding_runs, preserved_chains)
        for deleted, inserted in find(comparison)
    )


def _preference(comparison: Comparison, links: Collection[Link], lane: int) -> tuple[bool, float, bool, int]:
    was, now = comparison.base.lanes[lane], comparison.edited.lanes[lane]
    moved = displacement_m(was, now) if readable_element(was) and readable_element(now) else 0.0
    return (
        not now.is_intersection,
        -round(moved, 6),
        not any(link[1] == lane for link in links),
        lane,
    )
