"""The properties of the change mapping (spec §6) under random edits of procedural maps and of the real ones.

The same sequences on every run; ``long_run`` looks for others.
"""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, settings
from hypothesis.stateful import run_state_machine_as_test
from tests.core.update_machine import STEPS, JunctionUpdate, RealUpdate, StreetUpdate
from tests.core.worlds import REAL_MAPS, REAL_MAPS_MISSING


def hold(machine, examples):
    few = settings(
        max_examples=examples,
        stateful_step_count=STEPS,
        derandomize=True,
        suppress_health_check=list(HealthCheck),
    )
    run_state_machine_as_test(machine, settings=few)


def test_streets():
    hold(StreetUpdate, 60)


def test_junctions():
    hold(JunctionUpdate, 25)


@pytest.mark.shared
@pytest.mark.skipif(not REAL_MAPS, reason=REAL_MAPS_MISSING)
def test_real_maps():
    hold(RealUpdate, 12)
