"""Stage ``motion``: the steady motion of the machine with its motor and flywheel."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.core.conversion import plain
from tmmcalc.core.stage import said
from tmmcalc.linkage.wanted import NO_CSV, is_long
from tmmcalc.machine.columns import motion_columns
from tmmcalc.machine.model import FlywheelTask, MotionTask, MotorChoice
from tmmcalc.machine.motion import Existing, Motion, Positions, existing
from tmmcalc.machine.wanted import NO_REGIME, constant_moment, curved

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.machine.driver import ConstantInertia, Driver
    from tmmcalc.machine.flywheel.placement import Wheel
    from tmmcalc.machine.flywheel.rim import Rim
    from tmmcalc.machine.room import MachineTables
    from tmmcalc.machine.stepwise import Recurrence


NO_WHEEL = "no [flywheel]: the motion has none"

kind = Motion
solve = "tmmcalc.machine.motion:solve_motion"
columns = motion_columns
declares = ("tmmcalc.linkage.columns:PHI", "tmmcalc.machine.stepwise", "tmmcalc.machine.flywheel.rim")


class Asked(NamedTuple):
    """What the regime is of: the constant inertia, what drives, the mean speed where nothing does [rad/s]."""

    inertia: ConstantInertia
    driver: Driver | None
    speed: float


Given = tuple[MotorChoice | None, MotionTask, FlywheelTask | None, str]


def inputs(spec: MachineTables) -> Given:
    """The motor, the constant inertia, a flywheel that is there, where the spec gives the speed."""
    from tmmcalc.machine.tables.tasks.machine import speed_key, to_flywheel, to_motion, to_motor

    return to_motor(spec), to_motion(spec), to_flywheel(spec), speed_key(spec)


def task(*given: *Given, **upstream: Any) -> tuple[Any, ...]:
    """The cycle with its idle one, what the regime is of, the positions, and the flywheel that is there."""
    machine, reduction = asked(given, upstream), upstream["reduction"]
    of_regime = (reduction.cycle, reduction.idle, machine.inertia, machine.driver, machine.speed)
    return (*of_regime, Positions.of(reduction), given[3], given[1].undriven, there(given[2], upstream))


def there(wheel: FlywheelTask | None, upstream: Mapping[str, Any]) -> Existing | None:
    """The flywheel that is there, if a size of it is given."""
    if wheel is None or not wheel.inertia or wheel.diameter is wheel.width is wheel.thickness is None:
        return None
    from tmmcalc.machine.stages.shaft import shaft_ratio

    return Existing(wheel, shaft_ratio(wheel, upstream["power"]))


def wheel_of(found: Motion, wheel: FlywheelTask | None, upstream: Mapping[str, Any]) -> Wheel | None:
    """The flywheel that is there, as it turns in the motion that was found."""
    return existing(there(wheel, upstream), found.inertia.flywheel, found.regime.omega_max)


def asked(given: Given, upstream: Mapping[str, Any]) -> Asked:
    """The machine with the drive line and the flywheel that earlier stages found."""
    from tmmcalc.machine.stages.shaft import constant_inertia, driver, flywheel_inertia, mean_speed

    wish, task, wheel, _ = given
    inertia = constant_inertia(upstream, task, flywheel_inertia(upstream, wheel))
    return Asked(inertia, driver(upstream, wish, task), mean_speed(upstream, task))


def errors(result: Motion) -> dict[str, Any]:
    """Estimates of its errors."""
    return plain(result.regime.errors)


def further(spec: MachineTables, results: Mapping[str, Any]) -> Sequence[Column]:
    """Columns by choice: the recurrence term by term, turn by turn, loaded and idle."""
    from tmmcalc.machine.stepwise import stepwise_columns

    return list(stepwise_columns(results["motion"], results["reduction"]))


def details(spec: MachineTables, results: Mapping[str, Any]) -> Mapping[str, Recurrence | Rim]:
    """Facts by choice: of the recurrence what is the same at every step, what comes of it; the rim that is there."""
    from tmmcalc.machine.stepwise import idle_run_of, run_of

    given = results["motion"], results["reduction"]
    runs = {"recurrence": run_of(*given), "recurrence_idle": idle_run_of(*given)}
    told: dict[str, Recurrence | Rim] = {name: run.told() for name, run in runs.items() if run is not None}
    wheel = wheel_of(results["motion"], inputs(spec)[2], results)
    return told if wheel is None or wheel.rim is None else {**told, "flywheel_existing": wheel.rim}


def omits(spec: MachineTables) -> tuple[str, ...]:
    """As of the flywheel; and a flywheel that is not there."""
    return said(
        (constant_moment(spec), NO_REGIME),
        (spec.flywheel is None, NO_WHEEL),
        (is_long(spec), NO_CSV),
    )


def packages(spec: MachineTables) -> tuple[str, ...]:
    """Monotone cubics through the points of a motor."""
    return curved(spec)
