"""Checks that reach across the tables of a spec.

Each check is a function from the outline of the raw document to its findings; a new one joins by one line in the
``CHECKS`` of its module. They never raise: what is not of the right type is left to the tables' own types.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from typing import TYPE_CHECKING

from tmmcalc.project.subject import NEEDS_MECHANISM, check_criteria, check_needs, check_subject
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw
from tmmcalc.spec.phrases import Path

if TYPE_CHECKING:
    from tmmcalc.project.files import Rows

Check = Callable[[Outline], Iterator[Finding]]

ALWAYS: tuple[Check, ...] = (check_subject, check_needs, check_criteria)

# Modules with the checks of a table, imported only when a spec has it.
_OF_TABLE = {
    "mechanism": ("linkage.tables.checks.mechanism",),
    "synthesis": (
        "linkage.tables.checks.synthesis",
        "linkage.tables.checks.dwell",
    ),
    "torque": ("machine.tables.checks.torque",),
    "loads": (
        "linkage.tables.checks.loads",
        "linkage.tables.checks.windows",
        "linkage.tables.checks.curves",
        "linkage.tables.checks.indicator",
    ),
    "springs": ("linkage.tables.checks.springs",),
    "drive": ("linkage.tables.checks.drive",),
    "motor": ("machine.tables.checks.motor",),
    "shafts": ("machine.tables.checks.shafts",),
    "motion": ("machine.tables.checks.motion",),
    "transients": ("machine.tables.checks.transients",),
    "unsteady": ("linkage.tables.checks.unsteady",),
    "manipulator": (
        "manipulators.tables.checks.manipulator",
        "manipulators.tables.checks.path",
        "manipulators.tables.checks.joints",
        "manipulators.tables.checks.zones",
    ),
    "flywheel": ("machine.tables.checks.flywheel",),
    "balance": ("machine.tables.checks.balance",),
    "engine": ("machine.tables.checks.engine",),
    "rotor": ("machine.tables.checks.rotor",),
    "train": ("gears.tables.checks.train",),
    "gearing": ("gears.tables.checks.gearing",),
    "criteria": ("gears.tables.checks.criteria",),
    "strength": ("gears.tables.checks.strength",),
    "pair": ("gears.tables.checks.pair",),
    "cam": (
        "cams.tables.checks.cam",
        "cams.tables.checks.cam_laws",
        "cams.tables.checks.cam_sizes",
        "cams.tables.checks.cam_loads",
        "cams.tables.checks.cam_search",
    ),
    "indexing": ("cams.tables.checks.indexing",),
    "vibrator": ("vibration.tables.checks.vibrator",),
    "pendulum": ("vibration.tables.checks.pendulum",),
    "contact": ("extras.tables.checks.extras",),
    "reliability": ("extras.tables.checks.extras",),
    "tie_down": ("extras.tables.checks.extras",),
    "falling_ball": ("extras.tables.checks.extras",),
    "bearing": ("extras.tables.checks.extras",),
    "constraints": ("feasibility.tables.checks.constraints",),
    "feasibility": ("feasibility.tables.checks.feasibility",),
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
                yield from import_module(f"tmmcalc.{module}").CHECKS
