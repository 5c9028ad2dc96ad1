"""The server's settings and where its socket goes."""

from __future__ import annotations

import hashlib
import os
import stat
import tempfile
from pathlib import Path

from lanewright.cluster.account import Account
from lanewright.cluster.errors import ClusterError

LONGEST_SOCKET_PATH = 107  # bytes in sockaddr_un.sun_path, less the final zero
SOCKET_NAME = ".s.PGSQL.5432.lock"  # the longest of the names in the folder
FILE_NAME = "lanewright.conf"


def write(data: Path, socket_folder: Path, account: Account, *, durable: bool) -> None:
    """Writes the settings that postgresql.conf includes; anew at each start, because the checkout may have moved."""
    settings = {
        "listen_addresses": "''",  # TCP with trust would make every local user a superuser
        "unix_socket_directories": _quoted('"' + str(socket_folder).replace('"', '""') + '"'),
        "unix_socket_permissions": "0700",
        "port": "5432",
        "max_connections": "100",
        "shared_buffers": "'256MB'" if durable else "'64MB'",
        "jit": "off",
        "timezone": "'UTC'",
        "log_timezone": "'UTC'",
        "log_line_prefix": "'%m [%p] %d '",
    }
    if not durable:
        settings |= {"fsync": "off", "synchronous_commit": "off", "full_page_writes": "off", "max_wal_size": "'4GB'"}
    path = data / FILE_NAME
    path.write_text("".join(f"{name} = {value}\n" for name, value in settings.items()))
    path.chmod(0o600)
    account.own(path)


def make_socket_folder(folder: Path, account: Account) -> Path:
    """Beside the data where the path is short enough for a socket, else a private folder for temporary files.

    Raises:
        ClusterError: somebody else made the temporary folder first.
    """
    beside = folder / "run"
    if len(os.fsencode(beside / SOCKET_NAME)) <= LONGEST_SOCKET_PATH:
        beside.mkdir(mode=0o700, exist_ok=True)
        account.own(beside)
        return beside
    name = hashlib.sha256(os.fsencode(folder)).hexdigest()[:16]
    temporary = Path(tempfile.gettempdir()) / f"lanewright-{account.uid}-{name}"
    try:
        temporary.mkdir(mode=0o700)
        account.own(temporary)
    except FileExistsError:
        pass
    status = temporary.lstat()
    if not stat.S_ISDIR(status.st_mode) or status.st_uid != account.uid or status.st_mode & 0o077:
        raise ClusterError(
            f"{temporary} is not a private folder of the user with id {account.uid}.",
            mend="Remove it, or set LANEWRIGHT_HOME to a folder with a shorter path.",
        )
    return temporary


def _quoted(value: str) -> str:
    return "'" + value.replace("'", "''") + "'"
