"""Twenty tabs save to one task while server and database are killed with -9 in the middle of it.

``LANEWRIGHT_CHAOS_KILLS`` says how often (``make chaos``: 20). All traffic stays on the loopback interface and is
bounded by the kills: the tabs stop when the last one is survived.
"""

from __future__ import annotations

import contextlib
import json
import os
import random
import signal
import threading
import uuid
from pathlib import Path

import psycopg
from tests.chaos.ledger import Ledger
from tests.chaos.tab import Tab
from tests.chaos.world import Site
from tests.cli.command import Lanewright, eventually

from lanewright.cluster import PrivateCluster

KILLS = int(os.environ.get("LANEWRIGHT_CHAOS_KILLS", "3"))
TABS, DEVICES = 20, 4
LIVE = 2**31 - 1


def test_every_acknowledged_changeset_is_saved_exactly_once(command: Lanewright, tmp_path: Path) -> None:
    site = Site(command, tmp_path)
    devices = [site.sign_in("anna") for _ in range(DEVICES)]
    ledger, stop = Ledger(), threading.Event()
    tabs = [Tab(number, devices[number % DEVICES], site.task_id, ledger, command, stop) for number in range(TABS)]
    for tab in tabs:
        tab.start()
    try:
        survive(command, ledger, random.Random(7))
    finally:
        stop.set()
        for tab in tabs:
            tab.join()
    assert ledger.faults == []
    find_out_what_became_of_the_rest(tabs[0], ledger)
    assert ledger.faults == []
    assert ledger.replays > 0
    assert ledger.refusals.get("save.stale", 0) > 0
    hold_the_store_against(command, ledger)
    verified = command.run("verify")
    assert verified.returncode == 0, verified.stdout
    print(f"{KILLS} kills, {ledger.acknowledged} saves, {ledger.replays} replays, refusals: {ledger.refusals}")


def survive(command: Lanewright, ledger: Ledger, choose: random.Random) -> None:
    """Kills server, database or both in the middle of saves, again and again; each time they come back."""
    for number in range(KILLS):
        wanted = ledger.acknowledged + choose.randint(4, 16)
        eventually(lambda wanted=wanted: ledger.faults or ledger.acknowledged >= wanted, "saves are acknowledged")
        assert ledger.faults == []
        victims = ("both", "server", "database")[number % 3]
        if victims != "server":
            kill_database(command.home)
        if victims != "database":
            os.killpg(command.servers[-1].pid, signal.SIGKILL)
            command.servers[-1].wait()
            command.serve()
    wanted = ledger.acknowledged + TABS
    eventually(lambda: ledger.faults or ledger.acknowledged >= wanted, "saves go on after the last kill")


def kill_database(home: Path) -> None:
    """The postmaster and every process it has started, without any chance to say goodbye."""
    postmaster = PrivateCluster(home).status().pid
    assert postmaster is not None
    children = Path(f"/proc/{postmaster}/task/{postmaster}/children").read_text().split()
    for process in (postmaster, *map(int, children)):
        with contextlib.suppress(ProcessLookupError):
            os.kill(process, signal.SIGKILL)


def find_out_what_became_of_the_rest(tab: Tab, ledger: Ledger) -> None:
    """Requests whose answer was lost: repeated, each is either acknowledged or was never saved."""
    for request in [request for request in ledger.requests.values() if request.answer is None]:
        tab.send(request)
    assert all(request.answer is not None for request in ledger.requests.values())


def hold_the_store_against(command: Lanewright, ledger: Ledger) -> None:
    url = PrivateCluster(command.home).status().url
    assert url is not None
    with psycopg.connect(url) as store:
        line_id, head = store.execute("SELECT line.id, head FROM line JOIN task ON task.line_id = line.id").fetchone()
        saved: dict[uuid.UUID, tuple[int, bytes]] = {
            key: (number, bytes(answer))
            for number, key, answer in store.execute(
                "SELECT number, changeset_uuid, answer FROM revision WHERE line_id = %s AND number > 0", [line_id]
            )
        }
        versions = store.execute(
            "SELECT element_id, rev_from, rev_to, attributes ->> 'right_lane_mark_type' FROM element_version"
            " WHERE line_id = %s ORDER BY element_id, rev_from",
            [line_id],
        ).fetchall()
    assert sorted(number for number, _ in saved.values()) == list(range(1, head + 1)), "history has a gap"
    assert {key: answer for key, (_, answer) in saved.items()} == {
        request.key: request.answer for request in ledger.requests.values()
    }
    written = {(element, rev_from): mark for element, rev_from, _, mark in versions}
    for request in ledger.requests.values():
        number, answer = saved[request.key]
        assert json.loads(answer)["revision"] == number
        assert written[request.lane, number] == request.mark
    spans: dict[int, list[tuple[int, int]]] = {}
    for element, rev_from, rev_to, _ in versions:
        spans.setdefault(element, []).append((rev_from, rev_to))
    for element, own in spans.items():
        ends = [rev_to for _, rev_to in own]
        assert [rev_from for rev_from, _ in own] == [0, *ends[:-1]], f"lane {element} has a gap or an overlap"
        assert ends[-1] == LIVE
    assert sum(len(own) - 1 for own in spans.values()) == head, "a version belongs to no acknowledged changeset"
