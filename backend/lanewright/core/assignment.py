"""Which element of the edited map is which of the base: a working state for the canonical form.

Elements of the edited map go by *tokens*: ids above all that are in use, given in order of position, so that nothing
depends on the ids the edited map happens to have.
"""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Collection, Iterable, Sequence
from itertools import count
from typing import Any

from lanewright.core.alignment import Alignment
from lanewright.core.comparison import Comparison, crossing_key, lane_key
from lanewright.core.cuts import marked_as_parts
from lanewright.core.elements import ElementKey, ElementKind, LaneSegment, Line, MapState, PedestrianCrossing
from lanewright.core.geometry import lines_of
from lanewright.core.identity import renamed, with_lanes_exchanged
from lanewright.core.matching import same_crossings, same_lanes
from lanewright.core.series import Run
from lanewright.core.survey import largest_id_named


class Assignment:
    """Matches of lanes and crossings, and the edited map (under tokens) that they are about.

    Attributes:
        base: the base map.
        edited: the edited map under tokens; re-cut as matches of whole runs ask for it.
        lanes, crossings: token -> base id, for what is matched.
        own_lane_ids, own_crossing_ids: token -> id in the edited map as it came.
        scope: the elements (of either map) to be looked at anew; None: all.
        parts: token -> base lane that is cut, for the parts of it.
        banned: pairs of token and base id that the rules forbid.
    """

    def __init__(
        self,
        base: MapState,
        edited: MapState,
        own_lanes: dict[int, int],
        own_crossings: dict[int, int],
        first_free: int,
        scope: Collection[ElementKey] | None,
    ):
        self.base = base
        self.edited = edited
        self.own_lane_ids = own_lanes
        self.own_crossing_ids = own_crossings
        self.lanes: dict[int, int] = {}
        self.crossings: dict[int, int] = {}
        self.banned: set[tuple[int, int]] = set()
        self.parts: dict[int, int] = {}
        self.scope = scope
        self._next = first_free

    @classmethod
    def start(cls, base: MapState, edited: MapState, scope: Collection[ElementKey] | None) -> Assignment:
        """Everything outside the scope matched by its id, what has the same lines matched by those."""
        lanes: Iterable[LaneSegment] = edited.lanes.values()
        crossings: Iterable[PedestrianCrossing] = edited.crossings.values()
        if scope is not None:
            inside = [element for element in map(edited.get, scope) if element is not None]
            lanes = [element for element in inside if isinstance(element, LaneSegment)]
            crossings = [element for element in inside if isinstance(element, PedestrianCrossing)]
        tokens = count(1 + largest_id_named(base, edited))
        own_lanes = {next(tokens): lane.id for lane in sorted(lanes, key=_position)}
        own_crossings = {next(tokens): crossing.id for crossing in sorted(crossings, key=_crossing_position)}
        lane_tokens = {own: token for token, own in own_lanes.items()}
        crossing_tokens = {own: token for token, own in own_crossings.items()}
        # What is out of the scope goes by its own id, as its token and as its match.
        outside = {key: key for key in edited.lanes if key not in lane_tokens}
        outside_crossings = {key: key for key in edited.crossings if key not in crossing_tokens}
        assignment = cls(
            base,
            _with_cuts_forgotten(base, renamed(edited, lane_tokens, crossing_tokens), own_lanes),
            outside | own_lanes,
            outside_crossings | own_crossings,
            next(tokens),
            scope,
        )
        assignment.lanes = {key: key for key in outside if key in base.lanes}
        assignment.crossings = {key: key for key in outside_crossings if key in base.crossings}
        assignment.lanes |= same_lanes(assignment.base, assignment.edited, assignment.lanes, own_lanes)
        assignment.crossings |= same_crossings(*assignment.unmatched_crossings(), own_crossings)
        return assignment

    def copied(self) -> Assignment:
        """An assignment to try something on."""
        other = copy.copy(self)
        other.lanes, other.crossings = dict(self.lanes), dict(self.crossings)
        other.parts, other.banned = dict(self.parts), set(self.banned)
        return other

    def part(self, lanes: Iterable[int]) -> bool:
        """Take matches back and forbid them; whether there were any."""
        tokens = self.tokens
        parted = False
        for lane in lanes:
            if lane in self.parts:
                whole = self.parts[lane]
                siblings = [token for token, of in self.parts.items() if of == whole]
                self.banned.update((token, whole) for token in siblings)
                for token in siblings:
                    del self.parts[token]
                parted = True
            elif lane in tokens and tokens[lane] != lane:
                self.banned.add((tokens[lane], lane))
                del self.lanes[tokens[lane]]
                parted = True
        return parted

    def unmatched_crossings(self) -> tuple[dict[int, PedestrianCrossing], dict[int, PedestrianCrossing]]:
        """Base crossings and edited crossings that have no counterpart yet."""
        known = set(self.crossings.values())
        return (
            {
                key: crossing
                for key, crossing in self.base.crossings.items()
                if key not in known and self._in_scope(crossing_key(key))
            },
            {
                key: crossing
                for key, crossing in self.edited.crossings.items()
                if key not in self.crossings and self._in_scope(crossing_key(key))
            },
        )

    def comparison(self) -> Comparison:
        """Base and edited map under the present matches; what is unmatched goes by its token."""
        named = renamed(self.edited, other_than_itself(self.lanes), other_than_itself(self.crossings))
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

    def is_free(self, lanes: Iterable[int]) -> bool:
        """Whether lanes, as the comparison names them (base id or token), are all to be looked at anew."""
        if self.scope is None:
            return True
        tokens = self.tokens
        return all(tokens[lane] != lane if lane in tokens else self._in_scope(lane_key(lane)) for lane in lanes)

    def is_free_crossing(self, crossing: int) -> bool:
        """Whether an unmatched crossing, of the base or under its token, is to be looked at anew."""
        return self._in_scope(crossing_key(crossing))

    def _in_scope(self, key: ElementKey) -> bool:
        if self.scope is None:
            return True
        own = self.own_lane_ids if key.kind is ElementKind.LANE_SEGMENT else self.own_crossing_ids
        return ElementKey(key.kind, own.get(key.id, key.id)) in self.scope

    def match_run(self, deleted: Sequence[int], inserted: Sequence[int], alignment: Alignment) -> None:
        """Let a run of the edited map be the base lanes it is aligned with, re-cut if the alignment says so."""
        if not alignment.recut:
            for token, piece in zip(inserted, alignment.pieces, strict=True):
                self.lanes[token] = piece.base
            return
        pieces = []
        as_drawn = len(inserted) == len(alignment.pieces) and all(
            lines_of(self.edited.lanes[token]) == lines_of(piece.lane)
            for token, piece in zip(inserted, alignment.pieces, strict=True)
        )
        for index, piece in enumerate(alignment.pieces):
            token = inserted[index] if index < len(inserted) else self._fresh_token()
            pieces.append(_under(piece.lane, token))
            if piece.is_part:
                self.parts[token] = piece.base
            else:
                self.lanes[token] = piece.base
        if not as_drawn:
            self.edited = with_lanes_exchanged(self.edited, inserted, pieces)

    def join(self, one: int, other: int) -> None:
        """Let two unmatched lanes in series be one, under the first one's token."""
        whole = Run.of([self.edited.lanes[one], self.edited.lanes[other]]).pieces([])[0]
        self.edited = with_lanes_exchanged(self.edited, [one, other], [_under(whole, one)])

    def cut(self, token: int, pieces: Sequence[LaneSegment], kept: int) -> None:
        """Let an unmatched lane be those pieces in series; the one at ``kept`` keeps its token."""
        named = [_under(piece, token if index == kept else self._fresh_token()) for index, piece in enumerate(pieces)]
        self.edited = with_lanes_exchanged(self.edited, [token], named)

    def _fresh_token(self) -> int:
        self._next += 1
        return self._next - 1


def other_than_itself(ids: dict[int, int]) -> dict[int, int]:
    """The renamings that do something."""
    return {token: key for token, key in ids.items() if token != key}


def _under(lane: LaneSegment, token: int) -> LaneSegment:
    return dataclasses.replace(lane, id=token, part_of=None)


def _with_cuts_forgotten(base: MapState, edited: MapState, tokens: Iterable[int]) -> MapState:
    """The edited map with lanes that are parts of whole base lanes as lanes like any other."""
    parts = [lane for lane in map(edited.lanes.__getitem__, tokens) if lane.part_of in base.lanes]
    return edited.replaced([dataclasses.replace(part, part_of=None) for part in parts]) if parts else edited


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
