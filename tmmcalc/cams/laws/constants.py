"""What a law costs: the largest values of its derivatives, and where they stand (table 5.1).

Cv = max s'    Ca = max|s''|    Cj = max|s'''|    k_M, s_M: where s'' is most negative, which springs ask for
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Law, Values
from tmmcalc.core.numerics.panels import Panels, panels
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

WIDEST = 1 / 8  # of a panel: a piece of a catalogue law is resolved to rounding on it
LEVEL = 1e-12  # of the largest: values that count as equal


@record
class LawConstants:
    """Largest values of one law; k is the part of its phase."""

    name: str = quantity("{phase}_law", "law of the {phase}")
    velocity: float = quantity("Cv_{phase}", "largest s'", symbol="C_v")
    velocity_at: float = quantity("Cv_at_k_{phase}", "k of the largest s'")
    acceleration: float = quantity("Ca_{phase}", "largest |s''|", symbol="C_a")
    acceleration_at: float = quantity(  # where rising and braking are alike, of the rising
        "Ca_at_k_{phase}", "k of the largest |s''|"
    )
    jerk: tuple[float, float]  # least and largest s'''
    braking: float = quantity("s2_min_{phase}", "least s''")
    braking_at: float = quantity("k_M_{phase}", "k of the least s''")
    braking_lift: float = quantity("s_M_{phase}", "s at k_M")
    power: float = quantity("power_max_{phase}", "largest s' s''")
    power_at: float = quantity("power_max_at_k_{phase}", "k of the largest s' s''")

    @derived("Cj_{phase}", "largest |s'''|", symbol="C_j")
    def largest_jerk(self) -> float:
        """Without the shocks, at which it is infinite."""
        return max(abs(self.jerk[0]), abs(self.jerk[1]))

    @derived("jerk_min_{phase}", "least s'''")
    def least_jerk(self) -> float:
        """Without the shocks."""
        return self.jerk[0]

    @derived("jerk_max_{phase}", "largest s'''")
    def most_jerk(self) -> float:
        """Without the shocks."""
        return self.jerk[1]


def constants(law: Law) -> LawConstants:
    """The constants of a law, exact to rounding for pieces that are smooth.

    >>> from tmmcalc.cams.laws.catalogue import LAWS
    >>> found = constants(LAWS["shun"])
    >>> round(found.acceleration, 6), round(found.braking_at, 6), round(found.braking_lift, 6)
    (5.773503, 0.788675, 0.933013)
    """
    on = panels(0.0, 1.0, law.breaks, WIDEST)
    first, second, third = sampled(law, on)[1:]
    velocity, velocity_at = first_of(on, first)
    rising, rising_at = first_of(on, second)
    braking, braking_at = first_of(on, second, -1)
    (jerk_low, _), (jerk_high, _) = on.extremes(third)
    power, power_at = first_of(on, first * second)
    lift = float(law.at(np.array([braking_at]))[0, 0])
    return LawConstants(
        law.name,
        velocity,
        velocity_at,
        max(rising, -braking),
        rising_at if rising >= -braking * (1 - LEVEL) else braking_at,
        (jerk_low, jerk_high),
        braking,
        braking_at,
        lift,
        power,
        power_at,
    )


def sampled(law: Law, on: Panels) -> Values:
    """s and its derivatives (4, K, N) at the points of panels of k, each on its own piece."""
    middle = (on.edges[:-1] + on.edges[1:]) / 2
    piece = np.repeat(law.piece(middle), on.order)
    return law.at(on.x.ravel(), piece).reshape(-1, *on.x.shape)


def first_of(on: Panels, values: Values, sign: int = 1) -> tuple[float, float]:
    """The largest (or with -1 the least) value and the first place that has it: a plateau counts from its begin."""
    at, found = on.turning(values)
    best = np.max(sign * found)
    level = np.flatnonzero(sign * found >= best - LEVEL * np.max(np.abs(found)))
    first = level[np.argmin(at[level])]
    return float(sign * best), float(at[first])
