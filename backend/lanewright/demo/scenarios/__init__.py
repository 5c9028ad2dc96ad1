"""The three demo places, each with its stale and its current plan."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lanewright.demo.scenarios.avenue import avenue
from lanewright.demo.scenarios.boulevard import boulevard
from lanewright.demo.scenarios.hillside import hillside
from lanewright.demo.scenarios.scenario import Scenario

SCENARIOS: tuple[Callable[[np.random.Generator], Scenario], ...] = (avenue, hillside, boulevard)

__all__ = ["SCENARIOS", "Scenario"]
