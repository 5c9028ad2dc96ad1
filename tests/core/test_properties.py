"""An incremental check equals the full one (spec §6.5); the other properties are those of ``update_machine``."""

from __future__ import annotations

from random import Random

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.core.grid import maps
from tests.core.rewriting import EDITS, REWRITES, several

from lanewright.core.elements import MapState
from lanewright.core.rules import check

few = settings(max_examples=60, suppress_health_check=[HealthCheck.too_slow])


@few
@given(maps(), st.integers(0, 10**6))
def test_a_check_on_what_changed_equals_the_full_check(base, seed):
    """The facts of the base are remembered; a copy of it that nothing is known of must be judged the same."""
    random = Random(seed)
    edited = several(random, several(random, base, EDITS, 3), REWRITES, 1)
    warm = check(base, edited)
    copies = [MapState.of(list(state)) for state in (base, edited)]
    assert check(*copies) == warm
