"""Settling an assignment: one step after the other until no rule of identity is broken (spec §5, §6)."""

from __future__ import annotations

from itertools import pairwise

from lanewright.core.assignment import Assignment
from lanewright.core.beside import LanesBeside
from lanewright.core.comparison import COINCIDENT_M, Comparison, crossing_key
from lanewright.core.elements import LaneSegment
from lanewright.core.geometry import distance_m, end_midpoint, overlap, readable_element
from lanewright.core.identity import one_road
from lanewright.core.loose_ends import freed_runs, lengthened_runs, outgrown_runs
from lanewright.core.places import (
    coinciding_runs,
    displaced_crossings,
    displaced_lanes,
    exchanged_lanes,
    preserved_lanes,
    preserved_turns,
    rerouted_links,
    same_runs,
    unjustified_crossings,
)
from lanewright.core.replacement import replaced_lanes
from lanewright.core.rightmost import ambiguous_insertions
from lanewright.core.roadgraph import FINISH, START, Chain, Endpoint
from lanewright.core.run_matching import match_runs
from lanewright.core.series import Run

_MOST_STEPS = 400
"""A settled map takes a few steps, and seldom one more for a lane; the bound only guards against maps made to have no
end."""


def settle(assignment: Assignment) -> None:
    """Match, part and exchange until no step applies."""
    for _ in range(_MOST_STEPS + len(assignment.drawn)):
        comparison = assignment.comparison()
        if not any(step(assignment, comparison) for step in _STEPS):
            return


def _match_same_lines(assignment: Assignment, comparison: Comparison) -> bool:
    """Runs on the same lines are the same lanes, however they are cut."""
    return match_runs(assignment, comparison, same_runs(comparison))


def _part_displaced(assignment: Assignment, comparison: Comparison) -> bool:
    """Lanes and crossings that are matched too far away are parted."""
    parted = assignment.part(displaced_lanes(comparison))
    tokens = {matched: token for token, matched in assignment.crossings.items() if token != matched}
    for crossing in displaced_crossings(comparison):
        if crossing in tokens:
            assignment.banned.add((tokens[crossing], crossing))
            del assignment.crossings[tokens[crossing]]
            parted = True
    return parted


def _part_rerouted(assignment: Assignment, comparison: Comparison) -> bool:
    """The fewest lanes whose removal makes the survivors' vertices agree are parted."""
    links = rerouted_links(comparison)
    free = {lane for link in links for lane in link if assignment.is_free([lane])}
    links = [link for link in links if not free.isdisjoint(link)]
    return bool(links) and assignment.part(replaced_lanes(assignment, comparison, links))


def _uncross(assignment: Assignment, comparison: Comparison) -> bool:
    """Lanes side by side whose order was reversed exchange what they stand for."""
    tokens = assignment.tokens
    seen = set(assignment.parts)
    for pair in exchanged_lanes(comparison):
        if assignment.is_free(pair) and seen.isdisjoint(pair):
            seen.update(pair)
            one, other = pair
            assignment.lanes[tokens[one]], assignment.lanes[tokens[other]] = other, one
    return len(seen) > len(assignment.parts)


def _match_places(assignment: Assignment, comparison: Comparison) -> bool:
    """Lanes lengthened or shortened where nothing joins them, runs that took the place of a deleted chain, and turns
    that kept their function take the old ids: turns together with what is in series with them inside the intersection,
    else by themselves. The lengthened come first, with all that was drawn up to the loose end: otherwise a joint that
    happens to be near the old end would tell another story."""
    lanes = (((was,), (now,)) for was, now in preserved_lanes(comparison))
    return (
        match_runs(assignment, comparison, lengthened_runs(comparison), cut=False)
        or match_runs(assignment, comparison, coinciding_runs(comparison))
        or match_runs(assignment, comparison, preserved_turns(comparison), cut=False)
        or match_runs(assignment, comparison, lanes)
    )


def _match_freed(assignment: Assignment, comparison: Comparison) -> bool:
    """Lanes lengthened or shortened where all that held them went."""
    return match_runs(assignment, comparison, freed_runs(comparison), cut=False)


def _part_anchors(assignment: Assignment, comparison: Comparison) -> bool:
    """Where a lane that had to be replaced still stands between the same junctions, since two junctions became one (or
    one two), the survivors that hold it at the junction that changed are replaced along with it."""
    survivors = comparison.surviving_lanes
    for deleted, inserted in coinciding_runs(comparison):
        if not any((now, was) in assignment.banned for was in deleted for now in inserted):
            continue
        for was, now, end in ((deleted[0], inserted[0], START), (deleted[-1], inserted[-1], FINISH)):
            before = comparison.base_graph.anchors((was, end), survivors)
            after = comparison.edited_graph.anchors((now, end), survivors)
            if before != after and assignment.part(sorted({lane for lane, _ in before & after})):
                return True
    return False


def _match_crossings(assignment: Assignment, comparison: Comparison) -> bool:
    """A deleted and an inserted crossing that overlap become one, those that overlap most first."""
    pairs = [
        pair
        for pair in unjustified_crossings(comparison)
        if pair[::-1] not in assignment.banned and all(map(assignment.is_free_crossing, pair))
    ]
    matched: set[int] = set()
    for was, now in sorted(pairs, key=lambda pair: (-_crossing_overlap(comparison, pair), pair)):
        if matched.isdisjoint((was, now)):
            matched.update((was, now))
            assignment.crossings[now] = was
    return bool(matched)


def _crossing_overlap(comparison: Comparison, pair: tuple[int, int]) -> float:
    was, now = pair
    return round(
        overlap(comparison.shape(crossing_key(was), edited=False), comparison.shape(crossing_key(now), edited=True)), 6
    )


def _keep_right(assignment: Assignment, comparison: Comparison) -> bool:
    """An insertion that could as well be the lane on its right is; likewise a deletion."""
    tokens = assignment.tokens
    for chain, survivors in ambiguous_insertions(comparison):
        pairs = list(zip(chain, survivors, strict=True))
        if _may_exchange(assignment, chain, survivors) and assignment.banned.isdisjoint(pairs):
            for inserted, survivor in pairs:
                assignment.lanes[inserted] = survivor
                del assignment.lanes[tokens[survivor]]
            return True
    for chain, survivors in ambiguous_insertions(comparison.inverse):
        if not _may_exchange(assignment, chain, survivors):
            continue
        pairs = [(tokens[survivor], deleted) for deleted, survivor in zip(chain, survivors, strict=True)]
        if assignment.banned.isdisjoint(pairs):
            assignment.lanes.update(pairs)
            return True
    return False


def _may_exchange(assignment: Assignment, chain: Chain, survivors: Chain) -> bool:
    return assignment.is_free([*chain, *survivors]) and assignment.parts.keys().isdisjoint(survivors)


def _join_inserted(assignment: Assignment, comparison: Comparison) -> bool:
    """Inserted lanes in series become one where nothing differs between them and no lane beside them ends there."""
    beside = LanesBeside(comparison)
    joined = False
    for chain in comparison.edited_graph.chains(comparison.inserted_lanes):
        for one, other in pairwise(chain):
            pair = [comparison.edited.lanes[lane] for lane in (one, other)]
            if (
                one_road(*pair)
                and assignment.is_free([one, other])
                and all(map(readable_element, pair))
                and not _ends_beside(beside, *pair)
            ):
                assignment.join(one, other)
                joined = True
                break
    return joined


def _keep_to_loose_ends(assignment: Assignment, comparison: Comparison) -> bool:
    """Where the road goes on beyond a lane's loose end, the lane is kept up to there: up to the next joint of what was
    drawn, else up to where it ended, and what was drawn is cut there."""
    for deleted, inserted, end in outgrown_runs(comparison):
        lane = inserted[-1 if end == FINISH else 0]
        if (
            comparison.edited_graph.next_in_series(lane, comparison.inserted_lanes)
            if end == FINISH
            else (comparison.edited_graph.previous_in_series(lane, comparison.inserted_lanes))
        ):
            if match_runs(assignment, comparison, [(deleted, inserted)], cut=False):
                return True
            continue
        pieces = _pieces_at(comparison, (deleted[-1 if end == FINISH else 0], end), lane)
        banned = any((token, was) in assignment.banned for token in inserted for was in deleted)
        if pieces and not banned and assignment.is_free([*deleted, *inserted]):
            assignment.cut(lane, pieces, 0 if end == FINISH else 1)
            return True
    return False


def _pieces_at(comparison: Comparison, tip: Endpoint, lane: int) -> list[LaneSegment]:
    """An inserted lane cut where a deleted one ended, if there is another place on either side of the cut."""
    was, end = comparison.base.lanes[tip[0]], tip[1]
    whole = Run.of([comparison.edited.lanes[lane]])
    station = whole.station_of(was.left_boundary[-end], was.right_boundary[-end])
    if not all(COINCIDENT_M < here < there - COINCIDENT_M for here, there in zip(station, whole.ends, strict=True)):
        return []
    pieces = whole.pieces([station])
    there = end_midpoint(pieces[0], FINISH)
    return pieces if distance_m(there, end_midpoint(was, end)) <= COINCIDENT_M else []


def _ends_beside(beside: LanesBeside, one: LaneSegment, other: LaneSegment) -> bool:
    """Whether a third lane ends at the joint of two: their segmentation follows it."""
    pair, whole = (one.id, other.id), Run.of([one, other]).whole
    return beside.end_at(one.left_boundary[-1][:2], whole.left_boundary, pair) or beside.end_at(
        one.right_boundary[-1][:2], whole.right_boundary, pair
    )


def _cut_beside(assignment: Assignment, comparison: Comparison) -> bool:
    """Inserted lanes are cut where lanes beside them end."""
    beside = LanesBeside(comparison)
    cut = False
    for lane in sorted(comparison.inserted_lanes):
        whole = comparison.edited.lanes[lane]
        if assignment.is_free([lane]) and lane not in assignment.parts and readable_element(whole):
            joints = beside.joints_of(whole)
            if joints:
                assignment.cut(lane, Run.of([whole]).pieces(joints), 0)
                cut = True
    return cut


_STEPS = (
    _match_same_lines,
    _part_displaced,
    _part_rerouted,
    _uncross,
    _match_places,
    _part_anchors,
    _match_crossings,
    _keep_to_loose_ends,
    _match_freed,
    _join_inserted,
    _cut_beside,
    _keep_right,
)
