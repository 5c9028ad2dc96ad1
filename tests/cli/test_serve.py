"""Starting, finding, killing and stopping the whole of it."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import httpx
import psycopg
import pytest
from tests.cli.command import Lanewright, eventually

from lanewright.cluster import PrivateCluster


def test_serves_until_ctrl_c_which_stops_everything(command: Lanewright):
    server = command.serve()
    assert httpx.get(f"http://127.0.0.1:{command.port}/healthz").json()["status"] == "alive"
    eventually(lambda: len(command.processes()) > 2, "worker and database run beside the server")
    os.killpg(server.pid, signal.SIGINT)  # as a terminal does
    output, errors = server.communicate()
    assert server.returncode == 0
    assert f"http://127.0.0.1:{command.port}" in output
    assert errors == ""
    assert command.processes() == []


def test_second_server_says_where_the_first_one_is(command: Lanewright):
    server = command.serve()
    second = command.run("serve")
    assert second.returncode == 2
    assert f"runs already: http://127.0.0.1:{command.port}" in second.stderr
    assert "Traceback" not in second.stderr
    stopped = command.run("stop")
    assert stopped.stdout == "Lanewright has stopped.\n"
    assert server.wait() == 0
    assert command.processes() == []
    assert command.run("stop").stdout == "Lanewright was not running.\n"


def test_busy_port_is_named_before_anything_starts(command: Lanewright):
    command.serve()
    other = command.run("serve", LANEWRIGHT_HOME=str(command.home / "other"))
    assert other.returncode == 2
    assert f"Port {command.port} of 127.0.0.1 cannot be used" in other.stderr
    assert not (command.home / "other" / "cluster").exists()


def test_killed_worker_and_database_come_back(command: Lanewright):
    command.serve()
    cluster = PrivateCluster(command.home)
    killed = cluster.status().pid
    assert killed is not None
    worker = _worker(command)
    os.kill(worker, signal.SIGKILL)
    os.kill(killed, signal.SIGKILL)
    eventually(lambda: cluster.status().pid not in (None, killed), "the database is started again")
    eventually(command.answers, "the server works with it")
    eventually(lambda: _worker(command) not in (None, worker), "the worker is started again")


@pytest.mark.parametrize("moment", ["at once", "with its worker at work"])
def test_killed_server_leaves_nothing_running(command: Lanewright, moment: str):
    server = command.serve()
    if moment == "with its worker at work":
        url = PrivateCluster(command.home).status().url
        assert url is not None
        with psycopg.connect(url, autocommit=True) as connection:
            query = "SELECT count(*) FROM procrastinate_workers"
            eventually(lambda: connection.execute(query).fetchone() == (1,), "the worker has signed in")
    os.kill(server.pid, signal.SIGKILL)
    server.wait()
    eventually(lambda: command.processes() == [], "worker and database end too")
    assert command.serve().poll() is None


def _worker(command: Lanewright) -> int | None:
    with_arguments = {pid: _arguments(pid) for pid in command.processes()}
    return next((pid for pid, arguments in with_arguments.items() if b"worker" in arguments), None)


def _arguments(pid: int) -> list[bytes]:
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
    except OSError:
        return []
