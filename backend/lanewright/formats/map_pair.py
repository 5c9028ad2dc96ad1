"""Two maps to be compared: two AV2 map files, or one file ``{"base": map, "edited": map}``. File names are free."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from lanewright.core.errors import InvalidInput, Place
from lanewright.formats import json_text
from lanewright.formats.av2_map import LIMITS, MapDocument, parse_map
from lanewright.formats.json_document import BYTE_ORDER_MARK, Limits, parse_json
from lanewright.formats.untrusted_file import read_given_bytes

PAIR_LIMITS = Limits(size=2 * LIMITS.size, depth=LIMITS.depth + 1, nodes=2 * LIMITS.nodes)
_MEMBERS = ("base", "edited")


@dataclass(frozen=True, slots=True)
class MapPair:
    """The map before and after."""

    base: MapDocument
    edited: MapDocument


def read_map_pair(base: Path, edited: Path | None = None) -> MapPair:
    """The maps of two files; of one file with both where only that is given (other keys beside them are ignored).

    Raises:
        InvalidInput: names file (by the path given, as both may have one name), element, key and the mend.
    """
    if edited is not None:
        return MapPair(
            *(parse_map(read_given_bytes(path, most_bytes=LIMITS.size), str(path)) for path in (base, edited))
        )
    return _parse_pair(read_given_bytes(base, most_bytes=PAIR_LIMITS.size), str(base))


def _parse_pair(data: bytes, file_name: str) -> MapPair:
    document = parse_json(data, file_name, PAIR_LIMITS)
    if not isinstance(document.value, dict):
        raise InvalidInput("is not a JSON object", "Name two map files, or one {base, edited}.", Place(file=file_name))
    missing = [name for name in _MEMBERS if name not in document.value]
    if missing:
        mend = "Name two map files, or one that holds both as {base, edited}."
        raise InvalidInput("is missing", mend, Place(file=file_name, key=missing[0]))
    text = document.text
    start = json_text.skip_space(text, len(BYTE_ORDER_MARK) if text.startswith(BYTE_ORDER_MARK) else 0)
    maps = {
        member.key: parse_map(text[member.start : member.end].encode(), f"{file_name}, {member.key}")
        for member in json_text.members(text, start)
        if member.key in _MEMBERS
    }
    return MapPair(maps["base"], maps["edited"])
