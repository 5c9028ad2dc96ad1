"""Domain errors. They carry facts (what, where, how to mend it) and know nothing of HTTP."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


class LanewrightError(Exception):
    """Base of every error that a user may be told about.

    Attributes:
        code: stable machine-readable name, e.g. ``"task.not_found"``.
        message: one sentence, what is wrong and where.
        mend: one sentence, what to do about it; empty when the message says it all.
        facts: JSON-ready details (ids, provided and expected values).
    """

    code = "error"

    def __init__(self, message: str, *, mend: str = "", code: str | None = None, **facts: Any):
        super().__init__(message)
        self.message = message
        self.mend = mend
        self.facts = facts
        if code is not None:
            self.code = code

    def __str__(self) -> str:
        end = "" if self.message.endswith((".", "!", "?")) or not self.mend else "."
        return f"{self.message}{end} {self.mend}".strip()


class NotFound(LanewrightError):
    """The thing named does not exist, or the asker may not know that it does."""

    code = "not_found"


class Forbidden(LanewrightError):
    """The actor may not do this."""

    code = "forbidden"


class Unauthenticated(LanewrightError):
    """Nobody is signed in, or the credentials do not hold."""

    code = "unauthenticated"


class Conflict(LanewrightError):
    """The request contradicts the present state (stale base, replay with another body, wrong task state)."""

    code = "conflict"


class Throttled(LanewrightError):
    """Too many attempts; ``facts["retry_after_s"]`` says when to come back."""

    code = "throttled"


@dataclass(frozen=True, slots=True)
class Place:
    """Where in an input a problem sits: file, element, key; each may be unknown."""

    file: str | None = None
    element: str | None = None
    key: str | None = None

    def __str__(self) -> str:
        parts = [self.file, self.element, f'"{self.key}"' if self.key else None]
        return ", ".join(part for part in parts if part)


class InvalidInput(LanewrightError):
    """Input that cannot be used: names the file, the element and the key, and how to mend it.

    The place can be completed on the way up (a parser knows the key, the reader of the file its name).
    """

    code = "invalid_input"

    def __init__(self, problem: str, mend: str, place: Place | None = None, code: str | None = None):
        self.problem = problem
        self.place = place or Place()
        where = str(self.place)
        super().__init__(f"{where}: {problem}" if where else problem, mend=mend, code=code, **asdict(self.place))

    def within(self, *, file: str | None = None, element: str | None = None) -> InvalidInput:
        """The same error, with the parts of its place filled in that were unknown so far."""
        place = Place(self.place.file or file, self.place.element or element, self.place.key)
        return InvalidInput(self.problem, self.mend, place, self.code)
