"""What the road surface looks like from above: asphalt, pavements, grass, and the paint of the current map."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum

import numpy as np
import numpy.typing as npt
import shapely
import shapely.ops
from PIL import Image, ImageDraw

from lanewright.core.elements import LaneType, Line, MapState, Mark, PedestrianCrossing
from lanewright.demo.path import Array
from lanewright.demo.surface import fill

CELL_M = 0.06
STRIPE_WIDTH = 0.14
STRIPE_SPACING = 0.13
"""Half the distance between the two stripes of a double line."""
DASH_M, GAP_M = 3.0, 6.0
BAR_M = 0.6
STOP_LINE_WIDTH = 0.45
SIDEWALK_WIDTH = 3.2


class Cover(IntEnum):
    """What covers the ground."""

    GRASS = 0
    SIDEWALK = 1
    CURB = 2
    ASPHALT = 3
    WHITE = 4
    YELLOW = 5
    BLUE = 6


Stroke = tuple[shapely.LineString, float, Cover]
"""Centre line, width and colour of a painted stroke."""
COLOURS = {"WHITE": Cover.WHITE, "YELLOW": Cover.YELLOW, "BLUE": Cover.BLUE}


@dataclass(frozen=True)
class Surface:
    """A picture of covers; row 0 is the southern edge."""

    origin: tuple[float, float]
    covers: npt.NDArray[np.uint8]

    def at(self, points: Array) -> npt.NDArray[np.uint8]:
        """Covers (n,) at points (n, 2); grass outside the picture."""
        column, row = np.floor((points - self.origin) / CELL_M).astype(np.int64).T
        rows, columns = self.covers.shape
        inside = (row >= 0) & (row < rows) & (column >= 0) & (column < columns)
        found = np.full(len(points), Cover.GRASS, dtype=np.uint8)
        found[inside] = self.covers[row[inside], column[inside]]
        return found


def painted(state: MapState, pavement: shapely.Geometry, window: tuple[float, float, float, float]) -> Surface:
    """The surface inside a window (left, bottom, right, top), with all marks, stop lines and crossings of a map."""
    left, bottom, right, top = window
    origin = (left, bottom)
    image = Image.new("L", (int((right - left) / CELL_M), int((top - bottom) / CELL_M)), Cover.GRASS)
    image = fill(image, pavement.buffer(SIDEWALK_WIDTH), origin, CELL_M, Cover.SIDEWALK)
    image = fill(image, pavement.buffer(0.2), origin, CELL_M, Cover.CURB)
    image = fill(image, pavement, origin, CELL_M, Cover.ASPHALT)
    canvas = ImageDraw.Draw(image)
    for stroke, width, cover in _strokes(state):
        quad = stroke.buffer(width / 2, cap_style="flat")
        for part in shapely.get_parts(quad):
            pixels = (shapely.get_coordinates(part.exterior) - origin) / CELL_M - 0.5
            canvas.polygon([(float(x), float(y)) for x, y in pixels], fill=int(cover))
    return Surface(origin, np.asarray(image, dtype=np.uint8))


def _strokes(state: MapState) -> Iterator[Stroke]:
    seen: set[Line] = set()
    for lane in state.lanes.values():
        for line, mark, inner in ((lane.left_boundary, lane.left_mark, -1), (lane.right_boundary, lane.right_mark, 1)):
            if line in seen or mark.colour not in COLOURS:
                continue
            seen |= {line, line[::-1]}
            yield from _mark_strokes(shapely.LineString([point[:2] for point in line]), mark, inner)
    zebras = [shapely.Polygon([p[:2] for p in (*z.edge1, *z.edge2[::-1])]) for z in state.crossings.values()]
    stops = shapely.union_all(zebras).buffer(3.0)
    for lane in state.lanes.values():
        if lane.is_intersection and lane.lane_type is not LaneType.BIKE:
            stop = shapely.LineString([lane.left_boundary[0][:2], lane.right_boundary[0][:2]])
            if stops.intersects(stop):
                yield stop, STOP_LINE_WIDTH, Cover.WHITE
    for zebra in state.crossings.values():
        yield from _bars(zebra)


def _mark_strokes(line: shapely.LineString, mark: Mark, inner: int) -> Iterator[Stroke]:
    """Stripes of one line; ``inner`` is the side of the lane that reads the mark (1 = left of the line)."""
    cover = COLOURS[mark.colour]
    words = mark.pattern.split("_")
    if words[0] == "DOUBLE":
        words = [words[1], words[1]]
    offsets = [0.0] if len(words) == 1 else [inner * STRIPE_SPACING, -inner * STRIPE_SPACING]
    for word, offset in zip(words, offsets, strict=True):
        stripe = line.offset_curve(offset) if offset else line
        if word == "SOLID":
            yield stripe, STRIPE_WIDTH, cover
        else:
            for start in np.arange(GAP_M / 2, stripe.length, DASH_M + GAP_M):
                dash = shapely.ops.substring(stripe, start, min(start + DASH_M, stripe.length))
                if dash.geom_type == "LineString":
                    yield dash, STRIPE_WIDTH, cover


def _bars(zebra: PedestrianCrossing) -> Iterator[Stroke]:
    """Bars in driving direction, half a metre apart, from one edge to the other."""
    edge1, edge2 = (np.array([point[:2] for point in edge]) for edge in (zebra.edge1, zebra.edge2))
    count = int(np.linalg.norm(edge1[1] - edge1[0]) / (2 * BAR_M))
    for share in (np.arange(count) + 0.5) / count:
        bar = [edge1[0] + share * (edge1[1] - edge1[0]), edge2[0] + share * (edge2[1] - edge2[0])]
        yield shapely.LineString(bar), BAR_M, Cover.WHITE
