"""Source split, release split and direction are three things."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from lanewright.core.changes import Direction
from lanewright.core.errors import InvalidInput
from lanewright.formats.splits import Assignment, SourceSplits, Split, read_splits

SPLITS = SourceSplits({"old": Split.TRAIN, "stale": Split.VAL, "secret": Split.TEST})


def test_train_logs_get_a_prior_invented() -> None:
    assert SPLITS.assign("old") == Assignment(Split.TRAIN, Split.TRAIN, Direction.CURRENT_TO_PRIOR)
    assert SPLITS.assign("old", split=Split.VAL) == Assignment(Split.TRAIN, Split.VAL, Direction.CURRENT_TO_PRIOR)


def test_val_logs_have_a_stale_map_and_become_the_test_set() -> None:
    assert SPLITS.assign("stale") == Assignment(Split.VAL, Split.TEST, Direction.PRIOR_TO_CURRENT)


@pytest.mark.parametrize("log_id", ["nowhere", "secret"])
def test_a_log_without_a_rule_needs_both_said(log_id: str) -> None:
    for said in ({}, {"split": Split.TRAIN}, {"direction": Direction.CURRENT_TO_PRIOR}):
        with pytest.raises(InvalidInput, match=rf"log {log_id}: is in .* Say --split and --direction\."):
            SPLITS.assign(log_id, **said)  # type: ignore[arg-type]
    both = SPLITS.assign(log_id, split=Split.VAL, direction=Direction.PRIOR_TO_CURRENT)
    assert (both.release, both.direction) == (Split.VAL, Direction.PRIOR_TO_CURRENT)


@pytest.mark.parametrize(
    ("log_id", "said", "mend"),
    [
        ("old", {"split": Split.TEST}, "say train or val"),
        ("stale", {"split": Split.TRAIN}, "say test"),
        ("old", {"direction": Direction.PRIOR_TO_CURRENT}, "Leave --direction out"),
    ],
)
def test_what_contradicts_the_source_is_refused(log_id: str, said: dict[str, Any], mend: str) -> None:
    with pytest.raises(InvalidInput, match=mend):
        SPLITS.assign(log_id, **said)


def test_the_real_list(shared_data: Path) -> None:
    splits = read_splits(shared_data / "tbv" / "splits.json")
    assert len(splits.by_log) == 1043
    assert splits.assign("wwZ8efHWR8Rk5bgf78abyVPsE5KWJxYj__Autumn_2020").release is Split.TRAIN
    assert splits.assign("X4zQYzXVLTQ6zlvX85RNExX833eTCXBy__Summer_2020").release is Split.TEST


@pytest.mark.parametrize(
    ("value", "key", "problem"),
    [
        ([], None, "not an object"),
        ({"training": []}, "training", "no split"),
        ({"train": "abc"}, "train", "not a list"),
        ({"train": ["a", 7]}, "train[1]", "7, not a log id"),
        ({"train": ["a"], "val": ["a"]}, "val[0]", "already in train"),
    ],
)
def test_bad_lists_are_refused(tmp_path: Path, value: Any, key: str | None, problem: str) -> None:
    path = tmp_path / "splits.json"
    path.write_text(json.dumps(value))
    with pytest.raises(InvalidInput) as caught:
        read_splits(path)
    assert (caught.value.place.file, caught.value.place.key) == ("splits.json", key)
    assert problem in caught.value.message
    assert caught.value.mend
