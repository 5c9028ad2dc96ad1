"""Which split a log comes from (``splits.json``: TbV's train, val and test), and what follows for the release.

Three different things: the *source split*, the *release split* it goes to, and the *direction* in which it is edited.
TbV's train maps are up to date, so annotators invent a prior; its val maps are stale, so annotators update them, and
they make the test set. Source: paper supplement, shared facts §3.2.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from types import MappingProxyType

from lanewright.core.changes import Direction
from lanewright.core.errors import InvalidInput, Place
from lanewright.formats.json_document import Limits, parse_json
from lanewright.formats.untrusted_file import MEBIBYTE, read_bytes

LIMITS = Limits(size=4 * MEBIBYTE, depth=4, nodes=100_000)


class Split(StrEnum):
    """A part of a dataset, of the source or of the release."""

    TRAIN = "train"
    VAL = "val"
    TEST = "test"


@dataclass(frozen=True, slots=True)
class Assignment:
    """Where a log comes from, where it goes to, and which way it is edited. ``source`` None: in no list."""

    source: Split | None
    release: Split
    direction: Direction


_BY_SOURCE: Mapping[Split, tuple[frozenset[Split], Split, Direction]] = {
    Split.TRAIN: (frozenset({Split.TRAIN, Split.VAL}), Split.TRAIN, Direction.CURRENT_TO_PRIOR),
    Split.VAL: (frozenset({Split.TEST}), Split.TEST, Direction.PRIOR_TO_CURRENT),
}
"""Source split -> release splits it may go to, the one it goes to unless told, its direction.

TbV's test has no rule: its labels are not public."""


@dataclass(frozen=True, slots=True)
class SourceSplits:
    """Source split by log id."""

    by_log: Mapping[str, Split] = field(default_factory=dict)

    def assign(self, log_id: str, *, split: Split | None = None, direction: Direction | None = None) -> Assignment:
        """Place one log; ``split`` (of the release) and ``direction`` are what the caller asks for, if anything.

        Raises:
            InvalidInput: the log is in no list and the caller says too little, or what is asked contradicts its source.
        """
        source = self.by_log.get(log_id)
        if source is None or source not in _BY_SOURCE:
            if split is None or direction is None:
                known = (
                    "in no list of splits"
                    if source is None
                    else f"in the source split {source.value}, which has no rule"
                )
                raise InvalidInput(f"is {known}", "Say --split and --direction.", Place(element=f"log {log_id}"))
            return Assignment(source, split, direction)
        allowed, usual, fixed = _BY_SOURCE[source]
        if split is not None and split not in allowed:
            raise InvalidInput(
                f"is from the source split {source.value} and cannot go to {split.value}",
                f"Leave --split out, or say {' or '.join(sorted(allowed))}.",
                Place(element=f"log {log_id}"),
            )
        if direction is not None and direction is not fixed:
            raise InvalidInput(
                f"is from the source split {source.value}, which is edited {fixed.value}",
                "Leave --direction out.",
                Place(element=f"log {log_id}"),
            )
        return Assignment(source, split or usual, fixed)


def read_splits(path: Path) -> SourceSplits:
    """``{"train": [log id, …], "val": […], "test": […]}``.

    Raises:
        InvalidInput: broken, an unknown split, an id that is no text or that stands in two places.
    """
    value = parse_json(read_bytes(path, most_bytes=LIMITS.size), path.name, LIMITS).value
    by_log: dict[str, Split] = {}
    try:
        if not isinstance(value, dict):
            raise InvalidInput("is not an object", "Write an object of train, val and test.")
        for name, logs in value.items():
            if name not in set(Split):
                raise InvalidInput("is no split", "Use train, val and test.", Place(key=name[:60]))
            if not isinstance(logs, list):
                raise InvalidInput("is not a list of log ids", "Write a list of texts.", Place(key=name))
            for i, log_id in enumerate(logs):
                place = Place(key=f"{name}[{i}]")
                if not isinstance(log_id, str):
                    raise InvalidInput(f"is {log_id!r:.60}, not a log id", "Write it as text.", place)
                if log_id in by_log:
                    raise InvalidInput(
                        f"is {log_id:.60}, which is already in {by_log[log_id].value}", "Keep one.", place
                    )
                by_log[log_id] = Split(name)
    except InvalidInput as error:
        raise error.within(file=path.name) from None
    return SourceSplits(MappingProxyType(by_log))
