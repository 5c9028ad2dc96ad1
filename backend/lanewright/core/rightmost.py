"""The right-hand-side rule (spec §5; paper A.5): where it is unclear which lane is new, it is the rightmost.

Written for insertions; a deletion is the insertion of the inverse update.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from lanewright.core.comparison import COINCIDENT_M, Comparison, lane_key
from lanewright.core.geometry import apart_m, centreline, readable_element
from lanewright.core.lateral import right_of
from lanewright.core.places import FAR_M
from lanewright.core.roadgraph import FINISH, START, Chain, Endpoint


def ambiguous_insertions(comparison: Comparison) -> Iterator[tuple[Chain, Chain]]:
    """Inserted chains that could exchange identities with survivors to their right: the chain, and those survivors."""
    if not comparison.inserted_lanes:
        return
    for chain in comparison.edited_graph.chains(comparison.inserted_lanes):
        partner = exchangeable_run(comparison, chain)
        if partner is not None:
            yield chain, partner


def exchangeable_run(comparison: Comparison, chain: Chain) -> Chain | None:
    """The first run of as many survivors, beside and to the right of the chain, with which it could exchange ids."""
    for lane in chain:
        survivor = _survivor_to_the_right(comparison, lane)
        if survivor is None or not comparison.moved_sides(survivor)[0]:
            continue
        for part in _parts_holding(comparison, survivor, len(chain)):
            if _exchangeable(comparison, chain, part):
                return part
    return None


def _survivor_to_the_right(comparison: Comparison, lane: int) -> int | None:
    """The nearest survivor to the right in the lateral group."""
    seen = {lane}
    other = right_of(comparison.edited.lanes, lane)
    while other is not None and other not in comparison.surviving_lanes and other not in seen:
        seen.add(other)
        other = right_of(comparison.edited.lanes, other)
    return other if other in comparison.surviving_lanes else None


def _parts_holding(comparison: Comparison, survivor: int, count: int) -> Iterator[Chain]:
    """Contiguous parts of that many lanes, holding the survivor, of the changed survivors in series through it."""
    reshaped = {lane for lane in comparison.differing_lanes if any(comparison.moved_sides(lane))}
    run = comparison.edited_graph.chain_through(survivor, reshaped)
    at = run.index(survivor)
    for first in range(max(0, at - count + 1), min(at, len(run) - count) + 1):
        yield run[first : first + count]


def _exchangeable(comparison: Comparison, chain: Chain, part: Chain) -> bool:
    others = comparison.surviving_lanes.difference(part)
    graph = comparison.edited_graph
    free_ends = 0
    for one, other, end in ((chain[0], part[0], START), (chain[-1], part[-1], FINISH)):
        held, also_held = (graph.anchors((lane, end), others) for lane in (one, other))
        if held != also_held:
            return False
        if not held and along_m(comparison, (one, end), (other, end)) > COINCIDENT_M:
            return False
        free_ends += not held
    return free_ends < 2 or not any(_displaced(comparison, *pair) for pair in zip(chain, part, strict=True))


def _displaced(comparison: Comparison, inserted: int, survivor: int) -> bool:
    """Whether an inserted lane would be too far away to be a survivor that nothing holds."""
    now, was = comparison.shape(lane_key(inserted), edited=True), comparison.shape(lane_key(survivor), edited=False)
    return apart_m(was, now) > FAR_M


def along_m(comparison: Comparison, one: Endpoint, other: Endpoint) -> float:
    """How far apart two ends lie in the direction of the second lane there."""
    lanes = comparison.edited.lanes
    if not (readable_element(lanes[one[0]]) and readable_element(lanes[other[0]])):
        return float("inf")
    middle = centreline(lanes[other[0]])
    ahead = middle[2] - middle[0] if other[1] == START else middle[-1] - middle[-3]
    here, there = (comparison.edited_graph.location(end)[:2] for end in (one, other))
    length = float(np.hypot(*ahead))
    return abs(float(np.dot(np.subtract(here, there), ahead))) / length if length > 0 else float("inf")
