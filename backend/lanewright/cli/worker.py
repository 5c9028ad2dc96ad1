"""``lanewright worker``."""

from __future__ import annotations

import asyncio
import contextlib
import os
import signal
import sys
import threading
from typing import Annotated

import typer

from lanewright.cli.connection import database
from lanewright.cluster import PrivateCluster
from lanewright.jobs.worker import run_worker
from lanewright.log_setup import configure_logging
from lanewright.settings import get_settings

app = typer.Typer()


@app.command()
def worker(
    until_stdin_ends: Annotated[bool, typer.Option(hidden=True, help="End with the process that started it.")] = False,
) -> None:
    """Run background jobs until stopped; `lanewright serve` starts one by itself."""
    configure_logging(get_settings(), "worker")
    with contextlib.suppress(KeyboardInterrupt):
        # Until procrastinate handles them: the lease on the cluster has to be given up in any case.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.signal(signal.SIGTERM, _interrupt)
        if until_stdin_ends:
            threading.Thread(target=_end_with_stdin, daemon=True).start()
        with database(migrated=False) as url:
            asyncio.run(run_worker(url))
    if until_stdin_ends and get_settings().database_url is None:
        # A server that was killed could not stop the cluster, and this worker may not have got as far as a lease.
        PrivateCluster(get_settings().home).down_unless_used()


def _interrupt(number: int, frame: object) -> None:
    """SIGTERM told as Ctrl-C, which asyncio ends in good order; raised in its midst it would leave a trace."""
    signal.raise_signal(signal.SIGINT)


def _end_with_stdin() -> None:
    while os.read(sys.stdin.fileno(), 1):  # unbuffered: a buffer's lock would stand in the way of an ordinary end
        pass
    os.kill(os.getpid(), signal.SIGTERM)
