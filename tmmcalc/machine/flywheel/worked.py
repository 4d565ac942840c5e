"""What every method for the flywheel works out on the way to its inertia, and Wittenbauer's tangents on paper.

b_max = A - k_max J where the upper tangent touches     b_min = A - k_min J where the lower one does
J_F = (b_max - b_min) / (delta omega^2) = GH / (delta omega^2)                             (3.53), Fig. 3.17
tan psi = k mu_J / mu_T                                                                    (3.50)
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import Quantity, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.curve import EnergyCurve, energy_curve, nodal_curve
from tmmcalc.machine.flywheel.wittenbauer import METHODS, EnergyMass, tangents
from tmmcalc.machine.nodes import nodal_tables, nodal_work
from tmmcalc.report.drawing.scales import standard_scale

REACH = 100.0  # size of the energy-mass curve with its tangents on paper, at most [mm]

WORK = Quantity("A[J]", "change of the kinetic energy since position 0", source="(3.47)")
LINKS = Quantity("J_red[kg*m^2]", "reduced inertia of the links", source="(3.39)")
MEAN_ENERGY = Quantity("T_links[J]", "energy of the links at the mean speed", source="3.4.2.5")
REST = Quantity("T_rest[J]", "energy without that of the links at the mean speed, A - T_links", source="3.4.2.5")
ABSCISSA = Quantity("x_curve[mm]", "abscissa of the energy-mass curve on paper")
ORDINATE = Quantity("y_curve[mm]", "ordinate of the energy-mass curve on paper")
BELOW = Quantity("below_max[J]", "how far the curve lies below the tangent of the largest speed")
ABOVE = Quantity("above_min[J]", "how far the curve lies above the tangent of the least speed")


@record
class Worked:
    """The numbers of one method, in the order in which they are found."""

    method: str = quantity("method", "the method")
    on: str = quantity("on", "what it goes by: the whole cycle, or the positions of the table alone")
    slope_max: float = quantity("k_max[rad^2/s^2]", "slope of the tangent of the largest speed", source="(3.51)")
    slope_min: float = quantity("k_min[rad^2/s^2]", "slope of the tangent of the least speed", source="(3.51)")
    at_max: float = quantity("max_at[rad]", "phi where the tangent of the largest speed touches")
    at_min: float = quantity("min_at[rad]", "phi where the tangent of the least speed touches")
    work_max: float = quantity("A_max[J]", "change of the kinetic energy where the speed is largest")
    work_min: float = quantity("A_min[J]", "change of the kinetic energy where the speed is least")
    links_max: float = quantity("J_red_max[kg*m^2]", "reduced inertia of the links where the speed is largest")
    links_min: float = quantity("J_red_min[kg*m^2]", "reduced inertia of the links where the speed is least")
    intercept_max: float = quantity("b_max[J]", "intercept of the tangent of the largest speed")
    intercept_min: float = quantity("b_min[J]", "intercept of the tangent of the least speed")
    segment: float = quantity("GH[J]", "segment between both intercepts")
    divisor: float = quantity("delta_omega2[rad^2/s^2]", "delta times the square of the mean speed")
    inertia: float = quantity("J_F[kg*m^2]", "total constant inertia that the method asks for", source="(3.53)")

    @property
    def key(self) -> str:
        """Its name for programs: ``mertsalov_by_cycle``."""
        return f"{self.method.replace(' ', '_')}_by_{self.on}"


@record
class Paper:
    """Wittenbauer's tangents as they are drawn; lengths on paper in mm."""

    energy_scale: float = quantity("mu_T[J/mm]", "scale of the energies", symbol=r"\mu_T")
    inertia_scale: float = quantity("mu_J[kg*m^2/mm]", "scale of the inertias", symbol=r"\mu_J")
    angle_max: float = quantity("psi_max[rad]", "angle of the tangent of the largest speed", source="(3.50)")
    angle_min: float = quantity("psi_min[rad]", "angle of the tangent of the least speed", source="(3.50)")
    at_max: float = quantity("max_at[rad]", "phi where the tangent of the largest speed touches")
    at_min: float = quantity("min_at[rad]", "phi where the tangent of the least speed touches")
    segment: float = quantity("GH[mm]", "segment between both tangents on the axis of energies")
    origin_x: float = quantity("x_origin[mm]", "abscissa of the point where both tangents meet, the origin")
    origin_y: float = quantity("y_origin[mm]", "ordinate of the point where both tangents meet, the origin")


def worked(cycle: Cycle, delta: float, speed: float, steps: int | None, sense: float = 1.0) -> tuple[Worked, ...]:
    """All methods on the whole cycle, then on the positions of ``steps`` equal steps, if there are such.

    ``speed`` [rad/s] is the mean one; ``sense`` -1 where the input turns clockwise.
    """
    found = list(_worked(energy_curve(cycle, speed), "cycle", delta, speed, sense))
    if steps is not None:
        moment, inertia = nodal_tables(cycle, steps, speed)
        curve = nodal_curve(nodal_work(moment, cycle.period)[0], inertia, cycle.period)
        found += _worked(curve, "positions", delta, speed, sense)
    return tuple(found)


def _worked(curve: EnergyCurve, on: str, delta: float, speed: float, sense: float) -> Iterator[Worked]:
    found = tangents(curve, delta, speed)
    for i, rule in enumerate(METHODS):
        fast, slow = found.fastest, found.slowest
        numbers = (
            *(found.slope_max[i], found.slope_min[i]),
            *(sense * fast.theta[i] + 0.0, sense * slow.theta[i] + 0.0),
            *(fast.work[i], slow.work[i], fast.inertia[i], slow.inertia[i]),
            *(found.intercept_max[i], found.intercept_min[i]),
            *(found.intercept_max[i] - found.intercept_min[i], delta * speed**2, found.inertia[i]),
        )
        yield Worked(rule.name, on, *map(float, numbers))


def round_scales(picture: EnergyMass, wide: float = REACH, high: float = REACH) -> tuple[float, float]:
    """Standard scales mu_T [J/mm] and mu_J [kg*m^2/mm] at which the curve and its tangents from the axis fit on paper.

    Without inertia of the links the tangents rise by their segment on so many mm at most.
    """
    energy = np.ptp([*picture.work, *picture.intercepts])
    inertia = float(np.max(picture.links)) or (picture.upper - picture.lower) / picture.slope_max
    return standard_scale(float(energy) / high), standard_scale(inertia / wide)


def paper(picture: EnergyMass, scales: tuple[float, float], sense: float = 1.0) -> Paper:
    """The tangents at the ``scales`` mu_T [J/mm] and mu_J [kg*m^2/mm]."""
    mu_t, mu_j = scales
    at_max, at_min = (sense * at + 0.0 for at in picture.touching)
    segment = (picture.upper - picture.lower) / mu_t
    angles = picture.angles(mu_j / mu_t)
    return Paper(mu_t, mu_j, *angles, at_max, at_min, segment, -picture.inertia / mu_j, -picture.energy / mu_t)


def curve_columns(
    picture: EnergyMass, cycle: Cycle, theta: Values, speed: float, scales: tuple[float, float]
) -> list[Column]:
    """The energy-mass curve at angles theta (n,) of the cycle, on paper, and beside both tangents."""
    curve = energy_curve(cycle, speed)
    assert curve.panels is not None
    work, links = curve.panels.at(np.stack((curve.work, curve.inertia)), theta)
    mean = links * speed**2 / 2

    def off(k: int, sign: float) -> Values:
        return sign * (picture.intercepts[k] + picture.slopes[k] * links - work)

    return [
        column(WORK, lambda: work),
        column(LINKS, lambda: links),
        column(MEAN_ENERGY, lambda: mean),
        column(REST, lambda: work - mean),
        column(ABSCISSA, lambda: links / scales[1]),
        column(ORDINATE, lambda: work / scales[0]),
        column(BELOW, partial(off, 0, 1.0)),
        column(ABOVE, partial(off, 1, -1.0)),
    ]
