"""What is found of the ready specs, once for all tests of names and notes."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec


@cache
def solved(spec: Path) -> RunResult:
    """All stages of a spec; where one has no solution, those that do not read it."""
    return run(load_spec(spec), keep_going=True)
