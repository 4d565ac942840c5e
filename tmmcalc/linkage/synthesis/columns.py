"""The columns of the table of solutions: number, sizes in m and deg, figures of merit, number of defects."""

from __future__ import annotations

from tmmcalc.core.quantity import in_degrees, quantity_of
from tmmcalc.linkage.synthesis.results import Design, Synthesis


def columns(result: Synthesis) -> dict[str, list[float] | list[str]]:
    """Columns by header, one row a solution; all solutions of a kind have the same sizes."""
    found: dict[str, list[float] | list[str]] = {"i": [str(k + 1) for k in range(len(result.designs))]}
    for size in result.best.sizes:
        found[size.told.key] = [design.size(size.symbol) for design in result.designs]
    for name in result.best.merits:
        found[name] = [design.merits[name] for design in result.designs]
    found[quantity_of(Design, "defects").key] = [float(len(design.defects)) for design in result.designs]
    return in_degrees(found)
