"""A fault before it has a line: what pydantic's report and the checks both produce."""

from __future__ import annotations

from typing import NamedTuple

from tmmcalc.spec.phrases import Path


class Finding(NamedTuple):
    """One fault of the raw mapping: its place, what is wrong, what to write instead."""

    path: Path
    message: str
    remedy: str = ""
