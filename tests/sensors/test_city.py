"""City frames against published reference points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lanewright.core.errors import InvalidInput
from lanewright.formats.av2_log import CITIES
from lanewright.sensors.city import CITY_FRAMES, city_frame


def test_every_city_of_the_dataset_has_a_frame() -> None:
    assert tuple(CITY_FRAMES) == CITIES


@pytest.mark.parametrize(
    ("city", "epsg", "east", "north"),
    [
        ("ATX", 32614, 621150.027, 3349890.000),
        ("DTW", 32617, 320669.935, 4685369.999),
        ("MIA", 32617, 580560.009, 2850960.000),
        ("PAO", 32610, 576480.001, 4141379.935),
        ("PIT", 32617, 583710.007, 4477260.000),
        ("WDC", 32618, 323460.000, 4306469.987),
    ],
)
def test_origins_in_utm(city: str, epsg: int, east: float, north: float) -> None:
    frame = city_frame(city)
    assert frame.epsg == epsg
    assert (frame.origin_east, frame.origin_north) == pytest.approx((east, north), abs=1e-3)
    assert frame.to_wgs84(np.zeros((1, 2)))[0] == pytest.approx((frame.longitude, frame.latitude), abs=1e-12)


def test_reference_points_of_washington() -> None:
    found = city_frame("WDC").to_wgs84(np.array([[1716.85, 4470.38], [2139.70, 4606.14]]))
    expected = [[-77.01686032, 38.92998015], [-77.01201950, 38.93128695]]
    assert found == pytest.approx(np.array(expected), abs=5e-8)  # 5 mm


def test_av2_agrees() -> None:
    utm = pytest.importorskip("av2.geometry.utm")
    places = np.array([[0.0, 0.0], [5236.97, 2364.34], [-7000.0, 9000.0]])
    for city, frame in CITY_FRAMES.items():
        theirs = utm.convert_city_coords_to_wgs84(places, utm.CityName(city))
        assert frame.to_wgs84(places)[:, ::-1] == pytest.approx(theirs, abs=1e-9)


@given(city=st.sampled_from(CITIES), x=st.floats(-20_000, 20_000), y=st.floats(-20_000, 20_000))
def test_there_and_back_is_exact_to_a_micrometre(city: str, x: float, y: float) -> None:
    frame = city_frame(city)
    place = np.array([[x, y]])
    assert frame.from_wgs84(frame.to_wgs84(place)) == pytest.approx(place, abs=1e-6)


def test_mercator_stretches_with_the_latitude() -> None:
    a, b = city_frame("PIT").to_mercator(np.array([[0.0, 0.0], [100.0, 0.0]]))
    assert np.hypot(*(b - a)) == pytest.approx(100 / np.cos(np.radians(40.44)), rel=2e-3)


def test_an_unknown_city_is_named() -> None:
    with pytest.raises(InvalidInput, match=r"'LAX', no known city\. Use ATX, DTW"):
        city_frame("LAX")
