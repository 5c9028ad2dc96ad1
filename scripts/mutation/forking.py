"""A pytest plugin that runs the collected tests once per mutant, each in a fork, until the first failure.

The tests are collected once; a first round without mutant records which of them reach which mutated function. A fork
then runs only those: first the ones that caught most so far, then the quickest.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
from mutmut.mutation import trampoline

PLAN, RESULTS = (Path(os.environ[name]) for name in ("MUTATION_PLAN", "MUTATION_RESULTS"))
UNDER_TEST = "MUTANT_UNDER_TEST"
PATIENCE_S = 60


class Outcome:
    """The first failure of a round of tests."""

    failed = ""

    @pytest.hookimpl
    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self.failed = self.failed or report.nodeid


@pytest.hookimpl(tryfirst=True)
def pytest_runtestloop(session: pytest.Session) -> bool:
    outcome = Outcome()
    session.config.pluginmanager.register(outcome)
    reached, seconds = _first_round(session.items, outcome)
    results = [json.loads(line) for line in RESULTS.read_text().splitlines()] if RESULTS.exists() else []
    caught_by = Counter(one["caught_by"] for one in results)
    with RESULTS.open("a") as file:
        for mutant in json.loads(PLAN.read_text()):
            function = mutant.partition("__mutmut_")[0]
            items = [item for item in session.items if function in reached[item.nodeid]]
            items.sort(key=lambda item: (-caught_by[item.nodeid], seconds[item.nodeid]))
            caught = _forked(mutant, items, outcome)
            caught_by[caught] += 1
            print(json.dumps({"mutant": mutant, "caught_by": caught}), file=file, flush=True)
    return True


def _first_round(items: list[pytest.Item], outcome: Outcome) -> tuple[dict[str, set[str]], dict[str, float]]:
    """Mutated functions that each test reaches, and how long it takes; nothing may fail without a mutant."""
    reached: dict[str, set[str]] = {}
    seconds: dict[str, float] = {}
    for item in items:
        hits = reached[item.nodeid] = set()
        start = time.perf_counter()
        with _recorded(hits):
            _run(item)
        seconds[item.nodeid] = time.perf_counter() - start
        if outcome.failed:
            sys.exit(f"{outcome.failed} fails without any mutant")
    return reached, seconds


@contextlib.contextmanager
def _recorded(hits: set[str]) -> Iterator[None]:
    os.environ[UNDER_TEST] = "stats"
    trampoline.record_trampoline_hit = lambda name, caller=None: hits.add(name)
    yield
    os.environ[UNDER_TEST] = ""


def _run(item: pytest.Item) -> None:
    item.config.hook.pytest_runtest_protocol(item=item, nextitem=None)


def _forked(mutant: str, items: list[pytest.Item], outcome: Outcome) -> str:
    """The test that caught the mutant, ``time`` if it made them endless, or nothing."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        signal.alarm(PATIENCE_S)
        os.environ[UNDER_TEST] = mutant
        with contextlib.suppress(BaseException):
            for item in items:
                _run(item)
                if outcome.failed:
                    break
        os.write(write, (outcome.failed or ("crash" if sys.exc_info()[0] else "")).encode())
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as pipe:
        caught = pipe.read()
    _, status = os.waitpid(child, 0)
    return "time" if status else caught
