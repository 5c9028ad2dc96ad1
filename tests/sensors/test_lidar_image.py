"""The intensity image: exact in metres, paint brighter than asphalt, nothing but the ground."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image

from lanewright.formats.lidar import Sweep
from lanewright.formats.poses import Pose
from lanewright.sensors import lidar_image as module
from lanewright.sensors.lidar_image import LidarImage, lidar_image

AHEAD = Pose(1.0, 0.0, 0.0, 0.0, 100.0, 200.0, 5.32)
TRAJECTORY = np.array([[100.0, 200.0, 5.32]])


def sweep(*returns: tuple[float, float, float, int]) -> Sweep:
    table = np.array(returns)
    return Sweep(table[:, :3].astype(np.float32), table[:, 3].astype(np.uint8))


def ground_at_five(xy: np.ndarray) -> np.ndarray:  # type: ignore[type-arg]
    return np.full(len(xy), 5.0)


def pixels(image: LidarImage) -> np.ndarray:  # type: ignore[type-arg]
    return np.asarray(Image.open(io.BytesIO(image.png)))


def places_seen(image: LidarImage) -> list[tuple[float, float]]:
    """Centres of the pixels that hold a return, in city metres."""
    rows, columns = np.nonzero(pixels(image)[..., 1] == 255)
    x = image.bounds[0] + (columns + 0.5) * image.resolution
    y = image.bounds[3] - (rows + 0.5) * image.resolution
    return sorted(zip(x.round(3).tolist(), y.round(3).tolist(), strict=True))


def test_returns_lie_where_the_pose_puts_them() -> None:
    image = lidar_image([(AHEAD, sweep((10.02, 0.03, -0.32, 50), (-3.0 + 0.04, 7.04, -0.32, 90)))], TRAJECTORY, None)
    assert image is not None
    assert places_seen(image) == [(97.05, 207.05), (110.05, 200.05)]


def test_the_pose_of_the_sweep_turns_it() -> None:
    left = Pose(np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5), 100.0, 200.0, 5.32)
    image = lidar_image([(left, sweep((10.02, -1.03, -0.32, 50)))], TRAJECTORY, ground_at_five)
    assert image is not None
    assert places_seen(image) == [(101.05, 210.05)]


def test_bounds_are_whole_pixels_and_the_image_fills_them() -> None:
    image = lidar_image([(AHEAD, sweep((10.0, 0.0, -0.32, 50), (-3.0, 7.0, -0.32, 90)))], TRAJECTORY, None)
    assert image is not None
    low_x, low_y, high_x, high_y = image.bounds
    rows, columns, channels = pixels(image).shape
    assert channels == 2
    assert (high_x - low_x, high_y - low_y) == pytest.approx((columns * 0.1, rows * 0.1))
    assert np.array(image.bounds) / image.resolution == pytest.approx(
        np.rint(np.array(image.bounds) / image.resolution)
    )


def test_what_is_not_ground_is_left_out() -> None:
    returns = sweep((10.0, 0.0, -0.32, 50), (10.0, 5.0, 0.1, 50), (20.0, 5.0, 1.5, 255), (20.0, -5.0, -2.0, 255))
    image = lidar_image([(AHEAD, returns)], TRAJECTORY, ground_at_five)
    assert image is not None
    assert len(places_seen(image)) == 1
    assert lidar_image([(AHEAD, sweep((10.0, 0.0, 3.0, 50)))], TRAJECTORY, ground_at_five) is None
    assert lidar_image([], TRAJECTORY, ground_at_five) is None


def test_where_the_ground_is_unknown_a_slope_is_allowed_for() -> None:
    def unknown(xy: np.ndarray) -> np.ndarray:  # type: ignore[type-arg]
        return np.full(len(xy), np.nan)

    returns = sweep((30.0, 0.0, 0.5, 50), (3.0, 0.0, 0.5, 50))
    for height_at in (unknown, None):
        image = lidar_image([(AHEAD, returns)], TRAJECTORY, height_at)
        assert image is not None
        assert places_seen(image) == [(130.05, 200.05)]


def test_paint_is_bright_on_dark_asphalt_whatever_single_reflectors_say() -> None:
    random = np.random.default_rng(3)
    x, y = random.uniform(-20, 20, (2, 60_000))
    intensity = np.where(np.abs(y - 3.5) < 0.1, 80, random.integers(5, 15, 60_000))
    intensity[:20] = 255  # a few road studs
    points = np.stack([x, y, np.full(60_000, -0.32)], axis=1).astype(np.float32)
    image = lidar_image([(AHEAD, Sweep(points, intensity.astype(np.uint8)))], TRAJECTORY, ground_at_five)
    assert image is not None
    gray = dict(zip(places_seen(image), _values(image), strict=True))
    paint = np.mean([value for (_, py), value in gray.items() if abs(py - 203.5) < 0.06])
    asphalt = np.mean([value for (_, py), value in gray.items() if abs(py - 203.5) > 0.3])
    assert paint > 200
    assert asphalt < 110


def _values(image: LidarImage) -> list[int]:
    table = pixels(image)
    rows, columns = np.nonzero(table[..., 1] == 255)
    order = np.lexsort((-rows, columns))
    return [int(value) for value in table[rows[order], columns[order], 0]]


def test_beside_a_return_the_image_fades_out() -> None:
    image = lidar_image([(AHEAD, sweep((10.05, 0.05, -0.32, 50)))], TRAJECTORY, None)
    assert image is not None
    assert pixels(image)[..., 1].tolist() == [
        [110, 110, 110, 110, 110],
        [110, 190, 190, 190, 110],
        [110, 190, 255, 190, 110],
        [110, 190, 190, 190, 110],
        [110, 110, 110, 110, 110],
    ]


def test_strips_leave_no_seam(monkeypatch: pytest.MonkeyPatch) -> None:
    random = np.random.default_rng(5)
    points = np.stack([*random.uniform(-6, 6, (2, 3000)), np.full(3000, -0.32)], axis=1).astype(np.float32)
    returns = [(AHEAD, Sweep(points, random.integers(0, 255, 3000).astype(np.uint8)))]
    whole = lidar_image(returns, TRAJECTORY, None)
    monkeypatch.setattr(module, "_STRIP_ROWS", 7)
    assert lidar_image(returns, TRAJECTORY, None) == whole


def test_a_long_log_gets_coarser_pixels_instead_of_a_larger_image() -> None:
    trajectory = np.array([[0.0, 0.0], [3000.0, 100.0]])
    far = Pose(1.0, 0.0, 0.0, 0.0, 3000.0, 100.0, 5.32)
    start = Pose(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.32)
    image = lidar_image([(start, sweep((1.0, 1.0, -0.32, 9))), (far, sweep((1.0, 1.0, -0.32, 9)))], trajectory, None)
    assert image is not None
    assert image.resolution == pytest.approx(0.4)
    assert max(pixels(image).shape) <= module.MOST_PIXELS_A_SIDE
    assert image.sweeps == 2
