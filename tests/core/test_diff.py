"""Atomic changes: what counts, what does not, and how they read."""

from __future__ import annotations

import dataclasses

from hypothesis import given
from hypothesis import strategies as st
from tests.core.worlds import crossing, lane, line, scenario, straight, street, world

from lanewright.core.diff import diff, invert
from lanewright.core.elements import LaneType, Mark
from lanewright.core.geometry import hausdorff_m
from lanewright.core.macros import fewest_paths
from lanewright.core.report import diff_document
from lanewright.core.roadgraph import RoadGraph


def leaves(was, now):
    return {one.id: one.leaves for one in diff(world(was), world(now)).changes}


def test_five_centimetres_are_no_change_and_six_are():
    base = straight(1, 0, 60)
    assert leaves(base, dataclasses.replace(base, left_boundary=line("0,3.55 60,3.55"))) == {}
    assert leaves(base, dataclasses.replace(base, left_boundary=line("0,3.56 60,3.56"))) == {
        1: ("geometry.border.left",)
    }


def test_a_bump_between_vertices_counts():
    base = straight(1, 0, 60)
    assert hausdorff_m(base.left_boundary, line("0,3.5 30,4.5 60,3.5")) == 1.0
    assert leaves(base, dataclasses.replace(base, left_boundary=line("0,3.5 30,4.5 60,3.5"))) == {
        1: ("geometry.border.left", "geometry.width.left")
    }


def test_marks_are_two_properties():
    base = straight(1, 0, 60, left_mark=Mark.SOLID_WHITE, right_mark=Mark.NONE)
    assert leaves(base, dataclasses.replace(base, left_mark=Mark.SOLID_YELLOW)) == {1: ("marking.color.left",)}
    assert leaves(base, dataclasses.replace(base, left_mark=Mark.DOUBLE_SOLID_WHITE)) == {1: ("marking.type.left",)}
    assert leaves(base, dataclasses.replace(base, right_mark=Mark.SOLID_WHITE)) == {
        1: ("marking.color.right", "marking.type.right")
    }
    assert leaves(base, dataclasses.replace(base, right_mark=Mark.UNKNOWN)) == {1: ("marking.type.right",)}


def test_types_restrict_open_and_convert():
    def of(kind):
        return straight(1, 0, 60, lane_type=kind)

    assert leaves(of(LaneType.VEHICLE), of(LaneType.BUS)) == {1: ("type.restriction",)}
    assert leaves(of(LaneType.BIKE), of(LaneType.VEHICLE)) == {1: ("type.opening",)}
    assert leaves(of(LaneType.BIKE), of(LaneType.BUS)) == {1: ("type.conversion",)}
    assert leaves(of(LaneType.BUS), straight(1, 0, 60, lane_type=LaneType.BUS, is_intersection=True)) == {
        1: ("type.intersection",)
    }


def test_crossing_edges_have_no_order_and_no_direction():
    base = crossing(5, 30)
    turned = dataclasses.replace(base, edge1=base.edge2[::-1], edge2=base.edge1)
    assert diff(world(base), world(turned)).changes == ()
    assert diff(world(base), world(crossing(5, 30.06))).changes[0].categories == ("geometry",)


def test_old_and_new_hold_what_changed():
    case = scenario("bike_to_vehicle_in_place")
    change = diff(case.base, case.edited).changes[1]
    assert change.old is not None
    assert set(change.old) == {"lane_type", "left_lane_mark_type", "right_lane_boundary"}
    assert change.new is not None
    assert change.new["lane_type"] == "VEHICLE"


def test_an_inserted_lane_brings_the_links_that_only_the_others_write():
    base = world(straight(1, 0, 20))
    edited = world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40))
    change = diff(base, edited).changes[0]
    assert change.new is not None
    assert change.new["predecessors"] == [1]


def test_lane_numbers_count_paths_not_segments():
    #  1 → 2 → 3 and 1 → 4: two paths
    graph = RoadGraph.of(
        world(
            straight(1, 0, 20, successors=(2, 4)),
            straight(2, 20, 40, successors=(3,)),
            straight(3, 40, 60),
            lane(4, "20,3.5 40,-10", "20,0 38,-12"),
        )
    )
    assert fewest_paths(graph, {1, 2, 3, 4}) == 2
    assert fewest_paths(graph, {1, 2, 3}) == 1
    assert fewest_paths(graph, {1, 3}) == 2
    assert fewest_paths(graph, set()) == 0


def test_a_better_choice_of_followers_is_found():
    #  1 → 3, 1 → 4, 2 → 3: 1 must take 4 so that 2 can take 3
    graph = RoadGraph.of(
        world(
            straight(1, 0, 20, successors=(3, 4)),
            straight(2, 0, 20, successors=(3,)),
            straight(3, 20, 40),
            straight(4, 20, 40),
        )
    )
    assert fewest_paths(graph, {1, 2, 3, 4}) == 2


def test_a_ring_is_one_path():
    graph = RoadGraph.of(world(straight(1, 0, 20, successors=(2,)), straight(2, 20, 40, successors=(1,))))
    assert fewest_paths(graph, {1, 2}) == 1


def test_the_document_is_sorted_and_stable():
    case = scenario("outer_lane_removed_turn_in_place")
    document = diff_document(diff(case.base, case.edited))
    assert [one["id"] for one in document["changes"]] == [11, 12, 22, 42, 51]
    shuffled = case.edited.replaced([], []).replaced(list(case.edited.lanes.values())[::-1])
    assert diff_document(diff(case.base, shuffled)) == document


@given(
    st.lists(st.sampled_from(list(Mark)), min_size=2, max_size=2),
    st.sampled_from(list(LaneType)),
    st.floats(-1, 1),
    st.floats(-1, 1),
)
def test_inversion_is_exact_for_any_edit_in_place(marks, kind, up, down):
    base = street()
    edited = base.replaced(
        [
            dataclasses.replace(
                base.lanes[1],
                left_mark=marks[0],
                right_mark=marks[1],
                lane_type=kind,
                left_boundary=line(f"20,3.5 40,{3.5 + up} 60,3.5"),
                right_boundary=line(f"20,0 30,{down} 60,0"),
            )
        ]
    )
    assert invert(diff(base, edited)) == diff(edited, base)
    assert invert(invert(diff(base, edited))) == diff(base, edited)


def test_an_intersection_lane_that_leads_nowhere_is_never_rerouted():
    #  free at both ends: it has no function to keep
    base = straight(1, 0, 60, is_intersection=True)
    bent = dataclasses.replace(base, left_boundary=line("0,3.5 60,4.5"))
    pushed = straight(1, 4, 64, is_intersection=True)
    assert leaves(base, bent) == {1: ("geometry.border.left", "geometry.width.left")}
    assert "geometry.topology" not in leaves(base, pushed)[1]


def test_inversion_is_exact_where_an_oncoming_neighbour_takes_the_id():
    #  1 ──>            <── 1   on the other side of the shared line
    was = lane(1, "2223.43,2309.0 2243.29,2311.29", "2223.77,2306.02 2243.64,2308.31")
    now = lane(1, "2243.29,2311.29 2223.43,2309.0", "2242.92,2314.53 2223.05,2312.24")
    assert invert(diff(world(was), world(now))) == diff(world(now), world(was))
