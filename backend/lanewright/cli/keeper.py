"""Keeps alive what the server needs beside itself: the worker process and the private cluster."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from types import TracebackType

import structlog

from lanewright.cluster import ClusterError, PrivateCluster

LOOK_EVERY_S = 1.0
LONGEST_PAUSE_S = 30.0
PATIENCE_S = 15.0

_log = structlog.get_logger(__name__)


class Keeper:
    """Starts the worker, and starts worker and cluster again when they die (a worker that dies soon, after a pause).

    Args:
        cluster: the private cluster; None when the database is somebody else's.
    """

    def __init__(self, cluster: PrivateCluster | None) -> None:
        self._cluster = cluster
        self._ending = threading.Event()
        self._pause_s = LOOK_EVERY_S
        self._thread = threading.Thread(target=self._watch, name="keeper", daemon=True)

    def __enter__(self) -> Keeper:
        self._start_worker()
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
        while not self._ending.wait(LOOK_EVERY_S):
            self._revive_cluster()
            self._revive_worker()

    def _revive_cluster(self) -> None:
        if self._cluster is None or self._cluster.status().pid is not None:
            return
        _log.warning("the private cluster ended and is started again")
        try:
            self._cluster.up()
        except ClusterError as error:
            _log.error("the private cluster does not start", reason=str(error))

    def _revive_worker(self) -> None:
        age_s = time.monotonic() - self._started_at
        if self._worker.poll() is None:
            if age_s > LONGEST_PAUSE_S:
                self._pause_s = LOOK_EVERY_S
        elif age_s >= self._pause_s:
            _log.warning("the worker ended and is started again", exit_code=self._worker.returncode)
            self._start_worker()
            self._pause_s = min(2 * self._pause_s, LONGEST_PAUSE_S)

    def _start_worker(self) -> None:
        """A worker in a session of its own, so that Ctrl-C reaches the server alone, which then ends the worker.

        It reads from a pipe that nobody writes to: the pipe's end tells it that the server was killed.
        """
        command = [sys.executable, "-m", "lanewright.cli.main", "worker", "--until-stdin-ends"]
        self._started_at = time.monotonic()
        self._worker = subprocess.Popen(command, stdin=subprocess.PIPE, start_new_session=True)
