"""Which element of the edited map is which of the base: a working state for the canonical form.

Elements of the edited map go by *tokens*: ids above all that are in use, given in order of position, so that nothing
depends on the ids the edited map happens to have.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Sequence
from typing import Any

from lanewright.core.alignment import Alignment
from lanewright.core.comparison import Comparison, crossing_key, lane_key
from lanewright.core.cuts import marked_as_parts
from lanewright.core.elements import ElementKey, LaneSegment, Line, MapState, PedestrianCrossing
from lanewright.core.identity import fresh_id, renamed, with_lanes_exchanged
from lanewright.core.matching import same_crossings, same_lanes


class Assignment:
    """Matches of lanes and crossings, and the edited map (under tokens) that they are about.

    Attributes:
        base: the base map.
        edited: the edited map under tokens; re-cut as matches of whole runs ask for it.
        lanes, crossings: token -> base id, for what is matched.
        own_lane_ids, own_crossing_ids: token -> id in the edited map as it came.
        banned: pairs of token and base id that the rules forbid.
    """

    def __init__(self, base: MapState, edited: MapState, own_lanes: dict[int, int], own_crossings: dict[int, int]):
        self.base = base
        self.edited = edited
        self.own_lane_ids = own_lanes
        self.own_crossing_ids = own_crossings
        self.lanes: dict[int, int] = {}
        self.crossings: dict[int, int] = {}
        self.banned: set[tuple[int, int]] = set()
        self.parts: dict[int, int] = {}
        self._next = max([*own_lanes, *own_crossings], default=0) + 1

    @classmethod
    def start(cls, base: MapState, edited: MapState, scope: Collection[ElementKey] | None) -> Assignment:
        """Everything outside the scope matched by its id, what has the same lines matched by those."""
        first = fresh_id((base, edited))
        order = sorted(edited.lanes.values(), key=_position)
        own_lanes = {first + index: lane.id for index, lane in enumerate(order)}
        first += len(order)
        crossings = sorted(edited.crossings.values(), key=_crossing_position)
        own_crossings = {first + index: crossing.id for index, crossing in enumerate(crossings)}
        tokens = renamed(
            edited,
            {own: token for token, own in own_lanes.items()},
            {own: token for token, own in own_crossings.items()},
        )
        assignment = cls(base, tokens, own_lanes, own_crossings)
        if scope is not None:
            assignment.lanes = {
                token: own for token, own in own_lanes.items() if own in base.lanes and lane_key(own) not in scope
            }
            assignment.crossings = {
                token: own
                for token, own in own_crossings.items()
                if own in base.crossings and crossing_key(own) not in scope
            }
        assignment.lanes |= same_lanes(*assignment.unmatched_lanes())
        assignment.crossings |= same_crossings(*assignment.unmatched_crossings())
        return assignment

    def unmatched_lanes(self) -> tuple[dict[int, LaneSegment], dict[int, LaneSegment]]:
        """Base lanes and edited lanes that have no counterpart yet."""
        known = set(self.lanes.values())
        return (
            {key: lane for key, lane in self.base.lanes.items() if key not in known},
            {key: lane for key, lane in self.edited.lanes.items() if key not in self.lanes},
        )

    def unmatched_crossings(self) -> tuple[dict[int, PedestrianCrossing], dict[int, PedestrianCrossing]]:
        """Base crossings and edited crossings that have no counterpart yet."""
        known = set(self.crossings.values())
        return (
            {key: crossing for key, crossing in self.base.crossings.items() if key not in known},
            {key: crossing for key, crossing in self.edited.crossings.items() if key not in self.crossings},
        )

    def comparison(self) -> Comparison:
        """Base and edited map under the present matches; what is unmatched goes by its token."""
        named = renamed(self.edited, self.lanes, self.crossings)
        return Comparison(self.base, self.with_parts_named(named, {}))

    def with_parts_named(self, state: MapState, ids: dict[int, int]) -> MapState:
        """The state with cuts recorded on the parts; ``ids`` are the tokens' names there."""
        for token, whole in self.parts.items():
            state = marked_as_parts(state, [ids.get(token, token)], whole)
        return state

    @property
    def tokens(self) -> dict[int, int]:
        """Base id -> token, for matched lanes."""
        return {matched: token for token, matched in self.lanes.items()}

    def match_run(self, deleted: Sequence[int], inserted: Sequence[int], alignment: Alignment) -> None:
        """Let a run of the edited map be the base lanes it is aligned with, re-cut if the alignment says so."""
        if not alignment.recut:
            for token, piece in zip(inserted, alignment.pieces, strict=True):
                self.lanes[token] = piece.base
            return
        pieces = []
        for index, piece in enumerate(alignment.pieces):
            token = inserted[index] if index < len(inserted) else self._fresh_token()
            pieces.append(_under(piece.lane, token))
            if piece.is_part:
                self.parts[token] = piece.base
            else:
                self.lanes[token] = piece.base
        self.edited = with_lanes_exchanged(self.edited, inserted, pieces)

    def _fresh_token(self) -> int:
        self._next += 1
        return self._next - 1


def _under(lane: LaneSegment, token: int) -> LaneSegment:
    return dataclasses.replace(lane, id=token, part_of=None)


def _position(lane: LaneSegment) -> tuple[Any, ...]:
    """What is seen of a lane, as an order: its lines, then its properties."""
    return (
        _plan(lane.left_boundary),
        _plan(lane.right_boundary),
        lane.lane_type.value,
        lane.left_mark.value,
        lane.right_mark.value,
        lane.is_intersection,
    )


def _crossing_position(crossing: PedestrianCrossing) -> tuple[Any, ...]:
    return tuple(sorted(min(_plan(edge), _plan(edge[::-1])) for edge in (crossing.edge1, crossing.edge2)))


def _plan(line: Line) -> tuple[tuple[float, ...], ...]:
    return tuple(point[:2] for point in line)
