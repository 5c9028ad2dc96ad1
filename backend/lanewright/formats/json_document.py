"""Untrusted JSON: bytes to values, with every way to go wrong named by file and path inside it.

The standard library's scanner does the parsing; its hooks only mark what is refused, and the tree is walked for the
path of a mark only when there is one. Depth and size are checked before anything is built.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
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
_STRINGS = re.compile(rb'"(?:[^"\\]++|\\.)*+(?:"|\\?\Z)', re.DOTALL)
_SUSPICIOUS_ESCAPE = re.compile(r"\\u(?:0000|[dD][89a-fA-F])")
_DEPTH_STEP = np.zeros(256, dtype=np.int8)
_DEPTH_STEP[[ord("{"), ord("[")]] = 1
_DEPTH_STEP[[ord("}"), ord("]")]] = -1


@dataclass(frozen=True, slots=True)
class Limits:
    """What a file may take. ``nodes`` counts objects, lists and their members."""

    size: int = 32 * MEBIBYTE
    depth: int = 32
    nodes: int = 2_000_000


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
    return JsonDocument(text, value)


def _check_shape(data: bytes, limits: Limits) -> None:
    """Depth and node count from the brackets and commas outside strings, before anything is built."""
    bare = np.frombuffer(_STRINGS.sub(b"", data), dtype=np.uint8)
    depth = int(np.cumsum(_DEPTH_STEP[bare], dtype=np.int32).max(initial=0))
    if depth > limits.depth:
        raise InvalidInput(
            f"nests {depth} levels deep, more than the {limits.depth} allowed", "Check that it is what was meant."
        )
    counts = np.bincount(bare, minlength=256)
    nodes = int(counts[ord("{")] + counts[ord("[")] + counts[ord(",")])
    if nodes > limits.nodes:
        raise InvalidInput(
            f"holds {nodes:,} values, more than the {limits.nodes:,} allowed", "Check that it is what was meant."
        )


def _decoder(refused: list[_Refused]) -> json.JSONDecoder:
    def refuse(problem: str, mend: str, key: str | None = None) -> _Refused:
        refused.append(_Refused(problem, mend, key))
        return refused[-1]

    def number(text: str) -> float | _Refused:
        value = float(text)
        return value if math.isfinite(value) else refuse(f"is {text:.40}, too large a number", "Write a finite number.")

    def whole_number(text: str) -> int | _Refused:
        if len(text) > _MOST_DIGITS:
            return refuse(f"is a number of {len(text)} digits", "Write a number of a sensible size.")
        return int(text)

    def constant(text: str) -> _Refused:
        return refuse(f"is {text}, not a number of JSON", "Write a finite number.")

    def members(pairs: list[tuple[str, Any]]) -> dict[str, Any] | _Refused:
        value = dict(pairs)
        if len(value) == len(pairs):
            return value
        seen: set[str] = set()
        twice = next(key for key, _ in pairs if key in seen or seen.add(key))  # type: ignore[func-returns-value]
        return refuse("stands twice in one object", "Keep one of the two.", twice)

    return json.JSONDecoder(
        parse_float=number, parse_int=whole_number, parse_constant=constant, object_pairs_hook=members
    )


def _refuse_marked(root: Any, locate: Locate) -> None:
    """Walk the tree (without recursion, in the order of the file) to the first thing that is refused."""
    pending: list[tuple[JsonPath, Any]] = [((), root)]
    while pending:
        path, value = pending.pop()
        if isinstance(value, _Refused):
            where = path if value.key is None else (*path, value.key)
            raise InvalidInput(value.problem, value.mend, locate(where))
        if isinstance(value, dict):
            for key in value:
                _check_characters(key, path, "has a key that", locate)
            pending.extend(((*path, key), item) for key, item in reversed(value.items()))
        elif isinstance(value, list):
            pending.extend(((*path, i), value[i]) for i in reversed(range(len(value))))
        elif isinstance(value, str):
            _check_characters(value, path, "is text that", locate)


def _check_characters(value: str, path: JsonPath, subject: str, locate: Locate) -> None:
    if "\0" in value:
        raise InvalidInput(f"{subject} contains the NUL character \\u0000", "Remove it.", locate(path))
    if any("\ud800" <= character <= "\udfff" for character in value):
        raise InvalidInput(
            f"{subject} contains half a surrogate pair (\\ud800 to \\udfff)", "Write the whole character.", locate(path)
        )
