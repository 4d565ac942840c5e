"""The documents of the elastic contact: pressure, approach, area, Hertz beside them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.quantity import keyed
from tmmcalc.extras.columns import contact_columns
from tmmcalc.extras.contact import Contact
from tmmcalc.extras.facts.rows import view_of, with_table
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number
from tmmcalc.report.sizes import quantity


def summary(result: Contact, title: str) -> Document:
    """Pressure, approach and area, with what Hertz has."""
    grid = f"{len(result.x)} nodes at {quantity(result.step, 'm')}, {result.touching} touch; {result.passes} passes"
    facts = [
        Fact("grid", grid, keyed(result, "step", "touching", "passes")),
        Fact(
            "largest pressure",
            f"{quantity(result.peak, 'Pa')} at x = {quantity(result.peak_x, 'm')}, y = {quantity(result.peak_y, 'm')}",
            keyed(result, "peak", "peak_x", "peak_y"),
        ),
        Fact("approach", f"{number(1e6 * result.approach, 6)} um", keyed(result, "approach")),
        Fact("contact area", f"{number(1e6 * result.area, 5)} mm^2", keyed(result, "area")),
        Fact(
            "change from a grid twice as coarse",
            f"pressure {result.peak_change:.1e}, approach {result.approach_change:.1e}; load kept to "
            f"{result.load_error:.0e}",
            keyed(result, "peak_change", "approach_change", "load_error"),
        ),
    ]
    smooth = result.hertz
    if smooth is not None:
        text = f"half-axes {quantity(smooth.along_x, 'm')} along x, {quantity(smooth.along_y, 'm')} along y\n"
        text += f"p0 = {quantity(smooth.peak, 'Pa')}, approach {number(1e6 * smooth.approach, 6)} um"
        text += f"\nhere p_max/p0 = {number(result.peak / smooth.peak, 6)}, "
        text += f"of the approaches {number(result.approach / smooth.approach, 6)}"
        facts.append(Fact("Hertz", text, keyed(smooth)))
    return Document(title, tuple(facts), result.notes)


def document(
    result: Contact,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
) -> Document:
    """The summary with the pressures; people get the nodes on the axis of x."""
    axis = [int(k) for k in np.flatnonzero(np.abs(result.y) < result.step / 4)]
    view = view_of(contact_columns(result), patterns, rows, everything, axis)
    return with_table(summary(result, title), view, everything or rows is not None)
