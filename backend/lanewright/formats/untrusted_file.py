"""Reading files that nobody vouches for: only inside their folder, only regular files, only up to a size."""

from __future__ import annotations

from pathlib import Path

from lanewright.core.errors import InvalidInput, Place

MEBIBYTE = 1024 * 1024


def read_bytes(path: Path, *, most_bytes: int, name: str | None = None) -> bytes:
    """The whole file, its size checked before and after reading (it may grow meanwhile).

    Args:
        name: how errors call the file; its own name if not given.

    Raises:
        InvalidInput: it is missing, not a regular file, not readable or larger than ``most_bytes``.
    """
    place = Place(file=name or path.name)
    try:
        if not path.is_file():
            problem = "is not a regular file" if path.exists() else "is missing"
            raise InvalidInput(problem, "Copy the log again.", place)
        size = path.stat().st_size
        if size <= most_bytes:
            with path.open("rb") as file:
                data = file.read(most_bytes + 1)
            size = len(data)
    except OSError as error:
        raise InvalidInput(f"cannot be read ({error.strerror})", "Check the file and its permissions.", place) from None
    if size > most_bytes:
        raise InvalidInput(
            f"is {size / MEBIBYTE:.1f} MiB, more than the {most_bytes / MEBIBYTE:g} MiB allowed",
            "Check that it is the right file.",
            place,
        )
    return data


def read_given_bytes(path: Path, *, most_bytes: int) -> bytes:
    """The whole file at a path that a person gave; errors call it by that path. Raises InvalidInput as above."""
    if not path.is_file():
        problem = "is not a file" if path.exists() else "is missing"
        raise InvalidInput(problem, "Check the path.", Place(file=str(path)))
    return read_bytes(path, most_bytes=most_bytes, name=str(path))


def require_inside(path: Path, root: Path) -> None:
    """Refuse a path that leads out of its log folder, e.g. through a symlink.

    Raises:
        InvalidInput: names the path below the folder and where it leads is not inside.
    """
    if not path.resolve().is_relative_to(root.resolve()):
        raise InvalidInput(
            "leads out of the log folder",
            "Replace the symlink by the file itself.",
            Place(file=str(path.relative_to(root))),
        )
