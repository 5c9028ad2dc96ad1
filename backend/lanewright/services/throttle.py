"""Slows guessing of passwords down: waits that double with each failure, counted by name and by address."""

from __future__ import annotations

import datetime
import math
from dataclasses import dataclass

from sqlalchemy.orm import Session

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


def seconds_to_wait(session: Session, name: str, address: str, now: datetime.datetime) -> int:
    """How long this name or this address must wait before the next attempt; 0: go ahead.

    Holds a lock on both until the transaction ends, so that parallel attempts are counted one after the other.
    """
    accounts.lock_sign_in(session, f"name {name}", f"address {address}")
    by_name = accounts.failures_of(session, name=name, since=now - MEMORY)
    by_address = accounts.failures_of(session, address=address, since=now - MEMORY)
    return max(_left(BY_NAME, *by_name, now), _left(BY_ADDRESS, *by_address, now))


def note_failure(session: Session, name: str, address: str, now: datetime.datetime) -> None:
    accounts.forget_failures(session, before=now - MEMORY)
    accounts.add_failure(session, name, address, now)


def note_success(session: Session, name: str) -> None:
    """A name's own success clears its count; the address keeps what it did to other names."""
    accounts.forget_failures(session, name=name)


def _left(allowance: Allowance, failures: int, last: datetime.datetime | None, now: datetime.datetime) -> int:
    if last is None:
        return 0
    return max(0, math.ceil(allowance.wait_s(failures) - (now - last).total_seconds()))
