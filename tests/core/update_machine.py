"""A map update as a hypothesis state machine: legal edits, other ways to write their outcome, and the properties of
the change mapping (spec §6) after every step.

Each step takes a seed, so that a failing sequence can be read, and run again, as it is printed.
"""

from __future__ import annotations

import math
from collections import Counter
from functools import cache
from random import Random

from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule
from tests.core.rewriting import REWRITES, Rewrite
from tests.core.roadworks import ALL_EDITS
from tests.core.street_maps import random_map
from tests.core.worlds import REAL_MAPS, real_map

from lanewright.core.canonical import canonical_map, canonical_updates, canonicalise, lengthening_updates
from lanewright.core.changes import Category
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff, invert
from lanewright.core.edits import apply_edits
from lanewright.core.elements import MapState, Point
from lanewright.core.geometry import lines_of
from lanewright.core.replay import replayed
from lanewright.core.restore import restore
from lanewright.core.rules import check, findings
from lanewright.demo import build_map

IDENTITY = ("identity.", "replacement.", "insertion.", "deletion.")
WHOLE_CHANGES = {Category.INSERTION, Category.DELETION}
MOST_FIXES = 6
STEPS = 6
WHOLE = 10**6
seeds = st.integers(0, 10**6)
sizes = st.sampled_from((4, 8, 8, 16, 16, 16, 32, 32, 64, WHOLE))
"""Lanes in a part of a map; in whole maps edits rarely meet."""


class MapUpdate(RuleBasedStateMachine):
    """One map update. ``edited`` is what the annotator drew, ``written`` the same map written in another way."""

    def begin(self, base: MapState) -> None:
        self.base = base
        self._draw(base)

    def _draw(self, edited: MapState) -> None:
        self.edited = edited
        self._write(edited)
        self.canonical_of_edited = self.canonical

    def _write(self, written: MapState) -> None:
        """What several properties look at is derived once a step."""
        self.written = written
        self.found = diff(self.base, written)
        self.violations = check(self.base, written)
        self.canonical = canonicalise(self.base, written)

    @rule(change=st.sampled_from(ALL_EDITS), seed=seeds)
    def edit(self, change: Rewrite, seed: int) -> None:
        self._draw(change(Random(seed), self.edited))

    @rule(way=st.sampled_from(REWRITES), seed=seeds)
    def write_differently(self, way: Rewrite, seed: int) -> None:
        self._write(way(Random(seed), self.written))

    @invariant()
    def properties_hold(self) -> None:
        self._the_diff_brings_either_map_back()
        self._every_difference_is_a_change_in_an_update_with_a_macro()
        self._an_unchanged_element_is_bit_identical_to_the_base()
        self._a_check_of_what_changed_is_the_full_check()
        self._a_fix_removes_its_violation_and_adds_none()
        self._one_map_has_one_explanation()
        self._what_no_rule_objects_to_is_canonical()
        self._the_canonical_form_is_the_same_map()

    def _the_diff_brings_either_map_back(self) -> None:
        inverse = invert(self.found)
        assert diff(replayed(self.base, self.found), self.written).changes == ()
        assert diff(replayed(self.written, inverse), self.base).changes == ()
        assert inverse == diff(self.written, self.base)

    def _every_difference_is_a_change_in_an_update_with_a_macro(self) -> None:
        assert bool(self.found.changes) == (restore(self.base, self.written) != self.base)
        in_updates = [element for update in self.found.updates for element in update.elements]
        assert sorted(in_updates) == [change.key for change in self.found.changes]
        for update in self.found.updates:
            macros = update.macros
            assert macros.shape or macros.appearance or macros.function or macros.lane_graph or macros.lane_number

    def _an_unchanged_element_is_bit_identical_to_the_base(self) -> None:
        """Its lines to the last bit and the height; a lane may name others that came or went."""
        restored = restore(self.base, self.written)
        assert restore(self.base, restored) == restored
        changed = {change.key for change in diff(self.base, restored).changes}
        for element in restored:
            if element.key not in changed:
                known = self.base.get(element.key)
                assert known is not None
                assert lines_of(element) == lines_of(known)

    def _a_check_of_what_changed_is_the_full_check(self) -> None:
        """The base is looked at once and remembered; copies of both maps that nothing is known of are judged alike."""
        copies = [MapState.of(list(state)) for state in (self.base, self.written)]
        assert check(*copies) == self.violations

    def _a_fix_removes_its_violation_and_adds_none(self) -> None:
        """A line that only a person can redraw (``geometry.invalid``) stays bad, under the lane's new id."""
        introduced = [one for one in self.violations if not one.inherited]
        before = {one.id for one in introduced}
        for violation in introduced[:MOST_FIXES]:
            assert violation.fixes or violation.code == "geometry.invalid"
            for fix in violation.fixes:
                left = findings(Comparison(self.base, apply_edits(self.written, fix.edits)))
                assert violation.id not in {one.id for one in left}
                added = [one.id for one in left if not one.inherited and one.id not in before]
                assert all(one.startswith("geometry.invalid:") for one in added)
                if fix.title.startswith("Make"):
                    assert ";" in fix.title or same_road(self.written, apply_edits(self.written, fix.edits))

    def _one_map_has_one_explanation(self) -> None:
        assert told(self.base, self.canonical) == told(self.base, self.canonical_of_edited)
        assert canonicalise(self.base, self.canonical) == self.canonical
        left = findings(Comparison(self.base, self.canonical))
        assert not [one.id for one in left if one.code.startswith(IDENTITY) and not one.inherited]

    def _what_no_rule_objects_to_is_canonical(self) -> None:
        """A map without a finding is saved as the one story, or as a shorter one than the canonical form knows (where
        there is an error, the save is refused, and the note would only stand beside it)."""
        if all(one.inherited for one in self.violations):
            comparison = Comparison(self.base, self.written)
            saved = canonical_updates(comparison, lengthening_updates(comparison)).edited
            written, canonical = told(self.base, saved), told(self.base, self.canonical)
            assert written == canonical or length(written) < length(canonical)

    def _the_canonical_form_is_the_same_map(self) -> None:
        """Up to ids and cuts in series, that is: as an update of the written map it changes nothing. Nor does what the
        workspace and the command line make of it, update by update."""
        assert same_road(self.written, self.canonical)
        assert same_road(self.written, canonical_map(Comparison(self.base, self.written)).edited)


def same_road(one: MapState, other: MapState) -> bool:
    """Whether two maps are the same up to ids and cuts in series."""
    return diff(one, canonicalise(one, other)).changes == ()


def told(base: MapState, edited: MapState) -> Counter[tuple[object, ...]]:
    """The changes, up to the ids of what is new."""
    return Counter(
        (change.kind, change.id if change.key in base else "new", change.categories, change.leaves)
        for change in diff(base, edited).changes
    )


def length(story: Counter[tuple[object, ...]]) -> tuple[int, int]:
    """Insertions and deletions, then categories of change."""
    whole, categories = 0, 0
    for (_, _, found, _), count in story.items():
        assert isinstance(found, tuple)
        whole += count * (not WHOLE_CHANGES.isdisjoint(found))
        categories += count * len(found)
    return whole, categories


def patch(random: Random, state: MapState, size: int) -> MapState:
    """The lanes of a map that begin nearest to one of them; what else they name is beyond the rim."""
    x, y, _ = state.lanes[random.choice(sorted(state.lanes))].left_boundary[0]

    def away_m(point: Point) -> float:
        return math.hypot(point[0] - x, point[1] - y)

    lanes = sorted(state.lanes.values(), key=lambda lane: away_m(lane.left_boundary[0]))[:size]
    reach = max(away_m(lane.left_boundary[0]) for lane in lanes)
    return MapState.of([*lanes, *(one for one in state.crossings.values() if away_m(one.edge1[0]) <= reach)])


class StreetUpdate(MapUpdate):
    """On a few streets of parallel lanes."""

    @initialize(seed=seeds)
    def lay_streets(self, seed: int) -> None:
        self.begin(random_map(Random(seed)))


class JunctionUpdate(MapUpdate):
    """In a part of one of the demo's blocks."""

    @initialize(block=st.integers(0, 7), size=sizes, seed=seeds)
    def build_block(self, block: int, size: int, seed: int) -> None:
        self.begin(patch(Random(seed), demo_block(block), size))


class RealUpdate(MapUpdate):
    """In a part of one of the real logs' maps."""

    @initialize(log=st.sampled_from(range(max(len(REAL_MAPS), 1))), size=sizes, seed=seeds)
    def open_log(self, log: int, size: int, seed: int) -> None:
        self.begin(patch(Random(seed), real_log(log), size))


@cache
def demo_block(seed: int) -> MapState:
    return build_map(seed, blocks=(1, 1))


@cache
def real_log(log: int) -> MapState:
    return real_map(REAL_MAPS[log])
