"""The steady motion as the textbook finds it by hand: what its recurrence (3.57, 3.58) gives, or the energy (3.48)."""

from __future__ import annotations

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record


@record
class Turn:
    """One cycle of the textbook's iteration (3.58)."""

    first: float = quantity("textbook_first[rad/s]", "speed at the beginning of the cycle", symbol="omega_0")
    last: float = quantity("textbook_last[rad/s]", "speed at the end of the cycle", symbol="omega_n")


@record
class NodalRegime:
    """Speeds at the nodes over one cycle, periodic or not."""

    omega: Values  # (n + 1,) [rad/s]
    node_min: int
    node_max: int
    delta: float = quantity("delta_textbook", "coefficient of speed fluctuation over the nodes")
    multiplier: float  # factor of a deviation of w_0^2 after one cycle [-]
    warning: float = quantity(
        "B_dphi_over_J", "largest B dphi/J: above 1 the recurrence alternates and the step is too wide"
    )


@record
class Textbook:
    """The motion by the recurrence (3.57) on the grid of the positions."""

    a: float = quantity("A[N*m]", "A of the parabola M_d = A - B omega^2")
    b: float = quantity("B[N*m*s^2/rad^2]", "B of the parabola M_d = A - B omega^2")
    regime: NodalRegime  # the periodic one, directly
    turns: tuple[Turn, ...]  # the iteration from the rated speed (3.58)


@record
class EnergyMotion:
    """The motion without a motor by the energy at the nodes of the positions (3.48)."""

    energy: float = quantity("T0_textbook[J]", "kinetic energy at position 0 at the mean speed")
    drive: float = quantity("M_d_textbook[N*m]", "constant moment that closes the work by the trapezoid rule")
    omega: Values  # (n + 1,) [rad/s]
    node_min: int
    node_max: int
    mean: float = quantity("omega_mean_textbook[rad/s]", "mean speed that comes out, between the extremes")
    delta: float = quantity("delta_textbook", "coefficient of speed fluctuation over the nodes")
