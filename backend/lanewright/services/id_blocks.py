"""New element ids: handed out in blocks, above everything the map names, never twice."""

from __future__ import annotations

import itertools
from collections.abc import Iterable

import shapely
from sqlalchemy.orm import Session

from lanewright.core.comparison import COINCIDENT_M
from lanewright.core.elements import Element, ElementKey, ElementKind, LaneSegment, MapState
from lanewright.core.errors import Conflict, InvalidInput, Place
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
    first = id_blocks.advance(session, task.log_id, BLOCK)
    if first is None:
        raise Conflict(
            f"Log {task.log.log_id} has no new element ids left below 2^31.",
            mend="Import the log again under a renumbered map.",
            code="ids.exhausted",
        )
    last = first + BLOCK - 1
    id_blocks.insert_block(
        session, log_id=task.log_id, task_id=task.id, account_id=actor.id, first_id=first, last_id=last
    )
    return first, last


def check_new_ids(
    session: Session, *, task_id: int, line_id: int, account_id: int, new: list[Element], base: MapState
) -> None:
    """Whether elements that a save brings in may carry their ids.

    They may when the id stood for this element before on this line (somebody takes a deletion back), when the base has
    it (the rules judge what became of it), or when it is a fresh one of this account's blocks.

    Raises:
        InvalidInput: names the element and the mend.
    """
    fresh = [element for element in new if element.key not in base]
    if not fresh:
        return
    namesakes = [ElementKey(kind, element.id) for element in fresh for kind in ElementKind]
    past = elements.load_versions(session, line_id, namesakes)
    past_ids = {key.id for key in past}
    seen: set[int] = set()
    unknown: list[Element] = []
    for element in fresh:
        if element.id in seen or (
            element.id in past_ids and not any(_stands_for(element, one) for one in past.get(element.key, []))
        ):
            raise InvalidInput(
                "is an id that was used before in this task for something else",
                "Insert the element under an id of its own from the block.",
                Place(element=_name(element), key="id"),
                code="identity.reused",
            )
        seen.add(element.id)
        if element.id not in past_ids:
            unknown.append(element)
    outside = set(id_blocks.outside_blocks(session, task_id, account_id, [element.id for element in unknown]))
    for element in unknown:
        if element.id in outside:
            raise InvalidInput(
                "is not an id that was handed to you for this task",
                "Take a block of ids (POST …/id-blocks) and insert the element under one of them.",
                Place(element=_name(element), key="id"),
                code="ids.not_reserved",
            )


def _stands_for(one: Element, other: Element) -> bool:
    """Whether both are one thing, perhaps edited since: lines of one kind at one place."""
    return one.key == other.key and shapely.hausdorff_distance(_shape(one), _shape(other)) <= COINCIDENT_M


def _shape(element: Element) -> shapely.MultiLineString:
    lines = (
        (element.left_boundary, element.right_boundary)
        if isinstance(element, LaneSegment)
        else (element.edge1, element.edge2)
    )
    return shapely.MultiLineString([[point[:2] for point in line] for line in lines])


def _name(element: Element) -> str:
    return f"{element.key.kind.value} {element.id}"
