"""The one server that runs from a home folder: holds its lock, and can be found by it."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from lanewright.core.errors import LanewrightError

POLL_S = 0.05
PATIENCE_S = 60.0


class AlreadyRuns(LanewrightError):
    """Another server runs from the same home folder."""

    code = "server.runs"


class Instance:
    """The lock file ``serve.lock``: a server holds it locked for life, so a killed one leaves no trace."""

    def __init__(self, home: Path) -> None:
        self._path = home / "serve.lock"

    @contextlib.contextmanager
    def hold(self) -> Iterator[None]:
        """For the server: this is the only one as long as the block runs.

        Raises:
            AlreadyRuns: it is not.
        """
        self._path.parent.mkdir(parents=True, exist_ok=True)
        with self._path.open("a+") as lock:
            if not _take(lock.fileno()):
                running = self._read()
                raise AlreadyRuns(
                    f"Lanewright runs already: {running.get('address', 'it is just starting')}.",
                    mend="Stop it with make stop, or give this one another LANEWRIGHT_HOME and LANEWRIGHT_PORT.",
                )
            self._write({"pid": os.getpid()})
            try:
                yield
            finally:
                lock.truncate(0)

    def announce(self, address: str) -> None:
        """Tells others where the server answers."""
        self._write({"pid": os.getpid(), "address": address})

    def stop(self) -> bool:
        """Ends the server and waits until it is gone; False when none runs.

        Raises:
            LanewrightError: it does not end.
        """
        deadline = time.monotonic() + PATIENCE_S
        signalled = False
        with contextlib.suppress(FileNotFoundError), self._path.open("r+") as lock:
            while not _take(lock.fileno()):
                pid = self._read().get("pid")
                if pid and not signalled:
                    os.kill(pid, signal.SIGTERM)
                    signalled = True
                if time.monotonic() > deadline:
                    raise LanewrightError(f"The server (process {pid}) does not end.", mend="End it by hand.")
                time.sleep(POLL_S)
        return signalled

    def _read(self) -> dict[str, Any]:
        try:
            return dict(json.loads(self._path.read_text()))
        except ValueError:  # between lock and first write
            return {}

    def _write(self, facts: dict[str, Any]) -> None:
        self._path.write_text(json.dumps(facts))


def _take(lock: int) -> bool:
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True
