"""Surgery on JSON text: replace, drop and append members while every other character stays as it was written.

The text must already be known to be valid JSON without duplicate keys (``json_document`` sees to that).
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

_DECODER = json.JSONDecoder()
_SPACE = re.compile(r"[ \t\n\r]*")


class Member(NamedTuple):
    """One member of an object: offsets of its key, its value and the value's end, and the value itself."""

    key: str
    key_start: int
    start: int
    end: int
    value: Any


def skip_space(text: str, at: int) -> int:
    """The offset of the first character from ``at`` on that is no JSON whitespace."""
    match = _SPACE.match(text, at)
    return match.end() if match else at


def members(text: str, start: int) -> Iterator[Member]:
    """The members of the object whose ``{`` stands at ``start``, in the order of the text."""
    at = skip_space(text, start + 1)
    while text[at] != "}":
        key_start = at
        key, at = _DECODER.raw_decode(text, at)
        value_start = skip_space(text, skip_space(text, at) + 1)  # past the colon
        value, end = _DECODER.raw_decode(text, value_start)
        yield Member(key, key_start, value_start, end, value)
        at = skip_space(text, end)
        if text[at] == ",":
            at = skip_space(text, at + 1)


def items(text: str, start: int) -> Iterator[tuple[str, Any]]:
    """The items of the list whose ``[`` stands at ``start``: as written, and as values."""
    at = skip_space(text, start + 1)
    while text[at] != "]":
        value, end = _DECODER.raw_decode(text, at)
        yield text[at:end], value
        at = skip_space(text, end)
        if text[at] == ",":
            at = skip_space(text, at + 1)


def rewrite_object(
    text: str, start: int, changed: Mapping[str, str | None], appended: Mapping[str, str] | None = None
) -> str:
    """The object at ``start`` with some values replaced (None: the member dropped) and new members at its end.

    Args:
        changed: key -> new value as JSON text; keys that are not in the object are ignored.
        appended: key -> value as JSON text of members that the object does not have.
    """
    found = list(members(text, start))
    pieces = ["{"]
    written = False
    gap_start = start + 1
    for member in found:
        value = changed.get(member.key, text[member.start : member.end])
        if value is not None:
            gap = text[gap_start : member.key_start]
            pieces += [gap if written else gap.replace(",", "", 1), text[member.key_start : member.start], value]
            written = True
        gap_start = member.end
    for key, value in (appended or {}).items():
        pieces += [", " if written else "", json.dumps(key), ": ", value]
        written = True
    close = skip_space(text, gap_start)
    pieces.append(text[gap_start : close + 1])
    return "".join(pieces)
