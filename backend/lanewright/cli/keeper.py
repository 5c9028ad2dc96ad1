"""Keeps alive what the server needs beside itself: the worker process and the private cluster."""

from __future__ import annotations

import subprocess
import sys
import threading
from types import TracebackType

import structlog

from lanewright.cluster import ClusterError, PrivateCluster

LOOK_EVERY_S = 1.0
LONGEST_PAUSE_S = 30.0
PATIENCE_S = 15.0

_log = structlog.get_logger(__name__)


class Keeper:
    """Starts the worker, starts it again when it dies (pausing longer each time), and so the cluster.

    Args:
        cluster: the private cluster; None when the database is somebody else's.
    """

    def __init__(self, cluster: PrivateCluster | None) -> None:
        self._cluster = cluster
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._watch, name="keeper", daemon=True)

    def __enter__(self) -> Keeper:
        self._worker = _start_worker()
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._ending.set()
        self._thread.join()
        self._worker.terminate()
        try:
            self._worker.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self._worker.kill()
            self._worker.wait()

    def _watch(self) -> None:
        pause_s = LOOK_EVERY_S
        while not self._ending.wait(pause_s):
            self._revive_cluster()
            if self._worker.poll() is None:
                pause_s = LOOK_EVERY_S
                continue
            _log.warning("the worker ended and is started again", exit_code=self._worker.returncode)
            self._worker = _start_worker()
            pause_s = min(2 * pause_s, LONGEST_PAUSE_S)

    def _revive_cluster(self) -> None:
        if self._cluster is None or self._cluster.status().pid is not None:
            return
        _log.warning("the private cluster ended and is started again")
        try:
            self._cluster.up()
        except ClusterError as error:
            _log.error("the private cluster does not start", reason=str(error))


def _start_worker() -> subprocess.Popen[bytes]:
    """A worker in a session of its own, so that Ctrl-C reaches the server alone, which then ends the worker.

    It reads from a pipe that nobody writes to: the pipe's end tells it that the server was killed.
    """
    command = [sys.executable, "-m", "lanewright.cli.main", "worker", "--until-stdin-ends"]
    return subprocess.Popen(command, stdin=subprocess.PIPE, start_new_session=True)
