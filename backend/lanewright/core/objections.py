"""Whose ids a rule of identity objects to (spec §5); the findings are those that the rules tell."""

from __future__ import annotations

from itertools import chain

from lanewright.core.comparison import Comparison, crossing_key, lane_key
from lanewright.core.elements import ElementKey
from lanewright.core.places import (
    coinciding_runs,
    displaced_crossings,
    displaced_lanes,
    exchanged_lanes,
    preserved_chains,
    rerouted_links,
    unjustified_crossings,
)
from lanewright.core.rightmost import ambiguous_insertions


def objected(comparison: Comparison) -> frozenset[ElementKey]:
    """The lanes and crossings that a rule of identity names."""
    lanes = {
        *displaced_lanes(comparison),
        *chain.from_iterable(exchanged_lanes(comparison)),
        *chain.from_iterable(rerouted_links(comparison)),
    }
    replaced = (*coinciding_runs(comparison), *preserved_chains(comparison))
    lanes.update(lane for pair in replaced for run in pair for lane in run)
    for one in (comparison, comparison.inverse):
        lanes.update(lane for run, _ in ambiguous_insertions(one) for lane in run)
    crossings = {*displaced_crossings(comparison), *chain.from_iterable(unjustified_crossings(comparison))}
    return frozenset({*map(lane_key, lanes), *map(crossing_key, crossings)})
