"""A command line with a home and a port of its own."""

from __future__ import annotations

import os
import shutil
import signal
import socket
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.cli.command import Lanewright


@pytest.fixture
def command() -> Iterator[Lanewright]:
    """No demo: a public address forbids it, and these tests are about processes."""
    folder = Path(tempfile.mkdtemp(prefix="lanewright-serve-"))
    folder.chmod(0o711)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("LANEWRIGHT_", "PG"))}
    environment.pop("DATABASE_URL", None)
    environment |= {
        "LANEWRIGHT_HOME": str(folder / "home"),
        "LANEWRIGHT_PORT": str(port),
        "LANEWRIGHT_PUBLIC_URL": f"http://127.0.0.1:{port}",
    }
    command = Lanewright(folder / "home", port, environment)
    yield command
    command.run("stop")
    for server in command.servers:
        if server.poll() is None:
            os.killpg(server.pid, signal.SIGKILL)
        server.communicate()
    shutil.rmtree(folder, ignore_errors=True)
