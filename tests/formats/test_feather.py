"""Feather files that lie about themselves."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pyarrow import feather

from lanewright.core.errors import InvalidInput
from lanewright.formats.feather import read_columns


def write(path: Path, columns: dict[str, Any], compression: str = "lz4") -> Path:
    feather.write_feather(pa.table(columns), path, compression=compression)
    return path


def read(path: Path, kind: str = "float32") -> Any:
    return read_columns(path, {"x": kind}, most_bytes=2**20, most_rows=1000)["x"]


@pytest.mark.parametrize("compression", ["lz4", "zstd", "uncompressed"])
def test_numbers_come_back_in_the_type_asked_for(tmp_path: Path, compression: str) -> None:
    path = write(tmp_path / "a.feather", {"x": np.array([1.5, -2.0], np.float16), "other": ["a", "b"]}, compression)
    values = read(path)
    assert values.dtype == np.float32
    assert values.tolist() == [1.5, -2.0]


def refusal(path: Path, kind: str = "float32") -> InvalidInput:
    with pytest.raises(InvalidInput) as caught:
        read(path, kind)
    assert caught.value.place.file == path.name
    assert caught.value.mend
    return caught.value


@pytest.mark.parametrize("cut", [0, 5, 100, -1, -40])
def test_broken_file(tmp_path: Path, cut: int) -> None:
    path = write(tmp_path / "a.feather", {"x": np.arange(100.0)})
    path.write_bytes(path.read_bytes()[:cut])
    assert "not a whole feather file" in refusal(path).message


def test_broken_inside(tmp_path: Path) -> None:
    path = write(tmp_path / "a.feather", {"x": np.arange(100.0)})
    data = path.read_bytes()
    path.write_bytes(data[:8] + b"\x00" * (len(data) - 16) + data[-8:])
    assert refusal(path).mend


def test_what_unpacks_to_too_much_is_refused_unopened(tmp_path: Path) -> None:
    path = write(tmp_path / "a.feather", {"x": np.zeros(30_000_000, np.float32)}, "zstd")
    assert path.stat().st_size < 2**20
    assert "unpacks to more than the 1 MiB" in refusal(path).message


def test_too_many_rows_and_too_large_a_file(tmp_path: Path) -> None:
    assert "1,001 rows" in refusal(write(tmp_path / "a.feather", {"x": np.zeros(1001, np.float32)})).message
    large = write(tmp_path / "b.feather", {"x": np.zeros(300_000, np.float32)}, "uncompressed")
    assert "is 1.1 MiB, more than the 1 MiB" in refusal(large).message


@pytest.mark.parametrize(
    ("columns", "kind", "problem"),
    [
        ({"y": [1.0]}, "float32", "is missing"),
        ({"x": ["1.0"]}, "float32", "is string, not float32"),
        ({"x": [True]}, "float32", "is bool, not float32"),
        ({"x": [1.0, None]}, "float32", "has 1 empty cells"),
        ({"x": [1.5]}, "int64", "is double, not int64"),
        ({"x": [300]}, "uint8", "is int64, not uint8"),
        ({"x": [[1.0]]}, "float32", "not float32"),
        ({"x": [1]}, "str", "is int64, not text"),
    ],
)
def test_columns_that_do_not_fit(tmp_path: Path, columns: dict[str, Any], kind: str, problem: str) -> None:
    error = refusal(write(tmp_path / "a.feather", columns), kind)
    assert error.place.key == "x"
    assert problem in error.message


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(damage=st.lists(st.tuples(st.floats(0, 1), st.integers(0, 255)), min_size=1, max_size=4))
def test_damaged_bytes_are_refused_or_read_but_never_anything_else(
    tmp_path: Path, damage: list[tuple[float, int]]
) -> None:
    path = write(tmp_path / "a.feather", {"x": np.arange(50, dtype=np.float32), "s": ["text"] * 50})
    data = bytearray(path.read_bytes())
    for place, byte in damage:
        data[round(place * (len(data) - 1))] = byte
    path.write_bytes(data)
    with contextlib.suppress(InvalidInput):
        columns = read_columns(path, {"x": "float32", "s": "str"}, most_bytes=2**20, most_rows=1000)
        assert len(columns["x"]) == len(columns["s"])
