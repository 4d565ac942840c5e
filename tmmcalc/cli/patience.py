"""What a long command says of itself where no bar shows it: that it is still at it, and how far it is."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from tmmcalc.cli.messages import say
from tmmcalc.core.progress import listening

FIRST = 10.0  # seconds until something is said; from then on whenever the time has doubled


@contextmanager
def patience(*, quiet: bool = False) -> Iterator[None]:
    """Context of a command that tells on standard error, after a while and ever more rarely, that it goes on.

    On a terminal bars do so; a ``quiet`` command says nothing.
    """
    if quiet or sys.stderr.isatty():
        yield
        return
    ended, told = threading.Event(), [""]

    def hear(part: float, words: str) -> None:
        told[0] = f": {100 * part:.0f} %, {words}" if 0 < part < 1 else f": {words}"

    def speak() -> None:
        after = FIRST
        wait = FIRST
        while not ended.wait(wait):
            say(f"still at it after {after:g} s{told[0]}")
            wait, after = after, 2 * after

    speaking = threading.Thread(target=speak, daemon=True)
    speaking.start()
    try:
        with listening(hear):
            yield
    finally:
        ended.set()
        speaking.join()  # or its last line would stand below what the command ends with
