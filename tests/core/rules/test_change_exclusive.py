"""A foreign annotation calls an element inserted and changed at once."""

from __future__ import annotations

from tests.core.worlds import street

from lanewright.core.changes import AtomicChange, Category
from lanewright.core.claims import Claims
from lanewright.core.elements import ElementKind
from lanewright.core.rules import check


def annotated(*categories):
    change = AtomicChange(ElementKind.LANE_SEGMENT, 1, categories, (), None, None)
    return [one.code for one in check(street(), street(), Claims(annotated=(change,)))]


def test_clean_several_categories_in_place():
    assert annotated(Category.GEOMETRY, Category.MARKING) == []


def test_broken_an_insertion_that_is_a_marking_too():
    assert annotated(Category.INSERTION, Category.MARKING) == ["change.exclusive"]


def test_edge_insertion_and_deletion_at_once():
    assert annotated(Category.INSERTION, Category.DELETION) == ["change.exclusive"]


def test_broken_each_annotated_change_is_told():
    changes = [
        AtomicChange(ElementKind.LANE_SEGMENT, key, (Category.DELETION, Category.TYPE), (), None, None)
        for key in (200, 1, 100)
    ]
    found = check(street(), street(), Claims(annotated=tuple(changes)))
    assert [one.elements for one in found] == [(1,), (100,), (200,)]


def test_broken_the_fix_takes_the_derived_categories_and_leaves_the_map_alone():
    change = AtomicChange(ElementKind.LANE_SEGMENT, 1, (Category.INSERTION, Category.TYPE), (), None, None)
    (violation,) = check(street(), street(), Claims(annotated=(change,)))
    assert [(fix.title, fix.edits, fix.declared) for fix in violation.fixes] == [
        ("Take the derived categories", (), None)
    ]
