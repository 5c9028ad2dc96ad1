"""The change-mapping engine against reading the same maps: ratios of times taken in one run, side by side.

A full check and diff of a real map (where the real logs are at ../shared/data, else of a procedural one) against
``json.loads`` of the two files; and a save of ten elements on a map and on one ten times as large.
"""

from __future__ import annotations

import dataclasses
import gc
import json
import time
from collections.abc import Callable, Mapping
from pathlib import Path

from bench.legal_edits import legally_edited

from lanewright.core.attributes import element_attributes
from lanewright.core.comparison import Comparison
from lanewright.core.diff import diff_of
from lanewright.core.edits import apply_edits, edits_between
from lanewright.core.elements import MapState
from lanewright.core.restore import restore
from lanewright.core.rules import check_of
from lanewright.demo import build_map
from lanewright.formats.av2_map import parse_map

_SHARED_MAPS = Path(__file__).resolve().parents[2] / "shared" / "data" / "av2"
_ROUNDS = 25
_SMALL_BLOCKS, _LARGE_BLOCKS = (1, 3), (7, 6)
"""City grids of some 200 and 2,000 lanes."""


@dataclasses.dataclass(frozen=True)
class Figure:
    """One figure: what it is, its value, and how it must compare."""

    name: str
    value: float
    unit: str = "×"
    goal: float | None = None

    def __str__(self) -> str:
        goal = "" if self.goal is None else f"   goal < {self.goal:g}   {'ok' if self.value < self.goal else 'MISSED'}"
        return f"{self.name:<64}{self.value:>9.2f} {self.unit:<3}{goal}"


def fastest_ms(actions: Mapping[str, Callable[[], object]], rounds: int = _ROUNDS) -> dict[str, float]:
    """The fastest time of each action in milliseconds; they take turns, so that a noisy machine is fair to all."""
    fastest = dict.fromkeys(actions, float("inf"))
    for _ in range(rounds):
        for name, action in actions.items():
            gc.collect()
            gc.disable()
            began = time.perf_counter()
            action()
            fastest[name] = min(fastest[name], (time.perf_counter() - began) * 1e3)
            gc.enable()
    return fastest


def figures() -> list[Figure]:
    """All figures of the engine."""
    return [*_against_reading(), *_by_what_changed()]


def _against_reading() -> list[Figure]:
    real = sorted(_SHARED_MAPS.glob("*/map/log_map_archive_*.json"))
    base_bytes = real[-1].read_bytes() if real else _as_file(build_map(7, blocks=_SMALL_BLOCKS))
    document = parse_map(base_bytes, "base.json")
    edited_bytes = document.render(legally_edited(document.state, 20))
    # Parsed apart, as two files are: no element of the one is an element of the other.
    base, edited = (parse_map(data, "map.json").state for data in (base_bytes, edited_bytes))
    times = fastest_ms(
        {
            "loads": lambda: (json.loads(base_bytes), json.loads(edited_bytes)),
            "convert": lambda: (parse_map(base_bytes, "base.json"), parse_map(edited_bytes, "edited.json")),
            "engine": lambda: _checked(base, edited),
        }
    )
    what = f"{'real' if real else 'procedural'} map, {len(base.lanes)} lanes, 20 edits"
    return [
        Figure(f"check + diff / json.loads ({what})", times["engine"] / times["loads"], goal=3.0),
        Figure("  json.loads of the two files", times["loads"], "ms"),
        Figure("  check + diff from parsed maps", times["engine"], "ms"),
        Figure("  files to maps (json.loads, validation and conversion)", times["convert"], "ms"),
    ]


def _checked(base: MapState, edited: MapState) -> object:
    comparison = Comparison(MapState.of(base), edited)  # nothing known of either
    return diff_of(comparison), check_of(comparison)


def _by_what_changed() -> list[Figure]:
    """A save as the server makes it: edits (as parsed JSON) applied to the base, what is below tolerance restored,
    checked by all rules, and the diff. The base is known from an earlier save, as it is in the server's memory. The
    full check does the same between two maps of which nothing is known and that share no element."""
    edits = {}
    bases = {}
    for size, blocks in (("small", _SMALL_BLOCKS), ("large", _LARGE_BLOCKS)):
        bases[size] = build_map(7, blocks=blocks)
        edits[size] = edits_between(bases[size], legally_edited(bases[size], 10))
    lanes = {size: len(base.lanes) for size, base in bases.items()}
    copy = _copied(apply_edits(bases["large"], edits["large"]))
    times = fastest_ms(
        {
            "small": lambda: _saved(bases["small"], apply_edits(bases["small"], edits["small"])),
            "large": lambda: _saved(bases["large"], apply_edits(bases["large"], edits["large"])),
            "full": lambda: _saved(MapState.of(bases["large"]), MapState.of(copy)),
        }
    )
    return [
        Figure(
            f"save of 10 elements, {lanes['large']} lanes / {lanes['small']} lanes",
            times["large"] / times["small"],
            goal=1.3,
        ),
        Figure(f"save of 10 elements / full check, {lanes['large']} lanes", times["large"] / times["full"], goal=0.1),
        Figure(f"  apply, restore, check + diff, {lanes['small']} lanes", times["small"], "ms"),
        Figure(f"  apply, restore, check + diff, {lanes['large']} lanes", times["large"], "ms"),
        Figure(f"  restore, full check + diff, {lanes['large']} lanes", times["full"], "ms"),
    ]


def _saved(base: MapState, edited: MapState) -> object:
    comparison = Comparison(base, restore(base, edited))
    return diff_of(comparison), check_of(comparison)


def _copied(state: MapState) -> MapState:
    return MapState.of(dataclasses.replace(element) for element in state)


def _as_file(state: MapState) -> bytes:
    groups = {"pedestrian_crossings": state.crossings, "lane_segments": state.lanes}
    document = {
        group: {str(key): element_attributes(element) for key, element in elements.items()}
        for group, elements in groups.items()
    }
    return json.dumps(document | {"drivable_areas": {}}).encode()


def main() -> None:
    """Print all figures."""
    for figure in figures():
        print(figure)


if __name__ == "__main__":
    main()
