"""The pressure angle over the turn of the cam, against its limits."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import Reached, pressure_angle, reached, remarks
from tmmcalc.cams.pressure.errors import pressure_errors
from tmmcalc.cams.rounding import Errors
from tmmcalc.cams.task import CamTask
from tmmcalc.core.notes import Said
from tmmcalc.core.quantity import derived, headed, quantity
from tmmcalc.core.records import record


@record
class Pressure:
    """Stage ``cam_pressure``: theta over the turn."""

    follower: Follower
    phi: Values = quantity("phi[rad]", "angle of the cam")  # (n,)
    theta: Values = quantity("theta[rad]", "pressure angle")  # (n,)
    labels: tuple[str, ...]  # of the positions
    rise: Reached
    back: Reached
    verdict: str  # "ok" or "pressure_angle_exceeded"
    notes: tuple[Said, ...]
    error: Errors  # estimates, relative: of theta, its extremes, the angles where it is exceeded

    @derived("gamma[deg]", "transmission angle")
    def gamma(self) -> Values:
        """(n,) what |theta| leaves of a right angle."""
        return 90 - np.abs(np.degrees(self.theta))


def solve_pressure(task: CamTask, follower: Follower) -> Pressure:
    """theta at the positions, its exact extremes on rise and return, and where the limits are exceeded.

    Raises `SingularityError` for a follower that comes to the cam's axis.
    """
    at = task.positions
    rise, back = reached(task, follower)
    theta = pressure_angle(follower, at.phi, task.motion)
    notes = (*remarks("rise", rise), *remarks("return", back))
    verdict = "pressure_angle_exceeded" if rise.exceeded or back.exceeded else "ok"
    error = pressure_errors(task, follower, theta, (rise, back))
    return Pressure(follower, at.phi, theta, at.labels, rise, back, verdict, notes, error)


def pressure_columns(result: Pressure) -> dict[str, Values]:
    """The table: positions, theta and the transmission angle by their headers."""
    return {"i": np.array(result.labels), **headed(result, "phi[deg]", "theta[deg]", "gamma")}
