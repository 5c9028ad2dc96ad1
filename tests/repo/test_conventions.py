"""The rules of the house that no linter knows."""

from __future__ import annotations

import ast
import re
import subprocess
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
LONGEST_FILE_LINES = {".py": 300, ".ts": 250, ".tsx": 250}
MADE_BY_PROGRAMS = ("schema.gen.ts",)
MIGRATIONS = "migrations/versions/"

MAY_COMMIT = {"backend/lanewright/db/engine.py"}
"""``transaction``, which the API's dependency, the commands and the jobs all use."""

UNWANTED_NAMES = {"utils", "util", "helpers", "helper", "common", "misc", "manager", "shared"}
UNFINISHED = re.compile(r"\b(TOD[O]|FIXM[E]|XX[X]|HAC[K])\b|NotImplementedErro[r]")
# Written so that this file does not name what it forbids.
REGISTRY_HOSTS = re.compile(
    r"regist[r]y\.(npm|yarn)|pythonhos[t]ed|pyp[i]\.org|deb\.debi[a]n|prox[y]\.golang|rep[o]1?\.maven|stati[c]\.crates"
)
MACHINE_PATHS = re.compile(r"(?<![\w.])/(w[o]rk|f[a]rm|hom[e]/\w+)/")


def tracked(*suffixes: str) -> list[str]:
    """Files under version control or about to be, with one of the suffixes (all without)."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    names = subprocess.run(command, cwd=REPOSITORY, capture_output=True, text=True, check=True).stdout.splitlines()
    return [name for name in names if (not suffixes or name.endswith(suffixes)) and (REPOSITORY / name).is_file()]


def texts(*suffixes: str) -> list[tuple[str, str]]:
    found = []
    for name in tracked(*suffixes):
        try:
            found.append((name, (REPOSITORY / name).read_text()))
        except UnicodeDecodeError:
            continue  # a picture
    return found


def test_no_source_file_outgrows_its_name():
    sizes = [
        f"{name}: {lines} lines"
        for name, text in texts(*LONGEST_FILE_LINES)
        if not name.endswith(MADE_BY_PROGRAMS) and not name.startswith(MIGRATIONS)
        if (lines := text.count("\n")) > LONGEST_FILE_LINES[Path(name).suffix]
    ]
    assert sizes == []


def test_files_are_named_after_what_they_are():
    assert [name for name in tracked(*LONGEST_FILE_LINES) if Path(name).stem.lower() in UNWANTED_NAMES] == []


def test_only_one_place_commits():
    calls = [
        f"{name}:{node.lineno}"
        for name, text in texts(".py")
        if name.startswith("backend/") and name not in MAY_COMMIT
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "commit"
    ]
    assert calls == []


def test_nothing_is_left_unfinished():
    assert _lines_with(UNFINISHED, texts(".py", ".ts", ".tsx", ".sh", "Makefile")) == []


def test_no_file_names_a_registry_host():
    assert _lines_with(REGISTRY_HOSTS, texts()) == []


def test_no_file_names_a_path_of_one_machine():
    assert _lines_with(MACHINE_PATHS, texts()) == []


@pytest.mark.parametrize("lock", ["requirements.txt", "requirements-dev.txt", "requirements-av2.txt"])
def test_every_locked_python_package_has_a_version_and_hashes(lock: str):
    text = (REPOSITORY / lock).read_text().replace("\\\n", " ")
    entries = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    assert entries
    assert [entry.split()[0] for entry in entries if "==" not in entry or "--hash=sha256:" not in entry] == []


def test_frontend_lock_has_a_hash_for_every_package_and_no_address():
    text = (REPOSITORY / "frontend" / "package-lock.json").read_text()
    assert '"resolved"' not in text
    assert text.count('"integrity"') >= text.count('"node_modules/')


def _lines_with(pattern: re.Pattern[str], files: list[tuple[str, str]]) -> list[str]:
    return [
        f"{name}:{number}: {line.strip()[:80]}"
        for name, text in files
        if pattern.search(text)
        for number, line in enumerate(text.splitlines(), 1)
        if pattern.search(line)
    ]
