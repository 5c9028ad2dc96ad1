"""Fixtures of the change mapping as tasks in the store: their base as the log, their edits as an editor sends them."""

from __future__ import annotations

import json
from typing import Any

from sqlalchemy.orm import Session
from tests.api.desk import Desk
from tests.core.worlds import FIXTURES, scenario
from tests.stored_logs import add_log

from lanewright.core.edits import edits_between
from lanewright.core.elements import MapState
from lanewright.core.identity import renamed
from lanewright.core.report import edit_document
from lanewright.db.models import Log


def add_fixture_log(session: Session, name: str) -> Log:
    """A log whose map is the fixture's base."""
    document = json.loads((FIXTURES / f"{name}.json").read_text())
    return add_log(session, name, text=json.dumps(document["base"]))


def drawn(desk: Desk, name: str, edited: MapState | None = None) -> list[dict[str, Any]]:
    """The edits of the fixture (or to another map), what is new under ids of the desk's own."""
    case = scenario(name)
    edited = edited or case.edited
    return as_sent(desk, case.base, edited)


def as_sent(desk: Desk, base: MapState, edited: MapState) -> list[dict[str, Any]]:
    """The edits from one map to another, what is new under ids of the desk's own."""
    mine = desk.new_id()
    lanes = {key: mine + n for n, key in enumerate(sorted(edited.lanes.keys() - base.lanes.keys()))}
    crossings = {key: mine + 50 + n for n, key in enumerate(sorted(edited.crossings.keys() - base.crossings.keys()))}
    return [edit_document(edit) for edit in edits_between(base, renamed(edited, lanes, crossings))]


def composed(*lists: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Edits made one after the other as the one net edit of each element that an editor sends."""
    net: dict[tuple[str, int], dict[str, Any]] = {}
    for edit in (edit for edits in lists for edit in edits):
        key = (edit["kind"], edit["id"])
        before = net.get(key)
        if before is None:
            net[key] = edit
        elif edit["operation"] == "delete":
            if before["operation"] == "insert":
                del net[key]
            else:
                net[key] = edit
        elif before["operation"] == "delete":
            net[key] = edit | {"operation": "update"}
        else:
            net[key] = before | {"attributes": {**before["attributes"], **edit["attributes"]}}
    return list(net.values())
