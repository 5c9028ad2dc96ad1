"""Mutation testing of the engine: do its tests notice when the rules or the diff are broken?

Takes a seeded sample of the mutants that mutmut makes of ``core/rules``, ``core/diff``, ``core/comparison`` and
``core/identity`` and runs the fast tests of the core on each. Everything stays in ``.mutation/``; what is done is not
done again, so a run can be stopped and taken up later.
"""

from __future__ import annotations

import argparse
import difflib
import importlib
import inspect
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
REPORT = HOME / "report.txt"
NAMES, PLAN, RESULTS = (WORK / name for name in ("mutants.json", "plan.json", "results.jsonl"))
HERE = Path(__file__).parent
MUTATED = ("rules/*.py", "diff.py", "comparison.py", "identity.py")
TESTED_BY = (
    "rules",
    "test_diff.py",
    "test_fixtures.py",
    "test_identity.py",
    "test_precedence.py",
    "test_replay.py",
    "test_restore.py",
    "test_roadgraph.py",
)
SETTINGS = """
[tool.mutmut]
source_paths = ["lanewright"]

[tool.pytest.ini_options]
pythonpath = ["."]
markers = ["browser", "shared"]
"""
PROFILE = """
import hypothesis

hypothesis.settings.register_profile("mutation", derandomize=True, database=None, deadline=None)
hypothesis.settings.load_profile("mutation")
"""


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--sample", type=int, default=400, help="how many mutants")
    options.add_argument("--seed", type=int, default=7)
    options.add_argument("--only", default="", help="mutants of this name alone, e.g. link_gap")
    again = options.add_mutually_exclusive_group()
    again.add_argument("--fresh", action="store_true", help="forget what was done, take the sources as they are now")
    again.add_argument(
        "--survivors", action="store_true", help="try what was not caught with the tests as they are now"
    )
    chosen = options.parse_args()
    if chosen.fresh:
        shutil.rmtree(WORK, ignore_errors=True)
    if not SITE.exists():
        _install()
    sys.path.insert(0, str(SITE))
    if not NAMES.exists():
        _mutate()
    _take_tests()
    results = _results()
    if chosen.survivors:
        _keep({mutant: caught_by for mutant, caught_by in results.items() if caught_by})
    names = [name for name in json.loads(NAMES.read_text()) if chosen.only in name]
    sample = random.Random(chosen.seed).sample(names, min(chosen.sample, len(names)))  # noqa: S311  # not a secret
    PLAN.write_text(json.dumps([name for name in sample if name not in _results()]))
    _try()
    _report(sample)


def _install() -> None:
    uv = Path(sys.executable).with_name("uv")
    target = ["--python", sys.executable, "--target", SITE]
    hashes = ["--require-hashes", "-r", HERE / "requirements.txt"]
    subprocess.run([uv, "pip", "install", "-q", *target, *hashes], check=True)


def _mutate() -> None:
    """A copy of the package in which every function stands beside all its mutants."""
    from mutmut.mutation.file_mutation import mutate_file_contents

    shutil.rmtree(WORK, ignore_errors=True)
    shutil.copytree(ROOT / "backend" / "lanewright", WORK / "lanewright", ignore=shutil.ignore_patterns("__pycache__"))
    (WORK / "pyproject.toml").write_text(SETTINGS)
    os.chdir(WORK)  # where mutmut looks for its settings
    names = []
    core = WORK / "lanewright" / "core"
    for path in sorted(path for pattern in MUTATED for path in core.glob(pattern)):
        mutated = mutate_file_contents(str(path), path.read_text())
        path.write_text(mutated.code)
        module = ".".join(path.relative_to(WORK).with_suffix("").parts).removesuffix(".__init__")
        names += [f"{module}.{name}" for name in mutated.mutant_names]
    NAMES.write_text(json.dumps(names))


def _take_tests() -> None:
    """The core's tests as they are now, with hypothesis' choices the same on every run."""
    shutil.rmtree(WORK / "tests", ignore_errors=True)
    for part in ("core", "fixtures"):
        shutil.copytree(ROOT / "tests" / part, WORK / "tests" / part, ignore=shutil.ignore_patterns("__pycache__"))
    (WORK / "tests" / "conftest.py").write_text(PROFILE)


def _try() -> None:
    environment = os.environ | {
        "PYTHONPATH": f"{SITE}:{HERE}",
        "PYTHONDONTWRITEBYTECODE": "1",
        "MUTANT_UNDER_TEST": "",
        "MUTATION_PLAN": str(PLAN),
        "MUTATION_RESULTS": str(RESULTS),
    }
    plugins = ["-p", "forking", "-p", "no:terminal", "-p", "no:cacheprovider", "--import-mode=importlib"]
    tests = [f"tests/core/{part}" for part in TESTED_BY]
    if subprocess.run([sys.executable, "-m", "pytest", *plugins, *tests], cwd=WORK, env=environment).returncode:
        sys.exit("The tests did not run to their end; nothing was judged wrongly, run this again when they do.")


def _results() -> dict[str, str]:
    """The test that caught each mutant; empty: none."""
    lines = RESULTS.read_text().splitlines() if RESULTS.exists() else []
    return {one["mutant"]: one["caught_by"] for one in map(json.loads, lines)}


def _keep(results: dict[str, str]) -> None:
    lines = (json.dumps({"mutant": mutant, "caught_by": caught_by}) for mutant, caught_by in results.items())
    RESULTS.write_text("".join(f"{line}\n" for line in lines))


def _report(sample: list[str]) -> None:
    results = _results()
    survivors = sorted(name for name in sample if not results[name])
    caught = len(sample) - len(survivors)
    score = f"{caught} of {len(sample)} mutants caught ({caught / len(sample):.1%})"
    sys.path.insert(0, str(WORK))
    REPORT.write_text("\n".join([score, *map(_difference, survivors)]))
    print(f"{score}; the {len(survivors)} that were not are in {REPORT.relative_to(ROOT)}")


def _difference(mutant: str) -> str:
    """The lines that the mutant changes."""
    module, _, name = mutant.rpartition(".")
    functions = importlib.import_module(module).__dict__
    original = name.partition("__mutmut_")[0] + "__mutmut_orig"
    lines = [inspect.getsource(_function(functions, one)).splitlines() for one in (original, name)]
    return "\n".join([f"\n# {mutant}", *list(difflib.unified_diff(*lines, lineterm="", n=2))[5:]])


def _function(functions: dict[str, object], name: str) -> object:
    if name in functions:
        return functions[name]
    owner = functions[name.split("ǁ")[1]]
    return inspect.getattr_static(owner, name)


if __name__ == "__main__":
    main()
