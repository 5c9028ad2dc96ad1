"""Lanes of a road between junctions: zones, tapers, cuts and shared lines."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from lanewright.core.elements import LaneType, Line, Mark
from lanewright.demo.ground import Ground
from lanewright.demo.path import Array, Path
from lanewright.demo.plan import Block, CrossSection, Half, Road, Slot, Zone

TILE_M = 30.0
"""Real maps are cut along a grid of this spacing in places."""
SAMPLING_M = 1.0
SHORTEST_PIECE_M = 0.2


@dataclass(frozen=True, slots=True)
class LaneDraft:
    """A lane before it has an id, links and neighbours. ``name`` stands for its place in the road graph."""

    name: str
    left: Line
    right: Line
    left_mark: Mark
    right_mark: Mark
    lane_type: LaneType = LaneType.VEHICLE
    is_intersection: bool = False


@dataclass(frozen=True, slots=True)
class Cut:
    """A line across the road: station on the centreline and metres forward per metre to the left."""

    station: float
    skew: float = 0.0


@dataclass(frozen=True, slots=True)
class _Section:
    """A stretch of a block over which every line runs from one place in the cross-section to another."""

    name: str
    start: float
    end: float
    upstream: CrossSection
    downstream: CrossSection


def block_lanes(road: Road, index: int, start: float, end: float, ground: Ground) -> list[LaneDraft]:
    """Drafts of one block's lanes between two stations of its road."""
    block = road.blocks[index]
    lanes: list[LaneDraft] = []
    for section in _sections(block, start, end):
        for piece, (first, last) in enumerate(_pieces(road, block, section, start, end)):
            name = f"{road.name}/{index}/{section.name}.{piece}"
            lanes += _section_lanes(name, road.path, ground, section, first, last)
    return lanes


def _sections(block: Block, start: float, end: float) -> Iterator[_Section]:
    first, last = start, end
    if block.start is not None:
        zone: Zone = block.start
        yield _Section("start", start, start + zone.storage, zone.section, zone.section)
        first = start + zone.storage
        if zone.taper:
            yield _Section("start-taper", first, first + zone.taper, zone.section, block.along)
            first += zone.taper
    if block.end is not None:
        last = end - block.end.storage - block.end.taper
    if first + 1.0 >= last:
        raise ValueError(f"a block of {end - start:.1f} m is too short for its zones")
    yield _Section("along", first, last, block.along, block.along)
    if block.end is not None:
        zone = block.end
        if zone.taper:
            yield _Section("end-taper", last, last + zone.taper, block.along, zone.section)
        yield _Section("end", end - zone.storage, end, zone.section, zone.section)


def _pieces(road: Road, block: Block, section: _Section, start: float, end: float) -> Iterator[tuple[Cut, Cut]]:
    """Where a section is cut into pieces, from its start to its end; oblique cuts do not meet between the curbs."""
    cuts, half_width = [Cut(section.start)], max(road.curb_left, road.curb_right)
    if section.upstream is section.downstream:
        wanted = [Cut((start if at >= 0 else end) + at) for at in block.cuts]
        wanted += [tile_cut(road, start + at) for at in block.tile_cuts]
        for cut in sorted(wanted, key=lambda cut: cut.station):
            reach = abs(cut.skew) * half_width + SHORTEST_PIECE_M
            before = cuts[-1].station + abs(cuts[-1].skew) * half_width
            if before + reach < cut.station < section.end - reach:
                cuts.append(cut)
    cuts.append(Cut(section.end))
    yield from pairwise(cuts)


def tile_cut(road: Road, station: float) -> Cut:
    """The 30 m grid line nearest to a station that crosses the road less obliquely; straight across in a bend."""
    path, width = road.path, road.curb_left + road.curb_right
    if not path.is_straight(station - TILE_M - width, station + TILE_M + width):
        return Cut(station)
    heading = path.heading_at(station)
    axis = 0 if abs(math.cos(heading)) > abs(math.sin(heading)) else 1
    along = math.cos(heading) if axis == 0 else math.sin(heading)
    across = -math.sin(heading) if axis == 0 else math.cos(heading)
    here = float(path.points([station], [0.0])[0, axis])
    moved = (round(here / TILE_M) * TILE_M - here) / along
    return Cut(station + moved, -across / along)


def _section_lanes(
    name: str, path: Path, ground: Ground, section: _Section, first: Cut, last: Cut
) -> Iterator[LaneDraft]:
    def line(side: int, upstream: float, downstream: float) -> Line:
        """The line at so many metres to the driver's right (side -1: forward, +1: backward), in road direction."""
        return ground.survey(_trace(path, section, first, last, side * upstream, side * downstream))

    for label, side in (("forward", -1), ("backward", 1)):
        forward = side < 0
        # A driver going backward passes the section from its far end.
        near, far = (section.upstream, section.downstream) if forward else (section.downstream, section.upstream)
        enters, leaves = (near.forward, far.forward) if forward else (near.backward, far.backward)
        centre = section.upstream.centre if forward else section.upstream.centre.mirrored
        for slot, entry, exit_ in _lanes_through(enters, leaves):
            left = line(side, entry[0], exit_[0]) if forward else line(side, exit_[0], entry[0])[::-1]
            right = line(side, entry[1], exit_[1]) if forward else line(side, exit_[1], entry[1])[::-1]
            marks = _marks(slot, enters, leaves, centre)
            yield LaneDraft(f"{name}/{label}/{slot.name}", left, right, *marks, slot.lane_type)


def _lanes_through(enters: Half, leaves: Half) -> Iterator[tuple[Slot, tuple[float, float], tuple[float, float]]]:
    """Lanes of a section with the lines where they enter and leave it; forks and merges lie on their parent there."""
    entry, exit_ = enters.lines(), leaves.lines()
    for slot in enters.slots:
        if slot.name in exit_:
            yield slot, entry[slot.name], exit_[slot.name]
        elif slot.parent is not None:
            yield slot, entry[slot.name], exit_[slot.parent]
    for slot in leaves.slots:
        if slot.name not in entry and slot.parent is not None:
            yield slot, entry[slot.parent], exit_[slot.name]


def _marks(slot: Slot, enters: Half, leaves: Half, centre: Mark) -> tuple[Mark, Mark]:
    """Left and right mark. Where lanes fork or merge, the lines between them are not painted."""
    names_in, names_out = [s.name for s in enters.slots], [s.name for s in leaves.slots]
    if names_in == names_out:
        return enters.left_mark(slot.name, centre), slot.outer
    both = [name for name in names_in if name in names_out]
    if slot.name in both:
        left_in, left_out = _beside(names_in, slot.name, -1), _beside(names_out, slot.name, -1)
        right_in, right_out = _beside(names_in, slot.name, 1), _beside(names_out, slot.name, 1)
        left = enters.left_mark(slot.name, centre) if left_in == left_out else Mark.NONE
        return left, (slot.outer if right_in == right_out else Mark.NONE)
    wider, parents = (leaves, names_in) if slot.name in names_out else (enters, names_out)
    names = [s.name for s in wider.slots]
    outermost_left = names[0] == slot.name and parents[0] == slot.parent
    outermost_right = names[-1] == slot.name and parents[-1] == slot.parent
    return (centre if outermost_left else Mark.NONE), (slot.outer if outermost_right else Mark.NONE)


def _beside(names: list[str], name: str, step: int) -> str | None:
    index = names.index(name) + step
    return names[index] if 0 <= index < len(names) else None


def _trace(path: Path, section: _Section, first: Cut, last: Cut, start: float, end: float) -> Array:
    """Dense points of one line of a section, between two cuts, eased from one left offset to another."""
    stations = np.array([first.station + first.skew * start, last.station + last.skew * end])
    count = max(2, math.ceil((stations[1] - stations[0]) / SAMPLING_M) + 1)
    along = np.linspace(stations[0], stations[1], count)
    share = np.clip((along - section.start) / (section.end - section.start), 0, 1)
    return path.points(along, start + (end - start) * share * share * (3 - 2 * share))
