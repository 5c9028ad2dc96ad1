"""Maps at the limits of a file: the engine comes to an end, in memory that any machine has."""

from __future__ import annotations

import resource
import subprocess
import sys
from pathlib import Path

import pytest
from tests.fuzz.extreme_maps import EXTREMES

REPOSITORY = Path(__file__).parents[2]
MOST_MEMORY_MIB = 800
HANGS_S = 60
"""Processor time that none of them comes near: the slowest takes some 5 s."""


def limited() -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (HANGS_S, HANGS_S))


@pytest.mark.parametrize("name", EXTREMES)
def test_comes_to_an_end_within_memory(name: str):
    done = subprocess.run(
        [sys.executable, "-m", "tests.fuzz.extreme_maps", name],
        cwd=REPOSITORY,
        preexec_fn=limited,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert int(done.stdout.split()[-2]) < MOST_MEMORY_MIB
