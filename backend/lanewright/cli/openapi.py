"""``lanewright openapi``: the contract that the frontend's types are made from."""

from __future__ import annotations

import json

import typer

app = typer.Typer()


@app.command()
def openapi() -> None:
    """Print the API's OpenAPI description, sorted, so that a change shows as a small difference."""
    from lanewright.api.app import create_app
    from lanewright.settings import Settings

    # Nothing is connected: the description does not depend on the database.
    description = create_app(Settings(), database_url="postgresql:///none").openapi()
    typer.echo(json.dumps(description, indent=2, sort_keys=True, ensure_ascii=False))
