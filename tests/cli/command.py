"""The real command, run as people run it."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import httpx

PATIENCE_S = 120.0


def eventually(condition: Callable[[], object], what: str) -> None:
    """Waits until the condition holds; fails the test if it never does."""
    deadline = time.monotonic() + PATIENCE_S
    while not condition():
        assert time.monotonic() < deadline, f"never happened: {what}"
        time.sleep(0.05)  # between two looks at a condition


@dataclass
class Lanewright:
    """The command line with a home and a port of its own."""

    home: Path
    port: int
    environment: dict[str, str]
    servers: list[subprocess.Popen[str]] = field(default_factory=list)

    def run(self, *arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
        return self._run("-m", "lanewright.cli.main", *arguments, environment=environment)

    def python(self, script: str) -> subprocess.CompletedProcess[str]:
        return self._run("-c", script, environment={})

    def _run(self, *arguments: str, environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, *arguments],
            env=self.environment | environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )

    def serve(self) -> subprocess.Popen[str]:
        """Starts the server in a process group of its own, and waits until it answers."""
        server = subprocess.Popen(
            [sys.executable, "-m", "lanewright.cli.main", "serve"],
            env=self.environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        self.servers.append(server)
        eventually(lambda: server.poll() is not None or self.answers(), "the server answers")
        assert server.poll() is None, server.communicate()[1]
        return server

    def answers(self) -> bool:
        try:
            return httpx.get(f"http://127.0.0.1:{self.port}/readyz").is_success
        except httpx.TransportError:
            return False

    def processes(self) -> list[int]:
        """Everything that runs on this home: server, worker, database."""
        mark = str(self.home).encode()
        return [
            int(folder.name)
            for folder in Path("/proc").iterdir()
            if folder.name.isdigit() and int(folder.name) != os.getpid() and mark in _traces(folder)
        ]


def _traces(process: Path) -> bytes:
    try:
        return (process / "environ").read_bytes() + (process / "cmdline").read_bytes()
    except OSError:
        return b""
