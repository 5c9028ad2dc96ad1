"""One of many open tabs of the same person: it saves, saves on old bases, repeats itself, and never gives up."""

from __future__ import annotations

import json
import random
import threading
import uuid

import httpx
from tests.chaos.ledger import Ledger, Request
from tests.chaos.world import LANES, repaint
from tests.cli.command import Lanewright, eventually

from lanewright.core.elements import Mark

SHARED_LANES = range(41, LANES + 1)
"""Lanes that all tabs repaint; every tab has one of those below for itself."""
REFUSALS = {"save.stale", "save.empty"}


class Tab(threading.Thread):
    """Sends one request after the other until told to stop; what must not happen goes into the ledger's faults."""

    def __init__(
        self,
        number: int,
        client: httpx.Client,
        task_id: int,
        ledger: Ledger,
        command: Lanewright,
        stop: threading.Event,
    ) -> None:
        super().__init__(name=f"tab-{number}")
        self._lane = number + 1
        self._client = client
        self._address = f"/api/v1/tasks/{task_id}/revisions"
        self._ledger = ledger
        self._command = command
        self._stop_asked = stop
        self._choose = random.Random(number)

    def run(self) -> None:
        while not self._stop_asked.is_set():
            try:
                self._act()
            except AssertionError as fault:
                self._ledger.fault(f"{self.name}: {fault}")
                return

    def _act(self) -> None:
        what = self._choose.choices(("fresh", "stale", "replay", "forgery"), (45, 25, 25, 5))[0]
        head = self._ledger.head
        if what == "fresh":
            self._save(self._lane, head)
        elif what == "stale":
            self._save(self._choose.choice(SHARED_LANES), self._choose.randint(max(0, head - 8), head))
        elif known := self._ledger.take_one_to_repeat(self._choose):
            if what == "forgery" and known.answer is not None:
                self._forge(known)
            self.send(known)

    def _save(self, lane: int, base: int) -> None:
        key = uuid.UUID(int=self._choose.getrandbits(128), version=4)
        mark = self._choose.choice(list(Mark)).value
        body = {"base_revision": base, "changeset_uuid": str(key), "edits": [repaint(lane, mark)], "note": self.name}
        request = Request(key, json.dumps(body).encode(), lane, mark)
        self._ledger.begin(request)
        self.send(request)

    def _forge(self, known: Request) -> None:
        """The same UUID with another body; a lost connection leaves nothing to judge."""
        body = json.loads(known.body) | {"note": "forged"}
        try:
            answer = self._client.post(self._address, json=body)
        except httpx.TransportError:
            return
        if answer.status_code < 500:
            found = (answer.status_code, answer.json()["code"])
            assert found == (409, "save.replayed_differently"), f"a forgery got {found}"

    def send(self, request: Request) -> None:
        """Sends a request and notes what came of it; waits for the server when it is away."""
        try:
            answer = self._client.post(
                self._address, content=request.body, headers={"Content-Type": "application/json"}
            )
        except httpx.TransportError:
            answer = None
        if answer is not None and answer.status_code == 201:
            self._ledger.acknowledge(request, answer.content, answer.json()["revision"])
        elif answer is not None and answer.status_code == 409:
            code = answer.json()["code"]
            assert code in REFUSALS, f"a save got {code}"
            self._ledger.refuse(request, code)
        else:
            self._ledger.lose(request)
            assert answer is None or answer.status_code >= 500, f"a save got {answer.status_code}: {answer.text}"
            eventually(lambda: self._stop_asked.is_set() or self._command.answers(), "the server is back")
