"""Picks the elements of an AV2 map that the walk along the whole line works on."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Any

Lane = dict[str, Any]


def line_places(points: list[dict[str, float]]) -> list[tuple[float, float]]:
    return [(point["x"], point["y"]) for point in points]


def length(points: list[dict[str, float]]) -> float:
    places = line_places(points)
    return sum(math.dist(a, b) for a, b in itertools.pairwise(places))


@dataclass(frozen=True)
class Scene:
    """Ids of lanes and a crossing, none touching another's edit.

    Attributes:
        shared: lane whose right boundary is bit for bit the left one of ``sharer``.
        painted: lane whose outer right mark is repainted.
        widened: lane with nothing to its right, beside which a lane is inserted.
        replaced: lane between two junctions, deleted and drawn anew.
        crossing: deleted.
    """

    shared: int
    sharer: int
    painted: int
    widened: int
    replaced: int
    crossing: int


def choose(archive: dict[str, Any]) -> Scene:
    """The longest suitable lanes of a map file."""
    lanes: dict[int, Lane] = {lane["id"]: lane for lane in archive["lane_segments"].values()}
    taken: set[int] = set()

    def around(lane: Lane) -> set[int]:
        near = {lane["id"], lane["left_neighbor_id"], lane["right_neighbor_id"]}
        near |= {*lane["successors"], *lane["predecessors"]}
        near |= {other["id"] for other in lanes.values() if lane["id"] in other["successors"]}
        return {number for number in near if number in lanes}

    def take(suits: Any) -> Lane:
        candidates = [lane for lane in lanes.values() if not lane["is_intersection"] and not around(lane) & taken]
        best = max((lane for lane in candidates if suits(lane)), key=lambda lane: length(lane["right_lane_boundary"]))
        taken.update(around(best))
        for number in around(best):
            taken.update(around(lanes[number]))
        return best

    def sharer_of(lane: Lane) -> Lane | None:
        other = lanes.get(lane["right_neighbor_id"])
        shares = other is not None and other["left_lane_boundary"] == lane["right_lane_boundary"]
        return other if shares else None

    def alone_on_the_right(lane: Lane) -> bool:
        line = lane["right_lane_boundary"]
        return lane["right_neighbor_id"] is None and all(
            other is lane or line not in (other["left_lane_boundary"], other["right_lane_boundary"])
            for other in lanes.values()
        )

    def tied(lane: Lane) -> bool:
        before = [other for other in lanes.values() if lane["id"] in other["successors"]]
        after = [number for number in lane["successors"] if number in lanes]
        return len(before) == 1 and len(after) == 1 and 10 < length(lane["right_lane_boundary"]) < 60

    shared = take(lambda lane: sharer_of(lane) is not None and len(lane["right_lane_boundary"]) >= 3)
    replaced = take(tied)
    widened = take(lambda lane: alone_on_the_right(lane) and length(lane["right_lane_boundary"]) < 60)
    painted = take(lambda lane: alone_on_the_right(lane) and lane["right_lane_mark_type"] != "DASHED_YELLOW")
    return Scene(
        shared=shared["id"],
        sharer=shared["right_neighbor_id"],
        painted=painted["id"],
        widened=widened["id"],
        replaced=replaced["id"],
        crossing=min(crossing["id"] for crossing in archive["pedestrian_crossings"].values()),
    )
