"""TarStream: a tar archive written piece by piece, so that no more than one member is in memory."""

from __future__ import annotations

import datetime
import hashlib
import io
import tarfile
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Member:
    """A file that was written, as a manifest lists it; ``bytes`` is its size."""

    path: str
    bytes: int
    sha256: str


class _Sink(io.RawIOBase):
    """Collects what tarfile writes until it is taken."""

    def __init__(self) -> None:
        self._pieces: list[bytes] = []

    def writable(self) -> bool:
        return True

    def write(self, data: object) -> int:
        piece = bytes(data)  # type: ignore[call-overload]
        self._pieces.append(piece)
        return len(piece)

    def take(self) -> bytes:
        taken = b"".join(self._pieces)
        self._pieces.clear()
        return taken


class TarStream:
    """Members go in, bytes of the archive come out; the same members give the same bytes."""

    def __init__(self) -> None:
        self._sink = _Sink()
        self._archive = tarfile.open(mode="w|", fileobj=self._sink, format=tarfile.PAX_FORMAT)  # noqa: SIM115
        self._members: list[Member] = []

    def add(self, path: str, body: bytes, modified_at: datetime.datetime) -> bytes:
        """Writes one file and returns the next bytes of the archive."""
        member = tarfile.TarInfo(path)
        member.size = len(body)
        member.mtime = int(modified_at.timestamp())
        member.mode = 0o644
        self._archive.addfile(member, io.BytesIO(body))
        self._members.append(Member(path, len(body), hashlib.sha256(body).hexdigest()))
        return self._sink.take()

    def take_members(self) -> list[Member]:
        """The files written since the last call."""
        taken, self._members = self._members, []
        return taken

    def close(self) -> bytes:
        """The last bytes of the archive."""
        self._archive.close()
        return self._sink.take()
