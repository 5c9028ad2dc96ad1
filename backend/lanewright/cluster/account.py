"""Under whose name the server runs: PostgreSQL refuses root, so root lends it another account."""

from __future__ import annotations

import os
import pwd
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from lanewright.cluster.errors import ClusterError

CANDIDATES = ("postgres", "nobody")  # initdb wants an entry in passwd: a made-up uid fails


@dataclass(frozen=True)
class Account:
    """How to start the server's programs.

    Attributes:
        uid, gid: owner of the cluster's files on disk.
        substitute: uid and gid to start the program with; None: the caller's own.
        namespace: uid and gid that the program sees in a user namespace of its own, where the files stay the caller's.
    """

    uid: int
    gid: int
    substitute: tuple[int, int] | None = None
    namespace: tuple[int, int] | None = None

    def run(
        self,
        command: Sequence[str],
        *,
        folder: Path = Path("/"),
        environment: Mapping[str, str] | None = None,
        stdout: int = subprocess.DEVNULL,
        stderr: int = subprocess.DEVNULL,
    ) -> subprocess.CompletedProcess[str]:
        """subprocess.run in ``folder`` (the caller's may be closed to the account) and without its PG* variables."""
        if self.namespace:
            uid, gid = self.namespace
            command = ["unshare", "--user", f"--map-user={uid}", f"--map-group={gid}", *command]
        uid_after, gid_after = self.substitute or (None, None)
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("PG")}
        return subprocess.run(
            command,
            check=False,
            text=True,
            stdin=subprocess.DEVNULL,
            stdout=stdout,
            stderr=stderr,
            cwd=folder,
            env=inherited | {"LC_ALL": "C.UTF-8", "TZ": "UTC"} | dict(environment or {}),
            user=uid_after,
            group=gid_after,
            extra_groups=[] if self.substitute else None,
        )

    def reaches(self, folder: Path) -> bool:
        """Whether the account can enter the folder: tried, because rights depend on every folder above it too."""
        try:
            return self.run(["/bin/sh", "-c", 'cd -- "$1"', "sh", str(folder)]).returncode == 0
        except (OSError, subprocess.SubprocessError):
            return False

    def own(self, path: Path) -> None:
        """Makes the path the account's (only root ever has to)."""
        status = path.lstat()
        if (status.st_uid, status.st_gid) != (self.uid, self.gid) and os.geteuid() == 0:
            os.chown(path, self.uid, self.gid, follow_symlinks=False)

    def own_all(self, folder: Path) -> None:
        """As ``own`` for a whole tree, when its top is not the account's: the checkout moved, or was copied."""
        if folder.lstat().st_uid == self.uid:
            return
        for path in [folder, *folder.rglob("*")]:
            self.own(path)


def caller() -> Account:
    """Whoever runs this process."""
    return Account(os.geteuid(), os.getegid())


def choose_account(folder: Path) -> Account | None:
    """The account that can run a server in ``folder`` (which exists); None if there is none for this folder.

    Root tries another account first, and where that account cannot reach the folder (a checkout below a 0700 folder),
    a user namespace, in which root's files belong to the account.

    Raises:
        ClusterError: an ordinary user who does not own the cluster.
    """
    if os.geteuid() != 0:
        owner = folder.stat().st_uid
        if owner != os.geteuid():
            raise ClusterError(
                f"The cluster in {folder} belongs to the user with id {owner}.",
                mend="Run as that user, or set LANEWRIGHT_HOME to a folder of your own.",
            )
        return caller()
    entries = [entry for name in CANDIDATES if (entry := _passwd(name)) is not None]
    others = [Account(entry.pw_uid, entry.pw_gid, substitute=(entry.pw_uid, entry.pw_gid)) for entry in entries]
    mapped = [Account(0, 0, namespace=(entry.pw_uid, entry.pw_gid)) for entry in entries]
    return next((account for account in [*others, *mapped] if account.reaches(folder.parent)), None)


def _passwd(name: str) -> pwd.struct_passwd | None:
    try:
        return pwd.getpwnam(name)
    except KeyError:
        return None
