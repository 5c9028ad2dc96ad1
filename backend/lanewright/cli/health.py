"""``lanewright health``: for whatever restarts sick containers; exit code 0 means well."""

from __future__ import annotations

import json
import urllib.error
import urllib.request

import typer

from lanewright.cli.connection import database
from lanewright.core.errors import LanewrightError
from lanewright.settings import get_settings

PATIENCE_S = 5

app = typer.Typer(no_args_is_help=True, help="Tell whether the server and the worker are well.")


class Unwell(LanewrightError):
    """It does not do its work at present."""

    code = "health.unwell"


@app.command()
def api() -> None:
    """Ask the server on this machine whether it can serve."""
    settings = get_settings()
    url = f"http://127.0.0.1:{settings.port}/readyz"
    try:
        with urllib.request.urlopen(url, timeout=PATIENCE_S) as answer:
            typer.echo(answer.read().decode())
    except urllib.error.HTTPError as error:
        problem = json.loads(error.read())
        raise Unwell(f"The server at {url} is not ready: {problem.get('detail', error.reason)}") from error
    except OSError as error:
        raise Unwell(f"The server at {url} does not answer: {error}.") from error


@app.command()
def worker() -> None:
    """Ask the database whether a worker gave a sign of life lately."""
    from lanewright.jobs.maintenance import STALLED_AFTER_S
    from lanewright.jobs.worker import seconds_since_heartbeat

    with database(migrated=False) as url:
        silent_s = seconds_since_heartbeat(url)
    if silent_s is None or silent_s > STALLED_AFTER_S:
        ago = "ever" if silent_s is None else f"for {silent_s:.0f} s"
        raise Unwell(f"No worker has given a sign of life {ago}.")
    typer.echo(f"A worker gave a sign of life {silent_s:.0f} s ago.")
