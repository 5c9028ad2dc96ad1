"""Declared macros that differ from the derived ones."""

from __future__ import annotations

import dataclasses

from tests.core.worlds import scenario

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
