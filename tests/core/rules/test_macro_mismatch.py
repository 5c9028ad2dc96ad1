"""Declared macros that differ from the derived ones."""

from __future__ import annotations

import dataclasses

from tests.core.worlds import crossing, line, scenario, straight, world

from lanewright.core.changes import Macros
from lanewright.core.claims import Claims, DeclaredMacros
from lanewright.core.diff import diff
from lanewright.core.elements import ElementKey, ElementKind
from lanewright.core.rules import check

CASE = scenario("lane_added_right")
UPDATE = diff(CASE.base, CASE.edited).updates[0]


def messages(macros, elements=UPDATE.elements):
    claims = Claims(declared=(DeclaredMacros(elements, macros),))
    return [one.message for one in check(CASE.base, CASE.edited, claims) if one.code == "macro.mismatch"]


def test_clean_what_was_declared_is_derived():
    assert messages(UPDATE.macros) == []


def test_broken_what_is_missing_and_what_is_extra_is_named():
    wrong = dataclasses.replace(UPDATE.macros, shape=False, function=True, lane_number=0)
    (message,) = messages(wrong)
    assert "shape is missing" in message
    assert "function is extra" in message
    assert "lane number is +1, not +0" in message


def test_edge_a_declaration_about_a_part_of_the_update_is_about_all_of_it():
    assert messages(UPDATE.macros, UPDATE.elements[:1]) == []


def fixed(*declared):
    """What the fix of the mismatch declares instead, and what is still wrong after it."""
    claims = Claims(declared=declared)
    (violation,) = [one for one in check(CASE.base, CASE.edited, claims) if one.code == "macro.mismatch"]
    (fix,) = violation.fixes
    assert fix.edits == ()
    return fix.declared, messages_of(fix.declared)


def messages_of(declared):
    found = check(CASE.base, CASE.edited, Claims(declared=declared))
    return [one.message for one in found if one.code == "macro.mismatch"]


def test_the_fix_declares_the_derived_macros_of_the_whole_update():
    wrong = DeclaredMacros(UPDATE.elements[:1], dataclasses.replace(UPDATE.macros, lane_graph=False))
    assert fixed(wrong) == ((DeclaredMacros(UPDATE.elements, UPDATE.macros),), [])


def test_the_fix_withdraws_what_is_declared_of_no_update():
    right = DeclaredMacros(UPDATE.elements[:1], UPDATE.macros)
    astray = DeclaredMacros((ElementKey(ElementKind.LANE_SEGMENT, 4711),), UPDATE.macros)
    assert fixed(right, astray) == ((right,), [])


def test_two_declarations_of_one_update_are_told_once():
    wrong = dataclasses.replace(UPDATE.macros, lane_graph=False)
    declared = tuple(DeclaredMacros((key,), wrong) for key in UPDATE.elements[:2])
    assert len(messages_of(declared)) == 1


#  two updates 500 m apart: 1 is widened, 2 goes
APART = world(straight(1, 0, 60), straight(2, 500, 560), crossing(5, 1000), crossing(6, 1500))
WIDER = dataclasses.replace(APART.lanes[1], left_boundary=line("0,4.5 60,4.5"))
EDITED = world(WIDER, crossing(5, 1000.5), crossing(7, 1600))
NOTHING = Macros(shape=False, appearance=False, function=False, lane_graph=False, lane_number=0)


def told(macros, *elements):
    claims = Claims(declared=(DeclaredMacros(elements, macros),))
    found = [one for one in check(APART, EDITED, claims) if one.code == "macro.mismatch"]
    return [(one.kind, one.elements, one.message.partition(": ")[2]) for one in found]


def a_lane(key):
    return ElementKey(ElementKind.LANE_SEGMENT, key)


def a_crossing(key):
    return ElementKey(ElementKind.PEDESTRIAN_CROSSING, key)


def test_broken_a_declaration_is_about_the_update_that_its_elements_are_in():
    lane_segment, pedestrian_crossing = ElementKind.LANE_SEGMENT, ElementKind.PEDESTRIAN_CROSSING
    assert told(NOTHING, a_lane(1)) == [(lane_segment, (1,), "shape is missing.")]
    assert told(NOTHING, a_lane(2)) == [(lane_segment, (2,), "lane graph is missing; lane number is -1, not +0.")]
    assert told(NOTHING, a_crossing(5)) == [(pedestrian_crossing, (5,), "shape is missing.")]
    assert told(NOTHING, a_crossing(7)) == [(pedestrian_crossing, (7,), "appearance is missing.")]


def test_broken_macros_of_what_did_not_change():
    shape = dataclasses.replace(NOTHING, shape=True)
    assert told(shape, a_lane(4711)) == [(ElementKind.LANE_SEGMENT, (4711,), "shape is extra.")]
    assert told(NOTHING, a_lane(4711)) == []


def test_edge_a_declaration_over_several_updates_is_about_the_one_with_most_of_its_elements():
    base = world(straight(1, 0, 60), straight(2, 500, 560), straight(3, 500, 560, 3.5, 7))
    edited = world(dataclasses.replace(base.lanes[1], left_boundary=line("0,4.5 60,4.5")))
    declared = DeclaredMacros((a_lane(1), a_lane(2), a_lane(3)), NOTHING)
    found = [one for one in check(base, edited, Claims(declared=(declared,))) if one.code == "macro.mismatch"]
    assert [one.elements for one in found] == [(2, 3)]


def test_edge_an_update_of_lanes_and_crossings_is_named_by_its_lanes():
    #  crossing 5 over lane 1, both moved
    base = world(straight(1, 0, 60), crossing(5, 30))
    edited = world(WIDER, crossing(5, 30.5))
    claims = Claims(declared=(DeclaredMacros((a_crossing(5),), NOTHING),))
    found = [one for one in check(base, edited, claims) if one.code == "macro.mismatch"]
    assert [(one.kind, one.elements) for one in found] == [(ElementKind.LANE_SEGMENT, (1,))]


def test_broken_a_declared_lane_graph_that_is_none():
    macros = dataclasses.replace(NOTHING, shape=True, lane_graph=True, appearance=True)
    assert told(macros, a_lane(1)) == [(ElementKind.LANE_SEGMENT, (1,), "appearance and lane graph are extra.")]


def test_broken_macros_where_nothing_changed_at_all():
    claims = Claims(declared=(DeclaredMacros((a_lane(1),), dataclasses.replace(NOTHING, shape=True)),))
    assert [one.elements for one in check(APART, APART, claims)] == [(1,)]
