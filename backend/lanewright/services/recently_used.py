"""Values that are dear to load and never change under their key, kept while they are used."""

from __future__ import annotations

from threading import Lock
from typing import Generic, TypeVar

Value = TypeVar("Value")


class RecentlyUsed(Generic[Value]):
    """Up to ``most`` values by content hash; the one unused for longest goes first. Safe among threads."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._values: dict[bytes, Value] = {}
        self._lock = Lock()

    def get(self, sha256: bytes) -> Value | None:
        """The value, now the most recently used one; None when it is not kept."""
        with self._lock:
            value = self._values.pop(sha256, None)
            if value is not None:
                self._values[sha256] = value
            return value

    def put(self, sha256: bytes, value: Value) -> None:
        """Keeps a value."""
        with self._lock:
            self._values[sha256] = value
            while len(self._values) > self._most:
                del self._values[next(iter(self._values))]

    def clear(self) -> None:
        """Forgets everything."""
        with self._lock:
            self._values.clear()
