"""The steady regime: what a solution for the speed over one cycle says of the machine."""

from __future__ import annotations

import cmath
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.numerics.panels import Extreme, Panels, Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.regimeerrors import (
    Balance,
    Excess,
    RegimeErrors,
    Solved,
    accelerations,
    regime_errors,
)

if TYPE_CHECKING:
    from tmmcalc.core.numerics.collocation import Orbit

LOST = 1e-300  # a multiplier below it counts as zero


@record
class Regime:
    """Steady motion of the input shaft over one cycle; all functions at the points of ``panels`` (K, N)."""

    panels: Panels  # of [0, period], not always those of the cycle
    omega: Values  # angular speed [rad/s]
    acceleration: Values  # angular acceleration [rad/s^2]
    driving: Values  # driving moment M_d [N*m]
    time: Values  # since theta = 0, at the edges (K + 1,) [s]
    omega_min: float = quantity("omega_min[rad/s]", "least speed of the input")
    theta_min: float  # where it stands [rad]
    omega_max: float = quantity("omega_max[rad/s]", "largest speed of the input")
    theta_max: float
    mean: float = quantity("omega_mean[rad/s]", "mean speed (omega_max + omega_min)/2", source="(3.52)")
    time_mean: float = quantity("omega_time_mean[rad/s]", "mean speed over the time: angle over time of a cycle")
    delta: float = quantity("delta", "coefficient of speed fluctuation (omega_max - omega_min)/omega_mean")
    cycle_time: float = quantity("cycle_time[s]", "time of a cycle", symbol="T")
    mean_moment: float = quantity("M_d_mean[N*m]", "mean driving moment over the angle: work of a cycle per radian")
    rms_moment: float = quantity("M_d_rms[N*m]", "root mean square of the driving moment over the time")
    mean_power: float = quantity("P_mean[W]", "mean driving power")
    multipliers: tuple[complex, ...] = quantity(  # the slowest to die first
        "multipliers", "Floquet multipliers: factors by which deviations change in a cycle"
    )
    stable: bool | None  # None: indifferent, for nothing depends on the speed
    constant_inertia: float  # J_c [kg*m^2]
    residual: float  # work of all moments over the cycle, against the work of their magnitudes [-]
    errors: RegimeErrors
    counters: dict[str, int] = quantity("counters", "Newton steps, meshes")

    @derived("stability", "stable, unstable or indifferent")
    def stability(self) -> str:
        """Indifferent: nothing depends on the speed."""
        return {True: "stable", False: "unstable", None: "indifferent"}[self.stable]

    @property
    def error(self) -> float:
        """Estimated relative error of omega [-]."""
        return self.errors.speed

    @cached_property
    def driving_extremes(self) -> tuple[Extreme, Extreme]:
        """Least and largest driving moment [N*m], each with its place [rad]."""
        return self.panels.extremes(self.driving)

    def omega_at(self, theta: Values) -> Values:
        """Angular speed (m,) [rad/s] at angles (m,) [rad] within the cycle."""
        return self.panels.at(self.omega, theta)

    def time_at(self, theta: Values) -> Values:
        """Time (m,) [s] from theta = 0 to angles (m,) [rad] within the cycle."""
        return self.panels.primitive_at(1 / self.omega, theta)


def regime_of(
    cycle: Cycle,
    constant: float,
    omega: Values,
    driving: Values,
    multipliers: tuple[complex, ...],
    missing: Values,
    counters: dict[str, int],
    *,
    fall: Values | float = 0.0,
    own: float = 0.0,
    lags: bool = False,
    ringing: float = 1.0,
    excess: Excess | None = None,
) -> Regime:
    """The regime with the speed ``omega`` and the moment ``driving``, both (K, N) on the panels of ``cycle``.

    ``missing`` (K,) is what is left out of omega, or of the ``excess`` that it was solved for, relative, beside
    rounding and errors of the cycle's own data; ``fall`` is the slope of the motor's moment over the speed (K, N),
    ``own`` the relative error of a moment that does not follow from the speed; where that ``lags``, ``ringing`` is how
    far it swings up what is rounded.
    """
    on, above = cycle.panels, excess is not None
    excess = excess or _excess(omega)
    extremes = on.extremes(excess.w)
    (low, low_at), (high, high_at) = extremes
    spread, low, high = high - low, excess.reference + low, excess.reference + high
    time, edges = on.primitive(1 / omega)[1], on.edges
    inertia = cycle.inertia + constant
    load = cycle.moment + (cycle.viscous + cycle.quadratic * omega) * omega
    net = driving + load
    work, heat, surplus, turnover = on.total(
        np.stack((driving, driving * driving / omega, net, np.abs(driving) + np.abs(load)))
    )
    kinetic = float(on.total(inertia * omega * omega)) / cycle.period
    # errors of the inertia count most where it is least; what is left of the work shifts the level of the speed,
    # less what the motor takes back
    share = float(np.max(cycle.inertia) / np.min(inertia)) / 2
    regulation = min(abs(np.log(max(abs(mu), LOST))) for mu in multipliers) or 1.0
    astray = abs(float(surplus)) + cycle.error * float(turnover)
    solved = Solved(
        missing, excess, fall, own, astray / (regulation * kinetic), ringing, float(regulation), lags, above
    )
    at = Balance(driving, load, cycle.slope * omega * omega / 2, inertia)
    acceleration, inaccurate = accelerations(cycle, omega, at, solved)
    mean, total_time, period = (high + low) / 2, float(time[-1]), cycle.period
    slowest = max(abs(mu) for mu in multipliers)
    return Regime(
        on,
        omega,
        acceleration,
        driving,
        time,
        low,
        low_at % float(edges[-1]),
        high,
        high_at % float(edges[-1]),
        mean,
        period / total_time,
        spread / mean,
        total_time,
        float(work) / period,
        float(heat / total_time) ** 0.5,
        float(work) / total_time,
        multipliers,
        None if slowest == 1 else slowest < 1,
        constant,
        float(surplus) / float(turnover) if turnover else 0.0,
        regime_errors(cycle, at, solved, share, extremes, inaccurate),
        counters,
    )


def _excess(omega: Values) -> Excess:
    """The speed above its least value, where that difference is exact: interpolated, it keeps the digits of delta."""
    least, largest = float(np.min(omega)), float(np.max(omega))
    reference = least if 2 * least >= largest else 0.0
    return Excess(reference, omega - reference, largest)


def multipliers(orbit: Orbit) -> tuple[complex, ...]:
    """Floquet multipliers, the largest first; their product is exact, and so is a single one."""
    product = np.exp(orbit.trace)
    if len(orbit.y) == 1:
        return (complex(product),)
    half = float(np.trace(orbit.monodromy)) / 2
    root = cmath.sqrt(half * half - product)
    first = half + root if half >= 0 else half - root
    return first, complex(product) / first if first else 0j
