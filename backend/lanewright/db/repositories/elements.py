"""Element versions: a line's map at any revision, and the one way in which new versions come to be."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy import (
    ARRAY,
    BigInteger,
    ColumnElement,
    Integer,
    LargeBinary,
    Text,
    and_,
    bindparam,
    func,
    insert,
    literal,
    select,
    tuple_,
    update,
)
from sqlalchemy.dialects.postgresql import JSONB
from sqlalchemy.orm import Session

from lanewright.core.elements import Element, ElementKey, ElementKind, MapState
from lanewright.core.errors import Conflict
from lanewright.db.mapping import ElementRow, from_rows
from lanewright.db.models import LIVE, ElementVersion

_GEOM = func.ST_AsBinary(ElementVersion.geom, type_=LargeBinary)
_COLUMNS = (
    ElementVersion.kind,
    ElementVersion.element_id,
    ElementVersion.attributes,
    _GEOM,
    ElementVersion.rev_from,
    ElementVersion.sha256,
)
_Version = tuple[str, int, dict[str, Any], bytes, int, bytes]
"""A row of ``_COLUMNS``."""
_INSERT = insert(ElementVersion).values(
    line_id=bindparam("line_id", type_=BigInteger),
    kind=bindparam("kind", type_=Text),
    element_id=bindparam("element_id", type_=BigInteger),
    rev_from=bindparam("rev_from", type_=Integer),
    attributes=bindparam("attributes", type_=JSONB),
    geom=func.ST_GeomFromWKB(bindparam("geom", type_=LargeBinary), 0),
    merc=func.ST_GeomFromWKB(bindparam("merc", type_=LargeBinary), 3857),
    sha256=bindparam("sha256", type_=LargeBinary),
)


@dataclass(frozen=True, slots=True)
class StoredMap:
    """Elements as they stand on a line. ``versions``: the revision that wrote each; ``hashes``: its content's SHA-256.

    ``state`` lists them by kind and id.
    """

    state: MapState
    versions: Mapping[ElementKey, int]
    hashes: Mapping[ElementKey, bytes]


@dataclass(frozen=True, slots=True)
class Departure:
    """How a revision departs from revision 0 of its line: elements written since, and elements gone."""

    written: StoredMap
    removed: tuple[ElementKey, ...]

    def applied_to(self, base: StoredMap) -> StoredMap:
        """The whole map at that revision."""
        if not self.written.versions and not self.removed:
            return base
        state = base.state.replaced(self.written.state, self.removed)
        if any(list(ids) != sorted(ids) for ids in (state.lanes, state.crossings)):  # new ids that are not the largest
            state = MapState.of(sorted(state, key=lambda element: element.key))
        versions = {**base.versions, **self.written.versions}
        hashes = {**base.hashes, **self.written.hashes}
        return StoredMap(
            state, {key: versions[key] for key in _keys(state)}, {key: hashes[key] for key in _keys(state)}
        )


@dataclass(frozen=True, slots=True)
class VersionSpan:
    """A version of an element, live on ``rev_from`` <= revision < ``rev_to``; ``sha256`` as stored."""

    element: Element
    rev_from: int
    rev_to: int
    sha256: bytes


def load(session: Session, line_id: int, revision: int) -> StoredMap:
    """The whole map of a line at a revision."""
    return _stored(_select(session, ElementVersion.line_id == line_id, *_at(revision)))


def load_departure(session: Session, line_id: int, revision: int) -> Departure:
    """What differs from revision 0 at a revision; reads only what was written since."""
    if revision == 0:
        return Departure(_stored([]), ())
    own = ElementVersion.line_id == line_id
    written = _stored(_select(session, own, ElementVersion.rev_from > 0, *_at(revision)))
    closed = session.execute(
        select(ElementVersion.kind, ElementVersion.element_id).where(
            own,
            ElementVersion.rev_from == 0,
            ElementVersion.rev_to <= revision,
            ElementVersion.rev_to < literal(LIVE, literal_execute=True),  # as the partial index is defined
        )
    )
    keys = {ElementKey(ElementKind(kind), identity) for kind, identity in closed}
    return Departure(written, tuple(sorted(keys - written.versions.keys())))


def load_versions(session: Session, line_id: int, keys: Iterable[ElementKey]) -> dict[ElementKey, list[Element]]:
    """Every version that elements ever had on a line, oldest first."""
    wanted = [(key.kind.value, key.id) for key in keys]
    if not wanted:
        return {}
    found: dict[ElementKey, list[Element]] = {}
    identity = tuple_(ElementVersion.kind, ElementVersion.element_id)
    rows = _select(session, ElementVersion.line_id == line_id, identity.in_(wanted))
    for element in from_rows([(row[0], row[1], row[2], row[3]) for row in rows]):
        found.setdefault(element.key, []).append(element)
    return found


def load_spans(session: Session, line_id: int) -> list[VersionSpan]:
    """Every version on a line with its span of revisions, by kind, id and first revision."""
    order = (ElementVersion.kind, ElementVersion.element_id, ElementVersion.rev_from)
    rows = session.execute(
        select(*_COLUMNS, ElementVersion.rev_to).where(ElementVersion.line_id == line_id).order_by(*order)
    ).all()
    elements = from_rows([(row[0], row[1], row[2], row[3]) for row in rows])
    return [VersionSpan(element, row[4], row[6], bytes(row[5])) for element, row in zip(elements, rows, strict=True)]


def insert_versions(session: Session, line_id: int, revision: int, rows: Sequence[ElementRow]) -> None:
    """New versions, live from ``revision`` on. The database refuses a second live version of an element."""
    if rows:
        session.execute(_INSERT, [_values(row, line_id, revision) for row in rows])


def close_versions(session: Session, line_id: int, revision: int, versions: Mapping[ElementKey, int]) -> None:
    """Ends live versions (key -> the revision that wrote it): ``revision`` does not hold them any more.

    Raises:
        Conflict: one of them is not the live version any more; nothing may then be committed.
    """
    if not versions:
        return
    ends = (
        func.unnest(
            bindparam("kinds", [key.kind.value for key in versions], type_=ARRAY(Text)),
            bindparam("ids", [key.id for key in versions], type_=ARRAY(BigInteger)),
            bindparam("revisions", list(versions.values()), type_=ARRAY(Integer)),
        )
        .table_valued("kind", "element_id", "rev_from")
        .render_derived()
    )
    closed = session.execute(
        update(ElementVersion)
        .where(
            ElementVersion.line_id == line_id,
            ElementVersion.rev_to == literal(LIVE, literal_execute=True),
            ElementVersion.kind == ends.c.kind,
            ElementVersion.element_id == ends.c.element_id,
            ElementVersion.rev_from == ends.c.rev_from,
        )
        .values(rev_to=revision)
        .execution_options(synchronize_session=False)
    )
    if _rowcount(closed) != len(versions):
        raise Conflict(
            "The task changed while it was being saved.",
            mend="Save again.",
            code="save.collision",
            expected=len(versions),
            found=_rowcount(closed),
        )


def copy_live(session: Session, source_line_id: int, target_line_id: int) -> None:
    """Copies the live versions of one line onto another, as its revision 0."""
    version = ElementVersion
    copied = ("kind", "element_id", "attributes", "geom", "merc", "sha256")
    columns = [getattr(version.__table__.c, name) for name in copied]
    rows = select(literal(target_line_id, BigInteger), literal(0, Integer), *columns).where(
        version.line_id == source_line_id, version.rev_to == literal(LIVE, literal_execute=True)
    )
    session.execute(insert(version).from_select(["line_id", "rev_from", *copied], rows))


def _at(revision: int) -> tuple[ColumnElement[bool], ...]:
    return (and_(ElementVersion.rev_from <= revision, ElementVersion.rev_to > revision),)


def _select(session: Session, *conditions: ColumnElement[bool]) -> Sequence[_Version]:
    order = (ElementVersion.kind, ElementVersion.element_id, ElementVersion.rev_from)
    rows: Sequence[Any] = session.execute(select(*_COLUMNS).where(*conditions).order_by(*order)).all()
    return rows


def _stored(rows: Sequence[_Version]) -> StoredMap:
    elements = from_rows([(row[0], row[1], row[2], row[3]) for row in rows])
    keyed = list(zip((element.key for element in elements), rows, strict=True))
    return StoredMap(
        MapState.of(elements), {key: row[4] for key, row in keyed}, {key: bytes(row[5]) for key, row in keyed}
    )


def _keys(state: MapState) -> list[ElementKey]:
    return [element.key for element in state]


def _values(row: ElementRow, line_id: int, revision: int) -> dict[str, Any]:
    return {
        "line_id": line_id,
        "kind": row.kind,
        "element_id": row.element_id,
        "rev_from": revision,
        "attributes": row.attributes,
        "geom": row.geom,
        "merc": row.merc,
        "sha256": row.sha256,
    }


def _rowcount(result: Any) -> int:
    return int(result.rowcount)
