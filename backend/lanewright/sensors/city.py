"""City frames: UTM (WGS84, northern) moved to an origin per city, neither rotated nor scaled.

x is grid east, y grid north (not local east and north: the grid converges by up to 1.5°). City metres are the truth;
WGS84 and Mercator are for display and search. Source: av2-api ``utm.py``, shared facts §1.4.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from types import MappingProxyType
from typing import Any

import numpy as np
from pyproj import Transformer

from lanewright.core.errors import InvalidInput, Place

FloatArray = np.ndarray[Any, np.dtype[np.float64]]

_WGS84 = 4326
_MERCATOR = 3857


@dataclass(frozen=True, slots=True)
class CityFrame:
    """The frame of one city.

    Attributes:
        epsg: its UTM zone.
        latitude, longitude: its origin, WGS84 degrees.
        origin_east, origin_north: its origin in UTM metres; city + origin = UTM.
    """

    city: str
    epsg: int
    latitude: float
    longitude: float
    origin_east: float = field(init=False)
    origin_north: float = field(init=False)

    def __post_init__(self) -> None:
        east, north = _transformer(_WGS84, self.epsg).transform(self.longitude, self.latitude)
        object.__setattr__(self, "origin_east", east)
        object.__setattr__(self, "origin_north", north)

    def to_wgs84(self, xy: FloatArray) -> FloatArray:
        """City metres, shape (N, 2) -> longitude, latitude in degrees, shape (N, 2)."""
        return self._from_city(xy, _WGS84)

    def from_wgs84(self, longitude_latitude: FloatArray) -> FloatArray:
        """Longitude, latitude in degrees, shape (N, 2) -> city metres, shape (N, 2)."""
        given = np.asarray(longitude_latitude, dtype=np.float64)
        east, north = _transformer(_WGS84, self.epsg).transform(given[:, 0], given[:, 1])
        return np.stack([east - self.origin_east, north - self.origin_north], axis=1)

    def to_mercator(self, xy: FloatArray) -> FloatArray:
        """City metres, shape (N, 2) -> Web Mercator (EPSG 3857) metres, shape (N, 2)."""
        return self._from_city(xy, _MERCATOR)

    def _from_city(self, xy: FloatArray, epsg: int) -> FloatArray:
        given = np.asarray(xy, dtype=np.float64)
        east, north = given[:, 0] + self.origin_east, given[:, 1] + self.origin_north
        return np.stack(_transformer(self.epsg, epsg).transform(east, north), axis=1)


@cache
def _transformer(source: int, target: int) -> Transformer:
    return Transformer.from_crs(source, target, always_xy=True)


CITY_FRAMES: Mapping[str, CityFrame] = MappingProxyType(
    {
        frame.city: frame
        for frame in (
            CityFrame("ATX", 32614, 30.27464237939507, -97.7404457407424),
            CityFrame("DTW", 32617, 42.29993066912924, -83.17555750783717),
            CityFrame("MIA", 32617, 25.77452579915163, -80.19656914449405),
            CityFrame("PAO", 32610, 37.416065, -122.13571963362166),
            CityFrame("PIT", 32617, 40.44177902989321, -80.01294377242584),
            CityFrame("WDC", 32618, 38.889377, -77.0355047439081),
        )
    }
)


def city_frame(city: str) -> CityFrame:
    """The frame of a city by its code. Raises InvalidInput when it is none of the six."""
    if city not in CITY_FRAMES:
        raise InvalidInput(f"is {city!r:.20}, no known city", f"Use {', '.join(CITY_FRAMES)}.", Place(key="city"))
    return CITY_FRAMES[city]
