"""Maps as tasks in the store: the base as the log, and what differs as the edits that an editor sends."""

from __future__ import annotations

import json
from typing import Any

from sqlalchemy.orm import Session
from tests.api.desk import Desk
from tests.stored_logs import add_log

from lanewright.core.attributes import element_attributes
from lanewright.core.edits import edits_between
from lanewright.core.elements import ElementKey, ElementKind, MapState
from lanewright.core.identity import renamed
from lanewright.core.report import edit_document
from lanewright.db.models import Log


def add_map_log(session: Session, log_id: str, base: MapState) -> Log:
    """A log with that map."""
    document: dict[str, Any] = {"lane_segments": {}, "pedestrian_crossings": {}, "drivable_areas": {}}
    for element in base:
        group = "lane_segments" if element.key.kind is ElementKind.LANE_SEGMENT else "pedestrian_crossings"
        document[group][str(element.id)] = element_attributes(element)
    return add_log(session, log_id, text=json.dumps(document))


def as_sent(desk: Desk, base: MapState, edited: MapState) -> list[dict[str, Any]]:
    """The edits from one map to another, what is new under ids of the desk's own."""
    mine = desk.new_id()
    lanes = {key: mine + n for n, key in enumerate(sorted(edited.lanes.keys() - base.lanes.keys()))}
    crossings = {key: mine + 50 + n for n, key in enumerate(sorted(edited.crossings.keys() - base.crossings.keys()))}
    return [edit_document(edit) for edit in edits_between(base, renamed(edited, lanes, crossings))]


def with_own_ids(desk: Desk, edits: list[dict[str, Any]], known: MapState) -> list[dict[str, Any]]:
    """A fix's edits as the editor applies them: what they bring in, under ids of the desk's own."""
    new = [edit for edit in edits if edit["operation"] == "insert" and _key(edit) not in known]
    mine = desk.new_id() if new else 0
    ids = {_key(edit): mine + n for n, edit in enumerate(new)}

    def lane(other: Any) -> Any:
        return ids.get(ElementKey(ElementKind.LANE_SEGMENT, other), other)

    def renumbered(edit: dict[str, Any]) -> dict[str, Any]:
        attributes = {name: value for name, value in edit["attributes"].items() if name != "id"}
        for name in attributes.keys() & {"successors", "predecessors"}:
            attributes[name] = [lane(other) for other in attributes[name]]
        for name in attributes.keys() & {"left_neighbor_id", "right_neighbor_id"}:
            attributes[name] = lane(attributes[name])
        return edit | {"id": ids.get(_key(edit), edit["id"]), "attributes": attributes}

    return [renumbered(edit) for edit in edits]


def _key(edit: dict[str, Any]) -> ElementKey:
    return ElementKey(ElementKind(edit["kind"]), edit["id"])


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
