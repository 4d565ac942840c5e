"""The checks of ``[mechanism]``, in the order in which their findings are told."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmmcalc.linkage.tables.checks.assembly import check_sketch, check_variants
from tmmcalc.linkage.tables.checks.input import (
    check_dimensions,
    check_followed,
    check_grid,
    check_joint,
    check_prismatic_input,
    check_reach,
    check_speed,
)
from tmmcalc.linkage.tables.checks.joints import check_friction, check_lines, check_links, check_names, check_pins
from tmmcalc.linkage.tables.checks.links import (
    check_ambiguous,
    check_connected,
    check_ids,
    check_lengths,
    check_masses,
    check_reserved_names,
)
from tmmcalc.linkage.tables.checks.outputs import check_outputs
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline

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
    check_speed,
    check_dimensions,
    check_followed,
    check_prismatic_input,
    check_grid,
    check_reach,
    check_outputs,
    check_sketch,
    check_variants,
)
