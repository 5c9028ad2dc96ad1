"""Untrusted JSON: bytes to values, with every way to go wrong named by file and path inside it.

The standard library's scanner does the parsing; its hooks only mark what is refused, and the tree is walked for the
path of a mark only when there is one. Depth and size are checked before anything is built.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.untrusted_file import MEBIBYTE

JsonPath = tuple[str | int, ...]
"""Object keys and list positions from the root, e.g. ``("lane_segments", "7", "left_lane_boundary", 3, "x")``."""
Locate = Callable[[JsonPath], Place]
"""Turns a path into the place that an error names (without the file)."""

BYTE_ORDER_MARK = "\ufeff"
_MOST_DIGITS = 300  # beyond it a whole number is no double any more, and parsing it is quadratic
_SUSPICIOUS_ESCAPE = re.compile(r"\\u(?:0000|[dD][89a-fA-F])")
_DEPTH_STEP = np.zeros(256, dtype=np.int8)
_DEPTH_STEP[[ord("{"), ord("[")]] = 1
_DEPTH_STEP[[ord("}"), ord("]")]] = -1
_OPENS_NODE = np.isin(np.arange(256), [ord("{"), ord("["), ord(",")])
_CHUNK_BYTES = MEBIBYTE


@dataclass(frozen=True, slots=True)
class Limits:
    """What a file may take. ``nodes`` counts objects, lists and their members."""

    size: int = 32 * MEBIBYTE
    depth: int = 32
    nodes: int = 1_000_000


@dataclass(frozen=True, slots=True)
class JsonDocument:
    """Parsed JSON beside its text (a byte order mark stays in the text)."""

    text: str
    value: Any


@dataclass(frozen=True, slots=True)
class _Refused:
    """Stands in the tree for a value that may not be there."""

    problem: str
    mend: str
    key: str | None = None


def path_text(path: JsonPath) -> str:
    """``a.b[3].x`` for ``("a", "b", 3, "x")``."""
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part:.80}" for part in path).removeprefix(".")


def parse_json(
    data: bytes,
    file: str,
    limits: Limits | None = None,
    locate: Locate = lambda path: Place(key=path_text(path) or None),
) -> JsonDocument:
    """JSON text as values.

    Raises:
        InvalidInput: not UTF-8, broken, too large or deep, or with duplicate keys, NaN, infinite numbers, NUL
            characters or lone surrogates; names the file and, where there is one, the path.
    """
    try:
        return _parse(data, limits or Limits(), locate)
    except InvalidInput as error:
        raise error.within(file=file) from None


def _parse(data: bytes, limits: Limits, locate: Locate) -> JsonDocument:
    if len(data) > limits.size:
        raise InvalidInput(
            f"is larger than the {limits.size / MEBIBYTE:g} MiB allowed", "Check that it is what was meant."
        )
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise InvalidInput(f"is not UTF-8 text at byte {error.start}", "Write it as UTF-8.") from None
    _check_shape(data, limits)
    refused: list[_Refused] = []
    body = text.removeprefix(BYTE_ORDER_MARK)
    try:
        value = _decoder(refused).decode(body)
    except json.JSONDecodeError as error:
        raise InvalidInput(
            f"is broken or cut short at line {error.lineno} column {error.colno} of JSON ({error.msg})",
            "Copy or send the whole of it again.",
        ) from None
    if refused or _SUSPICIOUS_ESCAPE.search(body):
        _refuse_marked(value, locate)
    if refused:  # the mark itself was lost, under a key that stands twice
        raise InvalidInput(refused[0].problem, refused[0].mend)
    return JsonDocument(text, value)


def _check_shape(data: bytes, limits: Limits) -> None:
    """Depth and node count from the brackets and commas outside strings, before anything is built."""
    # With escaped quotes out of the way, every other quote closes a string. (Outside of strings, where the parser stops
    # at a backslash, this may go wrong only behind that place.)
    bare = np.frombuffer(data.replace(b"\\\\", b"__").replace(b'\\"', b"__"), dtype=np.uint8)
    depth, nodes, in_string = 0, 0, np.uint8(0)
    for start in range(0, len(bare), _CHUNK_BYTES):
        chunk = bare[start : start + _CHUNK_BYTES]
        quotes = np.cumsum(chunk == ord('"'), dtype=np.uint8) + in_string  # wraps, which keeps odd odd
        outside = quotes % 2 == 0
        depths = depth + np.cumsum(_DEPTH_STEP[chunk] * outside, dtype=np.int64)
        if depths.max() > limits.depth:
            raise InvalidInput(f"nests more than the {limits.depth} levels allowed", "Check that it is what was meant.")
        nodes += int(np.count_nonzero(_OPENS_NODE[chunk] & outside))
        depth, in_string = int(depths[-1]), quotes[-1] % np.uint8(2)
    if nodes > limits.nodes:
        raise InvalidInput(
            f"holds {nodes:,} values, more than the {limits.nodes:,} allowed", "Check that it is what was meant."
        )


def _decoder(refused: list[_Refused]) -> json.JSONDecoder:
    """A decoder that leaves a mark where it meets the first thing that may not be, and adds that to ``refused``."""

    def refuse(instead: Any, problem: str, mend: str, key: str | None = None) -> Any:
        if refused:
            return instead
        refused.append(_Refused(problem, mend, key))
        return refused[0]

    def number(text: str) -> Any:
        value = float(text)
        if math.isfinite(value):
            return value
        return refuse(0.0, f"is {text:.40}, too large a number", "Write a finite number.")

    def whole_number(text: str) -> Any:
        if len(text) <= _MOST_DIGITS:
            return int(text)
        return refuse(0, f"is a number of {len(text)} digits", "Write a number of a sensible size.")

    def constant(text: str) -> Any:
        return refuse(0.0, f"is {text}, not a number of JSON", "Write a finite number.")

    def members(pairs: list[tuple[str, Any]]) -> Any:
        value = dict(pairs)
        if len(value) == len(pairs):
            return value
        seen: set[str] = set()
        twice = next(key for key, _ in pairs if key in seen or seen.add(key))  # type: ignore[func-returns-value]
        return refuse(value, "stands twice in one object", "Keep one of the two.", twice)

    return json.JSONDecoder(
        parse_float=number, parse_int=whole_number, parse_constant=constant, object_pairs_hook=members
    )


def _refuse_marked(root: Any, locate: Locate) -> None:
    """Walk the tree (without recursion, in the order of the file) to the first thing that is refused."""
    pending: list[Iterator[tuple[JsonPath, Any]]] = [iter([((), root)])]
    while pending:
        path, value = next(pending[-1], (None, None))
        if path is None:
            pending.pop()
        elif isinstance(value, _Refused):
            where = path if value.key is None else (*path, value.key)
            raise InvalidInput(value.problem, value.mend, locate(where))
        elif isinstance(value, str):
            _check_characters(value, path, "is text that", locate)
        elif isinstance(value, dict | list):
            pending.append(_children(path, value, locate))


def _children(path: JsonPath, value: dict[str, Any] | list[Any], locate: Locate) -> Iterator[tuple[JsonPath, Any]]:
    if isinstance(value, list):
        for position, item in enumerate(value):
            yield (*path, position), item
        return
    for key, item in value.items():
        _check_characters(key, path, "has a key that", locate)
        yield (*path, key), item


def _check_characters(value: str, path: JsonPath, subject: str, locate: Locate) -> None:
    if "\0" in value:
        raise InvalidInput(f"{subject} contains the NUL character \\u0000", "Remove it.", locate(path))
    if any("\ud800" <= character <= "\udfff" for character in value):
        raise InvalidInput(
            f"{subject} contains half a surrogate pair (\\ud800 to \\udfff)", "Write the whole character.", locate(path)
        )
