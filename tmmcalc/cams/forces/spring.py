"""The return spring: preload and stiffness by the safety of the contact or by the tangent, and what they reach.

P is the force of inertia and weight that lifts the follower off, Q = Q0 + c dS that of the spring, K1 the safety:

    safety    Q0 = (K1 - 1) P_M,  Q0 + c dS_M = K1 P_M at the largest P of rise and return        (5.54 to 5.57)
              and no less than K1 P at the largest P of the other phase, which may stand lower down
              exact: the same Q0 and the least c with Q >= K1 P all over the turn
    preload   c = max (P + F_min)/(f1 + dS),  Q0 = c f1: the tangent from the point -f1 to the curve of P + F_min

The least c, and the safety that a spring reaches, are the zeros of functions

    G(c) = max (K1 P - Q0 - c dS),  H(K) = min (Q - K P)

that are convex, so Newton's steps from one side reach them; each asks for one extreme over the turn.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.forces.coils import by_index, wound
from tmmcalc.cams.forces.results import Governing, SpringFound
from tmmcalc.cams.forces.turn import at_angles, smooth_panels, weight
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import on_phase
from tmmcalc.cams.program import SAME, TURN, Program, levelled
from tmmcalc.cams.task import CamTask, Loads, Spring
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.records import record

DEFLECTION = 0.4  # f1 of the method preload, part of the stroke
STEPS = 30
LEVEL = 1e-12  # of the largest: values that count as equal
LAST = 1e-8  # of the result: after so small a step of Newton the next would be below rounding


@record
class Lifting:
    """The force P that lifts the follower off, over the turn."""

    on: Panels
    lift: Values  # dS (K, N)
    force: Values  # P (K, N)


@record
class Peak:
    """The largest P of a phase."""

    phase: str
    force: float  # P_M
    lift: float  # dS_M
    phi: float


def lifting(task: CamTask, loads: Loads) -> Lifting:
    """P of inertia and weight on the panels of the motion."""
    on = task.program.panels if task.turning is None else smooth_panels(task, loads)
    at = at_angles(task, loads, on.x.ravel())
    force = lifting_force(task, loads, at.acceleration)
    return Lifting(on, at.motion[0].reshape(on.x.shape), force.reshape(on.x.shape))


def lifting_force(task: CamTask, loads: Loads, acceleration: Values) -> Values:
    """P of inertia and weight along the lift (5.52)."""
    force: Values = weight(task, loads) - loads.mass * loads.speed**2 * acceleration
    return force


def solve_spring(task: CamTask, loads: Loads) -> SpringFound:
    """The spring as it is asked for, and the safety that it reaches.

    Raises `NoSolutionError` where no stiffness keeps the follower on the cam.
    """
    asked, lifted = loads.spring, lifting(task.sprung, loads)
    tops = peaks_of(task, lifted)
    top = max(tops, key=lambda each: each.force) if tops else None
    place, governing = top, None
    if asked.method == "preload":
        stiffness, preload, place = _by_tangent(task, asked, lifted)
    elif asked.method == "safety":
        stiffness, preload, governing = _by_safety(asked, lifted, tops)
    else:
        stiffness, preload = (asked.stiffness, asked.preload) if asked.method == "given" else (0.0, 0.0)
    safety = asked.safety if asked.method == "safety" and top else None
    exact = _least(lifted, safety * lifted.force - preload, 0.0) if safety is not None else None
    reached = _reached(lifted if task.turning is None else lifting(task, loads), stiffness, preload) if top else None
    highest = preload + stiffness * task.program.highest
    return SpringFound(
        method=asked.method,
        stiffness=stiffness,
        preload=preload,
        highest=highest,
        asked=safety,
        lifting=place.force if place else None,
        phi=place.phi if place else None,
        lift=place.lift if place else None,
        phase=place.phase if place else "",
        governing=governing,
        exact=exact[0] if exact else None,
        exact_phi=exact[1] if exact else None,
        reached=reached[0] if reached else None,
        reached_phi=reached[1] if reached else None,
        wire=wound(task, asked, stiffness, preload, highest),
        sizes=by_index(task, asked, stiffness, highest),
    )


def peaks_of(task: CamTask, lifted: Lifting) -> list[Peak]:
    """M of rise and of return, where P is largest and above 0; of equal values that of least lift (fig. 5.20)."""
    found = []
    for kind in ("rise", "return"):
        part, force = on_phase(task.program, lifted.on, lifted.force, kind)
        at, values = part.turning(levelled(force))
        at = _on_edges(task.program, at)
        lift = task.program.at(at)[0]
        highest = np.max(values)
        level = np.flatnonzero(values >= highest - LEVEL * abs(highest))
        first = level[np.argmin(lift[level])]
        if values[first] > 0:
            found.append(Peak(kind, float(values[first]), float(lift[first]), float(at[first])))
    return found


def _on_edges(program: Program, at: Values) -> Values:
    """Places (n,), those within rounding of an edge on it: a smooth peak that stands there is found beside it."""
    near = program.edges[np.argmin(np.abs(at[:, None] - program.edges), axis=1)]
    return np.where(np.abs(at - near) <= SAME * TURN, near, at)


def _by_safety(asked: Spring, lifted: Lifting, tops: list[Peak]) -> tuple[float, float, Governing | None]:
    """c and Q0 for the larger P_M; where the other phase lifts lower down, stiff enough for it as well."""
    if not tops:
        return 0.0, 0.0, None
    safety, top = asked.safety, max(tops, key=lambda each: each.force)
    preload = (safety - 1) * top.force
    if asked.exact:
        preload = max(preload, safety * _at_rest(lifted))
        return _found(lifted, safety * lifted.force - preload)[0], preload, None
    if any(each.lift <= 0 for each in tops):
        raise _no_spring("the largest lifting force stands at the lowest position")
    rule = top.force / top.lift
    worst = max(tops, key=lambda each: (safety * each.force - preload) / each.lift)
    stiffness = (safety * worst.force - preload) / worst.lift
    if stiffness <= rule * (1 + LEVEL):
        return rule, preload, None
    return stiffness, preload, Governing(worst.phase, worst.force, worst.lift, worst.phi, rule)


def _at_rest(lifted: Lifting) -> float:
    """The largest P at the lowest position, which the preload alone has to hold."""
    ends = lifted.on.ends(np.stack((lifted.lift, lifted.force)))
    low = [force[lift <= LEVEL * np.max(lifted.lift)] for lift, force in ends]
    return float(max(np.max(force, initial=0.0) for force in low))


def _found(lifted: Lifting, needed: Values, deflection: float = 0.0) -> tuple[float, float]:
    """What `_least` finds; raises `NoSolutionError` where nothing does."""
    found = _least(lifted, needed, deflection)
    if found is None:
        raise _no_spring("a force lifts the follower off its lowest position, where the preload is too small")
    return found


def _least(lifted: Lifting, needed: Values, deflection: float) -> tuple[float, float] | None:
    """The least c with c (deflection + dS) >= needed over the turn, and its place, by Newton on G from below.

    0 where nothing is needed; None where something is that has no arm.
    """
    on, arm = lifted.on, lifted.lift + deflection
    level = LEVEL * float(np.max(np.abs(needed)))
    c, place = 0.0, 0.0
    for _ in range(STEPS):
        _, (excess, at) = on.extremes(levelled(needed - c * arm))
        length = float(on.at(arm, np.array([at]))[0])
        if length <= LEVEL * float(np.max(arm)) or not np.isfinite(excess / length):
            return None if excess > level else (c, place)
        if c == 0 and excess <= level:
            break
        step, place = excess / length, at
        c += step
        if step <= LAST * c:
            break
    return c, place


def _no_spring(why: str) -> NoSolutionError:
    return NoSolutionError(
        f"no stiffness keeps the follower on the cam: {why}",
        where="cam_forces, spring",
        remedy="give [cam.spring] exact = true, or method = 'given' with a preload",
    )


def _by_tangent(task: CamTask, asked: Spring, lifted: Lifting) -> tuple[float, float, Peak | None]:
    deflection = DEFLECTION * task.program.stroke if asked.deflection is None else asked.deflection
    c, at = _found(lifted, lifted.force + asked.least, deflection)
    if c == 0:
        return 0.0, 0.0, None
    force = _before_and_after(lifted.on, lifted.force, at)
    number = min(max(int(np.searchsorted(task.program.starts, at)) - 1, 0), len(task.program.phases) - 1)
    lift = float(task.program.at(np.array([at]))[0, 0])
    return c, c * deflection, Peak(task.program.phases[number].kind, float(force), lift, at)


def _reached(lifted: Lifting, stiffness: float, preload: float) -> tuple[float, float]:
    """The least Q/P where P > 0 and its place, by Newton on H from above."""
    on, spring = lifted.on, preload + stiffness * lifted.lift
    _, (top, at) = on.extremes(levelled(lifted.force))
    ratio = float(on.at(spring, np.array([at]))[0]) / top
    for _ in range(STEPS):
        (short, place), _ = on.extremes(levelled(spring - ratio * lifted.force))
        lifts = _before_and_after(on, lifted.force, place)
        if short >= 0 or lifts <= LEVEL * top:
            break
        at, step = place, short / lifts
        ratio += step
        if step > -LAST * ratio:
            break
    return max(ratio, 0.0), at


def _before_and_after(on: Panels, values: Values, at: float) -> float:
    """The larger of the two limits at a place."""
    x = np.array([at])
    return float(max(on.at(values, x)[0], on.at(values, x, before=True)[0]))
