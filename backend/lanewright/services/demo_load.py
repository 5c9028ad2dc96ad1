"""The demo on first start: its logs, its people, and a task on each log, so that the first screen is not empty."""

from __future__ import annotations

from pathlib import Path
from types import MappingProxyType

from sqlalchemy.orm import Session

from lanewright.core.workflow import Role
from lanewright.demo import generate
from lanewright.formats.splits import SourceSplits, Split
from lanewright.sensors.log_bundle import Progress
from lanewright.services import tasks
from lanewright.services.actor import Actor
from lanewright.services.demo_accounts import ensure_demo_accounts
from lanewright.services.importing import Outcome, Placing, import_log

SEED = 7
FOLDER = "demo"


def load_demo(session: Session, home: Path, *, progress: Progress = lambda what, done, total: None) -> list[str]:
    """Generates the demo's logs under ``home``, imports them and assigns a task on each; returns their ids."""
    written = generate(SEED, home / FOLDER)
    splits = SourceSplits(MappingProxyType({log.log_id: Split(log.source_split) for log in written}))
    people = ensure_demo_accounts(session)
    admin = Actor(people[Role.ADMIN].id, people[Role.ADMIN].name, Role.ADMIN)
    for done, log in enumerate(written):
        progress("demo logs", done, len(written))
        placing = Placing(splits, release=Split(log.split), direction=log.direction)
        if import_log(session, log.folder, placing).outcome is Outcome.IMPORTED:
            tasks.create(session, admin, log_id=log.log_id, direction=None, assignee_id=people[Role.ANNOTATOR].id)
    return [log.log_id for log in written]
