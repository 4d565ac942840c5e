"""The mean speed of a crank that follows from its motor: that of the steady motion with the flywheel of the machine.

Friction, inertia forces and viscous loads hang on the speed, so that the machine is reduced and moved again at the
speed found until it stays. Ratio and efficiency are given, or those of the train that is chosen at the rated speed.
Where nothing stores kinetic energy, or a constant moment drives, it is the speed at which the mean moments balance:

    u eta M_motor(u omega) + mean of M_c(omega) = 0
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.errors import AccuracyError, NoSolutionError, TmmError
from tmmcalc.gears.wanted import strength as unchosen
from tmmcalc.machine.driveline import DriveLine, drive_line
from tmmcalc.machine.wanted import power as unpowered

if TYPE_CHECKING:
    from tmmcalc.gears.selection.results import Winner
    from tmmcalc.machine.driver import Driver
    from tmmcalc.machine.model import MotorChoice
    from tmmcalc.machine.reduction.results import Reduction
    from tmmcalc.machine.room import MachineTables

ROUNDS, SETTLED = 20, 1e-9  # reductions at most, and the relative change of the speed that ends them
HALVINGS = 60


def followed(at: Callable[[float], MachineTables]) -> float:
    """The mean speed [rad/s] that its motor gives the crank; ``at`` gives the spec with a mean speed.

    Where nothing loads the crank, or the motor cannot carry its mean load, it is the rated speed over the ratio: the
    stages tell the rest. Raises what the reduction of the machine raises.
    """
    from tmmcalc.machine.tables.tasks.machine import to_gears, to_motor

    spec = at(1.0)
    wish = to_motor(spec)
    assert wish is not None
    assert wish.motor is not None
    speed = wish.motor.speed / (to_gears(spec).ratio or _nominal(spec))
    if unpowered(spec) is not None:
        return speed
    reduction = _reduced(at(speed))
    line = _line(at(speed), reduction)
    assert line.ratio is not None
    for _ in range(ROUNDS):
        mean = _mean(at(speed), reduction, wish, line)
        if mean is None:
            return wish.motor.speed / line.ratio
        speed, before = mean, reduction.cycle.speed
        if abs(speed / before - 1) < SETTLED:
            break
        reduction = _reduced(at(speed))
    return speed


def _nominal(spec: MachineTables) -> float:
    """Speed of the motor over that of the crank as the train's ratio says it."""
    from tmmcalc.gears.sizing import wheel_ratio
    from tmmcalc.gears.tables.tasks.open_pair import to_open_pair
    from tmmcalc.gears.tables.tasks.train import to_train

    if spec.strength is not None and spec.strength.moment_ratio is not None:
        return abs(spec.strength.moment_ratio)
    on_crank = to_open_pair(spec)
    return float(wheel_ratio(to_train(spec)[0])) * (1.0 if on_crank is None else on_crank.ratio)


def _line(spec: MachineTables, reduction: Reduction) -> DriveLine:
    """The drive line; where no train can be chosen, which its stages tell, that of the train's own ratio."""
    from tmmcalc.machine.tables.tasks.machine import to_gears

    given = to_gears(spec)
    chosen = unchosen(spec) is None and (given.ratio is None or given.efficiency is None)
    line = drive_line(given, _chosen(spec, reduction) if chosen else None)
    return line if line.ratio is not None else drive_line(replace(given, ratio=_nominal(spec)))


def _chosen(spec: MachineTables, reduction: Reduction) -> Winner | None:
    """The train that is chosen for the drive; None where none is asked for, or none can be chosen."""
    from tmmcalc.machine.stages.drive import best, sought

    asked = sought(spec)
    if asked is None:
        return None
    try:
        return best(asked, reduction)
    except TmmError:
        return None


def _mean(spec: MachineTables, reduction: Reduction, wish: MotorChoice, line: DriveLine) -> float | None:
    """The mean speed [rad/s] of the steady motion; None where there is none."""
    from tmmcalc.machine.driver import driver_of
    from tmmcalc.machine.model import TrialTask
    from tmmcalc.machine.stages.power import power_of
    from tmmcalc.machine.stages.trial import Trials
    from tmmcalc.machine.tables.tasks.machine import to_flywheel, to_motion

    assert wish.motor is not None
    assert line.ratio is not None
    motion = to_motion(spec)
    regime = None
    if not motion.positional:
        try:
            task = TrialTask(motion, to_flywheel(spec), (), ())
            regime = Trials(power_of(reduction, line), reduction, wish, task).regime(wish.motor, line.ratio)
        except (NoSolutionError, AccuracyError):
            return None
    if regime is not None:
        return regime.mean
    return _balanced(reduction, driver_of(wish.motor, wish.characteristic, line.ratio, line.efficiency))


def _balanced(reduction: Reduction, driver: Driver) -> float | None:
    """The speed [rad/s] at which the mean moments balance; None: at none."""
    from tmmcalc.machine.onemass import OneMass, balanced_speed

    cycle, motor = reduction.cycle, driver.characteristic
    near = balanced_speed(OneMass(cycle, 1.0, motor))
    if near is None:
        return None
    mean, viscous, quadratic = (
        float(cycle.panels.total(part)) / cycle.period for part in (cycle.moment, cycle.viscous, cycle.quadratic)
    )

    def net(omega: float) -> float:
        return float(motor.moment(omega)) + mean + (viscous + quadratic * omega) * omega

    low, high = near, near
    while net(low) < 0:
        low *= 0.999
    while net(high) > 0:
        high *= 1.001
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if net(middle) > 0 else (low, middle)
    return (low + high) / 2


def _reduced(spec: MachineTables) -> Reduction:
    from tmmcalc.linkage.kinematics import solve_kinematics
    from tmmcalc.linkage.structure import solve_structure
    from tmmcalc.machine.model import TorqueTask
    from tmmcalc.machine.stages.reduction import inputs

    given = inputs(spec)
    if isinstance(given, TorqueTask):
        from tmmcalc.machine.diagram.reduced import reduced_diagram

        return reduced_diagram(given)
    from tmmcalc.machine.reduction.solve import solve_reduction

    mechanism, loading, rods = given
    return solve_reduction(mechanism, loading, solve_kinematics(mechanism, solve_structure(mechanism)), rods)
