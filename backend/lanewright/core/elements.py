"""Map elements of one driving log, in the Argoverse 2 city frame (metres, x grid east, y grid north).

Source: AV2 ``log_map_archive`` files; spec §1 (change-mapping), paper supplement A.3. All values are immutable
and compare by value, so two map states can be compared element by element.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from enum import StrEnum
from types import MappingProxyType
from typing import Any, NamedTuple

Point = tuple[float, float, float]
"""x, y, z in metres, city frame."""
Line = tuple[Point, ...]
"""A polyline of at least two points; lane boundaries run in driving direction."""


class ElementKind(StrEnum):
    LANE_SEGMENT = "lane_segment"
    PEDESTRIAN_CROSSING = "pedestrian_crossing"


class LaneType(StrEnum):
    VEHICLE = "VEHICLE"
    BIKE = "BIKE"
    BUS = "BUS"


class Mark(StrEnum):
    """The 15 legal lane mark types of AV2. In mixed marks the first word is the stripe nearer to the lane."""

    DASH_SOLID_YELLOW = "DASH_SOLID_YELLOW"
    DASH_SOLID_WHITE = "DASH_SOLID_WHITE"
    DASHED_WHITE = "DASHED_WHITE"
    DASHED_YELLOW = "DASHED_YELLOW"
    DOUBLE_SOLID_YELLOW = "DOUBLE_SOLID_YELLOW"
    DOUBLE_SOLID_WHITE = "DOUBLE_SOLID_WHITE"
    DOUBLE_DASH_YELLOW = "DOUBLE_DASH_YELLOW"
    DOUBLE_DASH_WHITE = "DOUBLE_DASH_WHITE"
    SOLID_YELLOW = "SOLID_YELLOW"
    SOLID_WHITE = "SOLID_WHITE"
    SOLID_DASH_WHITE = "SOLID_DASH_WHITE"
    SOLID_DASH_YELLOW = "SOLID_DASH_YELLOW"
    SOLID_BLUE = "SOLID_BLUE"
    NONE = "NONE"
    UNKNOWN = "UNKNOWN"

    @property
    def pattern(self) -> str:
        """Mark type without its colour, e.g. ``DOUBLE_SOLID``; ``NONE`` and ``UNKNOWN`` are their own."""
        return self.value if self.colour == "NON_VISIBLE" else self.value.rpartition("_")[0]

    @property
    def colour(self) -> str:
        """``WHITE``, ``YELLOW``, ``BLUE`` or ``NON_VISIBLE``."""
        return "NON_VISIBLE" if self in (Mark.NONE, Mark.UNKNOWN) else self.value.rpartition("_")[2]

    @property
    def mirrored(self) -> Mark:
        """The same paint read from the lane on its other side (mixed marks exchange their words)."""
        if self.pattern == "DASH_SOLID":
            return Mark(f"SOLID_DASH_{self.colour}")
        if self.pattern == "SOLID_DASH":
            return Mark(f"DASH_SOLID_{self.colour}")
        return self


class ElementKey(NamedTuple):
    """Identity of an element in one map: ids are unique within a kind only."""

    kind: ElementKind
    id: int


@dataclass(frozen=True, slots=True)
class LaneSegment:
    """A lane segment with the 11 properties of the AV2 file. Links may name ids outside the map (the rim).

    ``part_of``: the lane of the base that was cut into this part and its siblings (spec §2); no AV2 property.
    """

    id: int
    is_intersection: bool
    lane_type: LaneType
    left_boundary: Line
    left_mark: Mark
    right_boundary: Line
    right_mark: Mark
    successors: tuple[int, ...] = ()
    predecessors: tuple[int, ...] = ()
    right_neighbor_id: int | None = None
    left_neighbor_id: int | None = None
    part_of: int | None = None

    @property
    def key(self) -> ElementKey:
        return ElementKey(ElementKind.LANE_SEGMENT, self.id)


@dataclass(frozen=True, slots=True)
class PedestrianCrossing:
    """A crossing: two edges of exactly two points, along the walking direction. Order and direction mean nothing."""

    id: int
    edge1: Line
    edge2: Line

    @property
    def key(self) -> ElementKey:
        return ElementKey(ElementKind.PEDESTRIAN_CROSSING, self.id)


Element = LaneSegment | PedestrianCrossing


@dataclass(frozen=True, slots=True)
class MapState:
    """All elements of one log at one moment. Drivable areas are carried by the file template, not here.

    ``facts``: what is known of the state (core.survey); it never changes, so a fact once found stays true.
    """

    lanes: MappingProxyType[int, LaneSegment] = field(default_factory=lambda: MappingProxyType({}))
    crossings: MappingProxyType[int, PedestrianCrossing] = field(default_factory=lambda: MappingProxyType({}))
    facts: dict[Any, Any] = field(default_factory=dict, init=False, repr=False, compare=False)
    _origin: tuple[MapState, frozenset[ElementKey]] | None = field(default=None, repr=False, compare=False)

    @classmethod
    def of(cls, elements: Iterable[Element]) -> MapState:
        """A state of the given elements; of two with the same key the later one stands."""
        lanes: dict[int, LaneSegment] = {}
        crossings: dict[int, PedestrianCrossing] = {}
        for element in elements:
            if isinstance(element, LaneSegment):
                lanes[element.id] = element
            else:
                crossings[element.id] = element
        return cls(MappingProxyType(lanes), MappingProxyType(crossings))

    def get(self, key: ElementKey) -> Element | None:
        """The element of that key, or None."""
        if key.kind is ElementKind.LANE_SEGMENT:
            return self.lanes.get(key.id)
        return self.crossings.get(key.id)

    def __contains__(self, key: ElementKey) -> bool:
        return self.get(key) is not None

    def __iter__(self) -> Iterator[Element]:
        yield from self.lanes.values()
        yield from self.crossings.values()

    def __len__(self) -> int:
        return len(self.lanes) + len(self.crossings)

    def replaced(self, elements: Iterable[Element], removed: Iterable[ElementKey] = ()) -> MapState:
        """A new state: ``removed`` taken out, then ``elements`` put in (replacing those of equal key)."""
        lanes, crossings = self.lanes.copy(), self.crossings.copy()
        edited = set(removed)
        for kind, key in edited:
            if kind is ElementKind.LANE_SEGMENT:
                lanes.pop(key, None)
            else:
                crossings.pop(key, None)
        for element in elements:
            edited.add(element.key)
            if isinstance(element, LaneSegment):
                lanes[element.id] = element
            else:
                crossings[element.id] = element
        origin, before = self.origin
        return MapState(MappingProxyType(lanes), MappingProxyType(crossings), (origin, before | edited))

    @property
    def origin(self) -> tuple[MapState, frozenset[ElementKey]]:
        """The state that this one was made from by edits (it may be itself), and all keys that were edited since."""
        return self._origin or (self, frozenset())

    def apart(self, other: MapState) -> set[ElementKey]:
        """Keys of the elements that are not one and the same object in both states.

        Costs by what was edited where one state was made from the other, or both from a third.
        """
        origin, mine = self.origin
        others_origin, theirs = other.origin
        keys: Iterable[ElementKey] = mine | theirs
        if origin is not others_origin:
            lanes, crossings = self.lanes.keys() | other.lanes.keys(), self.crossings.keys() | other.crossings.keys()
            keys = [ElementKey(ElementKind.LANE_SEGMENT, key) for key in lanes]
            keys += [ElementKey(ElementKind.PEDESTRIAN_CROSSING, key) for key in crossings]
        return {key for key in keys if self.get(key) is not other.get(key)}


def levelled(element: Element) -> Element:
    """The element with every z at 0: elements that differ in heights alone become equal (z is never a change)."""

    def level(line: Line) -> Line:
        return tuple((x, y, 0.0) for x, y, _ in line)

    if isinstance(element, LaneSegment):
        return replace(
            element, left_boundary=level(element.left_boundary), right_boundary=level(element.right_boundary)
        )
    return replace(element, edge1=level(element.edge1), edge2=level(element.edge2))
