"""Checks that reach across the tables of a spec.

Each check is a function from the outline of the raw document to its findings; a new one joins by one line in the
``CHECKS`` of its module. They never raise: what is not of the right type is left to the tables' own types.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from typing import TYPE_CHECKING

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import Path

from .outline import Outline, Raw
from .subject import NEEDS_MECHANISM, check_criteria, check_needs, check_subject

if TYPE_CHECKING:
    from tmmcalc.spec.files import Rows

Check = Callable[[Outline], Iterator[Finding]]

ALWAYS: tuple[Check, ...] = (check_subject, check_needs, check_criteria)

# Modules with the checks of a table, imported only when a spec has it.
_OF_TABLE = {
    "mechanism": ("mechanism",),
    "synthesis": ("linksynthesis", "dwell"),
    "torque": ("torque",),
    "loads": ("loads", "windows", "curves", "indicator"),
    "springs": ("springs",),
    "drive": ("gear",),
    "motor": ("motor",),
    "shafts": ("shafts",),
    "motion": ("motion",),
    "transients": ("transients",),
    "unsteady": ("unsteady",),
    "manipulator": ("manipulator", "manipulatorpath", "manipulatorjoints", "manipulatorzones"),
    "flywheel": ("flywheel",),
    "balance": ("balance",),
    "engine": ("engine",),
    "rotor": ("rotor",),
    "train": ("train",),
    "gearing": ("gearing",),
    "criteria": ("criteria",),
    "strength": ("strength",),
    "pair": ("pair",),
    "cam": ("cam", "camlaws", "camsizes", "camloads", "camsearch"),
    "indexing": ("indexing",),
    "vibrator": ("vibrator",),
    "pendulum": ("pendulum",),
    "contact": ("extras",),
    "reliability": ("extras",),
    "tie_down": ("extras",),
    "falling_ball": ("extras",),
    "bearing": ("extras",),
    "constraints": ("constraints",),
    "feasibility": ("feasibility",),
}


def check(data: Raw, line_of: Callable[[Path], int | None], rows: Mapping[Path, Rows]) -> list[Finding]:
    """Return the findings of all checks on the raw document.

    ``line_of`` gives the line of a place, ``rows`` what was read from the CSV files of load tables.
    """
    outline = Outline(data, line_of, rows)
    return [finding for rule in (*ALWAYS, *_of_tables(data)) for finding in rule(outline)]


def _of_tables(data: Raw) -> Iterator[Check]:
    """Yield the checks of the tables that are there; without a mechanism one fault of what needs it is enough."""
    for table, modules in _OF_TABLE.items():
        if table in data and ("mechanism" in data or table not in NEEDS_MECHANISM):
            for module in modules:
                yield from import_module(f".{module}", __name__).CHECKS
