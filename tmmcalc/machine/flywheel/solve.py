"""The flywheel of a machine from its cycle: all methods, the true inertia, the wheel on its shaft and its rim."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import UNDRIVEN, ConstantInertia, Driver
from tmmcalc.machine.flywheel.comparison import compared
from tmmcalc.machine.flywheel.methods import FlywheelMethod, nodal_flywheels
from tmmcalc.machine.flywheel.placement import wheels
from tmmcalc.machine.flywheel.results import Comparison, Flywheel, RequiredInertia, Trial
from tmmcalc.machine.flywheel.wittenbauer import energy_mass
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.nodes import nodal_tables, nodal_work
from tmmcalc.machine.power import moment_at
from tmmcalc.machine.verdicts import Verdict

ROUNDING = 4 * EPS  # of the intercepts of a tangent, relative to what they are summed up from
BOOK = 1  # place of the textbook's method among all


@record
class Machine:
    """What a flywheel is for."""

    cycle: Cycle
    at_hand: ConstantInertia  # without a flywheel
    task: FlywheelTask
    driver: Driver | None  # None: forces of position alone
    speed: float  # mean [rad/s]
    ratio: float  # speed of the flywheel's shaft over that of the input shaft
    motor_ratio: float | None = None  # speed of the motor's over that of the input shaft
    steps: int | None = None  # the equal ones of the table of positions; None: they differ
    sense: float = 1.0  # of the input's motion: -1 clockwise


def solve_flywheel(machine: Machine, comparison: Comparison | None = None, *, tried: bool = True) -> Flywheel:
    """The flywheel that keeps ``task.delta`` [-], by all methods; ``tried``: what each of them really leads to as well.

    ``comparison`` is that of the methods where a search found it, of which none is tried. Raises `NoSolutionError`
    where no inertia lets the motor carry the load.
    """
    cycle, at_hand, task, driver = machine.cycle, machine.at_hand, machine.task, machine.driver
    history: tuple[Trial, ...] = ()
    assert task.delta is not None
    if comparison is None:
        comparison = compared(
            cycle,
            at_hand.total,
            task.delta,
            speed=machine.speed if driver is None else None,
            characteristic=driver.characteristic if driver is not None else None,
            time_constant=driver.time_constant if driver is not None else 0.0,
            sense=machine.sense,
            tried=tried,
        )
        if tried:
            history = _history(cycle, driver, task.delta, at_hand, comparison.required)
    speed, ratio = machine.speed, machine.ratio
    required = comparison.required
    exact = comparison.rows[0].positional
    addition = required.addition if required is not None else exact.addition
    fastest = required.regime.omega_max if required is not None else speed * (1 + task.delta / 2)
    existing = task.inertia * ratio**2
    if required is not None:
        error, uneven = required.error, required.regime.errors.fluctuation
    else:
        error, uneven = _inexact(cycle, exact, at_hand.total, task.delta, speed)
    made = wheels(task, addition, fastest, ratio, machine.motor_ratio)
    mean = required.regime.mean if required is not None else speed
    return Flywheel(
        delta=task.delta,
        at_hand=at_hand,
        rows=comparison.rows,
        required=required,
        inertia=at_hand.total + addition,
        addition=addition,
        existing=existing,
        sufficient=existing >= addition * (1 - 1e-12) if existing else None,
        wheels=made,
        nodal=None if machine.steps is None else _nodal(cycle, at_hand.total, task.delta, mean, machine.steps),
        picture=energy_mass(cycle, task.delta, mean),
        history=history,
        verdicts=(
            *made[0].verdicts,
            *_verdicts(addition, existing, required),
            *(_resisted_verdicts(cycle, at_hand.total + addition, speed) if driver is None else ()),
        ),
        sense=machine.sense,
        undriven=driver is not None and driver.characteristic.name == UNDRIVEN,
        error=error,
        uneven=uneven,
    )


def _inexact(cycle: Cycle, exact: FlywheelMethod, at_hand: float, delta: float, speed: float) -> tuple[float, float]:
    """Relative errors of the inertia by the exact tangents and of the unevenness reached.

    Both hang on two intercepts, beside their difference.
    """
    square, moment = speed * speed, np.abs(moment_at(cycle, speed))
    turned = float(cycle.panels.total(moment)) + float(np.max(cycle.inertia)) * square / 2 * (1 + delta)
    off = (cycle.error + ROUNDING) * turned / square
    least = max(exact.inertia, at_hand) + float(np.min(cycle.inertia))
    return (
        off / (abs(exact.inertia) * delta) if exact.inertia else 0.0,
        off / (least * exact.delta) if exact.delta else 0.0,
    )


def _history(
    cycle: Cycle, driver: Driver | None, delta: float, at_hand: ConstantInertia, required: RequiredInertia | None
) -> tuple[Trial, ...]:
    """The textbook's correction, where there is a constant inertia to correct and the machine runs with it."""
    stalls = required is not None and Trial(at_hand.total, None) in required.trials
    if stalls or driver is None or at_hand.total <= 0:
        return ()
    from tmmcalc.machine.flywheel.required import fluctuation
    from tmmcalc.machine.flywheel.search import corrections

    try:
        return corrections(fluctuation(cycle, driver.characteristic, driver.time_constant), delta, at_hand.total)
    except NoSolutionError:
        return ()


def _nodal(cycle: Cycle, at_hand: float, delta: float, speed: float, steps: int) -> FlywheelMethod:
    """The textbook's method as it is done by hand: on the nodes of the table, the work by the trapezoid rule."""

    moment, inertia = nodal_tables(cycle, steps, speed)
    work, _ = nodal_work(moment, cycle.period)
    return nodal_flywheels(work, inertia, at_hand, delta, speed, period=cycle.period)[BOOK]


def _verdicts(addition: float, existing: float, required: RequiredInertia | None) -> list[Verdict]:
    said = [Verdict("note", remark) for remark in required.remarks] if required is not None else []
    if existing and existing < addition * (1 - 1e-12):
        text = Phrase(
            "the flywheel of {existing:.6g} kg*m^2 at the input shaft is too light: {addition:.6g} kg*m^2 are needed",
            existing=existing,
            addition=addition,
        )
        said.append(Verdict("warning", text, existing, addition, "kg*m^2", "J_F"))
    return said


def _resisted_verdicts(cycle: Cycle, inertia: float, speed: float) -> list[Verdict]:
    """What becomes of the positional flywheel where loads depend on the speed, as in the stage ``motion``."""
    if not (np.any(cycle.viscous) or np.any(cycle.quadratic)):
        return []
    from tmmcalc.machine.positional import positional

    try:
        reached = positional(cycle, inertia, speed).delta
    except (NoSolutionError, AccuracyError):
        return []
    text = Phrase(
        "all methods take the loads that depend on the speed at the mean speed; with their real course over the "
        "cycle delta is {reached:.7g}, as the motion under a constant driving moment has it",
        reached=reached,
    )
    return [Verdict("note", text)]
