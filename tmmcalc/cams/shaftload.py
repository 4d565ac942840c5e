"""What the cam asks of the shaft that drives it: the follower's inertia and static moments, reduced to the input shaft.

With u the speed of the cam over that of the input shaft, and y the displacement against the angle phi of the cam:

    J = m y'^2 u^2,  dJ/dtheta = 2 m y' y'' u^3       the follower is a mass of the machine (3.39)
    M = P y' u                                       P along the lift: of the spring, the weight, the force of the work
    M_F = -|R| a mu |y'| u                           what guide or pivot takes, with R of the mean speed (3.3.1.6)

At the mean speed -(J' omega^2/2) + M + M_F is the driving torque of the forces stage times -u, exactly.
"""

from __future__ import annotations

from dataclasses import replace
from math import degrees

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.state import state
from tmmcalc.cams.forces.turn import at_angles, loads_of, spans, weight
from tmmcalc.cams.forces.turnforces import NOTHING, TOLERANCE, TurnForces, turn_forces
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.task import CamTask, Force, Loads
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.attached import Attached, AttachedCause, Kind
from tmmcalc.machine.reduction.results import ReductionError

NAME = "cam"
NEAR = 1e-9  # of the period: edges so near to each other are one
MARGIN = 10.0  # for the rounding of products of several functions


def load_of_shaft(task: CamTask, follower: Follower) -> Attached:
    """The follower as a load of the input shaft; raises as the forces do where it jams or has no spring or guide."""
    loads = loads_of(task, "cam_load")
    spring = solve_spring(task, loads)
    loaded = turn_forces(task, follower, loads, spring)
    without = replace(loads, force=Force())
    idle = turn_forces(task, follower, without, spring) if _works(loads) else loaded
    on, phi = _on_shaft(task, loaded, idle)
    ratio = task.ratio

    def rubbed(of: TurnForces, acting: Loads, sense: float) -> tuple[Values, bool]:
        at = at_angles(task, acting, phi)
        now = state(of.carried, replace(at, sense=sense * at.sense))
        return -ratio * now.rubbed.reshape(on.x.shape), bool(np.all(now.works))

    at = at_angles(task, loads, phi)
    y, slope, second, _ = at.motion
    weighed = weight(task, loads)
    static: tuple[tuple[str, Kind, Values], ...] = (
        ("force", "load", at.force - weighed),
        ("weight", "weight", np.full(len(phi), weighed)),
        ("spring", "spring", -(spring.preload + spring.stiffness * y)),
    )
    causes = [
        _of_place(on, f"{NAME} {name}", kind, (ratio * force * slope).reshape(on.x.shape))
        for name, kind, force in static
        if np.any(force * slope)
    ]
    jams_back = False
    if loaded.carried.rubs:
        (forth, _), (rest, _) = rubbed(loaded, loads, 1.0), rubbed(idle, without, 1.0)
        (back, moves), (back_rest, moves_too) = rubbed(loaded, loads, -1.0), rubbed(idle, without, -1.0)
        jams_back = not (moves and moves_too)
        work = float(on.total(forth))
        # what is taken from a shaft that is turned back drives it forwards
        causes.append(AttachedCause(f"{NAME} friction", "friction", forth, rest, -back, -back_rest, work))
    inertia = (loads.mass * (slope * ratio) ** 2).reshape(on.x.shape)
    rise = (2 * loads.mass * slope * second * ratio**3).reshape(on.x.shape)
    speed = loads.speed / ratio
    asked = rise * speed**2 / 2 - sum((cause.moment for cause in causes), np.zeros(on.x.shape))
    (least, least_at), (largest, largest_at) = on.extremes(asked)
    return Attached(
        name=NAME,
        turns=task.turns,
        panels=on,
        inertia=inertia,
        slope=rise,
        causes=tuple(causes),
        speed=speed,
        ratio=ratio,
        inertia_max=on.extremes(inertia)[1][0],
        torque=(Extreme(least, least_at), Extreme(largest, largest_at)),
        jams_back=jams_back,
        notes=tuple(_notes(task, loaded)),
        error=_error(on, np.stack((asked, *(cause.moment for cause in causes))), inertia, rise),
    )


def _works(loads: Loads) -> bool:
    """Whether there is a technological force, which idle running is without."""
    return bool(loads.force.rise or loads.force.back or loads.force.phi is not None)


def _of_place(on: Panels, name: str, kind: Kind, moment: Values) -> AttachedCause:
    """A cause that depends on the position alone, the same where the shaft turns back; idle running has no loads."""
    idle = np.zeros_like(moment) if kind == "load" else moment
    return AttachedCause(name, kind, moment, idle, moment, idle, float(on.total(moment)))


def _on_shaft(task: CamTask, *courses: TurnForces) -> tuple[Panels, Values]:
    """Panels of the angle of the input shaft until the cam repeats, and the angles of the cam at their points (m,)."""
    period = TURN * task.turns
    own = np.concatenate([course.on.edges for course in courses])
    count = round(task.turns * task.ratio)
    places = task.begin + (own[:, None] + TURN * np.arange(count)) / task.ratio
    edges = np.sort(np.append(np.mod(places.ravel(), period), 0.0))
    apart = np.diff(edges, append=period) > NEAR * period  # from the next one: of equal edges the last is kept
    on = Panels(np.concatenate(([0.0], edges[apart & (edges > NEAR * period)], [period])))
    return on, np.mod((on.x.ravel() - task.begin) * task.ratio, TURN)


def _notes(task: CamTask, course: TurnForces) -> list[str]:
    """What is taken, and what does not hold."""
    shaft = "as it turns" if task.ratio == 1 else Phrase("at {ratio:.6g} of its speed", ratio=task.ratio)
    notes: list[str] = [
        Phrase(
            "it loads the crank, {shaft}: J_red has its follower, M_red its forces; its friction is that of the "
            "mean speed. The forces in the linkage, and its balancing moment, are those without it",
            shaft=shaft,
        )
    ]
    load = course.shaped(course.state.load)
    lifted = np.min(load, axis=1) >= -NOTHING * np.max(np.abs(load))
    if task.asked.closure == "force" and lifted.any() and np.any(load):
        lost = spans(course.on.edges, lifted)
        where = [Phrase("{low:.6g} to {high:.6g} deg", low=degrees(a), high=degrees(b)) for a, b in lost]
        notes.append(
            Phrase("nothing presses its follower on it for phi from {where}: it is taken as held there", where=where)
        )
    return notes


def _error(on: Panels, moments: Values, inertia: Values, slope: Values) -> ReductionError:
    """Errors as the panels tell them: what polynomials leave out, and rounding; the resolution of the forces."""

    def relative(rows: Values) -> float:
        size = float(np.max(np.abs(rows)))
        return MARGIN * EPS + (float(np.max(on.tail(rows))) / size if size else 0.0)

    moment = TOLERANCE + relative(moments)
    of_inertia, of_slope = relative(inertia[None]), relative(slope[None])
    worst = max(moment, of_inertia, of_slope)
    return ReductionError(of_inertia, of_slope, moment, worst, worst, moment)
