"""The installation scripts and the Makefile, as far as they can be tried without installing anything."""

from __future__ import annotations

import os
import pwd
import re
import subprocess
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
SCRIPTS = sorted((REPOSITORY / "scripts").glob("*.sh"))
PACKAGES = (REPOSITORY / "scripts" / "debian_packages.sh").read_text()


@pytest.mark.parametrize("script", [*SCRIPTS, REPOSITORY / ".ci" / "run"], ids=lambda path: path.name)
def test_script_is_sound_and_executable(script: Path):
    assert os.access(script, os.X_OK)
    assert subprocess.run(["bash", "-n", str(script)], capture_output=True, check=False).returncode == 0


def test_help_lists_what_the_readme_promises():
    told = subprocess.run(["make", "help"], cwd=REPOSITORY, capture_output=True, text=True, check=True).stdout
    targets = re.findall(r"^  make ([a-z-]+) ", told, re.MULTILINE)
    assert {"run", "stop", "test", "check", "bench", "format", "types", "demo", "install", "clean"} <= set(targets)


def test_nothing_is_installed_when_nothing_is_missing():
    ended = _packages("test")
    assert (ended.returncode, ended.stdout, ended.stderr) == (0, "", "")


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can act as an ordinary user")
def test_who_may_not_install_is_told_what_to_run():
    stranger = pwd.getpwnam("nobody")
    ended = _packages("test", user=stranger.pw_uid, group=stranger.pw_gid, LANEWRIGHT_CHROMIUM="/nowhere")
    assert ended.returncode == 2
    assert ended.stderr.count("\n") == 1
    assert "Run as root: apt-get update && apt-get install --no-install-recommends chromium;" in ended.stderr


def test_system_without_apt_is_told_what_it_lacks(tmp_path: Path):
    for program in ("id", "python3"):
        found = subprocess.run(["which", program], capture_output=True, text=True, check=True).stdout.strip()
        (tmp_path / program).symlink_to(found)
    ended = _packages("test", LANEWRIGHT_CHROMIUM="/nowhere", PATH=str(tmp_path))
    assert ended.returncode == 2
    assert "this system has no apt-get" in ended.stderr


def _packages(purpose: str, user: int | None = None, group: int | None = None, **environment: str):
    return subprocess.run(
        ["/bin/bash", "-s", purpose],
        input=PACKAGES,
        env=os.environ | environment,
        user=user,
        group=group,
        extra_groups=None if user is None else [],
        cwd="/",
        capture_output=True,
        text=True,
        check=False,
    )
