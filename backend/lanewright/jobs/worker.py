"""Runs the background jobs of one database."""

from __future__ import annotations

import psycopg

from lanewright.jobs.maintenance import retry_stalled_jobs
from lanewright.jobs.queue import opened_queue

HEARTBEAT_S = 5.0
FORGET_WORKER_AFTER_S = 600.0
"""Far above maintenance.STALLED_AFTER_S: the sweep finds no jobs of a worker whose row is gone (procrastinate 1518)."""
GRACE_S = 10.0
"""How long running jobs may go on when the worker is told to stop; the sweep retries what is cut off."""


async def run_worker(url: str, *, wait: bool = True) -> None:
    """Takes jobs until a signal ends it; with ``wait=False`` only until none is due."""
    async with opened_queue(url) as queue:
        # Before the worker forgets others: after a long stop, all rows are old enough for that.
        await retry_stalled_jobs(queue.job_manager)
        await queue.run_worker_async(
            wait=wait,
            concurrency=2,  # a nightly verification must not hold up the sweep
            additional_context={"database_url": url},
            update_heartbeat_interval=HEARTBEAT_S,
            stalled_worker_timeout=FORGET_WORKER_AFTER_S,
            shutdown_graceful_timeout=GRACE_S,
            delete_jobs="successful",
        )


def seconds_since_heartbeat(url: str) -> float | None:
    """How long ago the liveliest worker gave a sign of life; None if there is no worker."""
    with psycopg.connect(url) as connection:
        query = "SELECT extract(epoch FROM now() - max(last_heartbeat))::float8 FROM procrastinate_workers"
        row = connection.execute(query).fetchone()
    return row[0] if row else None
