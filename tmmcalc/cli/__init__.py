"""The command line: flags in, one call of the API, one document out. No formulas live here."""

from __future__ import annotations

import atexit
import errno
import gc
import os
import sys
from importlib import import_module
from typing import Any


def main() -> None:
    """Entry point of the console script: turns the user's faults into one message and an exit code."""
    _start_quickly()
    _open_streams()
    from tmmcalc.core.errors import AccuracyError, TmmError

    try:
        sys.exit(_run() or 0)
    except MemoryError as error:
        from tmmcalc.cli.messages import show_error

        said = f"the computation asks for more memory than there is: {error}".rstrip(": ")
        show_error(AccuracyError(said, remedy="ask for fewer positions, rows, steps or variants"))
        sys.exit(AccuracyError.exit_code)
    except TmmError as error:
        from tmmcalc.cli.messages import show_error

        show_error(error)
        sys.exit(error.exit_code)
    except KeyboardInterrupt:  # while the program still loads; later typer gives the same code
        sys.exit(130)


def _run() -> int | None:
    """Run the command that the arguments name; its exit code, None where it has none of its own."""
    from tmmcalc.cli.app import app
    from tmmcalc.cli.commands import computes
    from tmmcalc.cli.patience import patience

    if computes(sys.argv[1:]):
        _import_numpy()
    try:
        with patience(quiet=not {"-q", "--quiet"}.isdisjoint(sys.argv)):
            code: int | None = app(prog_name="tmmcalc", standalone_mode=False)
    except OSError as error:
        if error.filename is None and error.errno in (errno.ENOSPC, errno.EFBIG, errno.EIO):
            from tmmcalc.cli.messages import forget, unwritable

            forget(sys.stdout)  # a help or a completion, which typer itself writes
            raise unwritable(error) from None
        raise
    except Exception as error:
        if not hasattr(error, "format_message"):  # what typer says of flags: its class depends on its version
            raise
        return _show_usage(error)
    return code


def _show_usage(error: Any) -> int:
    """Show what typer says of flags and arguments, with the hidden characters in them written out."""
    from io import StringIO

    from tmmcalc.cli.messages import say

    told = StringIO()
    error.show(file=told)
    say(told.getvalue().rstrip("\n"))
    code: int = error.exit_code
    return code


def _open_streams() -> None:
    """Let closed streams lead nowhere; characters that a stream has no code for are written out."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8"))
        elif hasattr(stream, "reconfigure"):  # not where the caller reads what is written in this process
            stream.reconfigure(errors="backslashreplace")


def _start_quickly() -> None:
    """Most of a short command is imports; what only slows them down is turned off.

    The collector would walk the new modules again and again and find nothing to free; at the end three times more, to
    give back piece by piece what the system takes back at once, a fifth of a short command. Pydantic would search all
    installed packages for plugins, which have no say in a spec. OpenBLAS would start a pool of threads with
    numpy, which takes a third of numpy's import and never pays for matrices as small as ours.
    """
    gc.set_threshold(1_000_000, 20, 20)  # a command makes fewer objects, a note of a whole project a third of it
    atexit.register(gc.freeze)
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "1")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def _import_numpy() -> None:
    """Numpy first, while few calls are open.

    CPython keeps the frames of calls in pieces of 16 KiB. A loop that calls functions where a piece ends takes the next
    one from the system and gives it back at each turn, and from within a command numpy's import meets that thousands of
    times, for a third of its duration.
    """
    import_module("numpy")
