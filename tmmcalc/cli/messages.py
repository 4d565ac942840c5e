"""Where text goes: results to standard output; errors, warnings and progress to standard error.

Colour only on a terminal. A reader that has gone (``| head -1``) ends the text, not the command. Hidden characters of
names and values are written out.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, TextIO

from tmmcalc.core.errors import UsageError
from tmmcalc.core.printable import printable

if TYPE_CHECKING:
    from pathlib import Path

    from tmmcalc.core.errors import TmmError
    from tmmcalc.pipeline.outcome import Event, RunResult

NAMED = 8  # tables or pictures that are told by their names
_COLOURS = {"red": "31", "yellow": "33", "dim": "2"}


@contextmanager
def whoever_reads(stream: TextIO) -> Iterator[None]:
    """Write and flush inside the block; if the reader of the pipe has gone, the rest goes nowhere.

    Raises UsageError where the text cannot be written, such as to a full disk; of messages nobody could be told.
    """
    try:
        yield
        stream.flush()
    except BrokenPipeError:
        forget(stream)
    except OSError as error:
        forget(stream)
        if stream is not sys.stderr:
            raise unwritable(error) from None


def forget(stream: TextIO) -> None:
    """Let a stream that cannot be written lead nowhere: what it holds would fail again at the end of the program."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def unwritable(error: OSError) -> UsageError:
    """The error of a standard output that cannot be written."""
    return UsageError(
        f"standard output cannot be written: {error.strerror}", remedy="free the disk, or send the output elsewhere"
    )


def put(text: str) -> None:
    """Write a result to standard output."""
    with whoever_reads(sys.stdout):
        sys.stdout.write(printable(text))


def put_bytes(data: bytes) -> None:
    """Write a result that is no text to standard output; raises `UsageError` if that is a terminal."""
    if sys.stdout.isatty():
        raise UsageError(
            "a workbook cannot be shown on a terminal", where="--format xlsx", remedy="send it to a file: > my.xlsx"
        )
    with whoever_reads(sys.stdout):
        sys.stdout.flush()
        sys.stdout.buffer.write(data)


def say(text: str, colour: str = "") -> None:
    """Write one message to standard error, wrapped at words if that is a terminal."""
    text = printable(text)
    if sys.stderr.isatty():
        text = _wrapped(text)
        if colour and "NO_COLOR" not in os.environ:
            text = f"\033[{_COLOURS[colour]}m{text}\033[0m"
    with whoever_reads(sys.stderr):
        sys.stderr.write(f"{text}\n")


def warn(text: str) -> None:
    """Write what is to be known of a result to standard error."""
    say(f"warning: {text}", "yellow")


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


def counted(number: int, thing: str) -> str:
    """So many things in words.

    >>> counted(1, "file"), counted(2, "file")
    ('1 file', '2 files')
    """
    return f"{number} {thing}" if number == 1 else f"{number} {thing}s"


def show_error(error: TmmError) -> None:
    """The one message of a user's fault."""
    say(f"error: {error}", "red")


def show_event(event: Event) -> None:
    """One line a stage."""
    if event.kind in ("damaged", "waiting"):
        show_damage(event)
    elif event.kind in ("left out", "lost"):
        say(f"{event.stage}: left out ({event.message})", "dim")
    elif event.kind == "removed":
        say(f"{event.stage}: {event.message}", "dim")
    elif event.kind == "failed":
        say(f"{event.stage}: {event.message}", "red")
    else:
        say(f"{event.stage}: {event.kind} in {event.seconds * 1000:.0f} ms ({event.message})", "dim")


def show_news(event: Event) -> None:
    """What a person does not expect: not that a stage is loaded or computed, nor that the spec asks for no such one."""
    if event.kind not in ("loaded", "computed", "left out"):
        show_event(event)


def show_damage(event: Event) -> None:
    """What is said even when all else is quiet: a stored file is not what was written, or another process has it."""
    if event.kind == "damaged":
        warn(f"{event.stage}: {event.message}")
    elif event.kind == "waiting":
        say(event.message, "yellow")


def note_written(*files: Path) -> None:
    """Say which files were written."""
    say(f"wrote {' and '.join(map(str, files))}", "dim")


def tell_end(run: RunResult, folder: Path | None, verbose: bool) -> None:
    """How many stages ran and how long, which ``verbose`` has told of each; the files."""
    if not verbose:
        done = {kind: [event for event in run.events if event.kind == kind] for kind in ("computed", "loaded")}
        told = [f"{counted(len(events), 'stage')} {kind}" for kind, events in done.items() if events]
        seconds = sum(event.seconds for events in done.values() for event in events)
        if told:
            say(f"{', '.join(told)} in {f'{seconds:.1f} s' if seconds >= 1 else f'{seconds * 1000:.0f} ms'}", "dim")
    if run.files:
        say(f"files in {folder}: {', '.join(_named(run.files, verbose))}", "dim")


def _named(files: Sequence[Path], verbose: bool) -> list[str]:
    """The files in words: by name those for people, if they are few; all of them if ``verbose``."""
    if verbose:
        return [file.name for file in files]
    told = []
    for thing, suffix in (("table", ".csv"), ("picture", ".svg")):
        names = [file.name for file in files if file.suffix == suffix]
        told += names if len(names) <= NAMED else [f"{counted(len(names), thing)} ({suffix[1:]})"]
    rest = sum(file.suffix not in (".csv", ".svg") for file in files)
    return [*told, counted(rest, "file") + " of the stages"] if rest else told
