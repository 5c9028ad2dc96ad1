"""What a scenario is, and the pieces of cross-section that scenarios share."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lanewright.core.changes import Direction
from lanewright.core.elements import LaneType, Mark
from lanewright.demo.plan import Half, Plan, Slot, Turn


@dataclass(frozen=True)
class Scenario:
    """A place, its two states and a drive through it.

    Attributes:
        source_split: where the log would stand in TbV; train maps are up to date, val maps are stale.
        split: release split.
        route: names of the lanes where the drive starts and ends, in the current world.
        drive: metres after the route's start where the log begins, and its length in metres.
        one_sided: whether its map lists a predecessor only when its id is smaller than the lane's own.
    """

    name: str
    city: str
    season: str
    source_split: str
    split: str
    direction: Direction
    stale: Plan
    current: Plan
    route: tuple[str, str]
    drive: tuple[float, float]
    one_sided: bool = False


LEAD_M = 120.0
"""Roads begin this far before the places that a scenario speaks of: the map is a crop, the world goes on."""


def every(spacing: float, length: float) -> tuple[float, ...]:
    """Places along a long block at which it is cut near the 30 m grid."""
    return tuple(float(at) for at in np.arange(spacing * 0.6, length, spacing))


def about(generator: np.random.Generator, value: float, spread: float = 0.1) -> float:
    """A width near ``value``, to the centimetre."""
    return round(float(generator.uniform(value - spread, value + spread)), 2)


def bike(width: float = 1.7, outer: Mark = Mark.NONE) -> Slot:
    """A bike lane at the right."""
    return Slot("bike", width, outer, LaneType.BIKE, Turn.THROUGH)


def left_pocket(width: float = 3.0) -> Slot:
    """A left turn lane that opens from the leftmost through lane."""
    return Slot("left", width, Mark.SOLID_WHITE, turns=Turn.LEFT, parent="1")


def half(*slots: Slot, inner: float = 0.0) -> Half:
    """One direction of travel, from the centre outwards."""
    return Half(slots, inner)
