"""Ground height raster of a log: a NumPy array and the Sim(2) that places it in the city.

p_array = s · (R · p_city + t), value = array[row = int(y), column = int(x)], truncated towards zero, row 0 the
southern one; NaN outside the region of interest. Source: av2-api ``GroundHeightLayer``, shared facts §1.3.
"""

from __future__ import annotations

import io
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.json_document import Limits, parse_json
from lanewright.formats.untrusted_file import MEBIBYTE

FloatArray = np.ndarray[Any, np.dtype[np.float64]]

MOST_BYTES = 128 * MEBIBYTE
MOST_CELLS = 64 * 1024 * 1024
"""2.4 km square at 0.3 m; real logs have under a million."""
SIM2_LIMITS = Limits(size=64 * 1024, depth=4, nodes=100)
_MEND = "Copy or download the file again."


@dataclass(frozen=True, slots=True)
class Sim2:
    """p_array = scale · (rotation · p_city + translation)."""

    rotation: tuple[tuple[float, float], tuple[float, float]]
    translation: tuple[float, float]
    scale: float


@dataclass(frozen=True, slots=True)
class GroundHeight:
    """Height of the ground by place."""

    heights: np.ndarray[Any, Any]
    placement: Sim2

    def at(self, xy: FloatArray) -> FloatArray:
        """Heights in city metres at places of shape (N, 2), further columns ignored; NaN where there is none."""
        places = np.asarray(xy, dtype=np.float64)[:, :2]
        cells = (places @ np.array(self.placement.rotation).T + self.placement.translation) * self.placement.scale
        rows, columns = self.heights.shape
        # Truncation lets (-1, 0) fall into cell 0, as in av2. NaN fails every comparison.
        inside = (cells[:, 0] > -1) & (cells[:, 0] < columns) & (cells[:, 1] > -1) & (cells[:, 1] < rows)
        index = cells[inside].astype(np.int64)
        found = np.full(len(places), np.nan)
        found[inside] = self.heights[index[:, 1], index[:, 0]]
        return found


def parse_ground(raster: bytes, raster_file: str, placement: bytes, placement_file: str) -> GroundHeight:
    """The raster from the bytes of its two files.

    Raises:
        InvalidInput: pickled, broken, of a wrong shape or type, or too large; names the file and the key.
    """
    return GroundHeight(_parse_array(raster, raster_file), _parse_sim2(placement, placement_file))


def _parse_array(data: bytes, file: str) -> np.ndarray[Any, Any]:
    try:
        return _array(data)
    except InvalidInput as error:
        raise error.within(file=file) from None


def _array(data: bytes) -> np.ndarray[Any, Any]:
    """The array over the bytes themselves: nothing is unpickled, nothing allocated by what the header says."""
    if len(data) > MOST_BYTES:
        raise InvalidInput(f"is larger than {MOST_BYTES / MEBIBYTE:g} MiB", "Check that it is the right file.")
    if not data.startswith(np.lib.format.MAGIC_PREFIX):
        raise InvalidInput("is no NumPy array file (.npy); pickles are refused", "Write it with numpy.save.")
    stream = io.BytesIO(data)
    try:
        version = np.lib.format.read_magic(stream)
        if version not in ((1, 0), (2, 0)):
            raise InvalidInput(f"has the format version {version}", "Write it with numpy.save.")
        read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        shape, by_columns, kind = read(stream)
    except InvalidInput:
        raise
    except Exception as error:  # NumPy's header parser lets through whatever tokenizer, parser or dtype raise
        raise InvalidInput(f"has a broken header ({error!s:.120})", _MEND, Place(key="header")) from None
    if kind.hasobject:
        raise InvalidInput("holds pickled objects", "Save it as float16 numbers.", Place(key="descr"))
    if kind.kind != "f" or kind.itemsize > 8:
        raise InvalidInput(f"holds {kind}, not heights", "Save it as float16 numbers.", Place(key="descr"))
    if len(shape) != 2 or min(shape) <= 0 or math.prod(shape) > MOST_CELLS:
        raise InvalidInput(
            f"has the shape {str(shape)[:60]}",
            f"Write rows and columns, at most {MOST_CELLS:,} cells.",
            Place(key="shape"),
        )
    given, needed = len(data) - stream.tell(), math.prod(shape) * kind.itemsize
    if given != needed:
        raise InvalidInput(
            f"holds {given} bytes of numbers, not the {needed} of its shape",
            _MEND,
            Place(key="shape"),
        )
    cells = np.frombuffer(data, dtype=kind, offset=stream.tell())
    return cells.reshape(shape, order="F" if by_columns else "C")


def _parse_sim2(data: bytes, file: str) -> Sim2:
    value = parse_json(data, file, SIM2_LIMITS).value
    try:
        if not isinstance(value, dict):
            raise InvalidInput("is not an object", "Write an object with R, t and s.")
        rotation, translation = _numbers(value, "R", 4), _numbers(value, "t", 2)
        (scale,) = _numbers({"s": [value["s"]]} if "s" in value else {}, "s", 1)
        matrix = np.array(rotation).reshape(2, 2)
        if not np.allclose(matrix @ matrix.T, np.eye(2), atol=1e-6) or np.linalg.det(matrix) < 0:
            raise InvalidInput("is no rotation", "Write a rotation matrix, row by row.", Place(key="R"))
        if not 1e-3 <= scale <= 1e3:
            raise InvalidInput(f"is {scale}", "Write cells per metre, above 0.", Place(key="s"))
    except InvalidInput as error:
        raise error.within(file=file) from None
    return Sim2((tuple(rotation[:2]), tuple(rotation[2:])), tuple(translation), scale)  # type: ignore[arg-type]


def _numbers(value: dict[str, Any], key: str, count: int) -> list[float]:
    if key not in value:
        raise InvalidInput("is missing", "Write an object with R, t and s.", Place(key=key))
    numbers = value[key]
    if (
        not isinstance(numbers, list)
        or len(numbers) != count
        or any(isinstance(n, bool) or not isinstance(n, int | float) or not abs(n) <= 1e9 for n in numbers)
    ):
        raise InvalidInput(
            f"is not {count} number{'s' if count > 1 else ''}",
            "Write R as 4, t as 2 and s as one number.",
            Place(key=key),
        )
    return [float(n) for n in numbers]
