"""New element ids: handed out in blocks, above everything the map names, never twice."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence

from sqlalchemy.orm import Session

from lanewright.core.elements import Element, ElementKey, ElementKind, MapState
from lanewright.core.errors import Conflict, InvalidInput, Place
from lanewright.db.models import Task
from lanewright.db.repositories import elements, id_blocks
from lanewright.services.access import own_task, require_editable
from lanewright.services.actor import Actor

BLOCK = 100
LARGEST_NEW_ID = 2**31 - 1
"""Consumers of AV2 maps store ids as 32-bit integers."""
_PLENTY = 10_000_000


def free_range(used: Iterable[int]) -> tuple[int, int]:
    """The first and last of the new ids that a map has room for.

    All ids above the map's own, as long as these are many; in a map that already names ids near 2^31, the widest run
    between two of them.
    """
    taken = sorted({0, *(i for i in used if i <= LARGEST_NEW_ID)})
    if taken[-1] <= LARGEST_NEW_ID - _PLENTY:
        return taken[-1] + 1, LARGEST_NEW_ID
    widest = max(itertools.pairwise([*taken, LARGEST_NEW_ID + 1]), key=lambda pair: pair[1] - pair[0])
    return widest[0] + 1, widest[1] - 1


def named_ids(state: MapState) -> set[int]:
    """Every id that a map names, of elements in it and beyond its rim."""
    named = {element.id for element in state}
    for lane in state.lanes.values():
        named.update(lane.successors, lane.predecessors)
        named.update(i for i in (lane.left_neighbor_id, lane.right_neighbor_id) if i is not None)
    return named


def take_block(session: Session, actor: Actor, task_id: int) -> tuple[int, int]:
    """First and last id of a block for this actor in this task.

    Raises:
        NotFound, Forbidden, Conflict: the actor may not edit the task now, or its log has no ids left.
    """
    task = own_task(session, actor, task_id)
    require_editable(task)
    ids = reserve(session, task, actor.id, BLOCK)
    return ids[0], ids[-1]


def reserve(session: Session, task: Task, account_id: int, count: int) -> range:
    """So many new ids in a row for an account in a task.

    Raises:
        Conflict: ``ids.exhausted``, the log has no ids left.
    """
    first = id_blocks.advance(session, task.log_id, count)
    if first is None:
        raise Conflict(
            f"Log {task.log.log_id} has no new element ids left below 2^31.",
            mend="Import the log again under a renumbered map.",
            code="ids.exhausted",
        )
    ids = range(first, first + count)
    id_blocks.insert_block(
        session, log_id=task.log_id, task_id=task.id, account_id=account_id, first_id=ids[0], last_id=ids[-1]
    )
    return ids


def check_new_ids(
    session: Session, task: Task, account_id: int, *, new: Iterable[Element], base: MapState, head: MapState
) -> dict[ElementKey, Element]:
    """Whether elements that a save brings in may carry their ids; returns what had these ids before and was deleted.

    They may when the id is a fresh one of this account's blocks, or was that of an element on this line or in the base
    (the rules judge whether it still stands for the same).

    Raises:
        InvalidInput: names the element and the mend.
    """
    fresh = [element for element in new if element.key not in base]
    if not fresh:
        return {}
    namesakes = [ElementKey(kind, element.id) for element in fresh for kind in ElementKind]
    past = {key: versions[-1] for key, versions in elements.load_versions(session, task.line_id, namesakes).items()}
    _require_one_element_each(fresh, head)
    known = {key.id for key in past}
    unknown = [element for element in fresh if element.id not in known]
    outside = set(id_blocks.outside_blocks(session, task.id, account_id, [element.id for element in unknown]))
    for element in unknown:
        if element.id in outside:
            raise InvalidInput(
                "is not an id that was handed to you for this task",
                "Take a block of ids (POST …/id-blocks) and insert the element under one of them.",
                Place(element=_name(element), key="id"),
                code="ids.not_reserved",
            )
    return {key: element for key, element in past.items() if key not in head}


def _require_one_element_each(fresh: Sequence[Element], head: MapState) -> None:
    """No new lane has the id of a crossing, nor the other way round."""
    seen: set[int] = set()
    for element in fresh:
        if element.id in seen or any(ElementKey(kind, element.id) in head for kind in ElementKind):
            raise InvalidInput(
                "has the id of another element",
                "Insert the element under an id of its own from the block.",
                Place(element=_name(element), key="id"),
                code="ids.taken",
            )
        seen.add(element.id)


def _name(element: Element) -> str:
    return f"{element.key.kind.value} {element.id}"
