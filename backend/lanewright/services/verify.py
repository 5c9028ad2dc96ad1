"""Recomputes what is derived (hashes, atomic changes, structural updates) and says where the store says otherwise."""

from __future__ import annotations

import hashlib
import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import orjson
from sqlalchemy import select
from sqlalchemy.orm import Session

from lanewright.core.diff import diff
from lanewright.core.elements import MapState
from lanewright.core.errors import LanewrightError, NotFound
from lanewright.core.report import diff_document
from lanewright.db.mapping import element_sha256, map_sha256
from lanewright.db.models import LIVE, Line, Log, LogAsset, Task
from lanewright.db.repositories import changes, elements, revisions
from lanewright.db.repositories.elements import VersionSpan
from lanewright.formats.av2_map import parse_map


@dataclass(frozen=True, slots=True)
class Difference:
    """One place where the store does not say what follows from the rest of it."""

    where: str
    what: str

    def __str__(self) -> str:
        return f"{self.where}: {self.what}"


@dataclass(frozen=True, slots=True)
class Subject:
    """A line of revisions to look at, named as people know it; ``log``: whose base line it is."""

    name: str
    line: Line
    log: Log | None


def subjects(session: Session, task_id: int | None = None) -> Iterator[Subject]:
    """The base lines of all logs and the lines of all tasks, or the line of one task.

    Raises:
        NotFound: there is no such task.
    """
    if task_id is not None:
        task = session.get(Task, task_id)
        if task is None:
            raise NotFound(f"There is no task {task_id}.", mend="Name one of the tasks.", code="task.not_found")
        yield Subject(f"task {task_id}", task.line, None)
        return
    for log in session.scalars(select(Log).order_by(Log.log_id)):
        yield Subject(f"log {log.log_id}", session.get_one(Line, log.line_id), log)
    for task in session.scalars(select(Task).order_by(Task.id)):
        yield Subject(f"task {task.id}", task.line, None)


def verify(session: Session, subject: Subject) -> list[Difference]:
    """Everything that differs on one line."""
    spans = elements.load_spans(session, subject.line.id)
    found = [Difference(subject.name, what) for what in (*_broken_hashes(spans), *_broken_spans(spans, subject.line))]
    if subject.log is not None:
        found += _log_differences(session, subject.name, subject.log, spans)
    return found + list(_revision_differences(session, subject, spans))


def _broken_hashes(spans: Sequence[VersionSpan]) -> Iterator[str]:
    for span in spans:
        if element_sha256(span.element) != span.sha256:
            yield f"{_name(span)} of revision {span.rev_from} has another content than its hash says"


def _broken_spans(spans: Sequence[VersionSpan], line: Line) -> Iterator[str]:
    for span in spans:
        if not 0 <= span.rev_from <= line.head or not (span.rev_to <= line.head or span.rev_to == LIVE):
            yield f"{_name(span)} lives on revisions {span.rev_from} to {span.rev_to}, but the head is {line.head}"
    for one, other in itertools.pairwise(spans):
        if one.element.key == other.element.key and one.rev_to > other.rev_from:
            yield f"{_name(one)} has two versions at revision {other.rev_from}"


def _revision_differences(session: Session, subject: Subject, spans: Sequence[VersionSpan]) -> Iterator[Difference]:
    derived = revisions.load_derived(session, subject.line.id)
    numbers = [revision.number for revision in derived]
    if numbers != list(range(subject.line.head + 1)):
        yield Difference(subject.name, f"the revisions are {numbers}, but the head is {subject.line.head}")
    base = _state(spans, 0)
    for revision in derived:
        where = f"{subject.name}, revision {revision.number}"
        live = [span for span in spans if span.rev_from <= revision.number < span.rev_to]
        hashes = ((span.element.key, element_sha256(span.element)) for span in live)
        if map_sha256(hashes) != revision.content_sha256:
            yield Difference(where, "the map has another content than the revision's hash says")
        derivation = diff(base, _state(spans, revision.number))
        stored = changes.load_changes(session, subject.line.id, revision.number)
        expected = changes.rows_of(derivation.changes)
        for row in sorted(set(expected) - set(stored)):
            yield Difference(where, f"the {row.category} of {row.kind} {row.element_id} is not stored as derived")
        for row in sorted(set(stored) - set(expected)):
            yield Difference(where, f"the stored {row.category} of {row.kind} {row.element_id} does not follow")
        if _as_json(diff_document(derivation)["updates"]) != _as_json(revision.updates):
            yield Difference(where, "the structural updates are not stored as derived")


def _log_differences(session: Session, name: str, log: Log, spans: Sequence[VersionSpan]) -> Iterator[Difference]:
    if hashlib.sha256(log.map_document).digest() != log.map_sha256:
        yield Difference(name, "the map file has another content than its hash says")
    try:
        if parse_map(log.map_document, log.map_file_name).state != _state(spans, 0):
            yield Difference(name, "the base map is not what the map file says")
    except LanewrightError as error:
        yield Difference(name, f"the map file cannot be read any more: {error}")
    for asset in session.scalars(select(LogAsset).where(LogAsset.log_id == log.id).order_by(LogAsset.name)):
        if hashlib.sha256(asset.body).digest() != asset.sha256:
            yield Difference(name, f"{asset.name} has another content than its hash says")


def _state(spans: Sequence[VersionSpan], revision: int) -> MapState:
    return MapState.of(span.element for span in spans if span.rev_from <= revision < span.rev_to)


def _as_json(value: object) -> bytes:
    return orjson.dumps(value, option=orjson.OPT_SORT_KEYS)


def _name(span: VersionSpan) -> str:
    return f"{span.element.key.kind.value} {span.element.key.id}"
