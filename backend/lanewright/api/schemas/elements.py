"""Elements and edits on the wire: AV2's own attribute names, coordinates in city-frame metres."""

from __future__ import annotations

from pydantic import Field

from lanewright.api.schemas.base import Identifier, Incoming, Metres, Outgoing
from lanewright.core.edits import Edit, Operation
from lanewright.core.elements import ElementKind, LaneType, Mark


class PointOut(Outgoing):
    x: float
    y: float
    z: float


class LaneAttributes(Outgoing):
    """The AV2 attributes of a lane segment; boundaries run in driving direction."""

    id: int
    is_intersection: bool
    lane_type: LaneType
    left_lane_boundary: list[PointOut]
    left_lane_mark_type: Mark
    right_lane_boundary: list[PointOut]
    right_lane_mark_type: Mark
    successors: list[int]
    predecessors: list[int]
    right_neighbor_id: int | None
    left_neighbor_id: int | None
    part_of: int | None = None
    """The lane of the base of which this is a part, where the task records a cut; else absent. No AV2 attribute."""


class CrossingAttributes(Outgoing):
    """The AV2 attributes of a pedestrian crossing: two edges of two points."""

    edge1: list[PointOut]
    edge2: list[PointOut]
    id: int


class ElementKeyOut(Outgoing):
    kind: ElementKind
    id: int


class LaneOut(Outgoing):
    """A lane at one revision; ``version`` is the revision that wrote it."""

    version: int
    attributes: LaneAttributes


class CrossingOut(Outgoing):
    version: int
    attributes: CrossingAttributes


class MapOut(Outgoing):
    """A map state, or a part of one."""

    lanes: list[LaneOut]
    crossings: list[CrossingOut]


class PointIn(Incoming):
    """z null: not known (a new or moved vertex); the server takes it from the ground."""

    x: Metres
    y: Metres
    z: Metres | None = None


Line = list[PointIn]


class AttributesIn(Incoming):
    """Changed attributes (update) or all of them (insert) of a lane or crossing; left out means unchanged.

    ``id`` may stand here too, as it does in fixes; it must be that of the edit.
    """

    id: Identifier | None = None
    is_intersection: bool | None = None
    lane_type: str | None = None
    left_lane_boundary: Line | None = Field(None, min_length=2, max_length=10_000)
    left_lane_mark_type: str | None = None
    right_lane_boundary: Line | None = Field(None, min_length=2, max_length=10_000)
    right_lane_mark_type: str | None = None
    successors: list[Identifier] | None = Field(None, max_length=1000)
    predecessors: list[Identifier] | None = Field(None, max_length=1000)
    right_neighbor_id: Identifier | None = None
    left_neighbor_id: Identifier | None = None
    part_of: Identifier | None = None
    edge1: Line | None = Field(None, min_length=2, max_length=2)
    edge2: Line | None = Field(None, min_length=2, max_length=2)


class EditIn(Incoming):
    """One net edit of one element since the base revision of the draft."""

    operation: Operation = Field(strict=False)
    kind: ElementKind = Field(strict=False)
    id: Identifier
    attributes: AttributesIn = Field(default_factory=AttributesIn)

    def to_core(self) -> Edit:
        """The edit as a value of the domain; attributes that were left out stay out."""
        given = self.attributes.model_dump(include=self.attributes.model_fields_set)
        return Edit(self.operation, self.kind, self.id, given)


class EditOut(Outgoing):
    """An edit as part of a fix or a stored draft; the shape that the server takes back as EditIn."""

    operation: Operation
    kind: ElementKind
    id: int
    attributes: dict[str, object]
