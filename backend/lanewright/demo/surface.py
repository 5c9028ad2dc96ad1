"""Drivable areas from curb to curb, and the ground raster that covers them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
import shapely
from PIL import Image, ImageDraw

from lanewright.core.elements import Line
from lanewright.demo.ground import Ground
from lanewright.demo.plan import Plan
from lanewright.demo.street import TILE_M

CORNER_RADIUS = 6.0
CELL_M = 0.3
LONGEST_AREA_M = 180.0
MARGIN_M = 5.0


AREA_REACH_M = 130.0
"""Real maps carry drivable areas somewhat beyond their lanes."""


def pavement(plan: Plan) -> shapely.Geometry:
    """Everything from curb to curb, corners rounded."""
    strips = []
    for road in plan.roads.values():
        at = np.append(np.arange(0.0, road.path.length, 2.0), road.path.length)
        left = road.path.points(at, np.full(len(at), road.curb_left))
        right = road.path.points(at, np.full(len(at), -road.curb_right))
        strips.append(shapely.Polygon(np.concatenate([right, left[::-1]])))
    return shapely.union_all(strips).buffer(CORNER_RADIUS).buffer(-CORNER_RADIUS).simplify(0.03)


def tiles_near(trajectory: shapely.LineString) -> shapely.Geometry:
    """The 30 m tiles that drivable areas are cropped to."""
    reach = trajectory.buffer(AREA_REACH_M)
    left, bottom, right, top = (int(np.floor(bound / TILE_M)) for bound in reach.bounds)
    tiles = (
        shapely.box(i * TILE_M, j * TILE_M, (i + 1) * TILE_M, (j + 1) * TILE_M)
        for i in range(left, right + 1)
        for j in range(bottom, top + 1)
    )
    return shapely.union_all([tile for tile in tiles if tile.intersects(reach)])


def drivable_areas(surface: shapely.Geometry, ground: Ground) -> list[Line]:
    """Rings of the pavement, open as in the files. Long areas, and areas around a block, are cut."""
    rings = []
    for polygon in _pieces(surface):
        if polygon.area > 4.0:
            points = shapely.get_coordinates(shapely.orient_polygons(polygon.simplify(0.02)).exterior)[:-1]
            rounded = np.round(points, 2)
            heights = np.round(ground.heights(rounded), 2)
            rings.append(tuple((float(x), float(y), float(z)) for (x, y), z in zip(rounded, heights, strict=True)))
    return rings


def _pieces(surface: shapely.Geometry) -> Iterator[shapely.Polygon]:
    for polygon in shapely.get_parts(surface):
        if polygon.geom_type != "Polygon":
            continue
        left, bottom, right, top = polygon.bounds
        if not polygon.interiors and right - left <= LONGEST_AREA_M:
            yield polygon
            continue
        middle = polygon.interiors[0].centroid.x if polygon.interiors else (left + right) / 2
        cut = round(float(middle) / TILE_M) * TILE_M
        yield from _pieces(polygon.intersection(shapely.box(left, bottom, cut, top)))
        yield from _pieces(polygon.intersection(shapely.box(cut, bottom, right, top)))


def ground_raster(surface: shapely.Geometry, ground: Ground) -> tuple[npt.NDArray[np.float16], tuple[float, float]]:
    """Heights (rows northward, columns eastward) of 0.3 m cells, NaN beyond 5 m of the pavement; and its origin."""
    region = surface.buffer(MARGIN_M)
    left, bottom, right, top = region.bounds
    origin = (round(np.floor(left / CELL_M) * CELL_M, 1), round(np.floor(bottom / CELL_M) * CELL_M, 1))
    columns = int(np.ceil((right - origin[0]) / CELL_M)) + 1
    rows = int(np.ceil((top - origin[1]) / CELL_M)) + 1
    inside = np.asarray(fill(Image.new("1", (columns, rows)), region, origin, CELL_M, 1), dtype=bool)
    x = origin[0] + (np.arange(columns) + 0.5) * CELL_M
    y = origin[1] + (np.arange(rows) + 0.5) * CELL_M
    grid = np.column_stack([np.tile(x, rows), np.repeat(y, columns)])
    heights = ground.heights(grid).reshape(rows, columns)
    return np.where(inside, heights, np.nan).astype(np.float16), origin


def fill(
    image: Image.Image, region: shapely.Geometry, origin: tuple[float, float], cell: float, value: int
) -> Image.Image:
    """Paint polygons into an image whose row 0 is its southern edge; holes keep what they had."""
    background = image.copy()
    canvas, holes = ImageDraw.Draw(image), Image.new("1", image.size)
    hole_canvas = ImageDraw.Draw(holes)
    for polygon in shapely.get_parts(region):
        if polygon.geom_type == "Polygon":
            canvas.polygon(_pixels(polygon.exterior, origin, cell), fill=value)
            for ring in polygon.interiors:
                hole_canvas.polygon(_pixels(ring, origin, cell), fill=1)
    image.paste(background, mask=holes)
    return image


def _pixels(ring: shapely.LinearRing, origin: tuple[float, float], cell: float) -> list[tuple[float, float]]:
    points = (shapely.get_coordinates(ring) - origin) / cell - 0.5
    return [(float(x), float(y)) for x, y in points]
