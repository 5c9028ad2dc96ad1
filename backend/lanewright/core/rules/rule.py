"""What a rule is: one code, one question put to a comparison, and the words that explain it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from lanewright.core.claims import Claims
from lanewright.core.comparison import Comparison
from lanewright.core.elements import MapState
from lanewright.core.violations import Violation


@dataclass(frozen=True, slots=True)
class Remedy:
    """A map that mends a violation; or claims that do, all of them (None: as they are)."""

    title: str
    edited: MapState
    claims: Claims | None = None


@dataclass(frozen=True, slots=True)
class Rule:
    """One rule of spec §5.

    Attributes:
        code: stable name; also the name of its file, its page and its test.
        find: the violations in a comparison, without fixes.
        remedies: edited maps that mend a violation, best first, each with a title; the check offers the first that
            removes the violation and adds none.
        what: what must not be, in one or two sentences.
        why: the reason, naming the desideratum of spec §9.
        mend: what an annotator does about it.
        example: the fixture that shows it, if one does.
        gives_way_to: codes (or prefixes ending in a dot) that silence it on the same elements.
    """

    code: str
    find: Callable[[Comparison], Iterable[Violation]]
    remedies: Callable[[Comparison, Violation], Iterable[Remedy]]
    what: str
    why: str
    mend: str
    example: str | None = None
    gives_way_to: tuple[str, ...] = ()


def no_remedies(_comparison: Comparison, _violation: Violation) -> Iterable[Remedy]:
    """For what only a person can mend."""
    return ()
