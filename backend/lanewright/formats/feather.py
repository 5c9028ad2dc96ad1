"""Untrusted feather (Arrow IPC) files: named columns as arrays, nothing allocated before its size is known.

Compressed columns declare their own unpacked size; Arrow believes it. So the sizes are read from the messages first.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.untrusted_file import MEBIBYTE, read_bytes

_MAGIC = b"ARROW1"
_MEND = "Copy or download the file again."
_RECORD_BATCH = 3  # MessageHeader in Arrow's Message.fbs; 1 is the schema, 2 a dictionary


def read_columns(
    path: Path, columns: Mapping[str, str], *, most_bytes: int, most_rows: int, name: str | None = None
) -> dict[str, np.ndarray[Any, Any]]:
    """Columns of a feather file, each as an array of the type asked for.

    Args:
        columns: name -> numpy type (``"int64"``, ``"float64"``, ``"uint8"`` …) or ``"str"``.
        most_bytes: limit for the file and, unpacked, for its contents.
        name: how errors call the file.

    Raises:
        InvalidInput: not a feather file, broken, too large, a column missing, of the wrong type or with empty cells.
    """
    file = name or path.name
    data = read_bytes(path, most_bytes=most_bytes, name=file)
    try:
        table = _read_table(data, most_bytes)
        if table.num_rows > most_rows:
            raise InvalidInput(
                f"has {table.num_rows:,} rows, more than {most_rows:,}", "Check that it is the right file."
            )
        return {column: _column(table, column, kind) for column, kind in columns.items()}
    except InvalidInput as error:
        raise error.within(file=file) from None
    except (pa.ArrowException, OSError, ValueError, struct.error, IndexError, MemoryError) as error:
        raise InvalidInput(f"is a broken feather file ({error!s:.200})", _MEND, Place(file=file)) from None


def _read_table(data: bytes, most_bytes: int) -> pa.Table:
    if not (data.startswith(_MAGIC) and data.endswith(_MAGIC)):
        raise InvalidInput("is not a whole feather file (Arrow IPC)", _MEND)
    # Behind the magic a file is a stream, so that sizes and data are read from the same messages.
    stream = pa.py_buffer(data).slice(8)
    unpacked = 0
    for message in pa.ipc.MessageReader.open_stream(stream):
        if message.type == "record batch":
            unpacked += _unpacked_bytes(message.metadata.to_pybytes(), message.body)
        elif message.type != "schema":
            raise InvalidInput(f"holds a {message.type}", "Write plain columns of numbers and text.")
        if unpacked > most_bytes:
            raise InvalidInput(
                f"unpacks to more than the {most_bytes / MEBIBYTE:g} MiB allowed", "Check that it is the right file."
            )
    with pa.ipc.open_stream(stream) as reader:
        table = reader.read_all()
    table.validate(full=True)
    return table


def _unpacked_bytes(metadata: bytes, body: pa.Buffer) -> int:
    """Bytes that the buffers of a record batch take in memory, from its flatbuffer (Arrow's Message.fbs)."""
    message = _indirect(metadata, 0)
    if metadata[_field(metadata, message, 1)] != _RECORD_BATCH:
        raise ValueError("message types contradict each other")
    batch = _indirect(metadata, _field(metadata, message, 2))
    vector = _indirect(metadata, _field(metadata, batch, 2))
    compressed = _field(metadata, batch, 3) != 0
    total = 0
    for i in range(_number("<I", metadata, vector)):
        offset, length = struct.unpack_from("<qq", metadata, vector + 4 + 16 * i)
        unpacked = length
        if compressed and length >= 8:
            (unpacked,) = struct.unpack("<q", body.slice(offset, 8).to_pybytes())
        total += max(unpacked, length)
    return total


def _number(form: str, data: bytes, at: int) -> int:
    return int(struct.unpack_from(form, data, at)[0])


def _indirect(data: bytes, at: int) -> int:
    """Follow a flatbuffer offset."""
    return at + _number("<I", data, at)


def _field(data: bytes, table: int, slot: int) -> int:
    """Where a field of a flatbuffer table lies; 0 if it is not there."""
    vtable = table - _number("<i", data, table)
    entry = 4 + 2 * slot
    offset = _number("<H", data, vtable + entry) if entry < _number("<H", data, vtable) else 0
    return table + offset if offset else 0


def _column(table: pa.Table, name: str, kind: str) -> np.ndarray[Any, Any]:
    place = Place(key=name)
    if table.column_names.count(name) != 1:
        problem = "stands twice" if name in table.column_names else "is missing"
        raise InvalidInput(problem, f"The file has the columns {', '.join(table.column_names)[:300]}.", place)
    column = table.column(name)
    if column.null_count:
        raise InvalidInput(f"has {column.null_count} empty cells", "Give every row a value.", place)
    if kind == "str":
        if not (pa.types.is_string(column.type) or pa.types.is_large_string(column.type)):
            raise InvalidInput(f"is {column.type}, not text", "Write text.", place)
        return np.array(column.to_pylist(), dtype=np.str_)
    wanted = np.dtype(kind)
    fits = pa.types.is_integer(column.type) if wanted.kind in "iu" else _is_number(column.type)
    values = column.to_numpy() if fits else None
    if values is None or not np.can_cast(values.dtype, wanted, "same_kind" if wanted.kind == "f" else "safe"):
        raise InvalidInput(f"is {column.type}, not {kind}", f"Write {kind}.", place)
    return np.asarray(values, dtype=wanted)


def _is_number(kind: pa.DataType) -> bool:
    return bool(pa.types.is_floating(kind) or pa.types.is_integer(kind))
