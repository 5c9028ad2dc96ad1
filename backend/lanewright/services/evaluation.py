"""One save up to the point of writing: what the edits lead to, and what the engine says of it. The check ends here."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy.orm import Session

from lanewright.core.attributes import element_attributes
from lanewright.core.claims import Claims, DeclaredMacros
from lanewright.core.edits import Edit, apply_edits
from lanewright.core.elements import Element, ElementKey, MapState, levelled
from lanewright.core.elevation import Ground, fill_elevation
from lanewright.core.errors import Conflict, InvalidInput, Place
from lanewright.core.restore import restore
from lanewright.core.rules import check
from lanewright.core.violations import Violation
from lanewright.db.models import Task
from lanewright.db.repositories.elements import StoredMap
from lanewright.services import declarations, line_maps
from lanewright.services.declarations import Declared
from lanewright.services.findings import Findings
from lanewright.services.ground import ground_of
from lanewright.services.id_blocks import check_new_ids


@dataclass(frozen=True, slots=True)
class Evaluation:
    """Edits applied to the head of a task.

    Attributes:
        base: the map as imported.
        seen: the map that the editor had before them, at their base revision.
        head: the map that they now meet.
        edited: the map that a save would store: heights filled in, sub-tolerance edits taken back.
        restored: edited elements that went back to the base's exact coordinates.
        head_declared, declared: the macros declared at the head, and those that a save would store.
    """

    base: StoredMap
    seen: StoredMap
    head: StoredMap
    edited: MapState
    restored: tuple[ElementKey, ...]
    head_declared: Declared
    declared: Declared
    findings: Findings

    def introduced(self) -> tuple[Violation, ...]:
        """The violations that stop a save: errors that neither the base nor the head has already."""
        blocking = tuple(violation for violation in self.findings.violations if violation.blocks)
        if not blocking or self.head is self.base:
            return blocking
        known = {violation.id for violation in check(self.base.state, self.head.state) if violation.blocks}
        return tuple(violation for violation in blocking if violation.id not in known)


def evaluate(
    session: Session,
    task: Task,
    account_id: int,
    base_revision: int,
    edits: Sequence[Edit],
    declared: Sequence[DeclaredMacros] | None,
) -> Evaluation:
    """What ``edits``, made on ``base_revision``, lead to at the head of the task.

    Edits of elements that nobody else changed since merge; the same edit made twice counts once. So do declarations:
    ``declared`` is all of them (None: those of the base revision).

    Raises:
        InvalidInput: an edit cannot be applied, names its element twice, brings in an id that is not the account's, or
            a part of what the base does not have.
        Conflict: ``save.stale``, with base, mine and theirs of every element that was changed by others meanwhile,
            and the declarations at the head.
    """
    head_revision = task.line.head
    if base_revision > head_revision:
        raise InvalidInput(
            f"is {base_revision}, but the task's newest revision is {head_revision}",
            "Reload the task.",
            Place(key="base_revision"),
        )
    _require_one_edit_each(edits)
    ground = ground_of(session, task.log_id)
    base = line_maps.base_map(session, task.line_id)
    head = line_maps.map_at(session, task.line_id, head_revision, head_revision)
    head_declared = declarations.declared_at(session, task.line_id, head_revision)
    _require_known_wholes(edits, base.state)
    seen, seen_declared = head, head_declared
    if base_revision != head_revision:
        seen = line_maps.map_at(session, task.line_id, base_revision, head_revision)
        conflicts = _contradicted(edits, seen.state, head.state, ground)
        if conflicts:
            raise _stale(head_revision, conflicts, head_declared)
        edits = [edit for edit in edits if seen.state.get(edit.key) == head.state.get(edit.key)]
        seen_declared = declarations.declared_at(session, task.line_id, base_revision)
    stated = seen_declared if declared is None else declarations.in_order(declared)
    if base_revision != head_revision:
        stated = declarations.merged(seen_declared, head_declared, stated)
    asked = fill_elevation(apply_edits(head.state, edits, drawn=True), ground)
    edited = restore(base.state, asked)
    new = [element for element in edited if element.key not in head.state]
    retired = check_new_ids(session, task, account_id, new=new, base=base.state, head=head.state)
    restored = tuple(sorted(edit.key for edit in edits if _went_back(edit.key, base.state, asked, edited)))
    findings = Findings(base.state, edited, task.direction, Claims(retired=retired, declared=stated))
    return Evaluation(base, seen, head, edited, restored, head_declared, stated, findings)


def _require_one_edit_each(edits: Sequence[Edit]) -> None:
    seen: set[ElementKey] = set()
    for index, edit in enumerate(edits):
        if edit.key in seen:
            raise InvalidInput(
                "is edited twice in one changeset",
                "Send one net edit per element.",
                Place(element=f"{edit.kind.value} {edit.id}", key=f"edits[{index}]"),
            )
        seen.add(edit.key)


def _require_known_wholes(edits: Sequence[Edit], base: MapState) -> None:
    """Parts are parts of what the base has, whole or cut already."""
    wholes = {edit.attributes.get("part_of") for edit in edits} - {None}
    if not wholes or wholes <= base.lanes.keys():
        return
    known = base.lanes.keys() | {lane.part_of for lane in base.lanes.values()}
    for index, edit in enumerate(edits):
        whole = edit.attributes.get("part_of")
        if whole is not None and whole not in known:
            raise InvalidInput(
                f"is {whole!r:.60}, but the base has no such lane",
                "Name the lane of the base that was cut, or leave part_of out.",
                Place(element=f"{edit.kind.value} {edit.id}", key=f"edits[{index}].attributes.part_of"),
            )


def _contradicted(edits: Sequence[Edit], seen: MapState, head: MapState, ground: Ground) -> list[dict[str, Any]]:
    """The edited elements that others made different meanwhile, as the facts of ``save.stale`` tell them."""
    mine = fill_elevation(apply_edits(seen, edits, drawn=True), ground)
    return [
        {
            "kind": key.kind,
            "id": key.id,
            "base": _attributes(seen.get(key)),
            "mine": _attributes(mine.get(key)),
            "theirs": _attributes(head.get(key)),
        }
        for key in (edit.key for edit in edits)
        if seen.get(key) != head.get(key) and not _agree(mine.get(key), head.get(key))
    ]


def _stale(head_revision: int, conflicts: list[dict[str, Any]], head_declared: Declared) -> Conflict:
    count = "1 element" if len(conflicts) == 1 else f"{len(conflicts)} elements"
    return Conflict(
        f"Somebody saved before you: {count} that you edited changed up to revision {head_revision}.",
        mend="Choose yours or theirs for each, then save again on the newest revision.",
        code="save.stale",
        head=head_revision,
        conflicts=conflicts,
        declarations=declarations.documents(head_declared),
    )


def _agree(mine: Element | None, theirs: Element | None) -> bool:
    """Whether two people did the same; heights do not count, for the server may have filled them in."""
    if mine is None or theirs is None:
        return mine is theirs
    return levelled(mine) == levelled(theirs)


def _attributes(element: Element | None) -> dict[str, Any] | None:
    return None if element is None else element_attributes(element)


def _went_back(key: ElementKey, base: MapState, asked: MapState, edited: MapState) -> bool:
    known = base.get(key)
    return known is not None and asked.get(key) != known and edited.get(key) == known
