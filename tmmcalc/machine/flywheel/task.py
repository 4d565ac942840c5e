"""The flywheel of a machine: what all methods ask for, what is there, the wheel on its shaft and its rim."""

from __future__ import annotations

from dataclasses import replace

from tmmcalc.errors import NoSolutionError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia, Driver
from tmmcalc.machine.flywheel.comparison import Row, compared
from tmmcalc.machine.flywheel.materials import MATERIALS, Material
from tmmcalc.machine.flywheel.required import RequiredInertia, correction_history
from tmmcalc.machine.flywheel.rim import (
    Rim,
    rim_of_diameter_and_width,
    rim_of_mean_diameter,
    rim_of_proportions,
    rim_of_section,
)
from tmmcalc.machine.flywheel.search import Trial
from tmmcalc.machine.flywheel.wittenbauer import EnergyMass, energy_mass
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.verdicts import Verdict
from tmmcalc.records import record

THICK = 0.4  # thickness over mean diameter above which a rim is hardly one


@record
class Flywheel:
    """Result of the flywheel stage; inertias are reduced to the input shaft [kg*m^2] unless said otherwise."""

    delta: float  # allowed coefficient of speed fluctuation
    at_hand: ConstantInertia  # rotor, gears, further; the flywheel left out
    rows: tuple[Row, ...]  # the methods for forces of position, the exact one first
    required: RequiredInertia | None  # under the motor's characteristic; None without a motor
    inertia: float  # total constant inertia needed
    addition: float  # the flywheel needed
    existing: float  # the flywheel that is there
    sufficient: bool | None  # whether that one does; None if there is none
    ratio: float  # speed of the flywheel's shaft over that of the input shaft
    own: float  # inertia of the needed flywheel on its shaft
    speed: float  # largest speed of that shaft [rad/s]
    rim: Rim | None  # None if no flywheel is needed, or none can be made
    picture: EnergyMass  # Wittenbauer's energy-mass curve with the tangents
    history: tuple[Trial, ...]  # J_c := J_c delta/[delta] on the true model (3.60); empty without a motor
    verdicts: tuple[Verdict, ...]


def solve_flywheel(
    cycle: Cycle, at_hand: ConstantInertia, task: FlywheelTask, driver: Driver | None, speed: float, ratio: float
) -> Flywheel:
    """The flywheel that keeps ``task.delta`` [-], by all methods; ``driver`` None: forces of position alone.

    ``speed`` [rad/s] is the mean speed, ``ratio`` the speed of the flywheel's shaft over that of the input shaft.
    Raises `NoSolutionError` where no inertia lets the motor carry the load.
    """
    assert task.delta is not None
    characteristic = driver.characteristic if driver is not None else None
    lag = driver.time_constant if driver is not None else 0.0
    comparison = compared(
        cycle,
        at_hand.total,
        task.delta,
        speed=speed if driver is None else None,
        characteristic=characteristic,
        time_constant=lag,
    )
    required = comparison.required
    exact = comparison.rows[0].positional
    addition = required.addition if required is not None else exact.addition
    fast = abs(ratio) * (required.regime.omega_max if required is not None else speed * (1 + task.delta / 2))
    existing = task.inertia * ratio**2
    own = addition / ratio**2
    rim, said = _rim(task, own, fast)
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
        ratio=ratio,
        own=own,
        speed=fast,
        rim=rim,
        picture=energy_mass(cycle, task.delta, mean),
        history=_history(cycle, driver, task.delta, at_hand),
        verdicts=(*said, *_verdicts(addition, existing, required)),
    )


def _history(cycle: Cycle, driver: Driver | None, delta: float, at_hand: ConstantInertia) -> tuple[Trial, ...]:
    """The textbook's correction, where there is a constant inertia to correct and the machine runs with it."""
    if driver is None or at_hand.total <= 0:
        return ()
    try:
        return tuple(correction_history(cycle, driver.characteristic, delta, at_hand.total, driver.time_constant))
    except NoSolutionError:
        return ()


def _material(task: FlywheelTask) -> Material:
    material = MATERIALS[task.material]
    return replace(
        material,
        density=task.density or material.density,
        rim_speed=task.speed_limit or material.rim_speed,
    )


def _rim(task: FlywheelTask, own: float, fast: float) -> tuple[Rim | None, list[Verdict]]:
    """The rim that the task's sizes leave; what cannot be made is told, and no reason to stop."""
    if own <= 0:
        return None, []
    material, diameter, width, thickness = _material(task), task.diameter, task.width, task.thickness
    try:
        if diameter is not None and width is not None:
            rim = rim_of_diameter_and_width(own, diameter, width, fast, material)
        elif width is not None and thickness is not None:
            rim = rim_of_section(own, width, thickness, fast, material)
        elif diameter is not None:
            rim = rim_of_mean_diameter(own, diameter, fast, material)
        else:
            rim = rim_of_proportions(own, fast, material)
    except NoSolutionError as fault:
        return None, [Verdict("warning", f"no such rim: {fault.message}; {fault.remedy}")]
    if rim.thickness > THICK * rim.diameter:
        text = f"the rim is {rim.thickness / rim.diameter:.2g} of its mean diameter thick, more disk than rim"
        return rim, [Verdict("warning", f"{text}: a larger diameter, a wider rim or a faster shaft")]
    if rim.allowed:
        return rim, []
    text = f"the rim runs at {rim.speed:.4g} m/s, above {material.rim_speed:.4g} m/s, the limit for {material.name}"
    return rim, [Verdict("warning", f"{text}: a smaller diameter, a better material or a slower shaft")]


def _verdicts(addition: float, existing: float, required: RequiredInertia | None) -> list[Verdict]:
    said = [Verdict("note", remark) for remark in required.remarks] if required is not None else []
    if addition <= 0 and required is None:
        said.append(Verdict("note", "no flywheel is needed: the inertia at hand keeps the speed even enough"))
    elif existing and existing < addition * (1 - 1e-12):
        text = (
            f"the flywheel of {existing:.6g} kg*m^2 at the input shaft is too light: {addition:.6g} kg*m^2 are needed"
        )
        said.append(Verdict("warning", text))
    return said
