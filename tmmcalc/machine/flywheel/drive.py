"""The fluctuation of the machine under its motor as a function of the constant inertia: the model that is searched."""

from __future__ import annotations

from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.search import Model
from tmmcalc.machine.motors.characteristics import Characteristic
from tmmcalc.machine.onemass import OneMass, vanishing
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.settling import Guess, Halt, settled


def fluctuation(
    cycle: Cycle, characteristic: Characteristic, time_constant: float = 0.0, near: Regime | None = None
) -> Model:
    """The function constant inertia [kg*m^2] -> delta of the steady motion.

    None where the machine stalls or runs away, or where its inertia vanishes and nothing bounds the speed.

    Each motion is the first guess of the next, and ``near`` that of the first.
    """
    last: Guess | None = None if near is None else (near.panels, near.omega)

    def delta(inertia: float) -> float | None:
        nonlocal last
        if vanishing(cycle, inertia) is not None:
            return None
        machine = OneMass(cycle, inertia, characteristic, time_constant)
        orbit = settled(machine, last)
        if isinstance(orbit, Halt):
            return None
        omega = machine.speed(orbit.panels, orbit.y[0])
        last = orbit.panels, omega
        (slowest, _), (fastest, _) = orbit.panels.extremes(omega)
        return 2 * (fastest - slowest) / (fastest + slowest)

    return delta
