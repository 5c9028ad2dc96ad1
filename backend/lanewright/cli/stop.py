"""``lanewright stop``."""

from __future__ import annotations

import typer

from lanewright.cli.instance import Instance
from lanewright.cluster import PrivateCluster
from lanewright.settings import get_settings

app = typer.Typer()


@app.command()
def stop() -> None:
    """Stop what serve started, and the private database."""
    home = get_settings().home
    server = Instance(home).stop()
    cluster = PrivateCluster(home).down()
    typer.echo("Lanewright has stopped." if server or cluster else "Lanewright was not running.")
