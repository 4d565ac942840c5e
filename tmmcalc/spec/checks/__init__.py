"""Checks that reach across the tables of a spec.

Each check is a function from the outline of the raw mechanism to its findings; a new one joins by one
line in ``CHECKS``. They never raise: what is not of the right type is left to the tables' own types.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import Path

from .assembly import check_sketch, check_variants
from .drive import check_dimensions, check_grid, check_joint, check_prismatic_input, check_reach
from .joints import check_lines, check_links, check_names, check_pins
from .links import (
    check_ambiguous,
    check_connected,
    check_ids,
    check_lengths,
    check_masses,
    check_reserved_names,
)
from .outline import Outline, Raw, subtable
from .outputs import check_outputs

CHECKS: tuple[Callable[[Outline], Iterator[Finding]], ...] = (
    check_ids,
    check_reserved_names,
    check_masses,
    check_connected,
    check_lengths,
    check_ambiguous,
    check_names,
    check_links,
    check_pins,
    check_lines,
    check_joint,
    check_dimensions,
    check_prismatic_input,
    check_grid,
    check_reach,
    check_outputs,
    check_sketch,
    check_variants,
)


def check(data: Raw, line_of: Callable[[Path], int | None]) -> list[Finding]:
    """Return the findings of all checks on the raw document; ``line_of`` gives the line of a place."""
    outline = Outline(subtable(data, "mechanism"), line_of)
    return [finding for rule in CHECKS for finding in rule(outline)]
