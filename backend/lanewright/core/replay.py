"""Applying a diff with its values (spec §6.1): what it was derived from comes back, up to the normal form of §2."""

from __future__ import annotations

from lanewright.core.changes import AtomicChange, MapDiff
from lanewright.core.edits import Edit, Operation, apply_edits
from lanewright.core.elements import MapState


def replayed(base: MapState, changes: MapDiff) -> MapState:
    """The base with every change applied; ``replayed(edited, invert(changes))`` goes back.

    Links between survivors and what came or went are those of the inserted element; a survivor may still name a
    deleted lane, which then is an id outside the map.

    Raises:
        InvalidInput: the changes are not about this map.
    """
    return apply_edits(base, [_edit(change) for change in changes.changes])


def _edit(change: AtomicChange) -> Edit:
    if change.new is None:
        return Edit(Operation.DELETE, change.kind, change.id)
    operation = Operation.INSERT if change.old is None else Operation.UPDATE
    return Edit(operation, change.kind, change.id, change.new)
