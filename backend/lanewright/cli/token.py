"""``lanewright token``: credentials for pipelines, for whoever holds the database."""

from __future__ import annotations

from typing import Annotated

import typer

from lanewright.cli.connection import database
from lanewright.db.engine import transaction
from lanewright.services import accounts, sessions, tokens

app = typer.Typer(no_args_is_help=True, help="Make, list and revoke API tokens.")

Owner = Annotated[str, typer.Argument(help="Whose token: a reviewer's or an admin's name.")]


@app.command()
def create(
    owner: Owner,
    name: Annotated[str, typer.Option(help="What it is for.")],
    scope: Annotated[list[tokens.Scope], typer.Option(help="What it may read; may be given twice.")],
    days: Annotated[int, typer.Option(min=1, max=366, help="How long it holds.")] = 90,
) -> None:
    """Make a token and print it; it is shown only now."""
    with database() as url, transaction(url) as session:
        actor = sessions.actor_of(accounts.by_name(session, owner))
        _, secret = tokens.create(session, actor, name=name, scopes=[each.value for each in scope], days=days)
    typer.echo(secret)


@app.command("list")
def list_tokens(owner: Owner) -> None:
    """List somebody's tokens."""
    with database() as url, transaction(url) as session:
        for token in tokens.of_actor(session, sessions.actor_of(accounts.by_name(session, owner))):
            standing = "revoked" if token.revoked_at else f"until {token.expires_at:%Y-%m-%d}"
            typer.echo(f"{token.id}\t{token.name}\t{', '.join(token.scopes)}\t{standing}")


@app.command()
def revoke(owner: Owner, token_id: Annotated[int, typer.Argument(help="Its number in the list.")]) -> None:
    """End a token at once."""
    with database() as url, transaction(url) as session:
        tokens.revoke(session, sessions.actor_of(accounts.by_name(session, owner)), token_id)
    typer.echo(f"Token {token_id} is revoked.")
