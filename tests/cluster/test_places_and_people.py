"""The private cluster in odd places and under different users."""

from __future__ import annotations

import os
import pwd
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import lanewright
from lanewright.cluster import ClusterError, PrivateCluster
from lanewright.cluster.account import Account

ROOT_ONLY = pytest.mark.skipif(os.geteuid() != 0, reason="only root can act as different users")
UP_AND_DOWN = """
import sys; from pathlib import Path; from lanewright.cluster import PrivateCluster
cluster = PrivateCluster(Path(sys.argv[1])); print(cluster.up()); assert cluster.down()
"""


def test_path_too_long_for_a_socket(home, make_cluster, ask):
    deep = home / ("long " * 20) / ("deep '\"%$, " * 8)
    assert len(os.fsencode(deep)) > 107
    url = make_cluster(deep).up()
    assert ask(url, "SELECT 1") == 1


@pytest.mark.skipif(os.geteuid() == 0, reason="an ordinary user's matter")
def test_ordinary_user_starts_it_directly(home, make_cluster, ask):
    assert ask(make_cluster(home).up(), "SELECT 1") == 1


@ROOT_ONLY
def test_root_lends_the_server_another_account(home, make_cluster, ask):
    cluster = make_cluster(home)
    assert ask(cluster.up(), "SELECT 1") == 1
    assert cluster.data.owner() in ("postgres", "nobody")
    assert _user_of(cluster.status().pid) == cluster.data.stat().st_uid != 0


@ROOT_ONLY
def test_root_below_a_folder_closed_to_others(home, make_cluster, ask):
    home.mkdir(mode=0o700)
    cluster = make_cluster(home / "checkout" / ".lanewright")
    assert ask(cluster.up(), "SELECT 1") == 1
    assert cluster.data.stat().st_uid == 0 or str(cluster.data).startswith("/var/lib/lanewright/")


@ROOT_ONLY
def test_root_below_a_closed_folder_where_user_namespaces_are_forbidden(home, make_cluster, ask, monkeypatch):
    reaches = Account.reaches
    monkeypatch.setattr(Account, "reaches", lambda self, folder: self.namespace is None and reaches(self, folder))
    home.mkdir(mode=0o700)
    cluster = make_cluster(home / ".lanewright", new=True)
    made_before = PrivateCluster(home / ".lanewright")
    try:
        ask(cluster.up(), "CREATE TABLE kept AS SELECT 42 AS answer")
        assert cluster.folder.parent == Path("/var/lib/lanewright")
        assert ask(PrivateCluster(home / ".lanewright").up(), "SELECT answer FROM kept") == 42
        assert made_before.status().pid == cluster.status().pid
    finally:
        cluster.down()
        shutil.rmtree(cluster.folder)


@ROOT_ONLY
def test_cluster_that_moves_below_a_closed_folder_keeps_its_data(home, make_cluster, ask):
    cluster = make_cluster(home / "open")
    ask(cluster.up(), "CREATE TABLE kept AS SELECT 42 AS answer")
    cluster.down()
    (home / "closed").mkdir(mode=0o700)
    shutil.move(home / "open", home / "closed" / "moved")
    assert ask(make_cluster(home / "closed" / "moved").up(), "SELECT answer FROM kept") == 42


@ROOT_ONLY
def test_other_users_can_neither_enter_nor_pose_as_the_socket(home, make_cluster):
    url = make_cluster(home).up()
    stranger = _as_stranger(["psql", "--dbname", url, "--command", "SELECT 1"])
    assert stranger.returncode != 0
    assert "Permission denied" in stranger.stderr


@ROOT_ONLY
def test_temporary_socket_folder_of_a_stranger_is_refused(home, monkeypatch, tmp_path_factory):
    deep = home / ("long" * 30)
    temporary = home.parent / "temporary"
    temporary.mkdir(mode=0o777)
    monkeypatch.setattr("tempfile.tempdir", str(temporary))
    with PrivateCluster(deep, durable=False).lease():
        (socket_folder,) = temporary.iterdir()
    os.chown(socket_folder, 12345, 12345)
    with pytest.raises(ClusterError, match="is not a private folder"):
        PrivateCluster(deep, durable=False).up()


@ROOT_ONLY
def test_ordinary_user_with_nothing_but_the_standard_library(home):
    """Also the proof that the cluster works before any dependency is installed."""
    python = _python_for_strangers()
    home.mkdir()
    os.chown(home, *_stranger())
    package = home / "package" / "lanewright"
    source = Path(lanewright.__file__).parent
    shutil.copytree(source / "cluster", package / "cluster")
    (package / "core").mkdir()
    for name in ("__init__.py", "core/__init__.py", "core/errors.py"):
        shutil.copy(source / name, package / name)
    command = [python, "-S", "-c", UP_AND_DOWN, str(home / "of a stranger")]
    ended = _as_stranger(command, environment={"PYTHONPATH": str(package.parent)})
    assert ended.stderr == ""
    assert ended.stdout.startswith("postgresql://")
    assert (home / "of a stranger").stat().st_uid == _stranger()[0]


@ROOT_ONLY
def test_cluster_of_another_user_is_named_as_such(home, make_cluster):
    python = _python_for_strangers()
    make_cluster(home).up()
    home.chmod(0o777)
    (home / "cluster.lock").chmod(0o666)
    source = home / "package" / "lanewright"
    shutil.copytree(Path(lanewright.__file__).parent, source)
    ended = _as_stranger([python, "-S", "-c", UP_AND_DOWN, str(home)], environment={"PYTHONPATH": str(source.parent)})
    assert "belongs to the user with id" in ended.stderr


def _stranger() -> tuple[int, int]:
    entry = pwd.getpwnam("nobody")
    return entry.pw_uid, entry.pw_gid


def _python_for_strangers() -> str:
    for python in (sys.executable, "/usr/bin/python3"):
        if _as_stranger([python, "-c", "import sys; sys.exit(sys.version_info < (3, 11))"]).returncode == 0:
            return python
    pytest.skip("no Python 3.11 that other users may run")


def _as_stranger(command: list[str], environment: dict[str, str] | None = None) -> subprocess.CompletedProcess[str]:
    uid, gid = _stranger()
    try:
        return subprocess.run(
            command,
            user=uid,
            group=gid,
            extra_groups=[],
            cwd="/",
            env={"PATH": os.environ["PATH"], **(environment or {})},
            capture_output=True,
            text=True,
            check=False,
        )
    except PermissionError as error:
        return subprocess.CompletedProcess(command, 126, "", str(error))


def _user_of(pid: int) -> int:
    return Path(f"/proc/{pid}").stat().st_uid
