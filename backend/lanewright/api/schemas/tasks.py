"""Tasks, their workspace, drafts and steps."""

from __future__ import annotations

import datetime

from pydantic import Field

from lanewright.api.schemas.accounts import PersonOut
from lanewright.api.schemas.base import Identifier, Incoming, Outgoing, RevisionNumber, RowId, Text
from lanewright.api.schemas.declarations import DeclarationOut, Declarations
from lanewright.api.schemas.elements import EditIn, EditOut, ElementKeyOut, MapOut
from lanewright.core.changes import Category, Direction
from lanewright.core.elements import ElementKind
from lanewright.core.workflow import Action, TaskState


class TaskOut(Outgoing):
    """A row of the task lists. ``changes`` counts elements per category at the head, as edits made."""

    id: int
    log_id: str
    city: str
    source_split: str | None
    release_split: str
    direction: Direction
    state: TaskState
    state_since: datetime.datetime
    assignee: PersonOut | None
    reviewer: PersonOut | None
    head: int
    accepted_revision: int | None
    changes: dict[Category, int]
    changed_elements: int
    lanes: int
    crossings: int
    authors: list[PersonOut]
    """Everybody who saved a changeset in it."""
    actions: list[Action]
    """What the asker may do with it now."""
    can_edit: bool


class TaskPage(Outgoing):
    items: list[TaskOut]
    total: int
    page: int
    page_size: int
    state_counts: dict[TaskState, int]
    """Tasks per state under the same filter without its state."""


class TaskCreate(Incoming):
    log_id: Text = Field(min_length=1, max_length=200)
    direction: Direction | None = Field(None, strict=False, description="Default: the log's own.")
    assignee_id: RowId | None = None


class TaskPatch(Incoming):
    """Assignment. ``assignee_id`` null takes the task from whoever has it."""

    assignee_id: RowId | None


class RemarkOut(Outgoing):
    kind: ElementKind
    element_id: int
    text: str


class RemarkIn(Incoming):
    kind: ElementKind = Field(strict=False)
    element_id: Identifier
    text: Text = Field(min_length=1)


class TaskEventOut(Outgoing):
    action: str
    from_state: TaskState | None
    to_state: TaskState
    revision: int
    reason: str
    at: datetime.datetime
    actor: PersonOut
    remarks: list[RemarkOut]


class Step(Incoming):
    """A step through the states. ``revision``: the one that was looked at (submit, accept, send_back)."""

    action: Action = Field(strict=False)
    revision: RevisionNumber | None = None
    reason: Text = ""
    remarks: list[RemarkIn] = Field(default_factory=list, max_length=1000)


class CityFrame(Outgoing):
    """City frame = UTM zone ``epsg`` minus the origin; WGS84 is for display only."""

    city: str
    epsg: int
    origin_east: float
    origin_north: float


class LidarOut(Outgoing):
    """Intensity image, north up; ``bounds`` = min x, min y, max x, max y of its pixel edges in city metres."""

    url: str
    bounds: tuple[float, float, float, float]
    metres_per_pixel: float


class RevisionOut(Outgoing):
    number: int
    author: PersonOut | None
    created_at: datetime.datetime
    note: str
    changed_elements: int


class DraftOut(Outgoing):
    base_revision: int
    edits: list[EditOut]
    declarations: list[DeclarationOut]
    version: int
    kept_at: datetime.datetime


class DraftIn(Incoming):
    """``version``: the one last seen (0: none); another device's newer draft gives 409 with it in the facts."""

    base_revision: RevisionNumber
    edits: list[EditIn] = Field(max_length=5000)
    declarations: Declarations = None
    version: RevisionNumber


class DraftKept(Outgoing):
    version: int
    kept_at: datetime.datetime


class Workspace(Outgoing):
    """All that the editor needs to open a task at one revision (default: the head)."""

    task: TaskOut
    revision: int
    frame: CityFrame
    bounds: tuple[float, float, float, float]
    base: MapOut
    """The map as imported."""
    changed: MapOut
    """Elements of the revision that differ from the base (updated or inserted)."""
    removed: list[ElementKeyOut]
    """Elements of the base that the revision has not."""
    declarations: list[DeclarationOut]
    """Macros declared at that revision."""
    drivable_areas: list[list[tuple[float, float]]]
    lidar: LidarOut | None
    draft: DraftOut | None
    """The asker's own draft in this task."""
    events: list[TaskEventOut]
    revisions: list[RevisionOut]


class FrameOut(Outgoing):
    """One frame per > 5 m of motion; timestamps are strings because they exceed 2^53."""

    index: int
    drive: int
    timestamp_ns: str
    x: float
    y: float
    z: float
    heading_rad: float


class Drive(Outgoing):
    """The vehicle's way through the log, city frame."""

    trajectory: list[tuple[float, float]]
    frames: list[FrameOut]
    sensors: dict[str, int]


class IdBlockOut(Outgoing):
    """Fresh element ids, for this open workspace only; never handed out twice."""

    first_id: int
    last_id: int
