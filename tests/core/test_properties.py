"""The properties of the change mapping (spec §6), on procedural maps and on the real ones."""

from __future__ import annotations

from collections import Counter
from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.core.grid import maps
from tests.core.rewriting import EDITS, REWRITES, several

from lanewright.core.canonical import canonicalise
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff, invert
from lanewright.core.edits import apply_edits
from lanewright.core.elements import ElementKind, MapState
from lanewright.core.restore import restore
from lanewright.core.rules import check, findings
from lanewright.core.survey import Survey

IDENTITY = ("identity.", "replacement.", "insertion.", "deletion.")
MOST_FIXES = 6
few = settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow])


def told(base: MapState, edited: MapState) -> Counter[tuple[object, ...]]:
    """The changes, up to the ids of what is new."""
    return Counter(
        (
            change.kind,
            change.id if change.key in base else "new",
            change.categories,
            change.leaves,
        )
        for change in diff(base, edited).changes
    )


def one_explanation(base: MapState, seed: int) -> None:
    random = Random(seed)
    edited = several(random, base, EDITS, random.randint(0, 4))
    rewritten = several(random, edited, REWRITES, random.randint(1, 3))
    canonical, also = canonicalise(base, edited), canonicalise(base, rewritten)
    assert told(base, canonical) == told(base, also)
    for state in (canonical, also):
        assert not [one.id for one in check(base, state) if one.code.startswith(IDENTITY) and not one.inherited]
        assert canonicalise(base, state) == state


def fixes_close(base: MapState, seed: int) -> None:
    """A fix removes its violation and adds none; a line that only a person can redraw stays bad under a new id."""
    random = Random(seed)
    edited = several(random, several(random, base, EDITS, 2), REWRITES, 1)
    found = [one for one in check(base, edited) if not one.inherited]
    before = {one.id for one in found}
    for violation in found[:MOST_FIXES]:
        assert violation.fixes or violation.code == "geometry.invalid"
        for fix in violation.fixes:
            left = findings(Comparison(base, apply_edits(edited, fix.edits)))
            assert violation.id not in {one.id for one in left}
            added = [one.id for one in left if not one.inherited and one.id not in before]
            assert all(one.startswith("geometry.invalid:") for one in added)


@few
@given(maps(), st.integers(0, 10**6))
def test_one_explanation_on_procedural_maps(base, seed):
    one_explanation(base, seed)


@few
@given(maps(), st.integers(0, 10**6))
def test_fixes_close_on_procedural_maps(base, seed):
    fixes_close(base, seed)


@pytest.mark.shared
@settings(max_examples=12, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.integers(0, 10**6))
def test_one_explanation_on_real_maps(real_maps, seed):
    one_explanation(real_maps[seed % len(real_maps)], seed)


@pytest.mark.shared
@settings(max_examples=12, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.integers(0, 10**6))
def test_fixes_close_on_real_maps(real_maps, seed):
    fixes_close(real_maps[seed % len(real_maps)], seed)


@few
@given(maps(), st.integers(0, 10**6))
def test_the_inverse_diff_is_the_diff_of_the_inverse(base, seed):
    random = Random(seed)
    edited = several(random, several(random, base, EDITS, 3), REWRITES, 1)
    assert invert(diff(base, edited)) == diff(edited, base)


@few
@given(maps(), st.integers(0, 10**6))
def test_every_update_has_a_macro_and_every_difference_a_change(base, seed):
    random = Random(seed)
    edited = several(random, base, EDITS, 3)
    found = diff(base, edited)
    assert bool(found.changes) == (restore(base, edited) != base)
    for update in found.updates:
        macros = update.macros
        assert macros.shape or macros.appearance or macros.function or macros.lane_graph or macros.lane_number


@few
@given(maps(), st.integers(0, 10**6))
def test_an_unchanged_element_is_bit_identical_to_the_base(base, seed):
    edited = restore(base, several(Random(seed), base, EDITS, 4))
    changed = {change.key for change in diff(base, edited).changes}
    for element in edited:
        known = base.get(element.key)
        if element.key not in changed and element.key.kind is ElementKind.PEDESTRIAN_CROSSING:
            assert element == known
        elif element.key not in changed:
            assert (element.left_boundary, element.right_boundary) == (known.left_boundary, known.right_boundary)
    assert restore(base, edited) == edited


@few
@given(maps(), st.integers(0, 10**6))
def test_a_check_on_what_changed_equals_the_full_check(base, seed):
    """The facts of the base are remembered; a copy of it that nothing is known of must be judged the same."""
    random = Random(seed)
    edited = several(random, several(random, base, EDITS, 3), REWRITES, 1)
    Survey.of(base)
    warm = check(base, edited)
    copies = [MapState.of(list(state)) for state in (base, edited)]
    assert check(*copies) == warm
