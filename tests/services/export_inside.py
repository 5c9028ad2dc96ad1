"""The archive of a split as the test's own transaction sees it."""

from __future__ import annotations

import contextlib
import io
import tarfile
from collections.abc import Iterator

from sqlalchemy.orm import Session

from lanewright.formats.splits import Split
from lanewright.services.export import archive


def archive_bytes(session: Session, split: Split) -> bytes:
    """The tar archive."""

    @contextlib.contextmanager
    def inside_the_test() -> Iterator[Session]:
        session.flush()
        yield session

    return b"".join(archive(inside_the_test, split))


def archived(session: Session, split: Split) -> dict[str, bytes]:
    """Its files by path."""
    with tarfile.open(fileobj=io.BytesIO(archive_bytes(session, split))) as tar:
        return {member.name: tar.extractfile(member).read() for member in tar.getmembers()}  # type: ignore[union-attr]
