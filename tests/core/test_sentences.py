"""Changes in the words of a mapper, numbers with units."""

from __future__ import annotations

import dataclasses

from tests.core.worlds import line, scenario, straight, world

from lanewright.core.changes import Direction
from lanewright.core.diff import diff
from lanewright.core.elements import LaneType, Mark
from lanewright.core.sentences import Sentence, describe_update, exported_as, sentence


def told(base, edited):
    return {one.id: sentence(one, base, edited) for one in diff(base, edited).changes}


def test_a_lane_narrows_and_is_repainted():
    base = world(straight(7, 0, 38, 0, 5))
    edited = world(dataclasses.replace(base.lanes[7], right_boundary=line("0,1.4 38,1.4"), right_mark=Mark.SOLID_WHITE))
    assert told(base, edited)[7] == Sentence(
        "Lane 7 narrowed and repainted", "right boundary 1.4 m in, 38 m long; right mark none → solid white"
    )


def test_a_bike_lane_opens_for_all():
    base = world(straight(7, 0, 38, lane_type=LaneType.BIKE))
    edited = world(dataclasses.replace(base.lanes[7], lane_type=LaneType.VEHICLE))
    assert str(told(base, edited)[7]) == "Lane 7 turned into a vehicle lane: type bike → vehicle."


def test_insertions_and_deletions_say_what_came_and_went():
    case = scenario("crossing_inserted")
    assert str(told(case.base, case.edited)[500]) == "Crossing 500 inserted: 11 m long, 3.0 m wide."
    case = scenario("lane_removed_right")
    assert told(case.base, case.edited)[2].headline == "Lane 2 deleted"


def test_links_are_named():
    case = scenario("joint_link_removed")
    assert str(told(case.base, case.edited)[1]) == "Lane 1 relinked: no link to lane 4 any more."


def test_the_export_reads_the_other_way_round_where_the_direction_inverts_it():
    case = scenario("bike_to_vehicle_in_place")
    change = diff(case.base, case.edited).changes[0]
    assert exported_as(change, case.base, case.edited, Direction.PRIOR_TO_CURRENT) == ""
    assert exported_as(change, case.base, case.edited, Direction.CURRENT_TO_PRIOR) == (
        "will be exported as: lane 1 repainted: right mark solid white → dashed white"
    )


def test_an_update_is_headed_by_what_happened_to_the_road():
    case = scenario("lane_added_right")
    found = diff(case.base, case.edited)
    told = describe_update(found.updates[0], found.changes, case.base, case.edited)
    assert told == Sentence("One lane more (lanes 1 and 9)", "shape, appearance, lane graph, lane number +1")
    inverted = describe_update(found.updates[0], found.changes, case.base, case.edited, Direction.CURRENT_TO_PRIOR)
    assert inverted.detail.endswith("will be exported as lane number −1")
