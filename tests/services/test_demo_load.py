"""The demo on first start: something to do on the first screen, and nothing twice."""

from __future__ import annotations

from pathlib import Path

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session
from tests.api.desk import table_counts

from lanewright.core.workflow import Role
from lanewright.db.models import Account, Log, LogAsset, Task
from lanewright.services import demo_load
from lanewright.services.verify import subjects, verify


def test_the_demo_gives_everybody_something_to_do(
    session: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    everything = demo_load.generate
    monkeypatch.setattr(demo_load, "generate", lambda seed, folder: everything(seed, folder, 1))
    (log_id,) = demo_load.load_demo(session, tmp_path)
    assert (tmp_path / "demo" / log_id / "map").is_dir()
    assert sorted(session.scalars(select(Account.role))) == sorted(role.value for role in Role)
    task = session.scalars(select(Task)).one()
    assert (task.log.log_id, task.assignee and task.assignee.role) == (log_id, "annotator")
    assert task.direction == session.scalars(select(Log.direction)).one()
    assert "lidar.png" in session.scalars(select(LogAsset.name)).all()
    assert [found for subject in subjects(session) for found in verify(session, subject)] == []
    counts = table_counts(session)
    demo_load.load_demo(session, tmp_path)
    assert table_counts(session) == counts
