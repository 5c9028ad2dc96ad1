"""Declared macros that differ from the derived ones."""

from __future__ import annotations

import dataclasses

from tests.core.worlds import scenario

from lanewright.core.claims import Claims, DeclaredMacros
from lanewright.core.diff import diff
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
