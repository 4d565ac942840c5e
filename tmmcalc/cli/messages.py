"""What goes to standard error: errors, warnings, the progress of stages. Colour only on a terminal."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.errors import TmmError
    from tmmcalc.pipeline.outcome import Event

_COLOURS = {"red": "31", "yellow": "33", "dim": "2"}


def say(text: str, colour: str = "") -> None:
    """Write one line to standard error."""
    if colour and sys.stderr.isatty() and "NO_COLOR" not in os.environ:
        text = f"\033[{_COLOURS[colour]}m{text}\033[0m"
    print(text, file=sys.stderr)


def show_error(error: TmmError) -> None:
    """The one message of a user's fault."""
    say(f"error: {error}", "red")


def show_event(event: Event) -> None:
    """One line a stage."""
    if event.kind == "damaged":
        say(f"warning: {event.stage}: {event.message}", "yellow")
    else:
        say(f"{event.stage}: {event.kind} ({event.message}) {event.seconds * 1000:.0f} ms", "dim")
