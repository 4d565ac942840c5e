"""The columns of the reduction table; of a driven slider forces and masses stand for moments and inertias.

M_red, F_red           reduced moment (force) of everything; M_red_Q, M_red_weight, M_red_friction ... of each cause
P_red                  power of everything at the mean speed
eta                    instant efficiency, blank where nothing useful is done
J_red, m_red           reduced inertia (mass) of the links; dJ_red, dm_red its derivative against the input coordinate
J_lumped, m_lumped     the same with the masses of rods placed statically in their pins; where J_red has them there
J_exact, m_exact       the same with the rods as they are
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from tmmcalc.core.columns import Column
from tmmcalc.linkage.columns import phi_column
from tmmcalc.machine.reduction.efficiency import efficiency
from tmmcalc.machine.reduction.results import Contribution, Reduction

EFFICIENCY = "eta"  # the column that has blanks


def columns(result: Reduction) -> list[Column]:
    """All columns of a result in their usual order."""
    return [phi_column(result.phi, result.turns), *_moments(result), *_powers(result), *_inertias(result)]


def cells(result: Reduction, column: Column) -> list[float | str]:
    """The values of a column (n,), blank where an efficiency has none."""
    values = column.make().tolist()
    if column.name != EFFICIENCY:
        return values
    return [value if known else "" for value, known in zip(values, efficiency(result)[1].tolist(), strict=True)]


def contribution_name(result: Reduction, contribution: Contribution) -> str:
    """Name of a contribution in columns: its own, with its kind where a spring also damps."""
    twice = sum(other.name == contribution.name for other in result.contributions) > 1
    return f"{contribution.name}_{contribution.kind}" if twice else contribution.name.replace(" ", "_")


def _moments(result: Reduction) -> Iterator[Column]:
    letter, unit = ("M", "N*m") if result.turns else ("F", "N")
    yield Column(f"{letter}_red", unit, lambda: result.total)
    for k, contribution in enumerate(result.contributions):
        name = contribution_name(result, contribution)
        yield Column(f"{letter}_red_{name}", unit, partial(result.moment.__getitem__, k))


def _powers(result: Reduction) -> Iterator[Column]:
    yield Column("P_red", "W", lambda: result.total * result.speed)
    if any(contribution.kind == "load" for contribution in result.contributions):
        yield Column(EFFICIENCY, "-", lambda: efficiency(result)[0])


def _inertias(result: Reduction) -> Iterator[Column]:
    letter, unit, per = ("J", "kg*m^2", "kg*m^2/rad") if result.turns else ("m", "kg", "kg/m")
    other, beside = result.other, "lumped" if result.rods == "exact" else "exact"
    yield Column(f"{letter}_red", unit, lambda: result.inertia)
    yield Column(f"d{letter}_red", per, lambda: result.slope)
    if other is not None:
        yield Column(f"{letter}_{beside}", unit, lambda: other)
