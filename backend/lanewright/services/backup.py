"""Everything that is stored, in one file and back: PostgreSQL's own dump, restored in one transaction."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from alembic.util.exc import CommandError
from sqlalchemy import text

from lanewright.cluster import ClusterError
from lanewright.cluster.programs import find_programs
from lanewright.core.errors import Conflict, InvalidInput, LanewrightError, Place
from lanewright.db.engine import engine_for
from lanewright.db.migration import migrate

_CHUNK_BYTES = 1024 * 1024
_EMPTY_DATABASE = """
DO $$
DECLARE statement text;
BEGIN
  FOREACH statement IN ARRAY (
    SELECT coalesce(array_agg(format('DROP %s IF EXISTS %s CASCADE', kind, name) ORDER BY position), '{}') FROM (
      SELECT CASE relkind WHEN 'v' THEN 'VIEW' WHEN 'm' THEN 'MATERIALIZED VIEW' WHEN 'S' THEN 'SEQUENCE'
               ELSE 'TABLE' END AS kind,
             CASE relkind WHEN 'S' THEN 2 ELSE 1 END AS position,
             oid::regclass::text AS name, 'pg_class'::regclass AS class, oid
        FROM pg_class WHERE relnamespace = 'public'::regnamespace AND relkind IN ('r', 'p', 'v', 'm', 'S')
      UNION ALL
      SELECT 'ROUTINE', 3, oid::regprocedure::text, 'pg_proc'::regclass, oid
        FROM pg_proc WHERE pronamespace = 'public'::regnamespace
      UNION ALL
      SELECT 'TYPE', 4, oid::regtype::text, 'pg_type'::regclass, oid
        FROM pg_type WHERE typnamespace = 'public'::regnamespace
         AND (typtype IN ('e', 'd') OR (SELECT relkind FROM pg_class WHERE pg_class.oid = typrelid) = 'c')
    ) AS object
    WHERE NOT EXISTS (SELECT FROM pg_depend WHERE classid = class AND objid = object.oid AND deptype = 'e')
  ) LOOP
    EXECUTE statement;
  END LOOP;
END $$;
"""
"""Drops what is ours and leaves the extensions (PostGIS) alone."""


def backup(url: str, file: Path) -> int:
    """Writes the database as it stands at one moment; returns the file's size in bytes. Others may go on working.

    Raises:
        InvalidInput: the file cannot be written.
        ClusterError: pg_dump is not installed, or fails.
    """
    partial = file.with_name(f"{file.name}.partial")
    try:
        # Password hashes are in it: only its owner may read it.
        with os.fdopen(os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "wb") as out:
            made = subprocess.run(
                [_program("pg_dump"), "--format=custom", "--no-owner", "--no-privileges", f"--dbname={url}"],
                stdout=out,
                stderr=subprocess.PIPE,
                check=False,
            )
            out.flush()
            os.fsync(out.fileno())
        if made.returncode != 0:
            raise ClusterError(f"pg_dump failed: {_first_line(made.stderr)}", mend="See the message; nothing was kept.")
        partial.rename(file)
    except OSError as error:
        raise InvalidInput(
            f"cannot be written ({error.strerror})", "Name a file in a folder of yours.", Place(file=str(file))
        ) from None
    finally:
        partial.unlink(missing_ok=True)
    return file.stat().st_size


def restore(url: str, file: Path, *, force: bool) -> None:
    """Makes the database what the backup holds, and brings it to this version's tables. All or nothing.

    Args:
        force: replace what the database holds.

    Raises:
        InvalidInput: the file is no backup, or broken; the database is as before.
        Conflict: the database holds logs or people already, and ``force`` was not given.
        LanewrightError: the backup is of a newer version.
    """
    if not file.is_file():
        raise InvalidInput("is no file", "Name a file that lanewright backup wrote.", Place(file=str(file)))
    if not force and _is_used(url):
        raise Conflict(
            "The database holds logs or people already.",
            mend="Restore into an empty database, or replace everything in this one with --force.",
            code="restore.not_empty",
        )
    engine_for(url).dispose()
    _replace(url, file)
    try:
        migrate(url)
    except CommandError as error:
        raise LanewrightError(
            f"The backup is of a newer version of Lanewright ({error}).",
            mend="It was restored; use that version with it.",
            code="restore.newer",
        ) from None


def _replace(url: str, file: Path) -> None:
    """Drop and restore in one transaction of psql, which ends well only after pg_restore has."""
    psql = [
        _program("psql"),
        "--no-psqlrc",
        "--quiet",
        "--set=ON_ERROR_STOP=1",
        "--single-transaction",
        "--file=-",
        url,
    ]
    script = [_program("pg_restore"), "--no-owner", "--no-privileges", "--no-comments", "--file=-", str(file)]
    with (
        tempfile.TemporaryFile() as complaints,
        subprocess.Popen(script, stdout=subprocess.PIPE, stderr=complaints) as reader,
        subprocess.Popen(psql, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=complaints) as writer,
    ):
        if reader.stdout is None or writer.stdin is None:
            raise RuntimeError("pipes were asked for")
        broken = False
        try:
            writer.stdin.write(_EMPTY_DATABASE.encode())
            while piece := reader.stdout.read(_CHUNK_BYTES):
                writer.stdin.write(piece)
        except BrokenPipeError:
            broken = True
        finally:
            reader.stdout.close()
            if reader.wait() != 0 or broken:
                writer.kill()  # before its input ends: then nothing is committed
        try:
            writer.stdin.close()
        except BrokenPipeError:
            broken = True
        failed = writer.wait() != 0 or broken
        complaints.seek(0)
        if failed:
            raise InvalidInput(
                f"cannot be restored: {_first_line(complaints.read())}",
                "Nothing was changed. Name a whole file that lanewright backup wrote.",
                Place(file=str(file)),
            )


def _is_used(url: str) -> bool:
    with engine_for(url).connect() as connection:
        for table in ("log", "account"):
            if not connection.execute(text("SELECT to_regclass(:name) IS NOT NULL"), {"name": table}).scalar_one():
                continue
            if connection.execute(text(f"SELECT EXISTS (SELECT FROM {table})")).scalar_one():  # noqa: S608 (our names)
                return True
    return False


def _program(name: str) -> str:
    """A client program: the server's own where one is installed here, else the one on the path.

    Raises:
        ClusterError: there is none.
    """
    try:
        return find_programs()[name]
    except ClusterError:
        found = shutil.which(name)
        if found is None:
            raise ClusterError(
                f"{name} is not installed.", mend="Install the package postgresql-client of the server's version."
            ) from None
        return found


def _first_line(output: bytes) -> str:
    lines = [line for line in output.decode(errors="replace").splitlines() if line.strip()]
    return lines[0] if lines else "no reason was given"
