"""Many examples of the state machine of ``update_machine``, outside the ordinary tests; resumable.

``python -m tests.core.long_run RESULTS.txt 10000`` appends a line per batch of examples and goes on where the
file ends. ``--first`` keeps runs side by side apart; ``--again SEED`` shows the shortest failing sequence of a batch.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

import hypothesis
from hypothesis import HealthCheck, Phase, settings
from hypothesis.stateful import run_state_machine_as_test
from tests.core.update_machine import STEPS, JunctionUpdate, MapUpdate, RealUpdate, StreetUpdate
from tests.core.worlds import REAL_MAPS, REAL_MAPS_MISSING

BATCH = 25
KINDS: tuple[type[MapUpdate], ...] = (StreetUpdate, JunctionUpdate, StreetUpdate, RealUpdate, StreetUpdate)
"""Batches on each kind of map, in turn."""


def main() -> int:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("results", type=Path, nargs="?", help="the file to go on with")
    options.add_argument("examples", type=int, nargs="?", default=10_000, help="how many in all")
    options.add_argument("--first", type=int, default=0, help="seed of the first batch")
    options.add_argument("--again", type=int, metavar="SEED", help="run this batch alone, and shrink what fails")
    chosen = options.parse_args()
    if not REAL_MAPS:
        sys.exit(REAL_MAPS_MISSING)
    if chosen.again is not None:
        run(chosen.again, (Phase.generate, Phase.shrink))
        return 0
    if chosen.results is None:
        options.error("name the file for the results")
    return go_on(chosen.results, chosen.examples, chosen.first)


def go_on(results: Path, examples: int, first: int) -> int:
    """Run the batches that the file lacks; how many failed in all."""
    commit = subprocess.run(["git", "describe", "--always", "--dirty"], capture_output=True, text=True, check=True)
    done = results.read_text().splitlines() if results.exists() else []
    with results.open("a") as file:
        for seed in range(first + len(done), first + -(-examples // BATCH)):
            outcome = "passed"
            try:
                run(seed, (Phase.generate,))
            except Exception as error:
                outcome = f"failed: {type(error).__name__}"
            kind = KINDS[seed % len(KINDS)].__name__
            print(f"seed {seed}: {BATCH} of {kind} at {commit.stdout.strip()} {outcome}", file=file, flush=True)
    lines = results.read_text().splitlines()
    failed = [line for line in lines if not line.endswith(" passed")]
    print(*failed, f"{len(lines) * BATCH} examples, {len(failed)} batches failed", sep="\n")
    return len(failed)


def run(seed: int, phases: tuple[Phase, ...]) -> None:
    """One batch; the same seed gives the same examples."""
    machine = hypothesis.seed(seed)(KINDS[seed % len(KINDS)])
    batch = settings(
        max_examples=BATCH,
        stateful_step_count=STEPS,
        deadline=None,
        database=None,
        phases=phases,
        suppress_health_check=list(HealthCheck),
    )
    run_state_machine_as_test(machine, settings=batch)


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
