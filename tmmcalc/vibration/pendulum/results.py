"""The results of the pendulum-rotor."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.notes import Said
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import Quantity, derived, quantity
from tmmcalc.core.records import record
from tmmcalc.vibration.pendulum.swing import SwingCourse


@record
class WhirlModes:
    """The modes of one sense of whirl, or of one plane of a rotor that does not spin."""

    name: str  # "forward", "backward"; "both planes"; "plane xz", "plane yz"
    frequency: Values = quantity("omega[rad/s]", "natural frequency", symbol="omega")  # (m,) ascending
    shapes: Values  # (m, p) displacement at the places of the result, largest 1
    nodes: tuple[int, ...]  # of every mode, between the ends

    @derived("f[Hz]", "natural frequency")
    def hertz(self) -> Values:
        """(m,)."""
        return self.frequency / (2 * np.pi)

    @derived("n[rpm]", "natural frequency as a speed")
    def speed(self) -> Values:
        """(m,)."""
        return self.frequency * 30 / np.pi


@record
class Campbell:
    """Frequencies of whirl over the speed of spin."""

    modes: int  # m
    spin: Values = quantity("spin[rad/s]", "speed of spin", symbol="Omega")  # (s,)
    forward: Values  # (m, s) [rad/s]
    backward: Values  # (m, s), positive
    whirl: Values = quantity(  # (s,); empty without an eccentricity
        "whirl[m]", "displacement of the lower end by the eccentricity, turning with the rotor"
    )


@record
class PendulumResult:
    """Natural frequencies, whirl, critical speeds, torsion and motion of a pendulum-rotor."""

    spin: float = quantity("spin[rad/s]", "speed of spin", symbol="Omega")
    place: Values = quantity("a[m]", "place along the rod from the joint")  # (p,)
    modes: tuple[WhirlModes, ...]
    forward_critical: Values  # speeds at which forward whirl turns with the rotor [rad/s]; of one that may spin
    backward_critical: Values
    torsion: Values = quantity("torsion_omega[rad/s]", "natural frequencies of torsion")
    rigid: tuple[float, float] | None = quantity(
        "rigid_omega[rad/s]", "natural frequencies of the rod if it were rigid, forward and backward"
    )
    deflection: float | None = quantity(
        "whirl[m]", "displacement of the lower end by the eccentricity, turning with the rotor"
    )
    campbell: Campbell | None
    swing: SwingCourse | None
    functions: int  # of the Ritz method
    error: dict[str, float]  # relative: frequencies, critical, whirl, torsion, swing
    notes: tuple[Said, ...]

    @derived("frequency_error", "largest relative error of the natural frequencies")
    def frequency_error(self) -> float:
        """It is always found."""
        return self.error["frequencies"]

    @derived("critical[rad/s]", "critical speeds of forward and backward whirl")
    def critical(self) -> dict[str, list[float]]:
        """By the sense of whirl."""
        return {"forward": self.forward_critical.tolist(), "backward": self.backward_critical.tolist()}


SHAPE = Quantity("{whirl}_{mode}[-]", "displacement of mode {mode} of the whirl {whirl}, its largest 1")
WHIRL = Quantity("f_{whirl}_{mode}[Hz]", "frequency of mode {mode} of {whirl} whirl")
