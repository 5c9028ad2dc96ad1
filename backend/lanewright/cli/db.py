"""``lanewright db``: the database itself."""

from __future__ import annotations

import os
import shutil
import subprocess

import typer

from lanewright.cli.connection import database
from lanewright.cluster import ClusterError, PrivateCluster
from lanewright.settings import get_settings

app = typer.Typer(no_args_is_help=True, help="Start, stop and enter the database.")


@app.command()
def up() -> None:
    """Start the private cluster, and keep it running until `lanewright db down` or `lanewright stop`."""
    typer.echo(_private_cluster().keep())


@app.command()
def down() -> None:
    """Stop the private cluster."""
    stopped = _private_cluster().down()
    typer.echo("The private cluster has stopped." if stopped else "The private cluster was not running.")


@app.command()
def url() -> None:
    """Print the address of the database."""
    settings = get_settings()
    address = settings.database_url or PrivateCluster(settings.home).status().url
    if address is None:
        raise ClusterError("The private cluster is not running.", mend="Start it with lanewright db up or make run.")
    typer.echo(address)


@app.command(context_settings={"allow_extra_args": True, "ignore_unknown_options": True})
def psql(context: typer.Context) -> None:
    """Enter the database with psql; further arguments go to psql."""
    program = shutil.which("psql")
    if program is None:
        raise ClusterError("psql is not installed.", mend="Install the package postgresql-client.")
    with database(migrated=False) as address:
        ended = subprocess.run([program, "--dbname", address, *context.args], env=os.environ, check=False)
    raise typer.Exit(ended.returncode)


def _private_cluster() -> PrivateCluster:
    settings = get_settings()
    if settings.database_url is not None:
        raise ClusterError(
            "DATABASE_URL is set, so Lanewright uses that database and runs none itself.",
            mend="Unset DATABASE_URL to use the private cluster.",
        )
    return PrivateCluster(settings.home)
