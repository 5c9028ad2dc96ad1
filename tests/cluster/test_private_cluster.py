"""The private cluster in everyday life: made once, found again, shared, stopped."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import psycopg
import pytest

from lanewright.cluster import ClusterError, PrivateCluster, postmaster

UP = """
import sys; from pathlib import Path; from lanewright.cluster import PrivateCluster
print(PrivateCluster(Path(sys.argv[1])).up())
"""


def test_gives_a_postgis_database_on_a_socket_only(home, make_cluster, ask):
    url = make_cluster(home, durable=True, new=True).up()
    assert str(ask(url, "SELECT postgis_lib_version()")).startswith("3.")
    assert ask(url, "SELECT count(*) FROM pg_extension WHERE extname = 'btree_gist'") == 1
    assert ask(url, "SHOW listen_addresses") == ""
    assert ask(url, "SHOW fsync") == "on"
    assert (home / "cluster").stat().st_mode & 0o777 == 0o700


def test_up_again_finds_the_same_server_and_its_data(home, make_cluster, ask):
    cluster = make_cluster(home)
    url = cluster.up()
    ask(url, "CREATE TABLE kept AS SELECT 42 AS answer")
    pid = cluster.status().pid
    assert PrivateCluster(home).up() == url
    assert cluster.status().pid == pid
    assert cluster.down()
    assert not cluster.down()
    assert cluster.status().url is None
    assert ask(cluster.up(), "SELECT answer FROM kept") == 42


def test_two_starts_at_once_end_at_one_server(home, make_cluster):
    cluster = make_cluster(home, new=True)

    def start(_: int) -> str:
        return subprocess.run([sys.executable, "-c", UP, str(home)], capture_output=True, text=True, check=True).stdout

    with ThreadPoolExecutor(4) as pool:
        urls = set(pool.map(start, range(4)))
    assert urls == {f"{cluster.status().url}\n"}


def test_killed_server_is_recovered_with_what_it_had_committed(home, make_cluster, ask):
    cluster = make_cluster(home, durable=True)
    url = cluster.up()
    ask(url, "CREATE TABLE kept AS SELECT 42 AS answer")
    killed = cluster.status().pid
    with psycopg.connect(url):  # its backend outlives the postmaster for a moment
        os.kill(killed, signal.SIGKILL)
        url = cluster.up()
    assert cluster.status().pid != killed
    assert ask(url, "SELECT answer FROM kept") == 42


def test_stale_pid_file_that_names_a_stranger_does_not_bar_the_start(home, make_cluster, ask):
    cluster = make_cluster(home)
    cluster.up()
    lines = (cluster.data / "postmaster.pid").read_text().splitlines()
    cluster.down()
    (cluster.data / "postmaster.pid").write_text("\n".join([str(os.getpid()), *lines[1:]]))
    assert cluster.status().pid is None
    assert ask(cluster.up(), "SELECT 1") == 1


def test_zombie_is_not_alive(tmp_path):
    child = subprocess.Popen([sys.executable, "-c", ""], cwd=tmp_path)
    os.waitid(os.P_PID, child.pid, os.WEXITED | os.WNOWAIT)  # ended, not yet reaped
    os.kill(child.pid, 0)  # which this cannot tell
    assert not postmaster.is_alive(child.pid, tmp_path)
    child.wait()


def test_half_made_cluster_is_made_anew(home, make_cluster, ask):
    partial = home / "cluster" / "data.partial"
    partial.mkdir(parents=True)
    (partial / "PG_VERSION").write_text("15\n")
    assert ask(make_cluster(home, new=True).up(), "SELECT 1") == 1


def test_last_lease_stops_the_cluster(home, make_cluster):
    cluster = make_cluster(home)
    with cluster.lease():
        with PrivateCluster(home).lease():
            pass
        assert cluster.status().pid is not None
    assert cluster.status().pid is None


def test_kept_cluster_outlives_leases_until_down(home, make_cluster):
    cluster = make_cluster(home)
    cluster.keep()
    with cluster.lease():
        pass
    assert cluster.status().pid is not None
    cluster.down()
    with cluster.lease():
        pass
    assert cluster.status().pid is None


def test_without_postgis_one_sentence_says_what_to_install(home, monkeypatch, tmp_path):
    monkeypatch.setenv("LANEWRIGHT_POSTGRES_BIN", str(tmp_path))
    with pytest.raises(ClusterError, match=r"No PostgreSQL 15 or later with PostGIS is installed\. Run .*postgis-3"):
        PrivateCluster(home).up()


def test_server_that_does_not_start_names_the_reason_and_the_log(home, make_cluster):
    cluster = make_cluster(home)
    cluster.up()
    cluster.down()
    with (cluster.data / "postgresql.conf").open("a") as settings:
        settings.write("shared_buffers = 'nonsense'\n")
    with pytest.raises(ClusterError, match=r"does not start: .*postgres\.log"):
        cluster.up()


def test_home_that_cannot_be_written_is_named(tmp_path):
    occupied = tmp_path / "file"
    occupied.touch()
    with pytest.raises(ClusterError, match=r"cannot be written.*LANEWRIGHT_HOME"):
        PrivateCluster(occupied / "home").up()
