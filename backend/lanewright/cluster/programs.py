"""Finds PostgreSQL's server programs: only an installation that has PostGIS beside it will do."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from lanewright.cluster.errors import ClusterError

REQUIRED_EXTENSIONS = ("postgis", "btree_gist")
OLDEST_MAJOR = 15


@dataclass(frozen=True)
class Programs:
    """The folder of one server's programs and its major version."""

    folder: Path
    major: int

    def __getitem__(self, name: str) -> str:
        return str(self.folder / name)


def find_programs(major: int | None = None) -> Programs:
    """The newest server with PostGIS; with ``major``, the one that can run an existing data directory.

    ``LANEWRIGHT_POSTGRES_BIN`` names the folder outright.

    Raises:
        ClusterError: none is installed.
    """
    found = [programs for folder in _folders() if (programs := _inspect(folder)) is not None]
    fitting = [programs for programs in found if (programs.major == major if major else programs.major >= OLDEST_MAJOR)]
    if fitting:
        return max(fitting, key=lambda programs: programs.major)
    wanted = f"PostgreSQL {major}" if major else f"PostgreSQL {OLDEST_MAJOR} or later"
    raise ClusterError(
        f"No {wanted} with PostGIS is installed.",
        mend=(
            f"Run scripts/debian_packages.sh run as root, or install postgresql-{major or OLDEST_MAJOR}-postgis-3, "
            "or set DATABASE_URL to a PostGIS database."
        ),
    )


def _folders() -> list[Path]:
    named = os.environ.get("LANEWRIGHT_POSTGRES_BIN")
    if named:
        return [Path(named)]
    folders = sorted(Path("/usr/lib/postgresql").glob("*/bin"))
    on_path = shutil.which("initdb")
    if on_path:
        folders.append(Path(on_path).resolve().parent)
    return folders


def _inspect(folder: Path) -> Programs | None:
    """None unless the folder holds a server whose share folder has every extension we need."""
    try:
        answer = subprocess.run([folder / "postgres", "--version"], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    version = re.search(r"\)\s+(\d+)", answer.stdout)
    if version is None:
        return None
    major = int(version[1])
    has_extensions = any(
        all((share / "extension" / f"{name}.control").is_file() for name in REQUIRED_EXTENSIONS)
        for share in _share_folders(folder, major)
    )
    return Programs(folder, major) if has_extensions else None


def _share_folders(folder: Path, major: int) -> list[Path]:
    shares = [Path(f"/usr/share/postgresql/{major}"), folder.parent / "share", folder.parent / "share/postgresql"]
    try:
        answer = subprocess.run([folder / "pg_config", "--sharedir"], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return shares
    return [Path(answer.stdout.strip()), *shares]
