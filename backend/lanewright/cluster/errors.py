"""What can keep the private cluster from running."""

from __future__ import annotations

from lanewright.core.errors import LanewrightError


class ClusterError(LanewrightError):
    """The private database cluster cannot be had; the message says why, ``mend`` what to do."""

    code = "database.unavailable"
