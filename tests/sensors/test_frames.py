"""The frame index: one frame per more than 5 m of motion."""

from __future__ import annotations

import numpy as np
import pytest

from lanewright.formats.av2_log import SensorFile
from lanewright.formats.poses import Poses
from lanewright.sensors.frames import frame_index

MILLISECOND = 1_000_000


def drive(x: list[float], times_ms: list[int]) -> Poses:
    values = np.zeros((len(x), 7))
    values[:, 0], values[:, 4] = 1.0, x
    return Poses(np.array(times_ms, dtype=np.int64) * MILLISECOND, values)


def steady(rows: int) -> Poses:
    """12.5 m/s, a pose every 10 ms."""
    return drive([0.125 * i for i in range(rows)], [10 * i for i in range(rows)])


def sweeps(times_ms: list[int]) -> list[SensorFile]:
    return [SensorFile("lidar", time * MILLISECOND, f"sensors/lidar/{time}.feather") for time in times_ms]


def frame_times_ms(poses: Poses, files: dict[str, list[SensorFile]] | None = None) -> list[int]:
    return [frame.timestamp_ns // MILLISECOND for frame in frame_index(poses, files or {}).frames]


def test_a_frame_follows_after_more_than_five_metres() -> None:
    assert frame_times_ms(drive([0.0, 5.0, 5.01, 10.0, 10.02, 11.0], [0, 100, 200, 300, 400, 500])) == [0, 200, 400]


def test_a_standing_vehicle_has_one_frame() -> None:
    assert frame_times_ms(drive([3.0] * 50, list(range(50)))) == [0]


def test_driving_back_counts_as_motion() -> None:
    assert frame_times_ms(drive([0.0, 6.0, 3.0, 0.0], [0, 100, 200, 300])) == [0, 100, 300]


def test_a_gap_of_more_than_a_second_begins_a_new_drive() -> None:
    index = frame_index(drive([0.0, 6.0, 6.1, 12.0], [0, 1000, 2001, 2100]), {})
    assert [(frame.drive, frame.timestamp_ns // MILLISECOND) for frame in index.frames] == [
        (0, 0),
        (0, 1000),
        (1, 2001),
        (1, 2100),
    ]


def test_where_sweeps_cover_the_drive_frames_are_sweeps() -> None:
    files = {"lidar": sweeps(list(range(50, 1200, 100)))}
    index = frame_index(steady(121), files)
    assert [frame.timestamp_ns // MILLISECOND for frame in index.frames] == [50, 550, 1050]
    assert [frame.files for frame in index.frames] == [
        {"lidar": "sensors/lidar/50.feather"},
        {"lidar": "sensors/lidar/550.feather"},
        {"lidar": "sensors/lidar/1050.feather"},
    ]


def test_with_a_single_sweep_frames_still_come_from_the_poses() -> None:
    index = frame_index(steady(180), {"lidar": sweeps([430])})
    assert [frame.timestamp_ns // MILLISECOND for frame in index.frames] == [0, 410, 820, 1230, 1640]
    assert [sorted(frame.files) for frame in index.frames] == [[], ["lidar"], [], [], []]
    assert index.sensors == {"lidar": 1}


def test_the_file_nearest_in_time_belongs_to_a_frame_if_it_is_near_enough() -> None:
    images = [SensorFile("ring_front_center", time * MILLISECOND, f"{time}.jpg") for time in (-55, 61, 480, 500, 525)]
    index = frame_index(drive([0.0, 6.0], [0, 510]), {"ring_front_center": images})
    assert [frame.files for frame in index.frames] == [
        {"ring_front_center": "-55.jpg"},
        {"ring_front_center": "500.jpg"},
    ]


def test_the_pose_is_the_one_of_the_frame_exactly() -> None:
    poses = drive([0.1, 7.30000000000001], [0, 10])
    second = frame_index(poses, {}).frames[1]
    assert second.pose.tx_m == 7.30000000000001
    assert second.timestamp_ns == 10 * MILLISECOND


@pytest.mark.parametrize("count", [1, 2])
def test_the_shortest_logs_have_a_frame(count: int) -> None:
    assert len(frame_index(drive([0.0] * count, list(range(count))), {}).frames) == 1
