"""What the folder of a log may hold, and what it may not."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from lanewright.core.errors import InvalidInput
from lanewright.formats import av2_log
from lanewright.formats.av2_log import Layout, open_log

TBV_ID = "VvgE5LfOzIahbS266MFW7tP2al00LhQn__Autumn_2020"
SENSOR_ID = "7fab2350-7eaf-3b7e-a39d-6937a4c1bede"


def make_log(parent: Path, log_id: str = TBV_ID, city: str = "WDC") -> Path:
    root = parent / log_id
    (root / "map").mkdir(parents=True)
    (root / "map" / f"log_map_archive_{log_id}____{city}_city_17.json").write_text("{}")
    return root


def put(root: Path, *files: str) -> None:
    for file in files:
        (root / file).parent.mkdir(parents=True, exist_ok=True)
        (root / file).write_bytes(b"x")


def test_layout_and_city_come_from_the_names(tmp_path: Path) -> None:
    tbv, sensor = open_log(make_log(tmp_path)), open_log(make_log(tmp_path, SENSOR_ID, "PAO"))
    assert (tbv.log_id, tbv.layout, tbv.city) == (TBV_ID, Layout.TBV, "WDC")
    assert (sensor.log_id, sensor.layout, sensor.city) == (SENSOR_ID, Layout.SENSOR, "PAO")
    assert tbv.map_file == f"map/log_map_archive_{TBV_ID}____WDC_city_17.json"


def test_sensor_files_are_listed_by_sensor_and_time(tmp_path: Path) -> None:
    root = make_log(tmp_path)
    put(
        root,
        "sensors/lidar/200.feather",
        "sensors/lidar/1000.feather",
        "sensors/cameras/ring_front_center/3000.jpg",
        "sensors/cameras/ring_front_center/40.jpg",
        "sensors/lidar/.DS_Store",
        "sensors/cameras/ring_front_center/notes.txt",
        "annotations.feather",
    )
    files = open_log(root).sensor_files()
    assert {sensor: [file.timestamp_ns for file in own] for sensor, own in files.items()} == {
        "lidar": [200, 1000],
        "ring_front_center": [40, 3000],
    }
    assert files["lidar"][0].path == "sensors/lidar/200.feather"


def test_no_map_is_named(tmp_path: Path) -> None:
    root = tmp_path / TBV_ID
    root.mkdir()
    with pytest.raises(InvalidInput, match=r"map/log_map_archive_\*\.json: is missing\. .*exactly one map"):
        open_log(root)


def test_two_maps_are_refused_naming_both(tmp_path: Path) -> None:
    root = make_log(tmp_path)
    put(root, f"map/log_map_archive_{TBV_ID}____PIT_city_18.json")
    with pytest.raises(InvalidInput, match=r"PIT_city_18.*WDC_city_17.* Leave exactly one\."):
        open_log(root)


def test_two_ground_rasters_are_refused(tmp_path: Path) -> None:
    root = make_log(tmp_path)
    put(root, f"map/{TBV_ID}_ground_height_surface____WDC.npy", "map/b_ground_height_surface____WDC.npy")
    with pytest.raises(InvalidInput, match=r"2 files that could be the ground raster.* Leave exactly one\."):
        _ = open_log(root).ground_files


@pytest.mark.parametrize("target", ["outside.json", "/etc/hostname", "../elsewhere"])
def test_a_file_linked_from_outside_is_refused(tmp_path: Path, target: str) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "outside.json").write_text("{}")
    root = make_log(tmp_path)
    link = root / "map" / "extra.json"
    link.symlink_to(tmp_path / target)
    with pytest.raises(InvalidInput, match=r"map/extra\.json: leads out of the log folder\. Replace the symlink"):
        open_log(root)


def test_a_folder_linked_from_outside_is_refused(tmp_path: Path) -> None:
    (tmp_path / "sweeps").mkdir()
    root = make_log(tmp_path)
    (root / "sensors").mkdir()
    (root / "sensors" / "lidar").symlink_to(tmp_path / "sweeps")
    with pytest.raises(InvalidInput, match=r"sensors/lidar: leads out of the log folder"):
        open_log(root)


def test_the_map_itself_linked_from_outside_is_refused(tmp_path: Path) -> None:
    root = make_log(tmp_path)
    (name,) = (root / "map").iterdir()
    name.rename(tmp_path / "map.json")
    name.symlink_to(tmp_path / "map.json")
    with pytest.raises(InvalidInput, match=r"map/log_map_archive_.*: leads out of the log folder"):
        open_log(root)


def test_links_within_the_folder_and_to_the_folder_are_fine(tmp_path: Path) -> None:
    root = make_log(tmp_path / "disk")
    put(root, "sensors/lidar/7.feather")
    (root / "sensors" / "loop").symlink_to(root)
    (root / "sensors" / "lidar" / "8.feather").symlink_to("7.feather")
    (tmp_path / TBV_ID).symlink_to(root)
    log = open_log(tmp_path / TBV_ID)
    assert [file.timestamp_ns for file in log.sensor_files()["lidar"]] == [7, 8]


@pytest.mark.parametrize(
    ("name", "problem", "mend"),
    [
        (f"log_map_archive_{TBV_ID}____LAX_city_1.json", "unknown city 'LAX'", "ATX, DTW, MIA, PAO, PIT, WDC"),
        (f"log_map_archive_{SENSOR_ID}____PIT_city_1.json", "map of another log", "rename the folder"),
        (f"log_map_archive_{TBV_ID}.json", "no city in its name", "____<CITY>_city_<number>.json"),
    ],
)
def test_map_names_that_do_not_fit(tmp_path: Path, name: str, problem: str, mend: str) -> None:
    root = tmp_path / TBV_ID
    put(root, f"map/{name}")
    with pytest.raises(InvalidInput) as caught:
        open_log(root)
    assert caught.value.place.file == f"map/{name}"
    assert problem in caught.value.message
    assert mend in caught.value.mend


@pytest.mark.parametrize("name", ["logs", f"{TBV_ID}x", SENSOR_ID.upper(), TBV_ID.replace("Autumn", "Monsoon")])
def test_folders_not_named_like_a_log(tmp_path: Path, name: str) -> None:
    (tmp_path / name).mkdir()
    with pytest.raises(InvalidInput, match=r"is not named like a log\. Name the folder by the log's id"):
        open_log(tmp_path / name)


def test_a_sweep_without_a_time_in_its_name_is_named(tmp_path: Path) -> None:
    root = make_log(tmp_path)
    put(root, "sensors/lidar/first.feather")
    with pytest.raises(InvalidInput, match=r"sensors/lidar/first\.feather: is not named by a time in nanoseconds"):
        open_log(root).sensor_files()


@pytest.mark.parametrize("name", [b"caf\xe9.jpg", b"line\nbreak.jpg"])
def test_names_that_cannot_be_printed_are_refused(tmp_path: Path, name: bytes) -> None:
    root = make_log(tmp_path)
    (root / os.fsdecode(name)).write_bytes(b"")
    with pytest.raises(InvalidInput, match=r"is no printable name\. Rename it\.") as caught:
        open_log(root)
    assert str(caught.value).isprintable()


def test_a_folder_with_too_many_files_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(av2_log, "MOST_FILES", 5)
    root = make_log(tmp_path)
    put(root, *(f"sensors/lidar/{i}.feather" for i in range(5)))
    with pytest.raises(InvalidInput, match=r"more than 5 files"):
        open_log(root)


def test_real_logs_open(real_log: Path) -> None:
    log = open_log(real_log)
    assert (log.layout, log.city) == (Layout.SENSOR, "PIT")
    assert all(log.ground_files)
    assert set(log.sensor_files()) == {"lidar"}
