"""What an annotator reads: the sentence of every rule and what stands on the button of its fix."""

from __future__ import annotations

import dataclasses

import pytest
from tests.core.worlds import crossing, line, scenario, straight, street, world

from lanewright.core.changes import AtomicChange, Category
from lanewright.core.claims import NO_CLAIMS, Claims, DeclaredMacros
from lanewright.core.diff import diff
from lanewright.core.elements import ElementKind, Mark
from lanewright.core.rules import check
from lanewright.core.violations import Severity


def of(name):
    case = scenario(name)
    return case.base, case.edited, NO_CLAIMS


def with_lane(base, key, **changes):
    return base, base.replaced([dataclasses.replace(base.lanes[key], **changes)]), NO_CLAIMS


def side_by_side(**left):
    """1 above 2."""
    upper = straight(1, 0, 60, 3.5, 7, right_neighbor_id=2, **left)
    return world(upper, straight(2, 0, 60, 0, 3.5, left_neighbor_id=1))


def annotated(kind, *categories):
    change = AtomicChange(kind, 1, categories, (), None, None)
    return street(), street(), Claims(annotated=(change,))


def reused(old, *others):
    return world(straight(1, 0, 60, 20, 23.5)), world(straight(1, 0, 60, 20, 23.5), *others), Claims({old.key: old})


def declared(**changes):
    case = scenario("lane_added_right")
    update = diff(case.base, case.edited).updates[0]
    macros = dataclasses.replace(update.macros, **changes)
    return case.base, case.edited, Claims(declared=(DeclaredMacros(update.elements, macros),))


def crossing_drawn_badly(**edges):
    return world(), world(dataclasses.replace(crossing(5, 30), **edges)), NO_CLAIMS


LEVEL = world(straight(1, 0, 60, 0, 3.5), straight(2, 0, 60, 5, 8.5))
MOVED_UP = world(straight(2, 0, 60, 0, 3.5), straight(9, 0, 60, 5, 8.5))

SAID = {
    "a replaced lane": (
        of("replaced_same_place"),
        "Lane 1 was deleted and lane 9 drawn between the same junctions: the road graph did not change here, "
        "so edit lane 1 in place.",
        "Make it an edit of lane 1",
    ),
    "a lane replaced by two": (
        of("resegmented"),
        "Lane 1 was deleted and lanes 9 and 10 drawn between the same junctions: the road graph did not change here, "
        "so edit lane 1 in place.",
        "Make canonical: lane 9 becomes lane 1 and lane 10 is joined to it",
    ),
    "two lanes replaced by one": (
        (*of("resegmented")[1::-1], NO_CLAIMS),
        "Lanes 9 and 10 were deleted and lane 1 drawn between the same junctions: the road graph did not change here, "
        "so edit lanes 9 and 10 in place.",
        "Make canonical: lane 1 becomes lane 9 and lane 1 is cut",
    ),
    "a property that changes half-way": (
        of("marks_mid_lane"),
        "Lane 1 was deleted and lanes 9 and 10 drawn between the same junctions: the road graph did not change here, "
        "so edit lane 1 in place.",
        "Make canonical: lane 1 is cut",
    ),
    "a replaced crossing": (
        of("crossing_moved_replaced"),
        "Crossing 500 was deleted and crossing 501 drawn in its place: edit crossing 500 in place.",
        "Make it an edit of crossing 500",
    ),
    "a turn that was replaced": (
        of("outer_lane_removed_turn_replaced"),
        "Lane 51 was deleted and lane 59 drawn with the same function in the intersection: re-route lane 51 in place.",
        "Make it an edit of lane 51",
    ),
    "a link that went": (
        of("link_cut"),
        "Lane 1 no longer leads to lane 200: one of them has another place in the road graph now, so it cannot keep "
        "its id. Delete it and insert it anew.",
        "Make canonical: lane 200 becomes lane 201",
    ),
    "a link that came": (
        with_lane(world(straight(1, 0, 20), straight(2, 20, 40)), 1, successors=(2,)),
        "Lane 1 now leads to lane 2: one of them has another place in the road graph now, so it cannot keep its id. "
        "Delete it and insert it anew.",
        "Make canonical: lane 2 becomes lane 3",
    ),
    "a lane far away": (
        of("free_lane_moved_far"),
        "Lane 1 keeps its id more than 3 m from where it was, and no junction holds it: it is not the same lane. "
        "Delete it and insert a new one.",
        "Make canonical: lane 1 becomes lane 2",
    ),
    "lanes exchanged": (
        of("lanes_exchanged"),
        "Lanes 1 and 2 exchanged their order from left to right: each must keep its own place.",
        "Make canonical: lane 1 becomes lane 2 and lane 2 becomes lane 1",
    ),
    "a crossing far away": (
        of("crossing_moved_far_in_place"),
        "Crossing 500 keeps its id where it hardly overlaps its old place: it is not the same crossing. Delete it and "
        "insert a new one.",
        "Make canonical: crossing 500 becomes crossing 501",
    ),
    "legal ids with a longer story": (
        (LEVEL, MOVED_UP, NO_CLAIMS),
        "The ids of lanes 1, 2 and 9 are legal, but there is a simpler story of this update: the save tells that one.",
        "Make canonical: lane 2 becomes lane 1 and lane 9 becomes lane 2",
    ),
    "a lane that came on the left": (
        of("lane_added_left"),
        "Lane 9 came in on the left of lane 1, which made room: it could be either that is new. By convention the "
        "rightmost lane is, so exchange their ids.",
        "Make canonical: lane 1 becomes lane 9 and lane 9 becomes lane 1",
    ),
    "three segments that came on the left": (
        of("three_segments_added_left"),
        "Lanes 7, 8 and 9 came in on the left of lanes 1, 2 and 3, which made room: it could be either that is new. "
        "By convention the rightmost lane is, so exchange their ids.",
        "Make canonical: lane 1 becomes lane 7, lane 2 becomes lane 8, lane 3 becomes lane 9 and 3 more",
    ),
    "a lane that went on the left": (
        of("lane_removed_left"),
        "Lane 1 went on the left of lane 2, which took the room: it could be either that went. By convention the "
        "rightmost lane goes, so exchange their ids.",
        "Make it an edit of lane 1",
    ),
    "two lanes on each other": (
        (world(straight(1, 0, 60)), world(straight(1, 0, 60), straight(9, 0, 60)), NO_CLAIMS),
        "Lanes 1 and 9 lie on each other: keep one of them.",
        "Delete lane 9",
    ),
    "two crossings on each other": (
        (world(crossing(5, 30)), world(crossing(5, 30), crossing(6, 30)), NO_CLAIMS),
        "Crossings 5 and 6 lie on each other: keep one of them.",
        "Delete crossing 6",
    ),
    "a foreign annotation of a lane": (
        annotated(ElementKind.LANE_SEGMENT, Category.DELETION, Category.MARKING, Category.GEOMETRY),
        "Lane segment 1 is annotated as deletion and as geometry, marking: an inserted or deleted element has no "
        "counterpart to differ from.",
        "Take the derived categories",
    ),
    "a foreign annotation of a crossing": (
        annotated(ElementKind.PEDESTRIAN_CROSSING, Category.INSERTION, Category.GEOMETRY),
        "Pedestrian crossing 1 is annotated as insertion and as geometry: an inserted or deleted element has no "
        "counterpart to differ from.",
        "Take the derived categories",
    ),
    "the id of a deleted lane": (
        reused(straight(9, 0, 60), straight(9, 200, 260)),
        "Lane 9 has the id of an element that was deleted earlier: a new element needs a new id.",
        "Call it lane 10",
    ),
    "the id of a deleted crossing": (
        reused(crossing(9, 30), crossing(9, 50)),
        "Crossing 9 has the id of an element that was deleted earlier: a new element needs a new id.",
        "Call it crossing 10",
    ),
    "macros missing and extra": (
        declared(shape=False, lane_graph=False, function=True),
        "The declared macros do not match the update: shape and lane graph are missing; function is extra.",
        "Declare the derived macros",
    ),
    "another lane number": (
        declared(lane_number=-1),
        "The declared macros do not match the update: lane number is +1, not -1.",
        "Declare the derived macros",
    ),
    "a boundary that crosses itself": (
        with_lane(street(), 1, left_boundary=line("20,3.5 40,3.5 40,6 30,6 30,2 60,3.5")),
        "Lane 1: the left boundary crosses itself. Redraw it there.",
        None,
    ),
    "both boundaries wrong": (
        with_lane(street(), 1, left_boundary=line("20,3.5 20,3.5 60,3.5"), right_boundary=line("20,0 60,0 60,0")),
        "Lane 1: the left boundary repeats its point 1; the right boundary repeats its point 2. Redraw it there.",
        None,
    ),
    "a lane too narrow": (
        with_lane(world(straight(1, 0, 60)), 1, left_boundary=line("0,0.2 60,0.2")),
        "Lane 1: it is 0.20 m wide on average, outside 0.3 m to 15 m. Redraw it there.",
        None,
    ),
    "a lane the wrong way round": (
        (world(), world(straight(1, 0, 60, 3.5, 0)), NO_CLAIMS),
        "Lane 1: its left boundary is not on the left in driving direction. Redraw it there.",
        None,
    ),
    "boundaries that cross": (
        (
            world(),
            world(straight(1, 0, 60)).replaced(
                [dataclasses.replace(straight(1, 0, 60), left_boundary=line("0,3.5 60,-3.5"))]
            ),
            NO_CLAIMS,
        ),
        "Lane 1: its boundaries cross each other. Redraw it there.",
        None,
    ),
    "a crossing without extent": (
        crossing_drawn_badly(edge1=line("30,0"), edge2=line("33,0 nan,9")),
        "Crossing 5: the first edge has fewer than two points; the second edge has a coordinate that is not a finite "
        "number of metres. Redraw it there.",
        None,
    ),
    "a crossing whose edges cross": (
        crossing_drawn_badly(edge2=line("28,0 36,4")),
        "Crossing 5: its edges cross each other. Redraw it there.",
        None,
    ),
    "an id that no map knows": (
        with_lane(street(), 200, successors=(5,)),
        "Lane 200 names lane 5, which is not in the map: take the reference out.",
        "Take the unknown ids out of lane 200",
    ),
    "ids that no map knows": (
        with_lane(street(), 200, successors=(5,), right_neighbor_id=6),
        "Lane 200 names lanes 5 and 6, which are not in the map: take the reference out.",
        "Take the unknown ids out of lane 200",
    ),
    "a link that the downstream lane does not write": (
        with_lane(street(), 200, predecessors=()),
        "Lane 1 leads to lane 200, but only lane 1 says so: name it in lane 200 too.",
        "Write the link on both sides",
    ),
    "a link that the upstream lane does not write": (
        with_lane(street(), 1, successors=()),
        "Lane 1 leads to lane 200, but only lane 200 says so: name it in lane 1 too.",
        "Write the link on both sides",
    ),
    "an end dragged off": (
        with_lane(street(), 1, left_boundary=line("21,3.5 60,3.5")),
        "Lane 100 leads to lane 1, but their ends are 1.00 m apart: they must meet.",
        "Move the end of lane 1 onto lane 100",
    ),
    "a neighbour that does not answer": (
        with_lane(side_by_side(), 2, left_neighbor_id=None),
        "Lanes 1 and 2 are neighbours but lane 2 does not name lane 1 back.",
        "Let lane 2 name lane 1 back",
    ),
    "a shared line moved in one lane": (
        with_lane(side_by_side(), 1, right_boundary=line("0,3.5 30,4 60,3.5")),
        "Lanes 1 and 2 are neighbours but their shared line differs.",
        "Give lane 2 the line and mark of lane 1",
    ),
    "a shared line painted in one lane": (
        with_lane(side_by_side(), 2, left_mark=Mark.SOLID_WHITE),
        "Lanes 1 and 2 are neighbours but the mark on their shared line differs.",
        "Give lane 1 the line and mark of lane 2",
    ),
    "neighbours that have nothing in common": (
        with_lane(world(straight(1, 0, 60, 20, 23.5), straight(2, 0, 60)), 1, right_neighbor_id=2),
        "Lanes 1 and 2 are neighbours but lane 2 does not name lane 1 back.",
        "Let lanes 1 and 2 be neighbours no more",
    ),
}


@pytest.mark.parametrize("case", SAID)
def test_the_sentence_and_the_button(case):
    (base, edited, claims), sentence, button = SAID[case]
    found = [one for one in check(base, edited, claims) if not one.inherited]
    assert [(one.message, [fix.title for fix in one.fixes]) for one in found] == [
        (sentence, [button] if button is not None else [])
    ]


def test_every_rule_has_its_sentence_here():
    from lanewright.core.rules import RULES

    told = {one.code for (base, edited, claims), _, _ in SAID.values() for one in check(base, edited, claims)}
    assert told == {rule.code for rule in RULES}


def test_every_violation_but_the_note_stops_the_save():
    for (base, edited, claims), _, _ in SAID.values():
        for one in check(base, edited, claims):
            assert one.severity is (Severity.NONE if one.code == "identity.not_canonical" else Severity.ERROR)
            assert one.blocks is (one.code != "identity.not_canonical")
