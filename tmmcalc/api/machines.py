"""The Python API of machines: power, flywheel, motion, transients, balance, vibration."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.api import solved

if TYPE_CHECKING:
    from tmmcalc.machine.flywheel.results import Flywheel
    from tmmcalc.machine.motion import Motion
    from tmmcalc.machine.power import Power
    from tmmcalc.machine.stages.balance import Balances
    from tmmcalc.machine.transient.timed import TimedMotions
    from tmmcalc.project import Spec
    from tmmcalc.vibration.pendulum.results import PendulumResult
    from tmmcalc.vibration.pendulum.task import PendulumTask
    from tmmcalc.vibration.vibrator.results import VibratorResult
    from tmmcalc.vibration.vibrator.task import VibratorTask


def solve_power(spec: Spec) -> Power:
    """Work per cycle, efficiency, power, and the motor of a spec, given or chosen."""
    return solved(spec, "power")


def solve_flywheel(spec: Spec) -> Flywheel:
    """The flywheel that keeps the unevenness of the spec, by all methods; raises `NoSolutionError` if none does."""
    return solved(spec, "flywheel")


def solve_motion(spec: Spec) -> Motion:
    """Steady motion of the machine of a spec; raises `NoSolutionError` where it stalls or runs away."""
    return solved(spec, "motion")


def solve_transients(spec: Spec) -> TimedMotions:
    """The motions in time that a spec asks for; raises `AccuracyError` where a method does not keep its tolerance."""
    return solved(spec, "transient")


def solve_balance(spec: Spec) -> Balances:
    """Shaking forces of the linkage, the engine and the rotor of a spec, and what balancing leaves of them."""
    return solved(spec, "balance")


def solve_vibrator(scene: Spec | VibratorTask) -> VibratorResult:
    """Springs, modes, steady vibration and starts of the vibratory device of a spec, or of a plain `VibratorTask`.

    Raises `NoSolutionError` if mass or stiffness is not positive definite, `SingularityError` at resonance without
    damping.
    """
    from tmmcalc.vibration.vibrator.task import VibratorTask

    if not isinstance(scene, VibratorTask):
        return solved(scene, "vibrator")
    from tmmcalc.vibration.vibrator.solve import solve_vibrator as _vibrator

    return _vibrator(scene)


def solve_pendulum(scene: Spec | PendulumTask) -> PendulumResult:
    """Whirl, critical speeds, torsion and motion of the pendulum-rotor of a spec, or of a plain `PendulumTask`.

    Raises `NoSolutionError` where nothing holds the rod, `SingularityError` for an unbalance at a critical speed.
    """
    from tmmcalc.vibration.pendulum.task import PendulumTask

    if not isinstance(scene, PendulumTask):
        return solved(scene, "pendulum")
    from tmmcalc.vibration.pendulum.solve import solve_pendulum as _pendulum

    return _pendulum(scene)
