"""The results of the pendulum-rotor."""

from __future__ import annotations

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.vibration.pendulum.swing import SwingCourse


@record
class WhirlModes:
    """The modes of one sense of whirl, or of one plane of a rotor that does not spin."""

    name: str  # "forward", "backward"; "both planes"; "plane xz", "plane yz"
    frequency: Values  # (m,) ascending [rad/s]
    shapes: Values  # (m, p) displacement at the places of the result, largest 1
    nodes: tuple[int, ...]  # of every mode, between the ends


@record
class Campbell:
    """Frequencies of whirl over the speed of spin."""

    modes: int  # m
    spin: Values  # (s,) [rad/s]
    forward: Values  # (m, s) [rad/s]
    backward: Values  # (m, s), positive
    whirl: Values  # (s,) displacement of the lower end by the eccentricity [m]; empty without one


@record
class PendulumResult:
    """Natural frequencies, whirl, critical speeds, torsion and motion of a pendulum-rotor."""

    spin: float  # [rad/s]
    place: Values  # (p,) along the rod from the joint [m]
    modes: tuple[WhirlModes, ...]
    forward_critical: Values  # speeds at which forward whirl turns with the rotor [rad/s]; of one that may spin
    backward_critical: Values
    torsion: Values  # natural frequencies of torsion [rad/s]
    rigid: tuple[float, float] | None  # frequencies of the rod if it were rigid, forward and backward [rad/s]
    deflection: float | None  # of the lower end by the eccentricity, turning with the rotor [m]
    campbell: Campbell | None
    swing: SwingCourse | None
    functions: int  # of the Ritz method
    error: dict[str, float]  # relative: frequencies, critical, whirl, torsion, swing
    notes: tuple[str, ...]
