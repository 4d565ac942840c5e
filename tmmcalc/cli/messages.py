"""Where text goes: results to standard output; errors, warnings and progress to standard error.

Colour only on a terminal. A reader that has gone (``| head -1``) ends the text, not the command.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, TextIO

if TYPE_CHECKING:
    from pathlib import Path

    from tmmcalc.core.errors import TmmError
    from tmmcalc.pipeline.outcome import Event

_COLOURS = {"red": "31", "yellow": "33", "dim": "2"}


@contextmanager
def whoever_reads(stream: TextIO) -> Iterator[None]:
    """Write and flush inside the block; if the reader of the pipe has gone, the rest goes nowhere."""
    try:
        yield
        stream.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def put(text: str) -> None:
    """Write a result to standard output."""
    with whoever_reads(sys.stdout):
        sys.stdout.write(text)


def say(text: str, colour: str = "") -> None:
    """Write one message to standard error, wrapped at words if that is a terminal."""
    if sys.stderr.isatty():
        text = _wrapped(text)
        if colour and "NO_COLOR" not in os.environ:
            text = f"\033[{_COLOURS[colour]}m{text}\033[0m"
    with whoever_reads(sys.stderr):
        sys.stderr.write(f"{text}\n")


def _wrapped(text: str) -> str:
    """Lines that are too long for the window, continued with their own indent and two spaces more."""
    from shutil import get_terminal_size
    from textwrap import wrap

    width = max(get_terminal_size().columns, 40)
    pieces = []
    for line in text.split("\n"):
        indent = " " * (len(line) - len(line.lstrip()) + 2)
        pieces += wrap(line, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False) or [""]
    return "\n".join(pieces)


def show_error(error: TmmError) -> None:
    """The one message of a user's fault."""
    say(f"error: {error}", "red")


def show_event(event: Event) -> None:
    """One line a stage."""
    if event.kind == "damaged":
        show_damage(event)
    elif event.kind == "left out":
        say(f"{event.stage}: left out ({event.message})", "dim")
    elif event.kind == "failed":
        say(f"{event.stage}: {event.message}", "red")
    else:
        say(f"{event.stage}: {event.kind} in {event.seconds * 1000:.0f} ms ({event.message})", "dim")


def show_damage(event: Event) -> None:
    """The one event that is said even when all else is quiet: a stored file is not what was written."""
    if event.kind == "damaged":
        say(f"warning: {event.stage}: {event.message}", "yellow")


def note_written(*files: Path) -> None:
    """Say which files were written."""
    say(f"wrote {' and '.join(map(str, files))}", "dim")
