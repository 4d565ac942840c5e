"""The flywheel of a machine: what all methods ask for, what is there, the wheel on its shaft and its rim."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import UNDRIVEN, ConstantInertia, Driver
from tmmcalc.machine.flywheel.comparison import Comparison, Row, compared
from tmmcalc.machine.flywheel.curve import nodal_work
from tmmcalc.machine.flywheel.placement import Wheel, wheels
from tmmcalc.machine.flywheel.positional import FlywheelMethod, on_nodes
from tmmcalc.machine.flywheel.rim import Rim
from tmmcalc.machine.flywheel.trials import RequiredInertia, Trial
from tmmcalc.machine.flywheel.wittenbauer import EnergyMass, energy_mass
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.power import moment_at
from tmmcalc.machine.verdicts import Verdict

ROUNDING = 4 * EPS  # of the intercepts of a tangent, relative to what they are summed up from
BOOK = 1  # place of the textbook's method among all


@record
class Flywheel:
    """Result of the flywheel stage; inertias are reduced to the input shaft [kg*m^2] unless said otherwise."""

    delta: float = quantity("delta_allowed", "coefficient of speed fluctuation that is allowed")
    at_hand: ConstantInertia  # rotor, gears, further; the flywheel left out
    rows: tuple[Row, ...]  # the methods for forces of position, the exact one first
    required: RequiredInertia | None  # under the motor, or the loads alone; None: a constant moment drives
    inertia: float = quantity("J_F[kg*m^2]", "total constant inertia needed")
    addition: float = quantity("J_add[kg*m^2]", "flywheel needed at the input shaft")
    existing: float = quantity("J_existing[kg*m^2]", "flywheel that is there, at the input shaft")
    sufficient: bool | None = quantity("existing_suffices", "the flywheel that is there does")  # None: there is none
    wheels: tuple[Wheel, ...]  # the needed flywheel on its shaft, then on the others for comparison
    nodal: FlywheelMethod | None  # the textbook's method on the table of positions; None if its steps differ
    picture: EnergyMass  # Wittenbauer's energy-mass curve with the tangents
    history: tuple[Trial, ...]  # J_c := J_c delta/[delta] on the true model (3.60); empty without a motor
    verdicts: tuple[Verdict, ...]
    sense: float = 1.0  # of the input's motion: -1 clockwise; places are sense theta
    undriven: bool = False  # without a motor: the loads alone set the speed
    error: float = 0.0  # estimated relative error of the total constant inertia
    uneven: float = 0.0  # and of the unevenness with it, or with what is at hand where that is more

    @property
    def under(self) -> str:
        """What the machine really runs under, in words."""
        if self.undriven:
            return "its loads"
        return "forces of position" if self.required is None else "the motor"

    @derived("J_at_hand[kg*m^2]", "constant inertia at hand without a flywheel")
    def without(self) -> float:
        """Of rotor, gears and what is further there."""
        return self.at_hand.total

    @derived("J_own[kg*m^2]", "inertia of the needed flywheel on its own shaft")
    def own(self) -> float:
        """J_add over the square of the ratio."""
        return self.wheels[0].inertia

    @derived("ratio_flywheel", "speed of the flywheel's shaft over that of the input shaft")
    def ratio(self) -> float:
        """Negative where it turns against the input shaft."""
        return self.wheels[0].ratio

    @derived("omega_flywheel_max[rad/s]", "largest speed of the flywheel")
    def fastest(self) -> float:
        """On its own shaft."""
        return self.wheels[0].speed

    @derived("delta_reached", "coefficient of speed fluctuation reached")
    def reached(self) -> float | None:
        """Under what the machine runs under.

        None where it stalls, and where forces of position ask for a flywheel: then it is the allowed one.
        """
        if self.required is not None:
            return self.required.delta
        return self.rows[0].positional.delta if self.addition <= 0 else None

    @property
    def rim(self) -> Rim | None:
        """Its rim; None if no flywheel is needed, or none can be made."""
        return self.wheels[0].rim


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


def solve_flywheel(machine: Machine) -> Flywheel:
    """The flywheel that keeps ``task.delta`` [-], by all methods.

    Raises `NoSolutionError` where no inertia lets the motor carry the load.
    """
    cycle, driver, delta = machine.cycle, machine.driver, machine.task.delta
    assert delta is not None
    comparison = compared(
        cycle,
        machine.at_hand.total,
        delta,
        speed=machine.speed if driver is None else None,
        characteristic=driver.characteristic if driver is not None else None,
        time_constant=driver.time_constant if driver is not None else 0.0,
        sense=machine.sense,
    )
    required = comparison.required
    stalls = required is not None and Trial(machine.at_hand.total, None) in required.trials
    return flywheel_of(machine, comparison, () if stalls else _history(cycle, driver, delta, machine.at_hand))


def flywheel_of(machine: Machine, comparison: Comparison, history: tuple[Trial, ...]) -> Flywheel:
    """The result from the methods side by side and the correction of the textbook."""
    cycle, at_hand, task, driver = machine.cycle, machine.at_hand, machine.task, machine.driver
    speed, ratio = machine.speed, machine.ratio
    assert task.delta is not None
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
            *_rim_verdicts(made[0]),
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


def _history(cycle: Cycle, driver: Driver | None, delta: float, at_hand: ConstantInertia) -> tuple[Trial, ...]:
    """The textbook's correction, where there is a constant inertia to correct and the machine runs with it."""
    if driver is None or at_hand.total <= 0:
        return ()
    from tmmcalc.machine.flywheel.required import correction_history

    try:
        return tuple(correction_history(cycle, driver.characteristic, delta, at_hand.total, driver.time_constant))
    except NoSolutionError:
        return ()


def _nodal(cycle: Cycle, at_hand: float, delta: float, speed: float, steps: int) -> FlywheelMethod:
    """The textbook's method as it is done by hand: on the nodes of the table, the work by the trapezoid rule."""
    from tmmcalc.machine.recurrence import nodal_tables

    moment, inertia = nodal_tables(cycle, steps, speed)
    work, _ = nodal_work(moment, cycle.period)
    return on_nodes(work, inertia, at_hand, delta, speed, period=cycle.period)[BOOK]


def _rim_verdicts(wheel: Wheel) -> list[Verdict]:
    return [Verdict("warning", remark) for remark in wheel.remarks]


def _verdicts(addition: float, existing: float, required: RequiredInertia | None) -> list[Verdict]:
    said = [Verdict("note", remark) for remark in required.remarks] if required is not None else []
    if existing and existing < addition * (1 - 1e-12):
        text = (
            f"the flywheel of {existing:.6g} kg*m^2 at the input shaft is too light: {addition:.6g} kg*m^2 are needed"
        )
        said.append(Verdict("warning", text))
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
    text = (
        "all methods take the loads that depend on the speed at the mean speed; with their real course over the cycle "
        f"delta is {reached:.7g}, as the motion under a constant driving moment has it"
    )
    return [Verdict("note", text)]
