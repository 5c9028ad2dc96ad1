"""The server process as the data directory and /proc tell of it: running, gone, or a zombie."""

from __future__ import annotations

import contextlib
import os
import signal
import time
from dataclasses import dataclass
from pathlib import Path

from lanewright.cluster.errors import ClusterError

POLL_S = 0.01


@dataclass(frozen=True)
class Postmaster:
    """A running server.

    Attributes:
        pid: of the first process of the server.
        socket_folder: where its unix socket is.
    """

    pid: int
    data: Path
    socket_folder: Path

    def stop(self, patience_s: float = 60.0) -> None:
        """Ends sessions, writes a checkpoint and stops ("fast"); after ``patience_s`` without one ("immediate").

        Raises:
            ClusterError: it does not even stop then.
        """
        for how in (signal.SIGINT, signal.SIGQUIT, signal.SIGKILL):
            try:
                os.kill(self.pid, how)
            except ProcessLookupError:
                return
            except PermissionError as error:
                raise ClusterError(
                    f"The database server (process {self.pid}) belongs to another user.",
                    mend="Run the command as the user who started it.",
                ) from error
            deadline = time.monotonic() + patience_s
            while time.monotonic() < deadline:
                if not is_alive(self.pid, self.data):
                    return
                time.sleep(POLL_S)
        raise ClusterError(f"The database server (process {self.pid}) does not stop.", mend="Stop it by hand.")


def find(data: Path) -> Postmaster | None:
    """The server that runs on this data directory, if one does; a stale postmaster.pid is nobody."""
    try:
        lines = (data / "postmaster.pid").read_text().splitlines()
        pid = int(lines[0])
    except (OSError, ValueError, IndexError):
        return None
    if not is_alive(pid, data):
        return None
    return Postmaster(pid, data, Path(lines[4]) if len(lines) > 4 and lines[4] else Path())


def is_alive(pid: int, data: Path) -> bool:
    """Whether the process lives and works in the data directory.

    kill(pid, 0) is no proof: it succeeds for a zombie (PID 1 of a container may reap late) and for a stranger that
    got the number after a crash.
    """
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        return state not in "ZX" and Path(f"/proc/{pid}/cwd").samefile(data)
    except PermissionError:  # another user's process: that it works here cannot be ruled out
        return True
    except OSError:
        return False


def clear_remains(data: Path, socket_folder: Path, patience_s: float = 5.0) -> None:
    """After a crash: waits for orphaned backends, ends those that stay, and removes what bars a new start.

    Only for the holder of the cluster's lock, and only when ``find`` found nobody.
    """
    deadline = time.monotonic() + patience_s
    while orphans := _working_in(data):
        if time.monotonic() > deadline:
            for pid in orphans:  # they have no postmaster any more; crash recovery follows anyway
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
            deadline = time.monotonic() + patience_s
        time.sleep(POLL_S)
    (data / "postmaster.pid").unlink(missing_ok=True)
    for remnant in socket_folder.glob(".s.PGSQL.*"):
        remnant.unlink(missing_ok=True)


def _working_in(data: Path) -> list[int]:
    return [int(entry.name) for entry in Path("/proc").iterdir() if entry.name.isdigit() and _works_in(entry, data)]


def _works_in(process: Path, data: Path) -> bool:
    try:
        return is_alive(int(process.name), data) and (process / "cwd").samefile(data)
    except OSError:
        return False
