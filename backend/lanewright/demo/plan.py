"""The plan of a small road network: roads, their cross-sections, junctions. A map is built from it.

Lanes have names that stand for their place in the road graph. Two plans that differ by an update give two maps whose
elements keep their ids exactly where the names persist, which is the identity rule of the change mapping (spec §2).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Flag, auto

from lanewright.core.elements import LaneType, Mark
from lanewright.demo.path import Path


class Turn(Flag):
    LEFT = auto()
    THROUGH = auto()
    RIGHT = auto()
    ANY = LEFT | THROUGH | RIGHT


@dataclass(frozen=True, slots=True)
class Slot:
    """One lane of a cross-section.

    Attributes:
        name: stands for the lane along the whole road: same name, same lane.
        outer: mark of its right line, read from this lane (mixed marks: first word nearer to this lane).
        turns: movements allowed at the junction downstream.
        parent: lane from which this one forks where it opens (or into which it merges where it ends).
    """

    name: str
    width: float
    outer: Mark = Mark.NONE
    lane_type: LaneType = LaneType.VEHICLE
    turns: Turn = Turn.ANY
    parent: str | None = None


@dataclass(frozen=True, slots=True)
class Half:
    """Lanes of one direction of travel, from the centre outwards (left to right for the driver).

    ``inner`` is where the first lane begins: metres to the driver's right of the centreline, negative across it.
    """

    slots: tuple[Slot, ...] = ()
    inner: float = 0.0

    def lines(self) -> dict[str, tuple[float, float]]:
        """Left and right line of each lane, metres to the driver's right of the centreline."""
        places, at = {}, self.inner
        for slot in self.slots:
            places[slot.name] = (at, at + slot.width)
            at += slot.width
        return places

    def slot(self, name: str) -> Slot | None:
        return next((slot for slot in self.slots if slot.name == name), None)

    def left_mark(self, name: str, centre: Mark) -> Mark:
        """Mark of a lane's left line, read from that lane."""
        index = [slot.name for slot in self.slots].index(name)
        return centre if index == 0 else self.slots[index - 1].outer.mirrored


@dataclass(frozen=True, slots=True)
class CrossSection:
    """Both directions side by side. ``centre`` is the mark of the line between them, read from the forward lanes."""

    forward: Half
    backward: Half = Half()
    centre: Mark = Mark.DOUBLE_SOLID_YELLOW


@dataclass(frozen=True, slots=True)
class Zone:
    """The end of a block towards a junction: its own cross-section, reached over a taper."""

    section: CrossSection
    storage: float = 28.0
    taper: float = 18.0


@dataclass(frozen=True, slots=True)
class Block:
    """A road between two junctions (or a junction and the end of the path).

    ``cuts`` are distances from the block's start (negative: from its end) where lanes are cut; a tile cut, likewise
    placed, runs along the nearest line of the 30 m grid.
    """

    along: CrossSection
    start: Zone | None = None
    end: Zone | None = None
    cuts: tuple[float, ...] = ()
    tile_cuts: tuple[float, ...] = ()


@dataclass(frozen=True)
class Road:
    """A path with its blocks in order of station, and the distance of the curbs from the centreline."""

    name: str
    path: Path
    blocks: tuple[Block, ...]
    curb_left: float
    curb_right: float


@dataclass(frozen=True, slots=True)
class Zebra:
    """A crossing in front of a junction arm: its width, and how far it lies from the stop line."""

    width: float = 3.4
    setback: float = 1.2


@dataclass(frozen=True)
class Junction:
    """Where roads meet: station on each road, crossings by arm (``"avenue+"`` is the arm that leaves forward)."""

    name: str
    stations: Mapping[str, float]
    zebras: Mapping[str, Zebra] = field(default_factory=dict)
    clearance: float = 7.0


@dataclass(frozen=True)
class Plan:
    """All roads and junctions by name."""

    roads: Mapping[str, Road]
    junctions: tuple[Junction, ...]
