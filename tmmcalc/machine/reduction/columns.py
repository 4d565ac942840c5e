"""The columns of the reduction table; of a driven slider forces and masses stand for moments and inertias."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from tmmcalc.core.columns import Column, column
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.columns import phi_column
from tmmcalc.machine.reduction.efficiency import efficiency
from tmmcalc.machine.reduction.results import Contribution, Reduction

POWER = Quantity("P_red[W]", "power of everything at the mean speed")
EFFICIENCY = Quantity("eta[-]", "instant efficiency, blank where nothing useful is done")


class Reduced(NamedTuple):
    """What is reduced to an input that turns, or that slides."""

    force: str  # in words
    mass: str
    speed: Quantity
    moment: Quantity
    of_cause: Quantity
    mean: Quantity
    inertia: Quantity
    slope: Quantity
    other: Quantity  # with the rods the other way
    lumping: Quantity  # what that changes


CRANK = Reduced(
    "moment",
    "inertia",
    Quantity("speed[rad/s]", "speed of the input"),
    Quantity("M_red[N*m]", "reduced moment of everything", source="(3.34)"),
    Quantity("M_red_{cause}[N*m]", "reduced moment of {cause}", source="(3.34)"),
    Quantity("M_red_mean[N*m]", "mean reduced moment"),
    Quantity("J_red[kg*m^2]", "reduced inertia of the links", source="(3.39)"),
    Quantity("dJ_red[kg*m^2/rad]", "slope of the reduced inertia"),
    Quantity("J_{rods}[kg*m^2]", "reduced inertia with the rods {rods}"),
    Quantity("lumping_J_red[kg*m^2]", "largest change of the reduced inertia by rods as masses in their pins"),
)
SLIDER = Reduced(
    "force",
    "mass",
    Quantity("speed[m/s]", "speed of the input"),
    Quantity("F_red[N]", "reduced force of everything", source="(3.34)"),
    Quantity("F_red_{cause}[N]", "reduced force of {cause}", source="(3.34)"),
    Quantity("F_red_mean[N]", "mean reduced force"),
    Quantity("m_red[kg]", "reduced mass of the links", source="(3.39)"),
    Quantity("dm_red[kg/m]", "slope of the reduced mass"),
    Quantity("m_{rods}[kg]", "reduced mass with the rods {rods}"),
    Quantity("lumping_m_red[kg]", "largest change of the reduced mass by rods as masses in their pins"),
)


def reduced(result: Reduction) -> Reduced:
    """What is reduced, by the kind of the input."""
    return CRANK if result.turns else SLIDER


def columns(result: Reduction) -> list[Column]:
    """All columns of a result in their usual order."""
    return [phi_column(result.phi, result.turns), *_moments(result), *_powers(result), *_inertias(result)]


def cells(result: Reduction, shown: Column) -> list[float | str]:
    """The values of a column (n,), blank where an efficiency has none."""
    values = shown.make().tolist()
    if shown.name != EFFICIENCY.name:
        return values
    return [value if known else "" for value, known in zip(values, efficiency(result)[1].tolist(), strict=True)]


def contribution_name(result: Reduction, contribution: Contribution) -> str:
    """Name of a contribution in columns: its own, with its kind where a spring also damps."""
    twice = sum(other.name == contribution.name for other in result.contributions) > 1
    return f"{contribution.name}_{contribution.kind}" if twice else contribution.name.replace(" ", "_")


def called(contribution: Contribution) -> str:
    """A contribution for people; those of a spring and its damper bear the same name."""
    return Phrase("{name} (damping)", name=contribution.name) if contribution.kind == "damper" else contribution.name


def _moments(result: Reduction) -> Iterator[Column]:
    told = reduced(result)
    yield column(told.moment, lambda: result.total)
    for k, contribution in enumerate(result.contributions):
        own = told.of_cause.of(cause=contribution_name(result, contribution))
        own = own._replace(meaning=Phrase(told.of_cause.meaning, cause=called(contribution)))
        yield column(own, partial(result.moment.__getitem__, k))


def _powers(result: Reduction) -> Iterator[Column]:
    yield column(POWER, lambda: result.total * result.speed)
    if any(contribution.kind == "load" for contribution in result.contributions):
        yield column(EFFICIENCY, lambda: efficiency(result)[0])


def _inertias(result: Reduction) -> Iterator[Column]:
    told, other = reduced(result), result.other
    yield column(told.inertia, lambda: result.inertia)
    yield column(told.slope, lambda: result.slope)
    if other is not None:
        yield column(told.other.of(rods="lumped" if result.rods == "exact" else "exact"), lambda: other)
