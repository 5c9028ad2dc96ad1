"""What the clients sent and were told: the truth that the store is held against."""

from __future__ import annotations

import random
import threading
import uuid
from dataclasses import dataclass, field


@dataclass
class Request:
    """One changeset: what it asks for, and the answer once there is one."""

    key: uuid.UUID
    body: bytes
    lane: int
    mark: str
    answer: bytes | None = None
    in_flight: bool = True


@dataclass
class Ledger:
    """Shared by all clients; a request is known from before it is first sent until it is answered for good."""

    requests: dict[uuid.UUID, Request] = field(default_factory=dict)
    refusals: dict[str, int] = field(default_factory=dict)
    replays: int = 0
    head: int = 0
    faults: list[str] = field(default_factory=list)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    @property
    def acknowledged(self) -> int:
        return sum(request.answer is not None for request in list(self.requests.values()))

    def begin(self, request: Request) -> None:
        with self._lock:
            self.requests[request.key] = request

    def take_one_to_repeat(self, choose: random.Random) -> Request | None:
        """A request that nobody is sending: acknowledged, or with its fate unknown."""
        with self._lock:
            idle = [request for request in self.requests.values() if not request.in_flight]
            chosen = choose.choice(idle) if idle else None
            if chosen is not None:
                chosen.in_flight = True
            return chosen

    def acknowledge(self, request: Request, answer: bytes, revision: int) -> None:
        with self._lock:
            if request.answer is not None:
                self.replays += 1
                if request.answer != answer:
                    self.faults.append(f"{request.key} was answered differently")
            request.answer, request.in_flight = answer, False
            self.head = max(self.head, revision)

    def refuse(self, request: Request, code: str) -> None:
        with self._lock:
            self.refusals[code] = self.refusals.get(code, 0) + 1
            if request.answer is not None:
                self.faults.append(f"{request.key} was acknowledged and then refused: {code}")
            self.requests.pop(request.key, None)

    def lose(self, request: Request) -> None:
        """The connection ended: nobody knows whether it was saved."""
        with self._lock:
            request.in_flight = False

    def fault(self, what: str) -> None:
        with self._lock:
            self.faults.append(what)
