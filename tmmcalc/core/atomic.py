"""Files that are either old or new, never half of one.

The new content goes to a temporary file in the same folder and takes the name in one step, so a killed run leaves
one of them. What could be damaged by a loss of power without being noticed is forced to the disk before. A file that
has this content already is left alone, so its time stamp tells make the truth.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import NoFileError, other_kind

_LEFTOVER = re.compile(r"\..+\.(toml|npz|csv|xlsx)\.\d+\.tmp")


@contextmanager
def blamed_on(path: Path, action: str) -> Iterator[None]:
    """Turn an OSError (disk full, read-only folder, a file in place of a folder) into UsageError."""
    try:
        yield
    except OSError as error:
        raise UsageError(
            f"{path}: cannot be {action}: {error.strerror or error}",
            remedy="free the disk, change the permissions or choose another output folder",
        ) from error


def replace_file(path: Path, data: bytes, sealed: bool = False) -> bool:
    """Give the file this content in one step; return False if it had it already and was not touched.

    A ``sealed`` file is vouched for by a digest and is computed again where that does not fit: the system may take its
    time to bring it to the disk. Raises UsageError if the file cannot be written; the old one is then still whole.
    """
    with blamed_on(path, "written"):
        if _holds(path, data):
            return False
        if kind := other_kind(path):  # as root a rename would take the place of a device for good
            raise NoFileError(path, kind)
        temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
        temporary.unlink(missing_ok=True)
        try:
            _write(temporary, data, through=not sealed)
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
        return True


def remove_leftovers(folder: Path) -> None:
    """Remove the temporary files of killed runs; the caller must hold the lock of the folder."""
    for entry in folder.iterdir():
        if _LEFTOVER.fullmatch(entry.name):
            entry.unlink(missing_ok=True)


def _holds(path: Path, data: bytes) -> bool:
    return path.is_file() and path.stat().st_size == len(data) and path.read_bytes() == data


def _write(path: Path, data: bytes, through: bool) -> None:
    with path.open("xb") as file:  # new: what somebody has put there, such as a link, is not written
        file.write(data)
        if through:
            file.flush()
            os.fsync(file.fileno())
