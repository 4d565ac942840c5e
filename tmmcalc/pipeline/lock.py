"""A lock on an output folder: one process at a time reads or writes the files of a stage.

The system drops the lock when its process ends, however it ends, so a killed run never blocks the next.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

LOCK_NAME = ".lock"


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """Hold the lock of ``folder`` inside the block, waiting for it as long as it takes.

    Raises OSError if the folder is missing, read-only, or on a file system without locks.
    """
    with (folder / LOCK_NAME).open("ab") as file:
        _acquire(file)
        try:
            yield
        finally:
            _release(file)


def locked_at_once(file: BinaryIO) -> bool:
    """Lock an open file until it is closed, without waiting; return False if another process has it."""
    try:
        _try(file)
    except OSError:
        return False
    return True


if sys.platform == "win32":
    import msvcrt
    from errno import EDEADLOCK

    def _acquire(file: BinaryIO) -> None:
        """Lock the first byte; msvcrt gives up after ten seconds with OSError, so ask again."""
        while True:
            try:
                file.seek(0)
                msvcrt.locking(file.fileno(), msvcrt.LK_LOCK, 1)
            except OSError as error:
                if error.errno != EDEADLOCK:
                    raise
            else:
                return

    def _try(file: BinaryIO) -> None:
        file.seek(0)
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)

    def _release(file: BinaryIO) -> None:
        file.seek(0)
        msvcrt.locking(file.fileno(), msvcrt.LK_UNLCK, 1)

else:
    import fcntl

    def _acquire(file: BinaryIO) -> None:
        fcntl.flock(file, fcntl.LOCK_EX)

    def _try(file: BinaryIO) -> None:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)

    def _release(file: BinaryIO) -> None:
        fcntl.flock(file, fcntl.LOCK_UN)
