"""The lie of the land: a smooth ground with slope and long swells, and lines surveyed on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lanewright.core.elements import Line
from lanewright.demo.path import Array

CENTIMETRES = 2
LINE_TOLERANCE = 0.02
HEIGHT_TOLERANCE = 0.05


@dataclass(frozen=True, slots=True)
class Ground:
    """Height of the ground in metres at city coordinates. ``swells``: amplitude, wave length, bearing, phase each."""

    x: float
    y: float
    height: float
    slope_x: float
    slope_y: float
    swells: tuple[tuple[float, float, float, float], ...] = ()

    @classmethod
    def random(cls, generator: np.random.Generator, x: float, y: float) -> Ground:
        """A ground that rises 1 to 3 % somewhere, with three swells of 150 to 400 m."""
        rise, bearing = generator.uniform(0.01, 0.03), generator.uniform(0, 2 * np.pi)
        swells = tuple(
            (
                float(generator.uniform(0.25, 0.7)),
                float(generator.uniform(150, 400)),
                float(generator.uniform(0, np.pi)),
                float(generator.uniform(0, 2 * np.pi)),
            )
            for _ in range(3)
        )
        height = float(generator.uniform(9, 24))
        return cls(x, y, height, float(rise * np.cos(bearing)), float(rise * np.sin(bearing)), swells)

    def heights(self, points: Array) -> Array:
        """Heights (n,) at points (n, 2)."""
        dx, dy = points[:, 0] - self.x, points[:, 1] - self.y
        z = self.height + self.slope_x * dx + self.slope_y * dy
        for amplitude, length, bearing, phase in self.swells:
            z = z + amplitude * np.sin(2 * np.pi * (dx * np.cos(bearing) + dy * np.sin(bearing)) / length + phase)
        return np.asarray(z)

    def survey(self, points: Array) -> Line:
        """A map line along dense points (n, 2): centimetres, with no more vertices than its shape and height need."""
        rounded = np.round(points, CENTIMETRES)
        z = np.round(self.heights(rounded), CENTIMETRES)
        surveyed = np.column_stack([rounded, z])
        scaled = np.column_stack([rounded, z * (LINE_TOLERANCE / HEIGHT_TOLERANCE)])
        kept = surveyed[_needed(scaled)]
        return tuple((float(x), float(y), float(z)) for x, y, z in kept)


def _needed(points: Array) -> list[int]:
    """Indices that Douglas and Peucker keep: the ends, and whatever strays from the chord."""
    kept, open_spans = {0, len(points) - 1}, [(0, len(points) - 1)]
    while open_spans:
        first, last = open_spans.pop()
        if last - first < 2:
            continue
        chord = points[last] - points[first]
        inside = points[first + 1 : last] - points[first]
        share = np.clip(inside @ chord / max(float(chord @ chord), 1e-9), 0, 1)
        stray = np.linalg.norm(inside - share[:, None] * chord, axis=1)
        worst = int(np.argmax(stray))
        if stray[worst] > LINE_TOLERANCE:
            middle = first + 1 + worst
            kept.add(middle)
            open_spans += [(first, middle), (middle, last)]
    return sorted(kept)
