"""``lanewright user``: people's accounts, for whoever holds the database."""

from __future__ import annotations

import secrets
import sys
from typing import Annotated

import typer

from lanewright.cli.connection import database
from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.services import accounts

app = typer.Typer(no_args_is_help=True, help="Add, disable and reset people's accounts.")

Name = Annotated[str, typer.Argument(help="The person's name, as they sign in.")]
Ask = Annotated[bool, typer.Option("--ask", help="Ask for the password; by default one is made and printed once.")]


@app.command()
def add(
    name: Name, role: Annotated[Role, typer.Option(help="What they may do.")] = Role.ANNOTATOR, ask: Ask = False
) -> None:
    """Add a person."""
    password = _password(ask)
    with database() as url, transaction(url) as session:
        accounts.add(session, name=name, role=role, password=password)
    typer.echo(f"Added {name}, {role.value}.")
    _tell(password, ask)


@app.command()
def reset(name: Name, ask: Ask = False) -> None:
    """Give a person a new password; they are signed out everywhere."""
    password = _password(ask)
    with database() as url, transaction(url) as session:
        accounts.change(session, None, accounts.by_name(session, name).id, password=password)
    typer.echo(f"{name} has a new password and is signed out.")
    _tell(password, ask)


@app.command()
def disable(name: Name) -> None:
    """Close an account: its sessions and tokens end at once, its history stays."""
    with database() as url, transaction(url) as session:
        accounts.change(session, None, accounts.by_name(session, name).id, disabled=True)
    typer.echo(f"{name} is disabled.")


@app.command()
def enable(name: Name) -> None:
    """Open a disabled account again; revoked tokens stay revoked."""
    with database() as url, transaction(url) as session:
        accounts.change(session, None, accounts.by_name(session, name).id, disabled=False)
    typer.echo(f"{name} is enabled.")


@app.command("list")
def list_people() -> None:
    """List everybody."""
    with database() as url, transaction(url) as session:
        for account in accounts.everybody(session):
            standing = "disabled" if account.disabled_at else "enabled"
            typer.echo(f"{account.name}\t{account.role}\t{standing}\tsince {account.created_at:%Y-%m-%d}")


def _password(ask: bool) -> str:
    if not ask:
        return secrets.token_urlsafe(12)
    if not sys.stdin.isatty():
        return sys.stdin.readline().rstrip("\r\n")
    return str(typer.prompt("Password", hide_input=True, confirmation_prompt=True))


def _tell(password: str, asked: bool) -> None:
    if not asked:
        typer.echo(f"Password, shown only now: {password}")
