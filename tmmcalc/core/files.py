"""Files from outside: what is no file, such as a pipe, is refused at once, where reading it would never end."""

from __future__ import annotations

import os
import stat
from errno import EINVAL, ELOOP
from pathlib import Path

_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a pipe",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
    stat.S_IFSOCK: "a socket",
}
_AT_ONCE = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)


class NoFileError(OSError):
    """Something else is in the place of a file; ``kind`` says what."""

    def __init__(self, path: Path, kind: str) -> None:
        self.kind = kind
        super().__init__(EINVAL, f"it is {kind}, not a file", str(path))


def other_kind(path: Path) -> str:
    """What is in the place of a file, such as "a pipe"; empty for a file and for nothing."""
    try:
        return _kind(path.stat())
    except (OSError, ValueError):
        return ""


def read_file(path: Path, most: int | None = None) -> bytes:
    """The content of a file, of a larger one the first ``most`` + 1 bytes; raises OSError, `NoFileError` among them."""
    handle = os.open(path, os.O_RDONLY | _AT_ONCE)
    _check(path, handle)
    with os.fdopen(handle, "rb") as file:
        return file.read() if most is None else file.read(most + 1)


def open_own(path: Path, flags: int) -> int:
    """Open a file that the program itself keeps, made if there is none; return its handle.

    Raises OSError, `NoFileError` among them: for a link too, so that nobody's file elsewhere is written.
    """
    try:
        handle = os.open(path, flags | os.O_CREAT | _AT_ONCE | getattr(os, "O_NOFOLLOW", 0), 0o666)
    except OSError as error:
        if error.errno == ELOOP or path.is_symlink():
            raise NoFileError(path, "a link, which is not followed") from None
        if kind := other_kind(path):
            raise NoFileError(path, kind) from None
        raise
    _check(path, handle)
    return handle


def _check(path: Path, handle: int) -> None:
    """Close what is no file and raise `NoFileError`."""
    if kind := _kind(os.fstat(handle)):
        os.close(handle)
        raise NoFileError(path, kind)


def _kind(found: os.stat_result) -> str:
    return "" if stat.S_ISREG(found.st_mode) else _KINDS.get(stat.S_IFMT(found.st_mode), "something else")
