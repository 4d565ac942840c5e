"""The checks of ``[mechanism]``, in the order in which their findings are told."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmmcalc.spec.findings import Finding

from .assembly import check_sketch, check_variants
from .drive import check_dimensions, check_grid, check_joint, check_prismatic_input, check_reach
from .joints import check_friction, check_lines, check_links, check_names, check_pins
from .links import (
    check_ambiguous,
    check_connected,
    check_ids,
    check_lengths,
    check_masses,
    check_reserved_names,
)
from .outline import Outline
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
    check_friction,
    check_joint,
    check_dimensions,
    check_prismatic_input,
    check_grid,
    check_reach,
    check_outputs,
    check_sketch,
    check_variants,
)
