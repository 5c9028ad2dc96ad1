"""Slows guessing of passwords down: waits that double with each failure, counted by name and by address."""

from __future__ import annotations

import datetime
import math
from collections.abc import Callable
from dataclasses import dataclass

from sqlalchemy.orm import Session

from lanewright.core.errors import Throttled
from lanewright.db.repositories import accounts


@dataclass(frozen=True, slots=True)
class Allowance:
    """How many failures are free, and how the wait grows after them (seconds)."""

    free: int
    longest_s: float

    def wait_s(self, failures: int) -> float:
        """Seconds to wait after the last of ``failures``: 0, then 1, 2, 4 … up to the longest."""
        excess = failures - self.free
        return 0.0 if excess < 0 else min(2.0 ** min(excess, 30), self.longest_s)


BY_NAME = Allowance(free=5, longest_s=15 * 60)
BY_ADDRESS = Allowance(free=30, longest_s=15 * 60)
MEMORY = datetime.timedelta(hours=1)
"""Failures older than this count no more."""


def judged(session: Session, name: str, address: str, holds: Callable[[], bool]) -> bool | Throttled:
    """What an attempt proves, counted; or the refusal to judge it now.

    ``holds`` does the slow work, and many attempts may do it side by side. Each is then counted under a lock, and those
    that others have outrun learn nothing: parallel guesses get no further than guesses in a row.
    """
    now = datetime.datetime.now(datetime.UTC)
    refusal = _refusal(session, name, address, now)
    if refusal is not None:
        return refusal
    proven = holds()
    accounts.lock_sign_in(session, f"name {name}", f"address {address}")
    refusal = _refusal(session, name, address, now)
    if refusal is not None:
        return refusal
    if proven:
        # The address keeps what it did to other names: one's own account is no way to start anew.
        accounts.forget_failures(session, name=name)
    else:
        accounts.forget_failures(session, before=now - MEMORY)
        accounts.add_failure(session, name, address, now)
    return proven


def _refusal(session: Session, name: str, address: str, now: datetime.datetime) -> Throttled | None:
    by_name = accounts.failures_of(session, name=name, since=now - MEMORY)
    by_address = accounts.failures_of(session, address=address, since=now - MEMORY)
    wait_s = max(_left(BY_NAME, *by_name, now), _left(BY_ADDRESS, *by_address, now))
    if not wait_s:
        return None
    return Throttled(
        "Too many attempts failed.",
        mend=f"Wait {wait_s} s, then try again.",
        code="session.throttled",
        retry_after_s=wait_s,
    )


def _left(allowance: Allowance, failures: int, last: datetime.datetime | None, now: datetime.datetime) -> int:
    if last is None:
        return 0
    return max(0, math.ceil(allowance.wait_s(failures) - (now - last).total_seconds()))
