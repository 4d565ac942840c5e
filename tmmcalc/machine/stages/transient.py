"""Stage ``transient``: start-up, braking, run-down and load changes, in time."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.stage import said
from tmmcalc.core.stored import Table
from tmmcalc.machine.attached import Attached
from tmmcalc.machine.model import DriveShaft, FlywheelTask, MotionTask, MotorChoice, TransientTask
from tmmcalc.machine.transient.columns import stacked_columns
from tmmcalc.machine.transient.timed import TimedMotions
from tmmcalc.machine.wanted import curved

if TYPE_CHECKING:
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.machine.cycle import Cycle
    from tmmcalc.machine.motors.characteristics import Characteristic
    from tmmcalc.machine.power import MotorDuty
    from tmmcalc.machine.reduction.results import Reduction
    from tmmcalc.machine.room import MachineTables
    from tmmcalc.machine.transient.solve import Machine

NO_SHAFTS = "no [[shafts]]: one mass, no rigid drive beside it"
NO_STEADY = "no motion in time begins in the steady one: that is not found first"


Linkage = tuple["Mechanism", "Loading", str]
Given = tuple[
    tuple[TransientTask, ...],
    tuple[DriveShaft, ...],
    MotorChoice | None,
    MotionTask,
    FlywheelTask | None,
    Linkage | None,
]

kind = TimedMotions
columns = stacked_columns
declares = ("motion", "alpha", "theta")

OWN = ("merson", "rk4", "collocation", "auto")  # methods of integration that are the program's own
POSITIONAL = (
    '[motion] drive = "positional" holds for the steady motion; motions in time take the motor, also for the steady '
    "motion that they begin in"
)


def inputs(spec: MachineTables) -> Given:
    """The scenarios, shafts, motor, constant inertia, a flywheel, a linkage that may turn back."""
    from tmmcalc.machine.tables.tasks.machine import to_flywheel, to_motion, to_motor, to_scenarios, to_shafts

    return (
        to_scenarios(spec),
        to_shafts(spec),
        to_motor(spec),
        to_motion(spec),
        to_flywheel(spec),
        _linkage(spec),
    )


def _linkage(spec: MachineTables) -> Linkage | None:
    """The linkage whose friction is reduced again where a motion may turn the crank back."""
    if spec.mechanism is None or all(transient.standstill == "stop" for transient in spec.transients):
        return None
    from tmmcalc.machine.stages.reduction import inputs as reduced

    given = reduced(spec)
    return given if isinstance(given, tuple) else None


def solve(*given: *Given, tolerance: float, **upstream: Any) -> TimedMotions:
    """Put the drive together and run every scenario."""
    from tmmcalc.machine.stages.shaft import mean_speed
    from tmmcalc.machine.transient.solve import solve_transients

    tasks, motion = given[0], given[3]
    return solve_transients(machine_of(given, upstream), tasks, mean_speed(upstream, motion), tolerance)


def machine_of(given: Given, upstream: Mapping[str, Any]) -> Machine:
    """The machine with the drive line and the flywheel that earlier stages found, the motor by its whole curve."""
    from tmmcalc.machine.stages.shaft import constant_inertia, driver, flywheel_inertia
    from tmmcalc.machine.transient.solve import Machine

    tasks, shafts, wish, motion, wheel, linkage = given
    reduction, power = upstream["reduction"], upstream["power"]
    duty = power.duty
    wish = _whole_curve(wish, duty)
    moved = driver(upstream, wish, replace(motion, positional=False))
    rubs = any(part.kind == "friction" for part in reduction.contributions)
    attached = tuple(each for each in upstream.values() if isinstance(each, Attached))
    return Machine(
        cycle=reduction.cycle,
        idle=_idle(reduction, tasks),
        inertia=constant_inertia(upstream, motion, flywheel_inertia(upstream, wheel)),
        motor=_on_motor_shaft(duty, wish, power.line.efficiency),
        reduced=moved.characteristic if moved is not None else None,
        time_constant=moved.time_constant if moved is not None else 0.0,
        ratio=duty.ratio if duty is not None else 1.0,
        shafts=shafts,
        wheel_at_motor=wheel is not None and wheel.shaft == "motor",
        back=partial(back_of, linkage, reduction, attached) if rubs else None,
        undriven=motion.undriven and moved is None,
        notes=(POSITIONAL,) if motion.positional and moved is not None else (),
        data=duty.motor if duty is not None else None,
        efficiency=power.line.efficiency,
    )


def back_of(
    linkage: Linkage | None, reduction: Reduction, attached: Sequence[Attached] = ()
) -> tuple[Cycle, Cycle | None]:
    """Both cycles of the crank turned back; it is never asked for where it may not turn back.

    Raises `NoSolutionError` where what is ``attached`` cannot be turned back.
    """
    from tmmcalc.machine.attached import backwards

    if linkage is None:
        return backwards(reduction.cycle, reduction.idle, attached)
    from tmmcalc.linkage.kinematics import solve_kinematics
    from tmmcalc.linkage.structure import solve_structure
    from tmmcalc.machine.reduction.solve import solve_back

    mechanism, loading, rods = linkage
    loaded = any(load.factor for load in loading.loads)
    turns = math.lcm(1, *(each.turns for each in attached))
    kinematics = solve_kinematics(mechanism, solve_structure(mechanism))
    cycle, quiet = solve_back(mechanism, loading, kinematics, rods, turns)
    idle = quiet if loaded and reduction.idle is not None else cycle
    return backwards(cycle, idle, attached, joined_already=False)


def _whole_curve(wish: MotorChoice | None, duty: MotorDuty | None) -> MotorChoice | None:
    """The motor by its whole curve: parabola and line hold near the rated speed alone, a start needs more."""
    if (
        wish is None
        or duty is None
        or duty.motor.overload is None
        or wish.characteristic not in ("parabolic", "linear")
    ):
        return wish
    return replace(wish, characteristic="kloss") if duty.motor.kind == "induction" else wish


def _idle(reduction: Reduction, tasks: Sequence[TransientTask]) -> Cycle | None:
    """The cycle that a load factor of zero leaves: without technological loads there is nothing to switch off.

    Raises `NoSolutionError` for a load factor other than one where friction locks the machine without its loads.
    """
    kinds = {part.kind for part in reduction.contributions}
    if "load" not in kinds:
        return reduction.cycle
    if reduction.idle is None and "friction" in kinds:
        for task in tasks:
            factor = next((step.factor for step in task.scenario.load if step.factor != 1), None)
            if factor is not None:
                raise NoSolutionError(
                    f"the load factor {factor:g} has no meaning: without its loads friction locks the machine, so that "
                    "there is no idle run to go from",
                    where=f"transient motion, scenario {task.scenario.name}",
                    value=factor,
                    limit=1.0,
                    remedy="keep load = 1 and leave load_steps out, or lessen the friction coefficients",
                )
    return reduction.idle


def _on_motor_shaft(duty: MotorDuty | None, wish: MotorChoice | None, efficiency: float) -> Characteristic | None:
    """The motor on its own shaft, the losses of the gears taken from its moment."""
    if duty is None or wish is None:
        return None
    from tmmcalc.machine.motors.gearing import reduced
    from tmmcalc.machine.motors.model import characteristic

    return reduced(characteristic(duty.motor, wish.characteristic), 1.0, efficiency)


def errors(result: TimedMotions) -> dict[str, Any]:
    """Estimates of its errors."""
    worst = max((motion.error for motion in result.motions), default=0.0)
    extremes = max((motion.extremes_error for motion in result.motions), default=0.0)
    imbalance = max((motion.imbalance for motion in result.motions), default=0.0)
    return {"speed": worst, "extremes": extremes, "energy": imbalance}


def table(result: TimedMotions) -> Table:
    """All columns, one row a time, one motion after the other."""
    labels = np.concatenate([np.full(len(motion.t), motion.name) for motion in result.motions])
    found = stacked_columns(result)
    return Table(["motion", *(each.header for each in found)], [labels, *(each.make() for each in found)])


def omits(spec: MachineTables) -> tuple[str, ...]:
    """Shafts that the drive has not, a motion that none begins in."""
    return said((not spec.shafts, NO_SHAFTS), (all(each.begin != "steady" for each in spec.transients), NO_STEADY))


def packages(spec: MachineTables) -> tuple[str, ...]:
    """As of the steady motion; and the methods of integration that are asked for by name."""
    asked = any(each.method not in OWN for each in spec.transients)
    return (*curved(spec), "scipy.integrate") if asked else curved(spec)
