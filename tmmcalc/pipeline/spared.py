"""Which of the results that it could use a stage does without: what the spec gives itself need not be computed.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.project import Spec

TRAIN = ("criteria",)  # the stage that hands the best train to the machine


def strength(spec: Spec) -> tuple[str, ...]:
    """A torque, or the moment that it follows from, stands in place of the largest reduced moment."""
    table = spec.strength
    given = table is None or table.torque is not None or table.moment is not None
    return ("reduction",) if given else ()


def pair(spec: Spec) -> tuple[str, ...]:
    """Pairs that are written out need no train."""
    return () if pairs_of_train(spec) else TRAIN


def power(spec: Spec) -> tuple[str, ...]:
    """The ratio of the gears matters to a motor, and is given or that of the train."""
    return TRAIN if spec.motor is None or _ratio_given(spec) else ()


def flywheel(spec: Spec) -> tuple[str, ...]:
    """The gears have an inertia and a ratio, both given, or else those of the train."""
    table = spec.transmission
    return TRAIN if table is not None and table.inertia is not None and _ratio_given(spec) else ()


def motion(spec: Spec) -> tuple[str, ...]:
    """As of the flywheel; and a flywheel that is there need not be sized."""
    there = spec.flywheel is not None and bool(spec.flywheel.inertia)
    return (*flywheel(spec), *(("flywheel",) if there else ()))


def transient(spec: Spec) -> tuple[str, ...]:
    """As of the motion."""
    return motion(spec)


def cam_forces(spec: Spec) -> tuple[str, ...]:
    """A cam with a speed of its own does not turn with the crank."""
    return ("motion",) if spec.cam is None or spec.cam.speed is not None else ()


def cam_strength(spec: Spec) -> tuple[str, ...]:
    """As of the forces."""
    return cam_forces(spec)


def cam_optimum(spec: Spec) -> tuple[str, ...]:
    """As of the forces."""
    return cam_forces(spec)


def cam_elastic(spec: Spec) -> tuple[str, ...]:
    """As of the forces."""
    return cam_forces(spec)


def feasibility(spec: Spec) -> tuple[str, ...]:
    """Stages of which no constraint asks anything; the designs of a synthesis are judged by those of their specs."""
    from tmmcalc.pipeline.stages import STAGES

    asked = {"synthesis", *(constraint.stage for constraint in spec.constraints)}
    return tuple(name for name in STAGES["feasibility"].uses if name not in asked)


def pairs_of_train(spec: Spec) -> bool:
    """Whether the pairs of the spec are those of its train."""
    return spec.pair is not None and spec.pair.of_train


def _ratio_given(spec: Spec) -> bool:
    """Whether the ratio of the gears is given, by itself or as that of the shafts."""
    return bool(spec.shafts) or (spec.transmission is not None and spec.transmission.ratio is not None)
