"""Road centrelines from curvature: straights, arcs and clothoids, as roads are designed.

A path is measured by *station* (metres from its start); an offset is positive to the left of the direction of travel.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
STEP_M = 0.25


@dataclass(frozen=True, slots=True)
class Bend:
    """A stretch whose curvature (1/m, positive to the left) runs linearly from one value to another."""

    length: float
    curvature_from: float = 0.0
    curvature_to: float = 0.0


def curve(turn_degrees: float, radius: float, easing: float = 25.0) -> tuple[Bend, Bend, Bend]:
    """Clothoid, arc, clothoid: turns by ``turn_degrees`` (positive to the left) with the given smallest radius."""
    curvature = math.copysign(1.0 / radius, turn_degrees)
    arc = abs(math.radians(turn_degrees)) * radius - easing
    if arc < 0:
        raise ValueError(f"a turn of {turn_degrees}° at {radius} m leaves no arc between easings of {easing} m")
    return Bend(easing, 0.0, curvature), Bend(arc, curvature, curvature), Bend(easing, curvature, 0.0)


@dataclass(frozen=True)
class Path:
    """A centreline starting at (x, y) with a heading in radians (0 = grid east), made of bends in order."""

    x: float
    y: float
    heading: float
    bends: tuple[Bend, ...]

    @property
    def length(self) -> float:
        return sum(bend.length for bend in self.bends)

    @cached_property
    def _table(self) -> tuple[Array, Array, Array, Array]:
        """Stations, x, y and headings, dense enough that linear interpolation stays below a millimetre."""
        pieces: list[tuple[Array, Array]] = [(np.zeros(1), np.array([self.heading]))]
        station, heading = 0.0, self.heading
        for bend in self.bends:
            along = np.linspace(0.0, bend.length, max(2, math.ceil(bend.length / STEP_M) + 1))[1:]
            change = (bend.curvature_to - bend.curvature_from) / bend.length
            pieces.append((station + along, heading + bend.curvature_from * along + change * along**2 / 2))
            station += bend.length
            heading += (bend.curvature_from + bend.curvature_to) / 2 * bend.length
        stations = np.concatenate([piece[0] for piece in pieces])
        headings = np.concatenate([piece[1] for piece in pieces])
        middle, step = (headings[1:] + headings[:-1]) / 2, np.diff(stations)
        x = self.x + np.concatenate([[0.0], np.cumsum(np.cos(middle) * step)])
        y = self.y + np.concatenate([[0.0], np.cumsum(np.sin(middle) * step)])
        return stations, x, y, headings

    def heading_at(self, station: float) -> float:
        """Direction of travel in radians."""
        stations, _, _, headings = self._table
        return float(np.interp(station, stations, headings))

    def points(self, stations: Sequence[float] | Array, offsets: Sequence[float] | Array) -> Array:
        """Points (n, 2) at stations and left offsets."""
        table, x, y, headings = self._table
        at = np.asarray(stations, dtype=float)
        heading = np.interp(at, table, headings)
        left = np.asarray(offsets, dtype=float)
        return np.column_stack(
            [np.interp(at, table, x) - np.sin(heading) * left, np.interp(at, table, y) + np.cos(heading) * left]
        )

    def is_straight(self, start: float, end: float) -> bool:
        """Whether the heading keeps within 0.01° between two stations."""
        stations, _, _, headings = self._table
        inside = headings[(stations >= start) & (stations <= end)]
        return bool(np.ptp(inside) < math.radians(0.01)) if inside.size else True


def crossing_path(
    road: Path, station: float, angle_degrees: float, before: float, after: float, bends: Sequence[Bend] = ()
) -> Path:
    """A path over ``road`` at a station, ``angle_degrees`` left of it; the crossing lies at station ``before``.

    Straight over the crossing and for ``after`` metres; ``bends`` follow.
    """
    (x, y), heading = road.points([station], [0.0])[0], road.heading_at(station) + math.radians(angle_degrees)
    return Path(
        float(x - before * math.cos(heading)),
        float(y - before * math.sin(heading)),
        heading,
        (Bend(before + after), *bends),
    )
