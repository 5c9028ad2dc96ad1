"""Which lanes must go anew where links were re-routed (spec §5, the fix of ``identity.rerouted``)."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from itertools import combinations, islice

from lanewright.core.alignment import categories_between, displacement_m
from lanewright.core.assignment import Assignment
from lanewright.core.comparison import Comparison
from lanewright.core.elements import LaneSegment
from lanewright.core.geometry import readable_element
from lanewright.core.places import coinciding_runs, preserved_chains, rerouted_links
from lanewright.core.roadgraph import FINISH, START, Chain, Link

_MOST_CANDIDATES = 9
_MOST_TRIALS = 100
"""Sets of lanes tried at one place; the first one mostly does."""


def replaced_lanes(assignment: Assignment, comparison: Comparison, links: Collection[Link]) -> tuple[int, ...]:
    """The fewest lanes whose replacement is legal and makes the survivors' vertices agree; among equals those that
    leave the fewest changed categories, then the least displacement (spec §6), then the one inside the intersection,
    then the downstream one (spec §5).

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
    best: tuple[int, float, int] | None = None
    found = covering[0] if covering else tuple(candidates)
    for index, chosen in enumerate(islice(covering, _MOST_TRIALS)):
        if best is not None and len(chosen) > len(found):
            break
        trial = _trial(assignment, links, chosen)
        if trial is not None:
            cost = (*_left_to_tell(trial, [lane for lane in candidates if lane not in chosen]), index)
            if best is None or cost < best:
                best, found = cost, chosen
    return found


def _connected(links: list[Link]) -> list[Link]:
    """The links that hang together with the first one by their lanes."""
    lanes = set(links[0])
    while True:
        found = [link for link in links if not lanes.isdisjoint(link)]
        grown = lanes.union(*found)
        if grown == lanes:
            return found
        lanes = grown


def _trial(assignment: Assignment, links: Iterable[Link], chosen: Chain) -> Comparison | None:
    """The maps with those lanes replaced, if nothing speaks against it: the links agree, and none of them keeps its
    place or its function."""
    trial = assignment.copied()
    trial.part(chosen)
    comparison = trial.comparison()
    if not set(links).isdisjoint(rerouted_links(comparison)):
        return None
    gone = set(chosen)
    kept = any(
        not gone.isdisjoint(deleted) and any((now, was) in trial.banned for was in deleted for now in inserted)
        for find in (coinciding_runs, preserved_chains)
        for deleted, inserted in find(comparison)
    )
    return None if kept else comparison


def _left_to_tell(comparison: Comparison, lanes: Collection[int]) -> tuple[int, float]:
    """Changed categories of the lanes that stay (parts of a cut lane go together), and how far they moved in all."""
    categories = len({lane for link, _ in comparison.changed_links for lane in link})
    displacement = 0.0
    for lane in sorted(comparison.surviving_lanes.intersection(lanes)):
        was, now = comparison.base.lanes[lane], comparison.edited.lanes[lane]
        categories += categories_between(was, now)
        displacement += _displacement_m(was, now)
    return categories, round(displacement, 6)


def _preference(comparison: Comparison, links: Collection[Link], lane: int) -> tuple[bool, float, bool, int]:
    was, now = comparison.base.lanes[lane], comparison.edited.lanes[lane]
    return (
        not now.is_intersection,
        -round(_displacement_m(was, now), 6),
        not any(link[1] == lane for link in links),
        lane,
    )


def _displacement_m(was: LaneSegment, now: LaneSegment) -> float:
    return displacement_m(was, now) if readable_element(was) and readable_element(now) else 0.0
