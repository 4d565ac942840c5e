"""The command line: flags in, one call of the API, one document out. No formulas live here."""

from __future__ import annotations

import gc
import os
import sys


def main() -> None:
    """Entry point of the console script: turns the user's faults into one message and an exit code."""
    _start_quickly()
    from tmmcalc.core.errors import TmmError

    try:
        from tmmcalc.cli.app import app

        app(prog_name="tmmcalc")
    except TmmError as error:
        from tmmcalc.cli.messages import show_error

        show_error(error)
        sys.exit(error.exit_code)
    except KeyboardInterrupt:  # while the program still loads; later typer gives the same code
        sys.exit(130)


def _start_quickly() -> None:
    """Most of a short command is imports; what only slows them down is turned off.

    The collector would walk the new modules again and again and find nothing to free. Pydantic would search all
    installed packages for plugins, which have no say in a spec. OpenBLAS would start a pool of threads with
    numpy, which takes a third of numpy's import and never pays for matrices as small as ours.
    """
    gc.set_threshold(50_000, 20, 20)
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "1")
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
