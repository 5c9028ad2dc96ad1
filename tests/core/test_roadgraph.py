"""The road graph: links, vertices, chains, anchors, lateral groups and turns."""

from __future__ import annotations

import pytest
from tests.core.worlds import lane, scenario, straight, street, world

from lanewright.core.elements import LaneType
from lanewright.core.lateral import lateral_group
from lanewright.core.roadgraph import FINISH, START, RoadGraph
from lanewright.core.turns import TurnClass, turn_class, turn_function


def test_a_link_exists_when_either_side_says_so():
    graph = RoadGraph.of(
        world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40), straight(3, 40, 60, predecessors=(2,)))
    )
    assert graph.links() == {(1, 2), (2, 3)}


def test_ids_beyond_the_crop_are_no_members():
    #  1 ──> 777 <── 2 lead to the same lane outside: no vertex of the map
    graph = RoadGraph.of(world(straight(1, 0, 20, successors=(777,)), straight(2, 0, 20, 5, 8.5, successors=(777,))))
    assert graph.links() == frozenset()
    assert graph.vertex((1, FINISH)) == {(1, FINISH)}


def test_a_vertex_is_the_transitive_closure_of_its_links():
    #  1 ─┬─> 3
    #  2 ─┴─> 4     1→3, 2→3, 2→4: all four ends are one vertex
    graph = RoadGraph.of(
        world(
            straight(1, 0, 20, 3.5, 7, successors=(3,)),
            straight(2, 0, 20, successors=(3, 4)),
            straight(3, 20, 40, 3.5, 7),
            straight(4, 20, 40),
        )
    )
    assert graph.vertex((1, FINISH)) == {(1, FINISH), (2, FINISH), (3, START), (4, START)}
    assert graph.vertex((1, FINISH), among={1, 3, 4}) == {(1, FINISH), (3, START)}
    assert graph.anchors((1, FINISH), survivors={4}) == {(4, START)}


def test_chains_run_as_long_as_nothing_else_joins():
    graph = RoadGraph.of(street())
    assert graph.chains({100, 1, 200}) == ((100, 1, 200),)
    assert graph.chains({100, 200}) == ((100,), (200,))
    assert graph.chain_through(1, {1, 200}) == (1, 200)


def test_a_ring_is_one_chain_cut_at_its_smallest_id():
    #  5 → 3 → 4 → 5
    ring = RoadGraph.of(
        world(
            straight(5, 0, 20, successors=(3,)),
            straight(3, 20, 40, successors=(4,)),
            straight(4, 40, 60, successors=(5,)),
        )
    )
    assert ring.chains({3, 4, 5}) == ((3, 4, 5),)


def test_a_lane_linked_to_itself_is_a_ring_of_one():
    graph = RoadGraph.of(world(straight(1, 0, 20, successors=(1,))))
    assert graph.links() == {(1, 1)}
    assert graph.vertex((1, START)) == {(1, START), (1, FINISH)}
    assert graph.chains({1}) == ((1,),)


def test_a_lateral_group_runs_from_left_to_right():
    #  ┆ 1 ┆ 2 ┆ 3 ┆
    lanes = world(
        straight(1, 0, 20, 7, 10.5, right_neighbor_id=2),
        straight(2, 0, 20, 3.5, 7, left_neighbor_id=1, right_neighbor_id=3),
        straight(3, 0, 20, 0, 3.5, left_neighbor_id=2),
    ).lanes
    assert lateral_group(lanes, 3) == (1, 2, 3)


def test_oncoming_unanswered_and_other_types_are_not_in_the_group():
    #  <── 2      1.left = 2 and 2.left = 1: oncoming
    #  1 ──>      3 is a bike lane, 4 does not answer
    oncoming = lane(2, "20,3.5 0,3.5", "20,7 0,7", left_neighbor_id=1)
    one = straight(1, 0, 20, left_neighbor_id=2, right_neighbor_id=3)
    bike = straight(3, 0, 20, -2, 0, left_neighbor_id=1, right_neighbor_id=4, lane_type=LaneType.BIKE)
    silent = straight(4, 0, 20, -4, -2, lane_type=LaneType.BIKE)
    lanes = world(one, oncoming, bike, silent).lanes
    assert lateral_group(lanes, 1) == (1,)
    assert lateral_group(lanes, 3) == (3,)


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        ("0,3.5 20,3.5", "0,0 20,0", TurnClass.STRAIGHT),
        ("0,3.5 7,1 10,-10", "0,0 4,-2 6.5,-10", TurnClass.RIGHT),
        ("0,3.5 4,5.5 6.5,20", "0,0 7,2 10,20", TurnClass.LEFT),
        ("0,1 2,1 2,3 0,3", "0,-1 4,-1 4,5 0,5", TurnClass.U_TURN),
    ],
)
def test_turn_classes(left, right, expected):
    assert turn_class(lane(1, left, right)) is expected


def test_the_function_of_a_turn_is_where_it_comes_from_and_goes_to():
    graph = RoadGraph.of(scenario("right_turn_inserted").edited)
    function = turn_function(graph, 51)
    assert function is not None
    assert (function.turn, function.approaches[0].group, function.approaches[0].from_right) == (
        TurnClass.RIGHT,
        (11, 12),
        0,
    )
    assert [one.lane for one in function.exits] == [31]
    assert turn_function(graph, 11) is None


def test_a_turn_without_exit_in_the_map_has_no_function():
    graph = RoadGraph.of(world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40, is_intersection=True)))
    assert turn_function(graph, 2) is None
