"""Words for lanes, marks, types and lengths, as a mapper says them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from lanewright.core.elements import LaneType, Mark

TYPE_WORDS = {LaneType.VEHICLE: "vehicle lane", LaneType.BIKE: "bike lane", LaneType.BUS: "bus lane"}


def listed(words: Sequence[str]) -> str:
    """``a``, ``a and b``, ``a, b and c``."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


def lanes_named(lanes: Iterable[int]) -> str:
    """``lane 1`` or ``lanes 1, 2 and 3``."""
    names = [str(lane) for lane in lanes]
    return f"lane{'s' if len(names) > 1 else ''} {listed(names)}"


def crossings_named(crossings: Iterable[int]) -> str:
    """``crossing 1`` or ``crossings 1 and 2``."""
    names = [str(crossing) for crossing in crossings]
    return f"crossing{'s' if len(names) > 1 else ''} {listed(names)}"


def mark_words(mark: Mark) -> str:
    """``solid white``, ``double dashed yellow``, ``none``, ``unknown``."""
    if mark in (Mark.NONE, Mark.UNKNOWN):
        return mark.value.lower()
    pattern = mark.pattern.replace("DASHED", "DASH").split("_")
    words = {"SOLID": "solid", "DASH": "dashed", "DOUBLE": "double"}
    joiner = "-" if "DOUBLE" not in pattern else " "
    return f"{joiner.join(words[part] for part in pattern)} {mark.colour.lower()}"


def metres(value: float) -> str:
    """A length with its unit: centimetres below 0.1 m, else metres with as many digits as matter."""
    if value < 0.095:
        return f"{value * 100:.0f} cm"
    return f"{value:.1f} m" if value < 9.95 else f"{value:.0f} m"


def capitalised(text: str) -> str:
    """The text with its first letter in upper case."""
    return text[:1].upper() + text[1:]


def was_or_were(elements: Sequence[object]) -> str:
    """``was`` for one, ``were`` for more."""
    return "was" if len(elements) == 1 else "were"
