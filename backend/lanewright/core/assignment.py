"""Which element of the edited map is which of the base: a working state for the canonical form.

Elements of the edited map go by *tokens*: ids above all that are in use, given in order of position, so that nothing
depends on the ids the edited map happens to have.
"""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import count
from typing import Any

from lanewright.core.alignment import Alignment
from lanewright.core.comparison import Comparison, crossing_key, lane_key
from lanewright.core.cuts import marked_as_parts
from lanewright.core.elements import ElementKey, ElementKind, LaneSegment, MapState, PedestrianCrossing
from lanewright.core.geometry import lines_of
from lanewright.core.identity import renamed, with_lanes_exchanged
from lanewright.core.matching import place_of, plan_of, same_crossings, same_lanes
from lanewright.core.segmentation import segmented
from lanewright.core.series import Run
from lanewright.core.survey import largest_id_named

_LANE = ElementKind.LANE_SEGMENT


class Assignment:
    """Matches of lanes and crossings, and the edited map (under tokens) that they are about.

    Attributes:
        base: the base map.
        edited: the edited map under tokens; re-cut as matches of whole runs ask for it.
        lanes, crossings: token -> base id, for what is matched.
        own_lane_ids, own_crossing_ids: token -> id in the edited map as it came; new pieces have none.
        drawn: the lanes of the edited map, as it came, that were looked at anew.
        pieces_of: token -> drawn lane, for what is one more piece of it.
        recut: whether any of them begins or ends elsewhere now.
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
        drawn: frozenset[int],
        scope: Collection[ElementKey] | None,
        first_token: int,
        numbers: Iterator[int],
    ):
        self.base = base
        self.edited = edited
        self.own_lane_ids = own_lanes
        self.own_crossing_ids = own_crossings
        self.lanes: dict[int, int] = {}
        self.crossings: dict[int, int] = {}
        self.banned: set[tuple[int, int]] = set()
        self.parts: dict[int, int] = {}
        self.drawn = drawn
        self.pieces_of: dict[int, int] = {}
        self.recut = False
        self.scope = scope
        self._first_token = first_token
        self._numbers = numbers

    @classmethod
    def start(cls, base: MapState, edited: MapState, scope: Collection[ElementKey] | None) -> Assignment:
        """Everything outside the scope matched by its id, what has the same lines matched by those."""
        numbers = count(1 + largest_id_named(base, edited))
        drawn, crossings = _inside(edited, scope)
        settled = () if scope is None else base.lanes.keys() - {key for kind, key in scope if kind is _LANE}
        pieces_of: dict[int, int] = {}

        def fresh(lane: int) -> int:
            piece = next(numbers)
            pieces_of[piece] = lane
            return piece

        recut = segmented(base, _with_cuts_forgotten(base, edited, drawn), drawn, settled, fresh)
        free = [recut.lanes[key] for key in (*drawn, *pieces_of) if key in recut.lanes]
        own_lanes = {next(numbers): lane.id for lane in sorted(free, key=_position)}
        own_crossings = {next(numbers): crossing.id for crossing in sorted(crossings, key=_crossing_position)}
        lane_tokens = {own: token for token, own in own_lanes.items()}
        crossing_tokens = {own: token for token, own in own_crossings.items()}
        # What is out of the scope goes by its own id, as its token and as its match.
        outside = {key: key for key in recut.lanes if key not in lane_tokens}
        outside_crossings = {key: key for key in edited.crossings if key not in crossing_tokens}
        assignment = cls(
            base,
            renamed(recut, lane_tokens, crossing_tokens),
            outside | {token: own for token, own in own_lanes.items() if own in drawn},
            outside_crossings | own_crossings,
            drawn,
            scope,
            min((*own_lanes, *own_crossings), default=0),
            numbers,
        )
        assignment.pieces_of = {lane_tokens[piece]: lane for piece, lane in pieces_of.items()}
        assignment.recut = recut.lanes.keys() != edited.lanes.keys() or any(
            place_of(recut.lanes[key]) != place_of(edited.lanes[key]) for key in drawn
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
        return all(self._in_scope(lane_key(lane)) for lane in lanes)

    def is_free_crossing(self, crossing: int) -> bool:
        """Whether an unmatched crossing, of the base or under its token, is to be looked at anew."""
        return self._in_scope(crossing_key(crossing))

    def _in_scope(self, key: ElementKey) -> bool:
        return self.scope is None or key.id >= self._first_token or key in self.scope

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
            token = inserted[index] if index < len(inserted) else self._piece_of(inserted[-1])
            pieces.append(_under(piece.lane, token))
            if piece.is_part:
                self.parts[token] = piece.base
            else:
                self.lanes[token] = piece.base
        if not as_drawn:
            self._exchange(inserted, pieces)

    def join(self, one: int, other: int) -> None:
        """Let two unmatched lanes in series be one, under the first token; what either must not be, it must not."""
        self.banned |= {(one, was) for token, was in self.banned if token == other}
        whole = Run.of([self.edited.lanes[one], self.edited.lanes[other]]).pieces([])[0]
        self._exchange([one, other], [_under(whole, one)])

    def cut(self, token: int, pieces: Sequence[LaneSegment], kept: int) -> None:
        """Let an unmatched lane be those pieces in series; the one at ``kept`` keeps its token."""
        named = [_under(piece, token if index == kept else self._piece_of(token)) for index, piece in enumerate(pieces)]
        self._exchange([token], named)

    def _piece_of(self, token: int) -> int:
        """A token for one more piece of what was drawn there."""
        piece = next(self._numbers)
        self.pieces_of[piece] = self.own_lane_ids[token] if token in self.own_lane_ids else self.pieces_of[token]
        return piece

    def _exchange(self, old: Sequence[int], new: Sequence[LaneSegment]) -> None:
        self.edited = with_lanes_exchanged(self.edited, old, new)
        self.recut = True


def other_than_itself(ids: dict[int, int]) -> dict[int, int]:
    """The renamings that do something."""
    return {token: key for token, key in ids.items() if token != key}


def _under(lane: LaneSegment, token: int) -> LaneSegment:
    return dataclasses.replace(lane, id=token, part_of=None)


def _inside(
    edited: MapState, scope: Collection[ElementKey] | None
) -> tuple[frozenset[int], Collection[PedestrianCrossing]]:
    """The lanes (by id) and crossings of the edited map that are in the scope."""
    if scope is None:
        return frozenset(edited.lanes), edited.crossings.values()
    inside = [element for element in map(edited.get, scope) if element is not None]
    lanes = frozenset(element.id for element in inside if isinstance(element, LaneSegment))
    return lanes, [element for element in inside if isinstance(element, PedestrianCrossing)]


def _with_cuts_forgotten(base: MapState, edited: MapState, lanes: Iterable[int]) -> MapState:
    """The edited map with lanes that are parts of whole base lanes as lanes like any other."""
    parts = [lane for lane in map(edited.lanes.__getitem__, lanes) if lane.part_of in base.lanes]
    return edited.replaced([dataclasses.replace(part, part_of=None) for part in parts]) if parts else edited


def _position(lane: LaneSegment) -> tuple[Any, ...]:
    """What is seen of a lane, as an order: its lines, then its properties."""
    return (
        place_of(lane),
        lane.lane_type.value,
        lane.left_mark.value,
        lane.right_mark.value,
        lane.is_intersection,
    )


def _crossing_position(crossing: PedestrianCrossing) -> tuple[Any, ...]:
    return tuple(sorted(min(plan_of(edge), plan_of(edge[::-1])) for edge in (crossing.edge1, crossing.edge2)))
