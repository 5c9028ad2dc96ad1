"""The ``lanewright`` command. Commands are imported only when called, so that ``--help`` is quick."""

from __future__ import annotations

import importlib
import importlib.util
from typing import Annotated, Any

import typer
from typer.core import TyperGroup
from typer.main import get_command

from lanewright import __version__
from lanewright.cli.failure import failures_as_sentences

COMMANDS = {
    "serve": ("lanewright.cli.serve", "Start the app, the API and the background worker on one port."),
    "stop": ("lanewright.cli.stop", "Stop what serve started, and the private database."),
    "import": ("lanewright.cli.import_command", "Import Argoverse 2 Sensor and TbV logs."),
    "export": ("lanewright.cli.export", "Write the accepted revisions of a split as a tar archive."),
    "demo": ("lanewright.cli.demo", "Generate demo logs in the TbV directory layout."),
    "diff": ("lanewright.cli.diff", "Derive the atomic changes between two maps."),
    "check": ("lanewright.cli.check", "Check an edited map against the rules of change mapping."),
    "canonicalise": ("lanewright.cli.canonicalise", "Write an edited map under its canonical ids."),
    "verify": ("lanewright.cli.verify", "Recompute content hashes and changes, and say where they differ."),
    "user": ("lanewright.cli.user", "Add, disable and reset people's accounts."),
    "token": ("lanewright.cli.token", "Make, list and revoke API tokens."),
    "backup": ("lanewright.cli.backup", "Write everything that is stored into one file."),
    "restore": ("lanewright.cli.restore", "Bring back what backup wrote."),
    "migrate": ("lanewright.cli.migrate", "Bring the database to the tables of this version."),
    "worker": ("lanewright.cli.worker", "Run background jobs."),
    "health": ("lanewright.cli.health", "Tell whether the server and the worker are well."),
    "db": ("lanewright.cli.db", "Start, stop and enter the database."),
    "openapi": ("lanewright.cli.openapi", "Print the API's OpenAPI description."),
}
"""Name on the command line: module with a Typer ``app``, and the line that ``--help`` shows."""


class LazyGroup(TyperGroup):
    """Lists commands from the table above; imports a module when its command is called."""

    def list_commands(self, ctx: Any) -> list[str]:
        return [name for name, (module, _) in COMMANDS.items() if importlib.util.find_spec(module) is not None]

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        if cmd_name not in self.list_commands(ctx):
            return None
        part: typer.Typer = importlib.import_module(COMMANDS[cmd_name][0]).app
        part._add_completion = False  # else each command would offer to install shell completion
        part.rich_markup_mode = None
        command = get_command(part)
        command.name = cmd_name
        return command

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(name, COMMANDS[name][1]) for name in self.list_commands(ctx)])

    def invoke(self, ctx: Any) -> Any:
        with failures_as_sentences():
            return super().invoke(ctx)


app = typer.Typer(
    cls=LazyGroup,
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"lanewright {__version__}")
        raise typer.Exit


@app.callback()
def lanewright(
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Annotate how HD maps change: one map update, one explanation."""


if __name__ == "__main__":
    app(prog_name="lanewright")
