"""Mutation testing of the engine: do its tests notice when the rules or the diff are broken?

Takes a seeded sample of the mutants that mutmut makes of ``core/rules``, ``core/diff``, ``core/comparison`` and
``core/identity`` and runs the fast tests of the core on each. Everything stays in ``.mutation/``; what is done is not
done again, so a run can be stopped and taken up later. ``--fresh`` starts over with the present sources.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HOME = ROOT / ".mutation"
SITE, WORK = HOME / "site", HOME / "work"
REQUIREMENTS = Path(__file__).with_name("requirements.txt")
TESTED_BY = ("test_fixtures.py", "rules", "test_diff.py", "test_roadgraph.py")
MUTATED = ("rules/*", "diff.py", "comparison.py", "identity.py")
ANY = "lanewright.core.diff.x_diff__mutmut_1"
BATCH = 100
SURVIVED, UNTESTED = 0, 33
"""What mutmut records: the tests' exit code, and its own code for a mutant that no test reaches."""


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--sample", type=int, default=400, help="how many mutants")
    options.add_argument("--seed", type=int, default=7)
    options.add_argument("--fresh", action="store_true", help="forget what was done")
    chosen = options.parse_args()
    if chosen.fresh:
        shutil.rmtree(WORK, ignore_errors=True)
    if not SITE.exists():
        _install()
    if not WORK.exists():
        _lay_out()
    if not _results():
        _mutmut("run", "--max-children", "1", ANY)  # makes all mutants and tries this one
    names = sorted(_results())
    sample = random.Random(chosen.seed).sample(names, min(chosen.sample, len(names)))  # noqa: S311  # not a secret
    while waiting := [name for name in sample if _results()[name] is None]:
        _mutmut("run", "--max-children", "1", *waiting[:BATCH])
        print(_score(sample), flush=True)
    _report(sample)


def _install() -> None:
    uv = Path(sys.executable).with_name("uv")
    subprocess.run(
        [
            uv,
            "pip",
            "install",
            "-q",
            "--python",
            sys.executable,
            "--target",
            SITE,
            "--require-hashes",
            "-r",
            REQUIREMENTS,
        ],
        check=True,
    )


def _lay_out() -> None:
    """Copies of the sources and the core's tests, side by side, where mutmut expects them."""
    ignore = shutil.ignore_patterns("__pycache__")
    shutil.copytree(ROOT / "backend" / "lanewright", WORK / "lanewright", ignore=ignore)
    for part in ("core", "fixtures"):
        shutil.copytree(ROOT / "tests" / part, WORK / "tests" / part, ignore=ignore)
    shutil.copy(ROOT / "tests" / "conftest.py", WORK / "tests")
    settings = {
        "source_paths": ["lanewright"],
        "only_mutate": [f"lanewright/core/{part}" for part in MUTATED],
        "also_copy": ["tests"],
        "pytest_add_cli_args": ["-q", "-p", "no:cacheprovider"],
        "pytest_add_cli_args_test_selection": [f"tests/core/{part}" for part in TESTED_BY],
    }
    lines = ["[tool.mutmut]", *(f"{name} = {json.dumps(value)}" for name, value in settings.items())]
    lines += ["[tool.pytest.ini_options]", 'pythonpath = ["."]', 'markers = ["browser", "shared"]']
    (WORK / "pyproject.toml").write_text("\n".join(lines) + "\n")


def _mutmut(*arguments: str, show: bool = False) -> str:
    environment = os.environ | {"PYTHONPATH": str(SITE), "COLUMNS": "200"}
    with (HOME / "mutmut.log").open("ab") as log:
        done = subprocess.run(
            [sys.executable, "-m", "mutmut", *arguments],
            cwd=WORK,
            env=environment,
            stdout=subprocess.PIPE if show else log,
            stderr=log,
            check=True,
        )
    return done.stdout.decode() if show else ""


def _results() -> dict[str, int | None]:
    """What became of each mutant; None: not tried yet."""
    results: dict[str, int | None] = {}
    for path in sorted((WORK / "mutants").rglob("*.meta")):
        results |= json.loads(path.read_text())["exit_code_by_key"]
    return results


def _score(sample: list[str]) -> str:
    codes = [code for name, code in _results().items() if name in set(sample) and code is not None]
    caught = sum(code not in (SURVIVED, UNTESTED) for code in codes)
    share = f"{caught / len(codes):.1%}" if codes else "none"
    return f"{len(codes)} of {len(sample)} mutants tried, {caught} caught ({share})"


def _report(sample: list[str]) -> None:
    results = _results()
    survivors = [name for name in sorted(sample) if results[name] in (SURVIVED, UNTESTED)]
    report = HOME / "report.txt"
    with report.open("w") as out:
        out.write(f"{_score(sample)}\n")
        for name in survivors:
            out.write(f"\n{_mutmut('show', name, show=True)}\n")
    print(f"{_score(sample)}; the {len(survivors)} that were not caught are in {report.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
