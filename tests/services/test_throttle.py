"""The wait between failed sign-ins, and that guessing in parallel gains nothing."""

from __future__ import annotations

import datetime
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import pytest

from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.db.models import LoginFailure
from lanewright.services import accounts, sessions
from lanewright.services.sessions import SessionRules
from lanewright.services.throttle import Allowance

RULES = SessionRules(idle=datetime.timedelta(hours=1), absolute=datetime.timedelta(days=1), demo_allowed=False)
GUESSES = 8


@pytest.mark.parametrize(
    ("failures", "wait_s"), [(0, 0), (4, 0), (5, 1), (6, 2), (7, 4), (14, 512), (15, 900), (10_000, 900)]
)
def test_the_wait_doubles_up_to_a_limit(failures: int, wait_s: float) -> None:
    assert Allowance(free=5, longest_s=900).wait_s(failures) == wait_s


def test_of_parallel_guesses_one_is_judged(fresh_database: str) -> None:
    with transaction(fresh_database) as session:
        accounts.add(session, name="anna", role=Role.ANNOTATOR, password="the right one")
        # Twelve failures, and their wait of 128 s is over: one more attempt is free, and the next wait is 256 s.
        over = datetime.datetime.now(datetime.UTC) - datetime.timedelta(seconds=200)
        session.add_all(LoginFailure(name="anna", address="elsewhere", at=over) for _ in range(12))
    start = Barrier(GUESSES)

    def guess(number: int) -> str:
        start.wait()
        with transaction(fresh_database) as session:
            outcome = sessions.sign_in(
                session, "anna", f"guess {number}", address=f"10.0.0.{number}", previous_token=None, rules=RULES
            )
            return type(outcome).__name__

    with ThreadPoolExecutor(GUESSES) as pool:
        outcomes = Counter(pool.map(guess, range(GUESSES)))
    assert outcomes == {"Unauthenticated": 1, "Throttled": GUESSES - 1}
