"""The store against the bare database: the server's part of opening and saving a task, beside the same rows alone.

Both sides in one run, on a private cluster of its own with commits as durable as in life.
"""

from __future__ import annotations

import tempfile
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import orjson
import psycopg
from bench.engine import Figure, fastest_ms
from bench.legal_edits import legally_edited
from psycopg.types.json import Jsonb

from lanewright.api.routes.workspace import open_workspace
from lanewright.cluster import PrivateCluster
from lanewright.core.changes import Direction
from lanewright.core.edits import Edit, Operation, edits_between
from lanewright.core.workflow import Role
from lanewright.db.engine import engine_for, transaction
from lanewright.db.migration import migrate
from lanewright.db.models import Account, Task
from lanewright.demo import generate
from lanewright.formats.splits import SourceSplits, Split
from lanewright.services import line_maps, tasks, workspace
from lanewright.services.actor import Actor
from lanewright.services.id_blocks import take_block
from lanewright.services.importing import Placing, import_log
from lanewright.services.saving import save

_SHARED_LOGS = Path(__file__).resolve().parents[2] / "shared" / "data" / "av2"
_ROUNDS = 15
_CHANGES = 10

READ = "SELECT kind, element_id, attributes, ST_AsBinary(geom), rev_from FROM element_version"
HEAD = "UPDATE line SET head = %(number)s WHERE id = %(line_id)s AND head = %(number)s - 1"
REVISION = (
    "INSERT INTO revision"
    " (line_id, number, author_id, note, changeset_uuid, body_sha256, answer, content_sha256, updates)"
    " VALUES (%(line_id)s, %(number)s, %(author_id)s, %(note)s, %(changeset_uuid)s, %(body_sha256)s, %(answer)s,"
    " %(content_sha256)s, %(updates)s)"
)
CLOSE = (
    "UPDATE element_version SET rev_to = %(number)s"
    " WHERE line_id = %(line_id)s AND kind = %(kind)s AND element_id = %(element_id)s AND rev_to = 2147483647"
)
VERSION = (
    "INSERT INTO element_version (line_id, kind, element_id, rev_from, attributes, geom, merc, sha256) VALUES"
    " (%(line_id)s, %(kind)s, %(element_id)s, %(number)s, %(attributes)s, ST_GeomFromWKB(%(geom)s, 0),"
    " ST_GeomFromWKB(%(merc)s, 3857), %(sha256)s)"
)
CHANGE = (
    "INSERT INTO atomic_change (line_id, revision, kind, element_id, category, leaves)"
    " VALUES (%(line_id)s, %(number)s, %(kind)s, %(element_id)s, %(category)s, %(leaves)s)"
)


def figures() -> list[Figure]:
    """Opening and saving, as multiples of the bare database's time."""
    with _store() as (url, folder):
        desk = _Desk(url, folder)
        opening = desk.opening()
        saving = desk.saving()
    return [
        Figure("open a task, its map known to the server / bare read", opening["known"] / opening["bare"]),
        Figure("open a task for the first time / bare read", opening["first"] / opening["bare"]),
        Figure("  bare read of the same rows", opening["bare"], "ms"),
        Figure(
            f"save of {_CHANGES} changes, rules and all / the same rows by psycopg", saving["save"] / saving["bare"]
        ),
        Figure("  the same rows by bare psycopg, one transaction", saving["bare"], "ms"),
    ]


@contextmanager
def _store() -> Iterator[tuple[str, Path]]:
    with tempfile.TemporaryDirectory(prefix="lanewright-bench-") as name:
        folder = Path(name)
        folder.chmod(0o711)
        with PrivateCluster(folder / "home").lease() as url:
            migrate(url)
            try:
                yield url, folder
            finally:
                engine_for(url).dispose()


def _under(edit: Edit, new: int) -> Edit:
    return replace(edit, id=new, attributes={**edit.attributes, "id": new})


class _Desk:
    """An admin beside one imported log."""

    def __init__(self, url: str, folder: Path) -> None:
        self._url = url
        with transaction(url) as session:
            account = Account(name="bench", role=Role.ADMIN.value, password_hash="")
            session.add(account)
            session.flush()
            self._actor = Actor(account.id, account.name, Role.ADMIN)
            placing = Placing(SourceSplits(), release=Split.TEST, direction=Direction.PRIOR_TO_CURRENT)
            self._log_id = import_log(session, _log_folder(folder), placing).log_id
        self._bare = psycopg.connect(url)

    def opening(self) -> dict[str, float]:
        task_id, line_id = self._new_task()

        def opened() -> object:
            with transaction(self._url) as session:
                return open_workspace(task_id, self._actor, session)

        def opened_first() -> object:
            line_maps.BASE_MAPS.clear()
            workspace.BASE_DOCUMENTS.clear()
            return opened()

        def bare() -> object:
            query = f"{READ} WHERE line_id = %s AND rev_to = 2147483647"
            rows = self._bare.execute(query, [line_id]).fetchall()
            self._bare.rollback()
            return rows

        opened()
        return fastest_ms({"known": opened, "first": opened_first, "bare": bare})

    def saving(self) -> dict[str, float]:
        """Every save begins on a task of its own, so that each side always writes the same rows."""
        with transaction(self._url) as session:
            base = line_maps.base_map(session, session.get_one(Task, self._new_task()[0]).line_id).state
        edits = edits_between(base, legally_edited(base, _CHANGES))
        mine = iter([self._ready(edits) for _ in range(_ROUNDS + 1)])
        bare = iter([self._new_task()[1] for _ in range(_ROUNDS)])

        def saved() -> int:
            task_id, line_id, own_edits = next(mine)
            with transaction(self._url) as session:
                save(
                    session,
                    self._actor,
                    task_id,
                    base_revision=0,
                    edits=own_edits,
                    changeset_uuid=uuid.uuid4(),
                    note="",
                )
            return line_id

        rows = self._rows_of(saved())
        return fastest_ms({"save": saved, "bare": lambda: self._write(next(bare), rows)}, _ROUNDS)

    def _new_task(self) -> tuple[int, int]:
        with transaction(self._url) as session:
            made = tasks.create(session, self._actor, log_id=self._log_id, direction=None, assignee_id=None)
            return made.id, session.get_one(Task, made.id).line_id

    def _ready(self, edits: tuple[Edit, ...]) -> tuple[int, int, list[Edit]]:
        """A new task, and the edits with ids that were handed out for it."""
        task_id, line_id = self._new_task()
        with transaction(self._url) as session:
            first, last = take_block(session, self._actor, task_id)
        ids = iter(range(first, last + 1))
        own = [_under(edit, next(ids)) if edit.operation is Operation.INSERT else edit for edit in edits]
        return task_id, line_id, own

    def _rows_of(self, line_id: int) -> dict[str, list[dict[str, Any]]]:
        """What a save wrote for revision 1 of a line, ready to be written again."""

        def rows(query: str) -> list[dict[str, Any]]:
            with self._bare.cursor(row_factory=psycopg.rows.dict_row) as cursor:
                return cursor.execute(query, {"line_id": line_id}).fetchall()

        found = {
            "revision": rows("SELECT * FROM revision WHERE line_id = %(line_id)s AND number = 1"),
            "closed": rows("SELECT kind, element_id FROM element_version WHERE line_id = %(line_id)s AND rev_to = 1"),
            "versions": rows(
                "SELECT kind, element_id, attributes, ST_AsBinary(geom) AS geom, ST_AsBinary(merc) AS merc, sha256"
                " FROM element_version WHERE line_id = %(line_id)s AND rev_from = 1"
            ),
            "changes": rows("SELECT * FROM atomic_change WHERE line_id = %(line_id)s AND revision = 1"),
        }
        self._bare.rollback()
        for name in ("updates", "attributes"):
            for row in (*found["revision"], *found["versions"]):
                if name in row:
                    row[name] = Jsonb(row[name], dumps=orjson.dumps)
        return found

    def _write(self, line_id: int, rows: dict[str, list[dict[str, Any]]]) -> None:
        place = {"line_id": line_id, "number": 1}
        with self._bare.transaction(), self._bare.cursor() as cursor:
            cursor.execute(HEAD, place)
            cursor.execute(REVISION, {**rows["revision"][0], **place})
            for statement, name in ((CLOSE, "closed"), (VERSION, "versions"), (CHANGE, "changes")):
                cursor.executemany(statement, [{**row, **place} for row in rows[name]])


def _log_folder(folder: Path) -> Path:
    """A real log where there is one, else one of the demo's."""
    real = sorted(path for path in _SHARED_LOGS.glob("*") if (path / "map").is_dir()) if _SHARED_LOGS.is_dir() else []
    return real[0] if real else generate(7, folder / "demo", 1)[0].folder
