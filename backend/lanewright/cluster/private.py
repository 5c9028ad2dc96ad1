"""PrivateCluster: makes, starts, shares, finds and stops Lanewright's own PostgreSQL on a unix socket."""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import os
import shutil
import subprocess
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

from lanewright.cluster import configuration, postmaster
from lanewright.cluster.account import Account, caller, choose_account
from lanewright.cluster.errors import ClusterError
from lanewright.cluster.programs import REQUIRED_EXTENSIONS, Programs, find_programs

DATABASE = "lanewright"
SUPERUSER = "lanewright"
READINESS_S = 300.0


@dataclass(frozen=True)
class ClusterStatus:
    """What ``lanewright db`` tells about the cluster; ``url`` and ``pid`` are None while it does not run."""

    data: Path
    log: Path
    pid: int | None
    url: str | None


class PrivateCluster:
    """One cluster below ``home``, for whoever runs as its owner.

    Every method may be called by several processes at once. The files: ``cluster/data``, ``cluster/run`` (socket),
    ``cluster/postgres.log``; ``cluster.lock`` guards starts and stops, ``cluster.users`` counts who uses it.

    Args:
        home: folder of everything Lanewright keeps; made if missing.
        durable: False only for tests: a power cut may then lose or spoil the database.
    """

    def __init__(self, home: Path, *, durable: bool = True) -> None:
        self.home = home.absolute()
        self.durable = durable
        # Where root has no account that reaches the folder and no user namespaces, the files move here.
        name = hashlib.sha256(os.fsencode(self.home)).hexdigest()[:16]
        self._refuge = Path("/var/lib/lanewright") / name

    @property
    def folder(self) -> Path:
        """Asked for each time: another process may be the one that moves the files to the refuge."""
        return self._refuge if self._refuge.is_dir() else self.home / "cluster"

    @property
    def data(self) -> Path:
        return self.folder / "data"

    @property
    def log(self) -> Path:
        return self.folder / "postgres.log"

    def up(self) -> str:
        """Starts the cluster unless it runs, makes the database unless it exists, and returns its URL.

        Raises:
            ClusterError: no PostGIS installed, no account to run it, or the server does not start.
        """
        with self._locked():
            return self._up()

    def down(self) -> bool:
        """Stops the cluster; False when it did not run."""
        if not self.home.is_dir():
            return False
        with self._locked():
            (self.home / "cluster.kept").unlink(missing_ok=True)
            return self._down()

    def keep(self) -> str:
        """As ``up``, and the cluster goes on when the last ``lease`` ends, until ``down``."""
        url = self.up()
        (self.home / "cluster.kept").touch()
        return url

    @contextlib.contextmanager
    def lease(self) -> Iterator[str]:
        """The URL of a running cluster; the last of the processes that hold a lease stops it at the end.

        A killed process holds nothing: the kernel drops its lock.
        """
        with contextlib.ExitStack() as cleanup:
            with self._locked():
                url = self._up()
                users = cleanup.enter_context((self.home / "cluster.users").open("a"))
                fcntl.flock(users, fcntl.LOCK_SH)
            try:
                yield url
            finally:
                users.close()
                self.down_unless_used()

    def down_unless_used(self) -> None:
        """Stops the cluster when nobody holds a lease on it and nobody asked to ``keep`` it."""
        with self._locked(), (self.home / "cluster.users").open("a") as users:
            try:
                fcntl.flock(users, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                return  # somebody still works with it
            if not (self.home / "cluster.kept").exists():
                self._down()

    def status(self) -> ClusterStatus:
        """How it stands, without touching anything."""
        server = postmaster.find(self.data)
        url = _url(server.socket_folder) if server else None
        return ClusterStatus(self.data, self.log, server.pid if server else None, url)

    @contextlib.contextmanager
    def _locked(self) -> Iterator[None]:
        try:
            self.home.mkdir(parents=True, exist_ok=True)
            lock = (self.home / "cluster.lock").open("a")
        except OSError as error:
            raise ClusterError(
                f"{self.home} cannot be written: {error.strerror}.",
                mend="Set LANEWRIGHT_HOME to a folder of your own.",
            ) from error
        with lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield

    def _up(self) -> str:
        socket_folder = self._attach()
        if socket_folder is None:
            account = self._account()
            programs = find_programs(self._major())
            account.own_all(self.folder)
            if self._major() is None:
                self._initialise(programs, account)
            socket_folder = self._start(programs, account)
        self._ensure_database(socket_folder)
        return _url(socket_folder)

    def _attach(self) -> Path | None:
        """The socket of the server that runs; one that is still recovering from a crash is waited for."""
        if postmaster.find(self.data) is None:
            return None
        command = [find_programs(self._major())["pg_isready"], "--quiet", "--timeout", "5"]
        deadline = time.monotonic() + READINESS_S
        while server := postmaster.find(self.data):
            if subprocess.run([*command, "--host", str(server.socket_folder)], check=False).returncode == 0:
                return server.socket_folder
            if time.monotonic() > deadline:
                raise ClusterError(
                    f"PostgreSQL runs (process {server.pid}) but does not answer.", mend=f"See {self.log}."
                )
            time.sleep(postmaster.POLL_S)
        return None

    def _down(self) -> bool:
        server = postmaster.find(self.data)
        if server is None:
            return False
        server.stop()
        return True

    def _major(self) -> int | None:
        """Version of the data directory; None while there is none."""
        try:
            return int((self.data / "PG_VERSION").read_text())
        except FileNotFoundError:
            return None

    def _account(self) -> Account:
        self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        account = choose_account(self.folder)
        if account is None:  # root, a folder closed to others, no user namespaces
            self._refuge.mkdir(mode=0o700, parents=True, exist_ok=True)
            self._refuge.parent.chmod(0o711)
            account = choose_account(self._refuge)
        if account is None:
            raise ClusterError(
                "PostgreSQL refuses to run as root, and no account called postgres or nobody can stand in.",
                mend="Run as an ordinary user, or set DATABASE_URL to a PostGIS database.",
            )
        return account

    def _initialise(self, programs: Programs, account: Account) -> None:
        partial = self.folder / "data.partial"  # renamed when whole: a kill in the middle leaves no half cluster
        shutil.rmtree(partial, ignore_errors=True)
        partial.mkdir(mode=0o700)
        account.own(partial)
        command = [programs["initdb"], "--pgdata", str(partial), "--username", SUPERUSER, "--auth", "trust"]
        command += ["--encoding", "UTF8", "--locale", "C.UTF-8", *([] if self.durable else ["--no-sync"])]
        made = account.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if made.returncode != 0:
            raise ClusterError(
                f"initdb failed: {_last_line(made.stdout)}", mend=f"Check disk space and rights of {self.folder}."
            )
        with (partial / "postgresql.conf").open("a") as settings:
            settings.write(f"include '{configuration.FILE_NAME}'\n")
        partial.rename(self.data)

    def _start(self, programs: Programs, account: Account) -> Path:
        socket_folder = configuration.make_socket_folder(self.folder, account)
        postmaster.clear_remains(self.data, socket_folder)
        configuration.write(self.data, socket_folder, account, durable=self.durable)
        command = [programs["pg_ctl"], "start", "--log", self.log.name, "--wait", "--timeout", f"{READINESS_S:.0f}"]
        # No path as an argument: pg_ctl hands those to a shell. Its output goes nowhere: the server inherits it, and a
        # pipe would keep the caller waiting for the server's end.
        started = account.run(command, folder=self.folder, environment={"PGDATA": str(self.data)})
        if started.returncode != 0:
            reason = _last_line(self.log.read_text(errors="replace")) if self.log.exists() else "no log was written"
            raise ClusterError(f"PostgreSQL does not start: {reason}", mend=f"See {self.log}.")
        return socket_folder

    def _ensure_database(self, socket_folder: Path) -> None:
        made = self.data / "lanewright.made"
        if made.exists():
            return
        programs = find_programs(self._major())
        databases = self._psql(programs, socket_folder, "postgres", "SELECT datname FROM pg_database")
        if DATABASE not in databases.split():
            self._psql(programs, socket_folder, "postgres", f"CREATE DATABASE {DATABASE}")
        extensions = "".join(f"CREATE EXTENSION IF NOT EXISTS {name};" for name in REQUIRED_EXTENSIONS)
        self._psql(programs, socket_folder, DATABASE, extensions)
        made.touch()

    def _psql(self, programs: Programs, socket_folder: Path, database: str, statement: str) -> str:
        command = [programs["psql"], "--no-psqlrc", "--quiet", "--tuples-only", "--no-align", "--set=ON_ERROR_STOP=1"]
        command += ["--host", str(socket_folder), "--username", SUPERUSER, "--dbname", database, "--command", statement]
        answer = caller().run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if answer.returncode != 0:
            raise ClusterError(f"The database cannot be made: {_last_line(answer.stderr)}", mend=f"See {self.log}.")
        return answer.stdout


def _url(socket_folder: Path) -> str:
    return f"postgresql://{SUPERUSER}@/{DATABASE}?host={quote(str(socket_folder), safe='/')}"


def _last_line(output: str) -> str:
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    return lines[-1] if lines else "it said nothing"
