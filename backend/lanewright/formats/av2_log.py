"""The folder of one AV2 log, Sensor or TbV (Map Change) layout: what is in it, found without reading any of it.

Source: av2-api and TbV directory layout (shared facts §1.3). The city stands only in the name of the map file.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.untrusted_file import require_inside

CITIES = ("ATX", "DTW", "MIA", "PAO", "PIT", "WDC")
POSES = "city_SE3_egovehicle.feather"
INTRINSICS = "calibration/intrinsics.feather"
EXTRINSICS = "calibration/egovehicle_SE3_sensor.feather"
LIDAR = "lidar"
"""Name of the sensor whose files are lidar sweeps; every other sensor is a camera."""
MOST_FILES = 200_000
"""The longest log of the dataset (117 s, nine cameras) has some 25,000."""

_LOG_IDS = {
    "sensor": re.compile(r"[0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12}"),
    "tbv": re.compile(r"[A-Za-z0-9]{32}__(?:Spring|Summer|Autumn|Winter)_[0-9]{4}"),
}
_MAP_NAME = re.compile(r"log_map_archive_(?P<log_id>.+)____(?P<city>[^_]+)_(?:.+)\.json")
_SENSOR_FILE = re.compile(
    r"sensors/(?:cameras/(?P<camera>[^/]+)/(?P<image>[^/]+)\.(?:jpg|png)|lidar/(?P<sweep>[^/]+)\.feather)"
)
_TIMESTAMP = re.compile(r"[0-9]{1,18}")


class Layout(StrEnum):
    """Which dataset a log has the layout of: told by the form of its id."""

    SENSOR = "sensor"
    TBV = "tbv"


@dataclass(frozen=True, slots=True)
class SensorFile:
    """One image or sweep. ``path`` is relative to the log folder, with ``/``."""

    sensor: str
    timestamp_ns: int
    path: str


@dataclass(frozen=True, slots=True)
class LogDirectory:
    """The folder of a log. Paths in it are relative and lead to nothing outside.

    Attributes:
        files: every file in it, relative, sorted.
    """

    root: Path
    log_id: str
    layout: Layout
    city: str
    map_file: str
    files: tuple[str, ...]

    def __contains__(self, file: str) -> bool:
        return (self.root / file).is_file()

    def path(self, file: str) -> Path:
        """Where a file of this folder lies."""
        return self.root / file

    @property
    def ground_files(self) -> tuple[str | None, str | None]:
        """Ground height raster and the Sim(2) that places it; None where the log has none."""
        return (
            self._only_map_file("ground_height_surface____", ".npy", "ground raster"),
            self._only_map_file("___img_Sim2_city", ".json", "placement of the ground raster"),
        )

    def _only_map_file(self, part: str, suffix: str, what: str) -> str | None:
        found = [file for file in self.files if _in_map(file) and part in file and file.endswith(suffix)]
        if len(found) > 1:
            raise _two_files(found, what)
        return found[0] if found else None

    def sensor_files(self) -> Mapping[str, tuple[SensorFile, ...]]:
        """Images and sweeps by sensor, each in order of time; other files below ``sensors/`` are none of its data.

        Raises:
            InvalidInput: the name of an image or sweep is not its time in nanoseconds.
        """
        found: dict[str, list[SensorFile]] = {}
        for file in self.files:
            match = _SENSOR_FILE.fullmatch(file)
            if match is None or Path(file).name.startswith("."):
                continue
            time = match["image"] or match["sweep"]
            if _TIMESTAMP.fullmatch(time) is None:
                raise InvalidInput(
                    "is not named by a time in nanoseconds", "Give it its original name.", Place(file=file)
                )
            sensor = match["camera"] or LIDAR
            found.setdefault(sensor, []).append(SensorFile(sensor, int(time), file))
        return {sensor: tuple(sorted(found[sensor], key=lambda f: f.timestamp_ns)) for sensor in sorted(found)}


def open_log(path: Path) -> LogDirectory:
    """Look through the folder of one log.

    Raises:
        InvalidInput: it is no folder, its name is no log id, it has no map or two, the map belongs to another log or to
            an unknown city, a symlink leads out of it, or it holds more files than any log.
    """
    root = Path(os.path.abspath(path))  # noqa: PTH100 - resolve() would follow a symlink that names the log
    if not root.is_dir():
        raise InvalidInput("is not a folder", "Give the folder of a log.", Place(file=str(path)))
    layouts = [name for name, pattern in _LOG_IDS.items() if pattern.fullmatch(root.name)]
    if not layouts:
        raise InvalidInput(
            "is not named like a log",
            "Name the folder by the log's id: a UUID (Sensor), or 32 letters and digits + __Season_Year (TbV).",
            Place(file=root.name),
        )
    files = tuple(sorted(_walk(root)))
    map_file = _only_map(files)
    city = _city(map_file, root.name)
    return LogDirectory(root, root.name, Layout(layouts[0]), city, map_file, files)


def _walk(root: Path) -> Iterator[str]:
    """Relative paths of all files, symlinks that leave the folder refused, symlinked folders inside not entered."""

    def refuse(error: OSError) -> None:
        raise InvalidInput(
            f"cannot be read ({error.strerror})", "Check its permissions.", Place(file=str(error.filename))
        ) from None

    count = 0
    for folder, folders, names in os.walk(root, onerror=refuse):
        for name in sorted(folders) + names:
            entry = Path(folder, name)
            if not name.isprintable():  # also false for bytes that are not UTF-8
                raise InvalidInput(
                    "is no printable name", "Rename it.", Place(file=ascii(entry.relative_to(root).as_posix()))
                )
            if entry.is_symlink():
                require_inside(entry, root)
        for name in names:
            count += 1
            if count > MOST_FILES:
                raise InvalidInput(
                    f"holds more than {MOST_FILES:,} files", "Give the folder of one log.", Place(file=root.name)
                )
            yield Path(folder, name).relative_to(root).as_posix()


def _in_map(file: str) -> bool:
    return file.startswith("map/") and file.count("/") == 1


def _two_files(found: list[str], what: str) -> InvalidInput:
    return InvalidInput(
        f"is one of {len(found)} files that could be the {what}: {', '.join(found)[:300]}",
        "Leave exactly one.",
        Place(file=found[0]),
    )


def _only_map(files: tuple[str, ...]) -> str:
    maps = [
        file for file in files if _in_map(file) and file.startswith("map/log_map_archive_") and file.endswith(".json")
    ]
    if not maps:
        raise InvalidInput(
            "is missing", "A log needs exactly one map in its folder map/.", Place(file="map/log_map_archive_*.json")
        )
    if len(maps) > 1:
        raise _two_files(maps, "map")
    return maps[0]


def _city(map_file: str, log_id: str) -> str:
    place = Place(file=map_file)
    match = _MAP_NAME.fullmatch(Path(map_file).name)
    if match is None:
        raise InvalidInput(
            "has no city in its name", "Name it log_map_archive_<log id>____<CITY>_city_<number>.json.", place
        )
    if match["log_id"] != log_id:
        raise InvalidInput(
            f"is the map of another log ({match['log_id']:.60}) than its folder",
            f"Put the map of {log_id} there, or rename the folder.",
            place,
        )
    if match["city"] not in CITIES:
        raise InvalidInput(f"names the unknown city {match['city'][:20]!r}", f"Known are {', '.join(CITIES)}.", place)
    return match["city"]
