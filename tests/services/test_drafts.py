"""Drafts kept while the same task is being saved: neither waits for the other, and the save has the last word."""

from __future__ import annotations

import uuid
from typing import Any

import pytest
from sqlalchemy import text
from tests.stored_logs import add_log

from lanewright.core.edits import Edit, Operation
from lanewright.core.elements import ElementKind
from lanewright.core.errors import Conflict
from lanewright.core.report import edit_document
from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.db.repositories import drafts
from lanewright.services import accounts, sessions, tasks
from lanewright.services.access import readable_task
from lanewright.services.drafts import keep_draft
from lanewright.services.saving import save

REPAINTED = Edit(Operation.UPDATE, ElementKind.LANE_SEGMENT, 11, {"right_lane_mark_type": "DASHED_WHITE"})


def test_a_draft_is_kept_while_its_task_is_being_saved(fresh_database: str) -> None:
    with transaction(fresh_database) as session:
        admin = sessions.actor_of(accounts.add(session, name="admin", role=Role.ADMIN, password="a long password"))
        add_log(session)
        task = tasks.create(session, admin, log_id="log-one", direction=None, assignee_id=admin.id)
    draft: dict[str, Any] = {"base_revision": 0, "edits": [edit_document(REPAINTED)], "declared": (), "seen_version": 0}
    with transaction(fresh_database) as saving:
        readable_task(saving, admin, task.id, lock=True)
        with transaction(fresh_database) as keeping:
            keeping.execute(text("SET LOCAL lock_timeout = '10s'"))
            keep_draft(keeping, admin, task.id, **draft)
        save(saving, admin, task.id, base_revision=0, edits=[REPAINTED], changeset_uuid=uuid.uuid4(), note="")
    with transaction(fresh_database) as session:
        assert drafts.find(session, task.id, admin.id) is None
        with pytest.raises(Conflict) as refused:
            keep_draft(session, admin, task.id, **draft)
        assert refused.value.code == "draft.superseded"
