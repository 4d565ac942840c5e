"""The steady motions of stacked variants with their motors."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.alike import Rows
from tmmcalc.core.numerics.gauss import ORDER
from tmmcalc.core.numerics.panels import Panels, Values
from tmmcalc.core.quantity import quantities
from tmmcalc.machine.driveline import drive_line
from tmmcalc.machine.driver import Driver, driver_of
from tmmcalc.machine.model import FlywheelTask, Gears, MotionTask, MotorChoice
from tmmcalc.machine.motion import Existing, Motion, Positions, motion_of
from tmmcalc.machine.onemass import onto
from tmmcalc.machine.regime import Regime, regime_of
from tmmcalc.machine.stacked.figures import FIGURES, figures
from tmmcalc.machine.stacked.places import places
from tmmcalc.machine.stacked.regimes import Machines, Regimes, is_smooth, machines_of, regimes
from tmmcalc.machine.stages import motion

if TYPE_CHECKING:
    from tmmcalc.core.numerics.roots import Indices
    from tmmcalc.linkage.stacked.scene import Block
    from tmmcalc.machine.cycle import Cycle
    from tmmcalc.machine.motors.characteristics import Characteristic
    from tmmcalc.machine.motors.model import Motor
    from tmmcalc.machine.reduction.results import Reduction
    from tmmcalc.machine.stacked.reduction import Cycles
    from tmmcalc.pipeline.outcome import RunResult

Machine = tuple[MotorChoice | None, Gears, MotionTask, FlywheelTask | None]


MACHINE = ("power", "flywheel", "motion")  # stages that read the machine
COLUMNS = {field: quantities(Motion)[field].name for field in ("omega", "eps", "time", "driving", "load")}


def given_of(stage: str, machine: Machine, key: str) -> Any:
    """What a stage of the machine reads; ``key`` is where the spec gives the speed."""
    motor, gears, task, wheel = machine
    return {
        "power": (motor, gears, key, None),
        "flywheel": (wheel, motor, task),
        "motion": (motor, task, wheel, key),
    }[stage]


def refusal(machine: Machine, base: RunResult) -> str | None:
    """Why steady motions of such machines cannot be found together; None if they can."""
    motor, gears, task, _ = machine
    if motor is None or motor.motor is None or task.positional or motor.motor.time_constant:
        return "a motion that no given motor without lag drives"
    speed = base.results["kinematics"].speed
    return None if is_smooth(_characteristic(motor, gears, speed)) else "a characteristic with bends"


def motions_of(
    block: Block, variants: Indices, machine: Machine, base: Motion, wanted: Collection[str]
) -> tuple[Motion, dict[str, Values], NDArray[np.bool_]]:
    """The motions of some variants (v,), at the positions of one behind the other; their figures; which are clear.

    Only the ``wanted`` columns and figures are found, by their names in the table and the summary.
    """
    from tmmcalc.machine.stacked.reduction import cycles_of

    own = Rows(machine)(variants)
    motor, speed = own[0], block.chain(variants).mechanism.input.speed
    assert motor is not None
    cycles = cycles_of(block, variants)
    driver = _stacked_driver(own, speed, len(variants))
    found = regimes(machines_of(cycles.panels, cycles.values, len(variants), _constant(own, speed), driver))
    told = figures(found) if any(name in FIGURES for name in wanted) else {}
    return _at_positions(found, base, wanted), told, cycles.clear & found.clear


def motions_of_each(
    block: Block,
    variants: Indices,
    machine: Machine,
    cycles: Cycles,
    results: Sequence[Mapping[str, Any] | None],
    key: str,
) -> list[Motion | None]:
    """The motions of some variants (v,), each by itself; None where it is not clear, or there are no ``results``.

    ``results`` by stage hold reduction and power; ``key`` is where the spec gives the speed.
    """
    rows = Rows(machine)
    given = [given_of("motion", rows(int(v)), key) for v in variants]
    asked = [None if found is None else motion.asked(each, found) for each, found in zip(given, results, strict=True)]
    constant = np.array([1.0 if each is None else each.inertia.total for each in asked])
    every = np.arange(len(variants))
    loaded = regimes(machines_without(block, variants, machine, cycles).at(every, constant), halvings=0)
    quiet = loaded
    if any(kind == "load" for _, kind, _ in cycles.names):
        quiet = regimes(machines_without(block, variants, machine, cycles, idle=True).at(every, constant), halvings=0)
    clear = loaded.clear & quiet.clear
    return [
        _motion(k, found["reduction"], each, loaded, quiet, key, motion.there(own[2], found))
        if clear[k] and found and each
        else None
        for k, (found, each, own) in enumerate(zip(results, asked, given, strict=True))
    ]


def machines_without(
    block: Block, variants: Indices, machine: Machine, cycles: Cycles, *, idle: bool = False
) -> Machines:
    """The machines of some variants (v,) without any constant inertia; ``idle``: without technological loads."""
    own, speed = Rows(machine)(variants), block.chain(variants).mechanism.input.speed
    values = cycles.idle if idle else cycles.values
    return machines_of(cycles.panels, values, len(variants), 0.0, _stacked_driver(own, speed, len(variants)))


def _motion(
    k: int,
    reduction: Reduction,
    asked: motion.Asked,
    loaded: Regimes,
    quiet: Regimes,
    key: str,
    there: Existing | None,
) -> Motion:
    assert asked.driver is not None
    total, driver = asked.inertia.total, asked.driver
    regime = regime_of_one(k, reduction.cycle, total, driver, loaded)
    idle = regime_of_one(k, reduction.idle, total, driver, quiet) if reduction.idle is not None else None
    return motion_of(reduction.cycle, regime, idle, asked.inertia, driver, Positions.of(reduction), key, there=there)


def regime_of_one(k: int, cycle: Cycle, constant: float, driver: Driver, found: Regimes) -> Regime:
    """The regime of one of several machines, whose ``constant`` inertia and motor these are."""
    on, motor = cycle.panels, driver.characteristic
    count = np.count_nonzero(found.machines.width[k])
    if count > on.count:  # all are halved
        on = Panels(np.append(found.machines.low[k, :count], on.edges[-1]))
    omega = found.omega[k, :count].copy()
    return regime_of(
        onto(cycle, on),
        constant,
        omega,
        motor.moment(omega),
        (complex(found.multiplier[k]),),
        found.tail[k, :count] ** (ORDER / (ORDER - 1)),
        {"newton": found.steps, "meshes": 1},
        fall=motor.slope(omega),
    )


def _stacked_driver(own: Machine, speed: float, count: int) -> Characteristic:
    """The characteristic at the input shaft; its constants stand against arrays (V, K, N)."""
    motor = own[0]
    assert motor is not None
    return Rows(_characteristic(motor, own[1], speed))(np.arange(count)[:, None, None])


def _ratio(motor: Motor, gears: Gears, speed: float) -> float:
    """Speed of the motor over that of the input."""
    return gears.ratio or motor.speed / abs(speed)


def _characteristic(motor: MotorChoice, gears: Gears, speed: float) -> Characteristic:
    """The characteristic at the input shaft."""
    assert motor.motor is not None
    ratio = _ratio(motor.motor, gears, speed)
    return driver_of(motor.motor, motor.characteristic, ratio, drive_line(gears).efficiency).characteristic


def _constant(machine: Machine, speed: float) -> float:
    """All constant inertia at the input shaft [kg*m^2]."""
    motor, gears, task, wheel = machine
    assert motor is not None
    assert motor.motor is not None
    ratio = _ratio(motor.motor, gears, speed)
    inertia = (motor.motor.inertia or 0.0) * ratio**2 + drive_line(gears).inertia + task.inertia
    if wheel is None:
        return inertia
    turned = (ratio if wheel.shaft == "motor" else wheel.ratio) or 1.0
    return inertia + wheel.inertia * turned**2


def _at_positions(found: Regimes, base: Motion, wanted: Collection[str]) -> Motion:
    """The motion at the positions of all machines, without what the textbook makes of that of one."""
    m = found.machines
    at = places(m, np.clip(base.theta, 0.0, base.regime.panels.edges[-1]), base.early)
    find: dict[str, Callable[[], Values]] = {
        "omega": lambda: at.at(found.omega),
        "eps": lambda: at.at(found.acceleration),
        "time": lambda: at.primitive(m, 1 / found.omega),
        "driving": lambda: at.at(found.driving),
        "load": lambda: at.at(found.load),
    }
    rows: dict[str, Any] = {field: find[field]().ravel() for field, column in COLUMNS.items() if column in wanted}
    return replace(base, phi=np.tile(base.phi, len(m.low)), textbook=None, by_energy=None, **rows)
