"""The ground height raster."""

from __future__ import annotations

import io
import json
import pickle
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lanewright.core.errors import InvalidInput
from lanewright.formats.av2_log import open_log
from lanewright.formats.ground import GroundHeight, parse_ground
from lanewright.formats.lidar import read_sweep

PLACEMENT = {"R": [1.0, 0.0, 0.0, 1.0], "t": [-100.0, -200.0], "s": 2.0}

#        y 201   +-------+-------+-------+     row 1, the northern one
#                |  4.0  |  5.0  |  nan  |
#        y 200.5 +-------+-------+-------+
#                |  1.0  |  2.0  |  3.0  |     row 0
#        y 200   +-------+-------+-------+
#              x 100   100.5    101    101.5
HEIGHTS = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, np.nan]], dtype=np.float16)


def npy(array: Any) -> bytes:
    stream = io.BytesIO()
    np.save(stream, array, allow_pickle=True)
    return stream.getvalue()


def header(text: str, version: tuple[int, int] = (1, 0)) -> bytes:
    form = "<H" if version == (1, 0) else "<I"
    return b"\x93NUMPY" + bytes(version) + struct.pack(form, len(text)) + text.encode()


def ground(raster: bytes, placement: Any = None) -> GroundHeight:
    return parse_ground(raster, "ground.npy", json.dumps(placement or PLACEMENT).encode(), "sim2.json")


@pytest.mark.parametrize("order", ["C", "F"])
def test_heights_lie_by_rows_from_the_south(order: Any) -> None:
    places = np.array([[100.1, 200.1], [101.4, 200.4], [100.2, 200.6], [101.2, 200.7], [102.0, 200.1], [100.1, 198.0]])
    found = ground(npy(np.asarray(HEIGHTS, order=order))).at(places)
    assert found[:3].tolist() == [1.0, 3.0, 4.0]
    assert np.isnan(found[3:]).all()


def test_truncation_is_towards_zero_as_in_av2() -> None:
    found = ground(npy(HEIGHTS)).at(np.array([[99.6, 200.1], [99.4, 200.1], [np.nan, 200.1], [1e300, 200.1]]))
    assert found[0] == 1.0
    assert np.isnan(found[1:]).all()


def test_real_rasters_agree_with_av2(real_log: Path) -> None:
    map_api = pytest.importorskip("av2.map.map_api")
    log = open_log(real_log)
    raster, placement = (log.path(str(file)).read_bytes() for file in log.ground_files)
    ours = parse_ground(raster, "ground.npy", placement, "sim2.json")
    theirs = map_api.GroundHeightLayer.from_file(real_log / "map")
    corner = -np.array(ours.placement.translation)
    places = corner + np.random.default_rng(7).uniform(-5, 270, size=(20_000, 2))
    expected = theirs.get_ground_height_at_xy(places)
    found = ours.at(places)
    assert np.isnan(expected).any()
    assert np.isfinite(expected).any()
    assert np.array_equal(found, expected, equal_nan=True)


GIANT = "{'descr': '<f2', 'fortran_order': False, 'shape': (1000000, 1000000), }\n"
BAD_RASTERS = [
    ("pickled objects", npy(np.array([[{"a": 1}]], dtype=object)), "descr", "pickled objects", "float16"),
    ("a pickle", pickle.dumps([[1.0]]), None, "no NumPy array file (.npy); pickles are refused", "numpy.save"),
    ("empty", b"", None, "no NumPy array file", "numpy.save"),
    ("giant shape", header(GIANT) + b"\0" * 64, "shape", "(1000000, 1000000)", "at most 67,108,864 cells"),
    ("giant header", header("{" + " " * 1_000_000 + "}", (2, 0)), "header", "broken header", "again"),
    ("header longer than file", b"\x93NUMPY\x02\x00" + struct.pack("<I", 2**31), "header", "broken header", "again"),
    ("code in header", header("__import__('os').getcwd()\n"), "header", "broken header", "again"),
    ("nested header", header("(" * 9000 + "\n"), "header", "broken header", "again"),
    ("unknown version", b"\x93NUMPY\x09\x00", None, "format version (9, 0)", "numpy.save"),
    ("integers", npy(np.ones((2, 2), np.int64)), "descr", "int64", "float16"),
    ("one row of cells", npy(np.ones(4, np.float16)), "shape", "(4,)", "rows and columns"),
    ("no cells", npy(np.ones((0, 4), np.float16)), "shape", "(0, 4)", "rows and columns"),
    ("negative shape", header(GIANT.replace("1000000", "-2")) + b"\0" * 8, "shape", "(-2, -2)", "rows and columns"),
    ("truncated", npy(HEIGHTS)[:-1], "shape", "11 bytes of numbers, not the 12", "again"),
    ("too long", npy(HEIGHTS) + b"\0", "shape", "13 bytes of numbers, not the 12", "again"),
]


@pytest.mark.parametrize(
    ("raster", "key", "problem", "mend"), [bad[1:] for bad in BAD_RASTERS], ids=[bad[0] for bad in BAD_RASTERS]
)
def test_bad_rasters_are_refused(raster: bytes, key: str | None, problem: str, mend: str) -> None:
    with pytest.raises(InvalidInput) as caught:
        ground(raster)
    assert (caught.value.place.file, caught.value.place.key) == ("ground.npy", key)
    assert problem in caught.value.message
    assert mend in caught.value.mend


@pytest.mark.parametrize(
    ("change", "key", "problem"),
    [
        ({"R": [2.0, 0.0, 0.0, 2.0]}, "R", "is no rotation"),
        ({"R": [1.0, 0.0, 0.0, -1.0]}, "R", "is no rotation"),
        ({"R": [[1.0, 0.0], [0.0, 1.0]]}, "R", "is not 4 numbers"),
        ({"t": [1.0]}, "t", "is not 2 numbers"),
        ({"t": [1.0, True]}, "t", "is not 2 numbers"),
        ({"s": 0}, "s", "is 0"),
        ({"s": "3.3"}, "s", "is not 1 number"),
    ],
)
def test_bad_placements_are_refused(change: dict[str, Any], key: str, problem: str) -> None:
    with pytest.raises(InvalidInput) as caught:
        ground(npy(HEIGHTS), PLACEMENT | change)
    assert (caught.value.place.file, caught.value.place.key) == ("sim2.json", key)
    assert problem in caught.value.message
    assert caught.value.mend


@pytest.mark.parametrize("key", ["R", "t", "s"])
def test_a_placement_without_a_part_is_refused(key: str) -> None:
    with pytest.raises(InvalidInput, match=rf'sim2\.json, "{key}": is missing'):
        ground(npy(HEIGHTS), {name: value for name, value in PLACEMENT.items() if name != key})


def test_real_sweeps_lie_on_the_ground(real_log: Path) -> None:
    log = open_log(real_log)
    sweep = read_sweep(log.path(log.sensor_files()["lidar"][0].path))
    assert sweep.points.shape[1] == 3
    assert len(sweep.points) == len(sweep.intensity) > 90_000
    assert sweep.points.dtype == np.float32
    under_the_car = np.hypot(sweep.points[:, 0], sweep.points[:, 1]) < 8
    lowest = np.percentile(sweep.points[under_the_car, 2], 10)
    assert -0.6 < lowest < -0.1  # the ego origin is about 0.3 m above the ground
