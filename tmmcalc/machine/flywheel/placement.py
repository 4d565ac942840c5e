"""The flywheel on a shaft, and its rim: the asked shaft, and for comparison the input shaft and that of the motor.

A wheel on a shaft that turns u times as fast as the input shaft counts u^2 times there, so it needs J/u^2 only.
Beyond the gears it does not relieve them, though: they carry the peaks of the load between the wheel and the crank.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.machine.flywheel.materials import MATERIALS, Material
from tmmcalc.machine.flywheel.rim import (
    Rim,
    largest_diameter,
    rim_of_diameter_and_thickness,
    rim_of_diameter_and_width,
    rim_of_mean_diameter,
    rim_of_proportions,
    rim_of_section,
)
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.verdicts import Verdict

THICK = 0.4  # thickness over mean diameter above which a rim is hardly one
TOO_FAST = "rim speed"  # name of the verdict on a rim that runs too fast
SMALLEST = 0.01  # mean diameter below which there is no rim to speak of [m]

ShaftName = Literal["input", "motor", "other"]


@record
class Wheel:
    """The flywheel on one shaft."""

    shaft: ShaftName
    ratio: float  # u, speed of the shaft over that of the input shaft
    inertia: float = quantity("J_{shaft}_shaft[kg*m^2]", "inertia J/u^2 of the flywheel on the {shaft} shaft")
    speed: float  # largest speed of the shaft [rad/s]
    rim: Rim | None  # None if no flywheel is needed, or none can be made
    verdicts: tuple[Verdict, ...]  # what speaks against it


def wheels(
    task: FlywheelTask, addition: float, speed: float, ratio: float, motor_ratio: float | None
) -> tuple[Wheel, ...]:
    """The wheel that adds ``addition`` [kg*m^2] to the input shaft: on the shaft of the task, then on the others.

    ``speed`` is the largest one of the input shaft [rad/s], ``ratio`` that of the task's shaft over it and
    ``motor_ratio`` that of the motor, None without one. The sizes of the task hold for its own shaft; the
    others have a rim of the usual proportions.
    """
    free = replace(task, diameter=None, width=None, thickness=None)
    known: tuple[tuple[ShaftName, float | None], ...] = (("input", 1.0), ("motor", motor_ratio))
    others = [(name, u) for name, u in known if name != task.shaft and u is not None and abs(u) != abs(ratio)]
    own = _wheel(task, task.shaft, ratio, addition, speed)
    return (own, *(_wheel(free, name, u, addition, speed) for name, u in others))


def _wheel(task: FlywheelTask, shaft: ShaftName, ratio: float, addition: float, speed: float) -> Wheel:
    own, fast = addition / ratio**2, abs(ratio) * speed
    rim, against = _rim(task, own, fast)
    return Wheel(shaft, ratio, own, fast, rim, against)


def _rim(task: FlywheelTask, own: float, fast: float) -> tuple[Rim | None, tuple[Verdict, ...]]:
    """The rim that the task's sizes leave; what cannot be made is told, and no reason to stop."""
    if own <= 0:
        return None, ()
    material = rim_material(task)
    edge = largest_diameter(fast, material)
    if task.diameter is task.width is task.thickness is None and edge < SMALLEST:
        text = Phrase(
            "no rim is sized: at {fast:.4g} rad/s {material} allows {edge:.3g} mm of outer diameter; a slower shaft",
            fast=fast,
            material=material.name,
            edge=1e3 * edge,
        )
        return None, (Verdict("warning", text, edge, SMALLEST, "m", "outer diameter"),)
    try:
        rim = _sized(task, own, fast, material)
    except NoSolutionError as fault:
        text = Phrase("no such rim: {message}; {remedy}", message=fault.message, remedy=fault.remedy)
        return None, (Verdict("warning", text),)
    if rim.diameter < SMALLEST:
        text = Phrase(
            "no rim is sized: for {own:.4g} kg*m^2 its mean diameter would be {diameter:.3g} mm",
            own=own,
            diameter=1e3 * rim.diameter,
        )
        return None, (Verdict("warning", text, rim.diameter, SMALLEST, "m", "mean diameter"),)
    return rim, tuple(_against(rim))


def _against(rim: Rim) -> Iterator[Verdict]:
    """What speaks against a rim: its thickness, its speed."""
    if rim.thickness > THICK * rim.diameter:
        text = Phrase(
            "the rim is {thickness:.2g} of its mean diameter thick, more disk than rim: a larger diameter, a wider rim "
            "or a faster shaft",
            thickness=rim.thickness / rim.diameter,
        )
        yield Verdict("warning", text, rim.thickness / rim.diameter, THICK, name="thickness/diameter")
    if not rim.allowed:
        text = Phrase(
            "the rim runs at {speed:.4g} m/s, above {rim_speed:.4g} m/s, the limit for {material}: a smaller diameter, "
            "a better material or a slower shaft",
            speed=rim.speed,
            rim_speed=rim.material.rim_speed,
            material=rim.material.name,
        )
        yield Verdict("warning", text, rim.speed, rim.material.rim_speed, "m/s", TOO_FAST)


def _sized(task: FlywheelTask, own: float, fast: float, material: Material) -> Rim:
    diameter, width, thickness = task.diameter, task.width, task.thickness
    if diameter is not None and width is not None:
        return rim_of_diameter_and_width(own, diameter, width, fast, material)
    if diameter is not None and thickness is not None:
        return rim_of_diameter_and_thickness(own, diameter, thickness, fast, material)
    if width is not None and thickness is not None:
        return rim_of_section(own, width, thickness, fast, material)
    if diameter is not None:
        return rim_of_mean_diameter(own, diameter, fast, material)
    return rim_of_proportions(own, fast, material)


def rim_material(task: FlywheelTask) -> Material:
    """The material of the rim, with what of its own data the task gives."""
    material = MATERIALS[task.material]
    return replace(
        material,
        density=task.density or material.density,
        rim_speed=task.speed_limit or material.rim_speed,
    )
