"""``lanewright serve``: the app, the API and the background worker on one port, over a database made ready."""

from __future__ import annotations

import contextlib
import signal
import socket
from collections.abc import Iterator
from typing import Annotated, Any

import typer
import uvicorn
from sqlalchemy import exists, select

from lanewright.api.app import create_app
from lanewright.cli.connection import database
from lanewright.cli.instance import Instance
from lanewright.cli.keeper import Keeper
from lanewright.cluster import PrivateCluster
from lanewright.core.errors import LanewrightError
from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.db.models import Log
from lanewright.db.repositories import accounts
from lanewright.log_setup import configure_logging, log_file
from lanewright.services.demo_accounts import DEMO_PASSWORD
from lanewright.settings import Settings, get_settings

SHUTDOWN_GRACE_S = 5

app = typer.Typer()


@app.command()
def serve(
    host: Annotated[str | None, typer.Option(help="Address to listen on; default LANEWRIGHT_HOST.")] = None,
    port: Annotated[int | None, typer.Option(help="Port; default LANEWRIGHT_PORT.", min=0, max=65535)] = None,
    worker: Annotated[bool, typer.Option(help="Run the background worker too.")] = True,
) -> None:
    """Start the app, the API and the background worker on one port; Ctrl-C stops everything."""
    given = {name: value for name, value in {"host": host, "port": port}.items() if value is not None}
    settings = get_settings().model_copy(update=given)
    configure_logging(settings, "serve")
    with contextlib.suppress(KeyboardInterrupt), _interruptible():
        _run(settings, worker)
    typer.echo("Lanewright has stopped.")


def _run(settings: Settings, with_worker: bool) -> None:
    instance = Instance(settings.home)
    cluster = PrivateCluster(settings.home) if settings.database_url is None else None
    with instance.hold(), _listen(settings) as listener, database() as url, _uninterrupted_end():
        _load_demo(settings, url)
        address = settings.public_url or _address(settings.host, listener)
        config = uvicorn.Config(
            create_app(settings, database_url=url),
            log_config=None,
            access_log=False,  # the app logs its requests itself, with their ids
            timeout_graceful_shutdown=SHUTDOWN_GRACE_S,
            server_header=False,
        )
        with Keeper(cluster) if with_worker else contextlib.nullcontext(), _uninterrupted_end():
            _AnnouncedServer(config, lambda: _announce(settings, instance, url, address)).run([listener])


class _AnnouncedServer(uvicorn.Server):
    """Calls back once it answers requests."""

    def __init__(self, config: uvicorn.Config, ready: Any) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            self._ready()


def _announce(settings: Settings, instance: Instance, url: str, address: str) -> None:
    instance.announce(address)
    typer.echo(f"Lanewright runs at {address} (Ctrl-C stops it)")
    if settings.demo_allowed:
        with transaction(url) as session:
            names = [role.value for role in Role if accounts.by_name(session, role.value) is not None]
        if names:
            typer.echo(f"Demo sign-ins: {', '.join(names)}; password of each: {DEMO_PASSWORD}")
    if settings.log_format == "console":
        typer.echo(f"Log: {log_file(settings, 'serve')}")


def _load_demo(settings: Settings, url: str) -> None:
    """On the first start with a private cluster, where only this machine can sign in."""
    if not settings.demo_allowed:
        return
    with transaction(url) as session:
        if session.scalar(select(exists().where(Log.id.is_not(None)))):
            return
        from lanewright.services.demo_load import load_demo  # needed once: its parts take long to import

        typer.echo("First start: making the demo (a minute at most)")
        load_demo(session, settings.home)


@contextlib.contextmanager
def _listen(settings: Settings) -> Iterator[socket.socket]:
    """The bound socket; taken before anything is started, so that a busy port costs nothing."""
    family = socket.AF_INET6 if ":" in settings.host else socket.AF_INET
    with socket.socket(family) as listener:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listener.bind((settings.host, settings.port))
        except OSError as error:
            raise LanewrightError(
                f"Port {settings.port} of {settings.host} cannot be used: {error.strerror}.",
                mend="Stop what uses it, or choose another with LANEWRIGHT_PORT.",
                code="server.port",
            ) from error
        yield listener


def _address(host: str, listener: socket.socket) -> str:
    return f"http://{f'[{host}]' if ':' in host else host}:{listener.getsockname()[1]}"


@contextlib.contextmanager
def _interruptible() -> Iterator[None]:
    """SIGTERM (make stop) and SIGHUP (closed terminal) end the server as Ctrl-C does."""

    def interrupt(number: int, frame: object) -> None:
        raise KeyboardInterrupt

    def pass_on(number: int, frame: object) -> None:
        signal.raise_signal(signal.SIGTERM)  # uvicorn catches that one and finishes its requests

    signal.signal(signal.SIGTERM, interrupt)
    signal.signal(signal.SIGHUP, pass_on)
    yield


@contextlib.contextmanager
def _uninterrupted_end() -> Iterator[None]:
    """Once the end has begun, a second Ctrl-C must not leave a cluster behind."""
    try:
        yield
    finally:
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_IGN)
