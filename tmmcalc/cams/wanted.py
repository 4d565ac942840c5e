"""Which stages of the cam room a scene wants, and which results they read, where the spec gives none.

Nothing heavy is imported here, because plans ask about every stage.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.linkage.wanted import slides

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.tables.cam import CamTable

NO_CAM = "no [cam]: no cam is asked for"


def forces(spec: CamTables) -> str | None:
    """What acts is known from the loads and the speed."""
    if spec.cam is None:
        return NO_CAM
    if spec.cam.loads is None:
        return "no [cam.loads]: nothing is known of masses and forces"
    return _speed(spec, spec.cam)


def load(spec: CamTables) -> str | None:
    """The machine feels the cam where a shaft of it is named."""
    if spec.cam is not None and spec.cam.shaft is None:
        return "no shaft in [cam]: no shaft of the machine is loaded by it"
    return forces(spec)


def read_at_speed(spec: CamTables) -> tuple[str, ...]:
    """A cam with a speed of its own does not turn with the crank."""
    return () if spec.cam is None or spec.cam.speed is not None else ("motion",)


def strength(spec: CamTables) -> str | None:
    """Requirements are judged by the forces."""
    lacking = "no [cam.requirements]: neither materials nor sizes to judge"
    return forces(spec) or (lacking if spec.cam is None or spec.cam.requirements is None else None)


def optimum(spec: CamTables) -> str | None:
    """An optimum is asked for."""
    lacking = "no [cam.optimum]: no optimum is asked for"
    return forces(spec) or (lacking if spec.cam is None or spec.cam.optimum is None else None)


def elastic(spec: CamTables) -> str | None:
    """Only an elastic train vibrates, with the mass of the loads or one of its own."""
    if spec.cam is None:
        return NO_CAM
    return "no [cam.elastic]: the follower is rigid" if spec.cam.elastic is None else _speed(spec, spec.cam)


def _speed(spec: CamTables, cam: CamTable) -> str | None:
    """A speed of the cam's own, or of the shaft that it turns with."""
    turns = spec.torque is not None or (spec.mechanism is not None and not slides(spec))
    return None if cam.speed is not None or turns else "[cam] has no speed: inertia forces are not known"
