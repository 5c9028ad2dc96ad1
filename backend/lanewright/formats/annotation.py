"""An annotation made elsewhere: the JSON that ``lanewright diff`` writes (spec §8), as claims about two maps.

``changes`` or ``updates`` may be left out, and so may what no rule reads (leaves, old, new). Other keys are ignored.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from enum import StrEnum
from pathlib import Path
from typing import Any, TypeVar

from lanewright.core.attributes import parse_id
from lanewright.core.changes import AtomicChange, Category, Macros
from lanewright.core.claims import Claims, DeclaredMacros
from lanewright.core.elements import ElementKey, ElementKind, MapState
from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.annotated_elements import AnnotatedElements
from lanewright.formats.json_document import parse_json
from lanewright.formats.map_pair import PAIR_LIMITS, MapPair
from lanewright.formats.untrusted_file import read_given_bytes

LIMITS = PAIR_LIMITS
"""``old`` and ``new`` hold at most what the two maps hold."""
_MEMBERS = ("changes", "updates")
_COUNT = "lane_number"
_MACROS = tuple(macro.name for macro in fields(Macros))

_Word = TypeVar("_Word", bound=StrEnum)


def read_annotation(path: Path, maps: MapPair) -> Claims:
    """What the file claims of the two maps, told from the base to the edited one.

    Raises:
        InvalidInput: it is no such JSON, or names an element that is in neither map; names the file (by the path
            given), the key and the mend.
    """
    return parse_annotation(
        read_given_bytes(path, most_bytes=LIMITS.size), str(path), maps.base.state, maps.edited.state
    )


def parse_annotation(data: bytes, file_name: str, base: MapState, edited: MapState) -> Claims:
    """What ``data`` claims of the two maps. Raises InvalidInput as ``read_annotation`` does."""
    document = parse_json(data, file_name, LIMITS)
    try:
        root = _require_object(document.value, "")
        if not any(name in root for name in _MEMBERS):
            raise _bad("", f"has neither {' nor '.join(_MEMBERS)}", "Write at least one of these lists.")
        return Claims(
            annotated=tuple(_changes(root.get("changes", []), AnnotatedElements(base, edited))),
            declared=tuple(_updates(root.get("updates", []), AnnotatedElements(base, edited))),
        )
    except InvalidInput as error:
        raise error.within(file=file_name) from None


def _changes(value: Any, elements: AnnotatedElements) -> Iterator[AtomicChange]:
    for key, item in _items(value, "changes"):
        change = _require_object(item, key)
        element = elements.named(_element(change, key), key)
        categories = tuple(
            _word(Category, category, at, "a category") for at, category in _member_items(change, key, "categories")
        )
        if len(set(categories)) < len(categories):
            raise _bad(f"{key}.categories", "names a category twice", "Name each once.")
        leaves = tuple(_text(leaf, at) for at, leaf in _items(change.get("leaves", []), f"{key}.leaves"))
        old, new = (_attributes(change.get(name), f"{key}.{name}") for name in ("old", "new"))
        yield AtomicChange(element.kind, element.id, categories, leaves, old, new)


def _updates(value: Any, elements: AnnotatedElements) -> Iterator[DeclaredMacros]:
    for key, item in _items(value, "updates"):
        update = _require_object(item, key)
        names = {at: _element_or_id(element, at) for at, element in _member_items(update, key, "elements")}
        yield DeclaredMacros(elements.of_update(names), _macros(_member(update, key, "macros"), f"{key}.macros"))


def _element_or_id(value: Any, key: str) -> ElementKey | int:
    """An element of an update: its id, or ``{"kind", "id"}`` as in the ``declarations`` of a fix."""
    return _element(value, key) if isinstance(value, dict) else parse_id(value, key)


def _element(value: dict[str, Any], key: str) -> ElementKey:
    kind = _word(ElementKind, _member(value, key, "kind"), f"{key}.kind", "a kind of element")
    return ElementKey(kind, parse_id(_member(value, key, "id"), f"{key}.id"))


def _macros(value: Any, key: str) -> Macros:
    macros = _require_object(value, key)
    for name in macros:
        if name not in _MACROS:
            raise _bad(f"{key}.{name:.40}", "is no macro", f"The macros are {', '.join(_MACROS)}.")
    flags = {name: _flag(_member(macros, key, name), f"{key}.{name}") for name in _MACROS if name != _COUNT}
    return Macros(**flags, lane_number=_count(_member(macros, key, _COUNT), f"{key}.{_COUNT}"))


def _bad(key: str, problem: str, mend: str) -> InvalidInput:
    return InvalidInput(problem, mend, Place(key=key or None))


def _require_object(value: Any, key: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise _bad(key, "is not an object", "Write a JSON object in braces.")
    return value


def _member(value: dict[str, Any], key: str, name: str) -> Any:
    if name not in value:
        raise _bad(f"{key}.{name}", "is missing", "Write it as lanewright diff --json does.")
    return value[name]


def _member_items(value: dict[str, Any], key: str, name: str) -> Iterator[tuple[str, Any]]:
    """The items of a list that must be there and say something."""
    items = _member(value, key, name)
    if items == []:
        raise _bad(f"{key}.{name}", "is empty", f"Name them, or leave {key} out.")
    return _items(items, f"{key}.{name}")


def _items(value: Any, key: str) -> Iterator[tuple[str, Any]]:
    if not isinstance(value, list):
        raise _bad(key, "is not a list", "Write a JSON list in brackets.")
    return ((f"{key}[{position}]", item) for position, item in enumerate(value))


def _word(words: type[_Word], value: Any, key: str, what: str) -> _Word:
    try:
        return words(value)
    except ValueError:
        raise _bad(key, f"is {value!r:.60}, not {what}", f"Use one of {', '.join(words)}.") from None


def _flag(value: Any, key: str) -> bool:
    if not isinstance(value, bool):
        raise _bad(key, f"is {value!r:.60}, not true or false", "Write true or false.")
    return value


def _count(value: Any, key: str) -> int:
    if isinstance(value, bool) or not isinstance(value, int):
        raise _bad(key, f"is {value!r:.60}, not a whole number", "Write by how many lanes the road grew, e.g. 1 or -1.")
    return value


def _text(value: Any, key: str) -> str:
    if not isinstance(value, str):
        raise _bad(key, f"is {value!r:.60}, not text", "Write a leaf as lanewright diff --json does.")
    return value


def _attributes(value: Any, key: str) -> dict[str, Any] | None:
    return None if value is None else _require_object(value, key)
