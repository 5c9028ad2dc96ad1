"""The job queue: its tasks register here, and it is opened on a database when one is known."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from procrastinate import App, PsycopgConnector

queue = App(connector=PsycopgConnector(), import_paths=["lanewright.jobs.maintenance"])
"""What tasks are declared on."""


@asynccontextmanager
async def opened_queue(url: str) -> AsyncIterator[App]:
    """The queue in this database."""
    with queue.replace_connector(PsycopgConnector(conninfo=url)) as app:
        async with app.open_async():
            yield app
