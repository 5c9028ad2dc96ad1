"""The canonical form of a draft (change mapping §5, §6): told as edits, or applied by a save, which says so."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy.orm import Session

from lanewright.core.canonical import Canonical, canonical_map, canonical_updates, lengthening_updates
from lanewright.core.claims import DeclaredMacros
from lanewright.core.comparison import Comparison
from lanewright.core.edits import Edit, edits_between
from lanewright.core.elements import ElementKey, ElementKind, MapState
from lanewright.core.errors import Conflict
from lanewright.core.identity import renamed
from lanewright.core.macros import update_groups
from lanewright.core.report import edit_document
from lanewright.core.restore import restore
from lanewright.core.rules import identity_not_canonical
from lanewright.core.rules.link_one_sided import with_links_completed
from lanewright.core.violations import Violation
from lanewright.db.models import Task
from lanewright.services import declarations, id_blocks
from lanewright.services.access import readable_task
from lanewright.services.actor import Actor
from lanewright.services.evaluation import Evaluation, evaluate
from lanewright.services.findings import Findings, violation_documents

Renames = Mapping[ElementKey, int]
"""Elements of the draft -> their ids in the canonical form, where these differ."""


@dataclass(frozen=True, slots=True)
class Retold:
    """How a save told its updates otherwise than they were drawn.

    Attributes:
        joined: lanes that became part of the one before or after them in series.
        cut: lanes of the base and drawn ones that are cut.
    """

    renamed: Renames
    joined: tuple[int, ...]
    cut: tuple[int, ...]


AS_DRAWN = Retold({}, (), ())


def proposal(
    session: Session,
    actor: Actor,
    task_id: int,
    *,
    base_revision: int,
    edits: Sequence[Edit],
    declared: Sequence[DeclaredMacros] | None = None,
) -> dict[str, Any]:
    """What takes the draft to its canonical form, as the JSON of ``CanonicalOut``; nothing is written.

    New elements have ids that nobody has reserved, as in fixes: whoever applies them gives them ids of their own.

    Raises:
        NotFound, InvalidInput, Conflict: as ``saving.check``.
    """
    task = readable_task(session, actor, task_id)
    evaluation = evaluate(session, task, actor.id, base_revision, edits, declared)
    comparison = evaluation.findings.comparison
    form = canonical_map(comparison)
    return {
        "edits": [edit_document(edit) for edit in edits_between(evaluation.edited, _completed(comparison, form))],
        "renamed": rename_documents(form.renamed),
        "joined": list(form.joined),
        "cut": list(form.cut),
    }


def settled(session: Session, task: Task, account_id: int, evaluation: Evaluation) -> tuple[Evaluation, Retold]:
    """The evaluation of what a save stores: updates that a note calls not canonical, and those in which a lane only
    makes another one longer (unless macros are declared of it), in their canonical form.

    Raises:
        Conflict: ``save.violations``, with the notes, whose fixes lead to it, when that form breaks a rule (a
            declaration of macros that only fits the ids as drawn).
    """
    notes = [one for one in evaluation.findings.violations if one.code == identity_not_canonical.CODE]
    comparison = evaluation.findings.comparison
    named = {key for declaration in evaluation.declared for key in declaration.elements}
    longer = [update for update in lengthening_updates(comparison) if named.isdisjoint(update)]
    updates = dict.fromkeys((*_updates_of(comparison, notes), *longer))
    if not updates:
        return evaluation, AS_DRAWN
    form = canonical_updates(comparison, updates)
    state, renames = _with_legal_ids(session, task, account_id, evaluation, form, _completed(comparison, form))
    state = restore(evaluation.base.state, state)
    declared = declarations.renamed(evaluation.declared, renames)
    claims = dataclasses.replace(comparison.claims, declared=declared)
    findings = Findings(evaluation.base.state, state, task.direction, claims)
    canonical = dataclasses.replace(evaluation, edited=state, declared=declared, findings=findings)
    introduced = canonical.introduced()
    if introduced:
        raise Conflict(
            f"The save would tell this update in its canonical form, and that breaks a rule: {introduced[0].message}",
            mend="Make the update canonical first; then the check shows what is wrong, with its fix.",
            code="save.violations",
            violations=violation_documents(notes),
        )
    return canonical, Retold(renames, form.joined, form.cut)


def rename_documents(renames: Renames) -> list[dict[str, Any]]:
    """As the API's JSON, sorted."""
    return [{"kind": key.kind.value, "from": key.id, "to": new} for key, new in sorted(renames.items())]


def _completed(comparison: Comparison, form: Canonical) -> MapState:
    return with_links_completed(comparison.base, form.edited)


def _updates_of(comparison: Comparison, notes: Sequence[Violation]) -> list[tuple[ElementKey, ...]]:
    """The updates that the notes are about."""
    told = {ElementKey(note.kind, element) for note in notes for element in note.elements}
    return [group for group in update_groups(comparison) if not told.isdisjoint(group)]


def _with_legal_ids(
    session: Session, task: Task, account_id: int, evaluation: Evaluation, form: Canonical, state: MapState
) -> tuple[MapState, Renames]:
    """The state and the renames with new ids from the account's own: an id that the draft itself brought in may pass
    from one new element to another, every other needs a fresh one."""
    taken_over = {ElementKey(key.kind, new) for key, new in form.renamed.items()}
    head, drafted = evaluation.head.state, evaluation.edited
    homeless = [
        element.key
        for element in state
        if element.key not in evaluation.base.state
        and (element.key not in drafted or (element.key in taken_over and element.key in head))
    ]
    if not homeless:
        return state, form.renamed
    ids = dict(zip(homeless, id_blocks.reserve(session, task, account_id, len(homeless)), strict=True))
    lanes, crossings = ({key.id: new for key, new in ids.items() if key.kind is kind} for kind in ElementKind)
    renames = {key: ids.get(ElementKey(key.kind, new), new) for key, new in form.renamed.items()}
    return renamed(state, lanes, crossings), {key: new for key, new in renames.items() if new != key.id}
