"""Which stages a scene wants: None, or the reason why it leaves the stage out.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.spec import Spec

TURN = 2 * math.pi


def forces(spec: Spec) -> str | None:
    """Nothing acts on a linkage without loads, masses and springs."""
    masses = any(link.mass or link.inertia for link in spec.mechanism.links)
    if masses or spec.loads or spec.springs:
        return None
    return "no loads, masses or springs: nothing acts on the links"


def reduction(spec: Spec) -> str | None:
    """What does not act cannot be reduced."""
    return forces(spec)


def power(spec: Spec) -> str | None:
    """Work over a cycle needs a cycle: a crank that turns fully."""
    return _acyclic(spec) or forces(spec)


def flywheel(spec: Spec) -> str | None:
    """A flywheel is asked for by the unevenness that it has to keep."""
    if spec.flywheel is None:
        return "no [flywheel]: no unevenness to keep"
    if spec.flywheel.delta is None:
        return "[flywheel] has no delta: no unevenness to keep"
    return power(spec)


def motion(spec: Spec) -> str | None:
    """The speed varies where kinetic energy is stored and something acts."""
    masses = any(link.mass or link.inertia for link in spec.mechanism.links)
    wheel = spec.flywheel is not None and (spec.flywheel.inertia or spec.flywheel.delta)
    further = spec.motion is not None and spec.motion.inertia
    if not (masses or wheel or further or spec.motor is not None):
        return "no masses and no constant inertia: nothing stores kinetic energy"
    return power(spec)


def _acyclic(spec: Spec) -> str | None:
    drive = next((joint for joint in spec.mechanism.joints if joint.name == spec.mechanism.input.joint), None)
    if drive is not None and drive.kind == "prismatic":
        return "the input is a driven slider: its motion is no cycle"
    span = spec.mechanism.grid.span
    if span is not None and abs(span - TURN) > 1e-9:
        return "grid.span is not a full turn: the motion is no cycle"
    return None
