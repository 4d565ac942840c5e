"""A lock on an output folder: one process at a time reads or writes the files of a stage.

The system drops the lock when its process ends, however it ends, so a killed run never blocks the next.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import monotonic, sleep
from typing import BinaryIO

from tmmcalc.core.errors import UsageError
from tmmcalc.core.files import open_own

LOCK_NAME = ".lock"
WAIT = 60.0  # seconds: a run holds the lock for some milliseconds at a time
PATIENCE = 0.3  # seconds before anything is said
STEP = 0.02  # seconds between two tries


@contextmanager
def locked(folder: Path, wait: float = WAIT, waiting: Callable[[float], None] = lambda seconds: None) -> Iterator[None]:
    """Hold the lock of ``folder`` inside the block, waiting for it up to ``wait`` seconds.

    ``waiting`` is told once, with these seconds, that another process has it. Raises UsageError if it keeps it, OSError
    if the folder is missing, read-only, or on a file system without locks.
    """
    with os.fdopen(open_own(folder / LOCK_NAME, os.O_WRONLY | os.O_APPEND), "ab") as file:
        _acquire(file, folder, wait, waiting)
        try:
            yield
        finally:
            _release(file)


def locked_at_once(file: BinaryIO) -> bool:
    """Lock an open file until it is closed, without waiting; return False if another process has it."""
    try:
        _try(file)
    except OSError as error:
        if error.errno not in _HELD:
            raise
        return False
    return True


def _acquire(file: BinaryIO, folder: Path, wait: float, waiting: Callable[[float], None]) -> None:
    began, told = monotonic(), False
    while not locked_at_once(file):
        waited = monotonic() - began
        if waited >= wait:
            raise UsageError(
                f"{folder}: another process works in this folder, and has not ended within {wait:g} s",
                value=waited,
                limit=wait,
                remedy="wait for its end, give it longer by --wait SECONDS, or choose another output folder",
            )
        if not told and waited >= min(PATIENCE, wait / 2):
            waiting(wait)
            told = True
        sleep(min(STEP, wait - waited))


if sys.platform == "win32":
    import msvcrt
    from errno import EACCES, EDEADLOCK

    _HELD = (EACCES, EDEADLOCK)  # how the system says that another process has it

    def _try(file: BinaryIO) -> None:
        file.seek(0)
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)

    def _release(file: BinaryIO) -> None:
        file.seek(0)
        msvcrt.locking(file.fileno(), msvcrt.LK_UNLCK, 1)

else:
    import fcntl
    from errno import EACCES, EAGAIN

    _HELD = (EACCES, EAGAIN)

    def _try(file: BinaryIO) -> None:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)

    def _release(file: BinaryIO) -> None:
        fcntl.flock(file, fcntl.LOCK_UN)
