"""What is written back: the file as it was, except for what changed."""

from __future__ import annotations

import dataclasses
import json
import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lanewright.core.elements import ElementKey, ElementKind, LaneType, MapState, Mark
from lanewright.core.errors import InvalidInput
from lanewright.formats.av2_map import MapDocument, parse_map, read_map

AWKWARD = b"""\xef\xbb\xbf{
  "version" : 1.50,
  "drivable_areas": { "31":{"id":31,"area_boundary":[{"z":1.0,"y":0.00,"x":0},{"x":5,"y":0,"z":1},{"x":5,"y":5,"z":1}]} },
  "lane_segments": {
    "7": {"comment": "caf\\u00e9 \\/ \xc3\xa9", "left_neighbor_id": null, "right_neighbor_id": null, "successors": [ 8 , 99 ],
          "predecessors": [], "id": 7, "is_intersection": false, "lane_type": "BIKE",
          "left_lane_mark_type": "NONE", "right_lane_mark_type": "NONE",
          "left_lane_boundary": [{"x": 1.10, "y": 2e0, "z": -0.0, "by": "hand"}, {"x": 4.0, "y": 2, "z": 0.30}],
          "right_lane_boundary": [{"x": 1.10, "y": 0.00, "z": 0}, {"x": 4.000000000000000001, "y": 0, "z": 0}] },
    "8": {"id": 8, "is_intersection": true, "lane_type": "BUS", "left_lane_boundary": [{"x":4.0,"y":2,"z":0.3},{"x":8,"y":2,"z":0}],
          "left_lane_mark_type": "NONE", "right_lane_boundary": [{"x":4,"y":0,"z":0},{"x":8,"y":0,"z":0}],
          "right_lane_mark_type": "NONE", "successors": [], "predecessors": [7], "right_neighbor_id": null, "left_neighbor_id": null}
  }
}
"""  # noqa: E501


def without_space(data: bytes) -> bytes:
    """JSON without the whitespace between its tokens."""
    parts = re.split(rb'("(?:[^"\\]|\\.)*")', data)
    return b"".join(part if i % 2 else re.sub(rb"\s+", b"", part) for i, part in enumerate(parts))


def awkward() -> MapDocument:
    return parse_map(AWKWARD, "awkward.json")


def rebuilt(state: MapState) -> MapState:
    """Equal values that are other objects in another order, as they come back from a database."""
    return MapState.of(reversed([dataclasses.replace(element) for element in state]))


def test_untouched_real_map_is_written_as_it_was_read(real_log: Path) -> None:
    (path,) = (real_log / "map").glob("log_map_archive_*.json")
    document = read_map(path)
    assert document.render(rebuilt(document.state)) == path.read_bytes()


def test_untouched_awkward_map_keeps_spacing_digits_escapes_and_foreign_keys() -> None:
    document = awkward()
    assert document.render(rebuilt(document.state)) == AWKWARD


def test_a_changed_mark_changes_nothing_else_in_the_file() -> None:
    document = awkward()
    lane = dataclasses.replace(document.state.lanes[7], right_mark=Mark.SOLID_BLUE)
    expected = AWKWARD.replace(b'"right_lane_mark_type": "NONE"', b'"right_lane_mark_type": "SOLID_BLUE"', 1)
    assert document.render(document.state.replaced([lane])) == expected


def test_a_moved_vertex_leaves_the_other_points_as_written() -> None:
    document = awkward()
    lane = document.state.lanes[7]
    moved = dataclasses.replace(lane, left_boundary=(lane.left_boundary[0], (4.25, 2.0, 0.3)))
    rendered = document.render(document.state.replaced([moved]))
    assert without_space(rendered) == without_space(AWKWARD).replace(
        b'{"x":4.0,"y":2,"z":0.30}', b'{"x":4.25,"y":2.0,"z":0.3}'
    )


def test_deleting_first_and_last_elements_leaves_valid_json_and_the_rest_verbatim() -> None:
    document = awkward()
    for gone, stays in ((7, 8), (8, 7)):
        rendered = document.render(document.state.replaced([], [ElementKey(ElementKind.LANE_SEGMENT, gone)]))
        assert list(json.loads(rendered.decode("utf-8-sig"))["lane_segments"]) == [str(stays)]
        kept = re.search(rb'"%d": \{(?s:.)*?\}(?=,\n    "|\n  \})' % stays, AWKWARD)
        assert kept is not None
        assert kept.group() in rendered


def test_inserted_elements_stand_at_the_end_by_id_with_the_keys_of_av2_in_order(small_map_bytes: bytes) -> None:
    document = parse_map(small_map_bytes, "map.json")
    lane = document.state.lanes[11]
    rendered = document.render(
        document.state.replaced([dataclasses.replace(lane, id=i, lane_type=LaneType.BUS) for i in (400, 5, 60)])
    )
    lanes = json.loads(rendered)["lane_segments"]
    assert list(lanes) == ["12", "11", "5", "60", "400"]
    assert list(lanes["5"]) == [
        "id", "is_intersection", "lane_type", "left_lane_boundary", "left_lane_mark_type", "right_lane_boundary",
        "right_lane_mark_type", "successors", "predecessors", "right_neighbor_id", "left_neighbor_id",
    ]  # fmt: skip
    assert rendered.startswith(small_map_bytes.split(b'"lane_segments"')[0])


def test_a_crossing_can_be_inserted_into_a_file_without_crossings(small_map: dict[str, Any]) -> None:
    crossing = parse_map(json.dumps(small_map).encode(), "map.json").state.crossings[21]
    del small_map["pedestrian_crossings"]
    data = json.dumps(small_map).encode()
    document = parse_map(data, "map.json")
    assert document.render(document.state) == data
    state = document.state.replaced([crossing])
    rendered = document.render(state)
    assert parse_map(rendered, "map.json").state == state
    assert list(json.loads(rendered)) == ["lane_segments", "drivable_areas", "pedestrian_crossings"]


def test_everything_can_be_deleted(small_map_bytes: bytes) -> None:
    rendered = json.loads(parse_map(small_map_bytes, "map.json").render(MapState()))
    assert rendered["lane_segments"] == rendered["pedestrian_crossings"] == {}
    assert list(rendered["drivable_areas"]) == ["31"]


FRAGMENTS = [
    b'"',
    b"\\",
    b"{",
    b"}",
    b"[",
    b",",
    b":",
    b"NaN",
    b"1e999",
    b"\\u0000",
    b"\\ud800",
    b" \n",
    b"null",
    b"true",
    b"-0",
]

coordinates = st.floats(-1e6, 1e6)
lines = st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=2, max_size=5).map(tuple)
ids = st.integers(0, 2**53 - 1)


@st.composite
def edited(draw: st.DrawFn, state: MapState) -> MapState:
    kept = [element for element in state if draw(st.booleans())]
    changed = [
        dataclasses.replace(
            element,
            left_boundary=draw(st.just(element.left_boundary) | lines),
            right_mark=draw(st.sampled_from(Mark)),
            successors=tuple(draw(st.lists(ids, max_size=4))),
            left_neighbor_id=draw(st.none() | ids),
        )
        for element in state.lanes.values()
        if draw(st.booleans())
    ]
    new_ids = draw(st.sets(ids, max_size=3)) - state.lanes.keys()
    template = next(iter(state.lanes.values()))
    inserted = [dataclasses.replace(template, id=i, right_boundary=draw(lines)) for i in new_ids]
    return MapState.of([*kept, *changed, *inserted])


@settings(max_examples=60, deadline=None)
@given(data=st.data())
def test_every_state_comes_back_from_the_file_it_was_written_to(data: st.DataObject) -> None:
    document = awkward()
    state = data.draw(edited(document.state))
    rendered = document.render(state)
    again = parse_map(rendered, "again.json")
    assert again.state == state
    assert again.drivable_areas == document.drivable_areas
    assert again.render(state) == rendered
    # and back to where it started: values equal the first file's, whatever way was taken
    assert parse_map(again.render(document.state), "back.json").state == document.state


@settings(max_examples=300, deadline=None)
@given(place=st.floats(0, 1), removed=st.integers(0, 3), put=st.binary(max_size=3) | st.sampled_from(FRAGMENTS))
def test_a_damaged_file_is_refused_by_name_or_comes_back_as_it_is(place: float, removed: int, put: bytes) -> None:
    start = round(place * len(AWKWARD))
    data = AWKWARD[:start] + put + AWKWARD[start + removed :]
    try:
        document = parse_map(data, "damaged.json")
    except InvalidInput as error:
        if not (error.message.startswith("damaged.json") and error.mend):
            pytest.fail(f"refused without a place or a mend: {error}")
    else:
        assert document.render(rebuilt(document.state)) == data
        rendered = document.render(MapState.of(list(document.state.lanes.values())[:1]))
        assert len(parse_map(rendered, "again.json").state) == 1


@pytest.mark.parametrize("edit", ["none", "mark", "delete", "insert"])
def test_av2_itself_loads_what_is_written(real_log: Path, tmp_path: Path, edit: str) -> None:
    map_api = pytest.importorskip("av2.map.map_api")
    (path,) = (real_log / "map").glob("log_map_archive_*.json")
    document = read_map(path)
    lane = next(iter(document.state.lanes.values()))
    state = {
        "none": document.state,
        "mark": document.state.replaced([dataclasses.replace(lane, left_mark=Mark.DASH_SOLID_WHITE)]),
        "delete": document.state.replaced([], [lane.key]),
        "insert": document.state.replaced([dataclasses.replace(lane, id=2_000_000_000)]),
    }[edit]
    folder = tmp_path / real_log.name / "map"
    folder.mkdir(parents=True)
    (folder / path.name).write_bytes(document.render(state))
    loaded = map_api.ArgoverseStaticMap.from_map_dir(folder, build_raster=False)
    assert loaded.vector_lane_segments.keys() == state.lanes.keys()
    assert loaded.vector_pedestrian_crossings.keys() == state.crossings.keys()
    for identity, segment in loaded.vector_lane_segments.items():
        ours = state.lanes[identity]
        assert segment.left_lane_boundary.xyz.tolist() == [list(point) for point in ours.left_boundary]
        assert segment.left_mark_type.value == ours.left_mark.value
        assert tuple(segment.successors) == ours.successors


def test_the_record_of_a_cut_is_written_and_taken_off_again() -> None:
    document = awkward()
    part = dataclasses.replace(document.state.lanes[7], part_of=5)
    rendered = document.render(document.state.replaced([part]))
    assert without_space(rendered) == without_space(AWKWARD).replace(
        b'"x":4.000000000000000001,"y":0,"z":0}]}', b'"x":4.000000000000000001,"y":0,"z":0}],"part_of":5}'
    )
    recorded = parse_map(rendered, "recorded.json")
    assert {key: lane.part_of for key, lane in recorded.state.lanes.items()} == {7: 5, 8: None}
    repainted = dataclasses.replace(part, right_mark=Mark.SOLID_BLUE)
    assert b'"part_of": 5' in recorded.render(recorded.state.replaced([repainted]))
    assert recorded.render(document.state) == AWKWARD


@pytest.mark.parametrize("wrong", ["true", '"5"', "-1", "1.0", "[]", "9007199254740992"])
def test_a_record_that_is_no_id_is_named(wrong: str) -> None:
    data = AWKWARD.replace(b'"comment":', b'"part_of": %s, "comment":' % wrong.encode())
    with pytest.raises(InvalidInput, match=r"awkward\.json.*lane_segment 7.*part_of"):
        parse_map(data, "awkward.json")
