"""What stands beside the road: facades with gaps between them, and poles, as vertical walls."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely
import shapely.ops

from lanewright.demo.path import Array

FACADE_SETBACK = 6.5
EMPTY_PLOTS = 0.12


@dataclass(frozen=True)
class Walls:
    """Vertical walls: ends (n, 4) as x1, y1, x2, y2; heights above the ground (n,); intensities (n,)."""

    ends: Array
    heights: Array
    intensities: Array

    def near(self, x: float, y: float, reach: float) -> Walls:
        """Those with an end or middle within reach of a point."""
        middles = (self.ends[:, :2] + self.ends[:, 2:]) / 2
        inside = np.linalg.norm(middles - (x, y), axis=1) < reach
        return Walls(self.ends[inside], self.heights[inside], self.intensities[inside])


def scenery(pavement: shapely.Geometry, generator: np.random.Generator) -> Walls:
    """Facades along the blocks, and poles on the pavement's edge."""
    ends, heights, intensities = [], [], []
    for ring in _rings(pavement.buffer(FACADE_SETBACK, join_style="mitre")):
        at = 0.0
        while at < ring.length - 4.0:
            length = float(generator.uniform(8, 24))
            depth, gap = float(generator.uniform(0, 2.5)), float(generator.uniform(0, 4))
            if generator.random() > EMPTY_PLOTS:
                front = shapely.ops.substring(ring, at, min(at + length, ring.length))
                for first, last in _facade(front, depth):
                    ends.append((*first, *last))
                    heights.append(float(generator.uniform(6, 16)))
                    intensities.append(float(generator.uniform(10, 45)))
            at += length + gap
    for ring in _rings(pavement.buffer(0.8)):
        for at in np.arange(float(generator.uniform(5, 20)), ring.length, 27.0):
            post = shapely.line_interpolate_point(ring, at)
            for angle in (0.0, np.pi / 2):
                dx, dy = 0.15 * np.cos(angle), 0.15 * np.sin(angle)
                ends.append((post.x - dx, post.y - dy, post.x + dx, post.y + dy))
                heights.append(6.0)
                intensities.append(60.0)
    return Walls(np.array(ends), np.array(heights), np.array(intensities))


def _rings(region: shapely.Geometry) -> list[shapely.LinearRing]:
    polygons = [part for part in shapely.get_parts(region) if part.geom_type == "Polygon"]
    return [ring for polygon in polygons for ring in (polygon.exterior, *polygon.interiors)]


def _facade(front: shapely.LineString, depth: float) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """The straight pieces of a house's front, set back from the line, without its sides."""
    moved = front.simplify(0.5).offset_curve(-depth) if depth > 0.1 else front.simplify(0.5)
    pieces = []
    for part in shapely.get_parts(moved):
        points = [(float(x), float(y)) for x, y in shapely.get_coordinates(part)]
        pieces += list(pairwise(points))
    return pieces
