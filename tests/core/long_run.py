"""Many examples of "one explanation" and fix closure, outside the ordinary tests; resumable.

``python -m tests.core.long_run RESULTS.txt 10000`` appends a line per example and goes on where the file ends.
"""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random

from tests.core.street_maps import random_map
from tests.core.test_properties import fixes_close, one_explanation
from tests.core.worlds import REAL_MAPS, real_map

EVERY_REAL = 8
"""Every eighth example is on a real map, the others on procedural ones."""


def main(results: Path, count: int) -> int:
    """Run the examples that the file lacks; how many failed in all."""
    real = [real_map(path) for path in REAL_MAPS]
    done = results.read_text().splitlines() if results.exists() else []
    with results.open("a") as file:
        for seed in range(len(done), count):
            base = real[seed // EVERY_REAL % len(real)] if real and seed % EVERY_REAL == 0 else random_map(Random(seed))
            outcome = "passed"
            try:
                one_explanation(base, seed)
                fixes_close(base, seed)
            except Exception as error:
                outcome = f"failed {type(error).__name__}"
            print(seed, outcome, file=file, flush=True)
    return sum(not line.endswith("passed") for line in results.read_text().splitlines())


if __name__ == "__main__":
    failed = main(Path(sys.argv[1]), int(sys.argv[2]))
    print(f"{failed} of {sys.argv[2]} examples failed")
    sys.exit(1 if failed else 0)
