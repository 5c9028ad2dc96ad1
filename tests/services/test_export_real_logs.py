"""Real logs through import, an edit and the export, as the official library reads them."""

from __future__ import annotations

import io
import json
import tarfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from sqlalchemy.orm import Session
from tests.services.export_inside import archive_bytes
from tests.stored_logs import change_task, cut_in_two

from lanewright.core.changes import Direction
from lanewright.core.elements import MapState, Mark
from lanewright.core.workflow import Role
from lanewright.db.models import Account, Task
from lanewright.db.repositories import elements
from lanewright.formats.splits import SourceSplits, Split
from lanewright.services import sessions, tasks
from lanewright.services.importing import Placing, import_log

map_api = pytest.importorskip("av2.map.map_api", reason="av2 is not installed (requirements-av2.txt)")
PART = 2_000_000_000
PLACING = Placing(SourceSplits(), release=Split.TEST, direction=Direction.PRIOR_TO_CURRENT)


def edited(state: MapState) -> MapState:
    """One vertex moved by 0.37 m, one mark repainted, one crossing gone."""
    lane = state.lanes[min(state.lanes)]
    (x, y, z), *rest = lane.right_boundary
    moved = replace(lane, right_boundary=((x + 0.37, y, z), *rest), left_mark=Mark.SOLID_BLUE)
    gone = min(state.crossings)
    return state.replaced([moved], [state.crossings[gone].key])


def unpack(session: Session, folder: Path) -> None:
    with tarfile.open(fileobj=io.BytesIO(archive_bytes(session, Split.TEST))) as tar:
        tar.extractall(folder)  # our own archive; Debian's Python 3.11.2 knows no extraction filters


@pytest.mark.shared
def test_what_was_drawn_is_what_av2_loads(session: Session, real_logs: list[Path], tmp_path: Path) -> None:
    admin = Account(name="admin", role=Role.ADMIN.value, password_hash="x")
    session.add(admin)
    session.flush()
    for folder in real_logs:
        import_log(session, folder, PLACING)
        made = tasks.create(session, sessions.actor_of(admin), log_id=folder.name, direction=None, assignee_id=None)
        change_task(session, made.id, edited)
        task = session.get_one(Task, made.id)
        task.state, task.accepted_revision = "accepted", 1
    unpack(session, tmp_path)
    for folder in real_logs:
        (imported,) = (folder / "map").glob("log_map_archive_*.json")
        prior_folder, current_folder = (tmp_path / side / folder.name / "map" for side in ("prior", "current"))
        assert (prior_folder / imported.name).read_bytes() == imported.read_bytes()
        prior, current = (
            map_api.ArgoverseStaticMap.from_map_dir(each, build_raster=True) for each in (prior_folder, current_folder)
        )
        drawn = min(prior.vector_lane_segments)
        before, after = prior.vector_lane_segments[drawn], current.vector_lane_segments[drawn]
        assert after.left_mark_type == "SOLID_BLUE"
        shift = after.right_lane_boundary.xyz - before.right_lane_boundary.xyz
        assert shift[0] == pytest.approx([0.37, 0.0, 0.0], abs=0.01)
        assert not shift[1:].any()
        gone = min(prior.vector_pedestrian_crossings)
        assert set(prior.vector_pedestrian_crossings) - set(current.vector_pedestrian_crossings) == {gone}
        for identity, lane in prior.vector_lane_segments.items():
            if identity != drawn:
                same = current.vector_lane_segments[identity]
                assert np.array_equal(lane.left_lane_boundary.xyz, same.left_lane_boundary.xyz)
                assert np.array_equal(lane.right_lane_boundary.xyz, same.right_lane_boundary.xyz)
        changes = json.loads((tmp_path / "changes" / f"{folder.name}.json").read_text())["changes"]
        assert {(change["id"], *change["categories"]) for change in changes} >= {(gone, "deletion")}
        assert drawn in {change["id"] for change in changes}
        sensors = json.loads((tmp_path / "sensors" / f"{folder.name}.json").read_text())
        assert all(isinstance(frame["timestamp_ns"], str) for frame in sensors["frames"])
        assert sensors["frames"]


@pytest.mark.shared
def test_both_sides_of_a_cut_load_with_av2_and_differ_in_paint_only(
    session: Session, real_logs: list[Path], tmp_path: Path
) -> None:
    admin = Account(name="admin", role=Role.ADMIN.value, password_hash="x")
    session.add(admin)
    session.flush()
    cut: dict[str, int] = {}
    for folder in real_logs:
        import_log(session, folder, PLACING)
        made = tasks.create(session, sessions.actor_of(admin), log_id=folder.name, direction=None, assignee_id=None)
        task = session.get_one(Task, made.id)
        state = elements.load(session, task.line_id, 0).state
        cut[folder.name] = max(state.lanes, key=lambda key: len(state.lanes[key].left_boundary))
        change_task(session, made.id, lambda state, lane=cut[folder.name]: cut_in_two(state, lane, PART))
        task.state, task.accepted_revision = "accepted", 1
    unpack(session, tmp_path)
    for folder in real_logs:
        whole = map_api.ArgoverseStaticMap.from_map_dir(folder / "map", build_raster=False).vector_lane_segments
        prior, current = (
            map_api.ArgoverseStaticMap.from_map_dir(tmp_path / side / folder.name / "map", build_raster=True)
            for side in ("prior", "current")
        )
        before, after = prior.vector_lane_segments, current.vector_lane_segments
        assert set(before) == set(after) == (set(whole) - {cut[folder.name]}) | {PART, PART + 1}
        for key in before:
            assert np.array_equal(before[key].left_lane_boundary.xyz, after[key].left_lane_boundary.xyz)
            assert np.array_equal(before[key].right_lane_boundary.xyz, after[key].right_lane_boundary.xyz)
        repainted = [key for key in before if before[key].right_mark_type != after[key].right_mark_type]
        assert repainted == [PART + 1]
        assert after[PART].successors == before[PART].successors == [PART + 1]
        joined = np.vstack([before[PART].left_lane_boundary.xyz, before[PART + 1].left_lane_boundary.xyz[1:]])
        assert {*map(tuple, whole[cut[folder.name]].left_lane_boundary.xyz)} <= {*map(tuple, joined)}
        changes = json.loads((tmp_path / "changes" / f"{folder.name}.json").read_text())["changes"]
        assert [(change["id"], change["categories"]) for change in changes] == [(PART + 1, ["marking"])]
