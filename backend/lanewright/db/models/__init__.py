"""Tables. Importing this package registers them all with ``Base.metadata``."""

from lanewright.db.models.account import Account, AccountSession, ApiToken, LoginFailure
from lanewright.db.models.base import Base
from lanewright.db.models.change import AtomicChangeRow
from lanewright.db.models.line import LIVE, ElementVersion, Line, Revision
from lanewright.db.models.log import Log, LogAsset
from lanewright.db.models.task import Draft, IdBlock, Remark, Task, TaskEvent

__all__ = [
    "LIVE",
    "Account",
    "AccountSession",
    "ApiToken",
    "AtomicChangeRow",
    "Base",
    "Draft",
    "ElementVersion",
    "IdBlock",
    "Line",
    "Log",
    "LogAsset",
    "LoginFailure",
    "Remark",
    "Revision",
    "Task",
    "TaskEvent",
]
