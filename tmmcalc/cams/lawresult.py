"""The motion of the follower over the turn: rows, constants of the laws, extremes with their angles, shocks.

y is the displacement from the lowest position [m or rad], its derivatives are by the angle of the cam; in time they
are multiplied by omega, omega^2, omega^3.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.follower import along
from tmmcalc.cams.lawerrors import constant_errors, extreme_errors, motion_errors
from tmmcalc.cams.laws.constants import LEVEL, LawConstants, constants
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.overshoot import overshoot_remarks
from tmmcalc.cams.program import PhaseKind, Positions, Program
from tmmcalc.cams.rounding import Errors, joints
from tmmcalc.cams.task import CamTask
from tmmcalc.core.notes import Phrase, Said
from tmmcalc.core.quantity import Quantity, derived, headed, in_degrees, quantity
from tmmcalc.core.records import record

POINTS = {"rise": "a", "high dwell": "b", "return": "c", "low dwell": "d"}  # at which a phase begins (fig. 5.2)
DISPLACEMENT = Quantity("d{coordinate}[{size}]", "displacement from the lowest position", symbol="y")
DERIVATIVE = {  # by whether the follower turns
    False: Quantity("S{order}[m]", "derivative {order} of the displacement by the angle of the cam"),
    True: Quantity("psi{order}", "derivative {order} of the displacement by the angle of the cam"),
}
RATES = {  # by whether the follower turns
    False: (Quantity("v[m/s]", "velocity"), Quantity("a[m/s^2]", "acceleration"), Quantity("jerk[m/s^3]", "jerk")),
    True: (
        Quantity("omega[rad/s]", "angular velocity"),
        Quantity("eps[rad/s^2]", "angular acceleration"),
        Quantity("jerk[rad/s^3]", "angular jerk"),
    ),
}
RATE_EXTREMES = (
    Quantity("velocity_{extreme}[{size}/s]", "{extreme} of the velocity"),
    Quantity("acceleration_{extreme}[{size}/s^2]", "{extreme} of the acceleration"),
    Quantity("jerk_{extreme}[{size}/s^3]", "{extreme} of the jerk"),
)
SHOCKS = {1: "rigid shock", 2: "soft shock", 3: "jump of the jerk"}


@record
class PhaseMotion:
    """A phase of the turn; angles [rad]."""

    kind: PhaseKind
    begin: float = quantity("{phase}_begin[rad]", "angle of the cam at the beginning of the {phase}")
    end: float = quantity("{phase}_end[rad]", "angle of the cam at the end of the {phase}")
    low: float  # y at its begin [m or rad]
    high: float  # y at its end
    constants: LawConstants | None  # of its law; None: dwell


@record
class MotionExtreme:
    """The largest or least value of a derivative of y over the turn."""

    order: int  # 1: y', 2: y'', 3: y'''
    value: float = quantity(
        "{coordinate}{order}_{extreme}[{slope}]", "extreme of derivative {order} by the angle of the cam: {extreme}"
    )
    phi: float = quantity(  # of the first place that has it
        "{coordinate}{order}_{extreme}_at_phi[rad]",
        "angle of the cam where derivative {order} has its extreme: {extreme}",
    )


@record
class Shock:
    """A jump of a derivative of y."""

    order: int = quantity("order", "order of the derivative: 1 rigid shock, 2 soft shock, 3 jump of the jerk")
    phi: float = quantity("phi[rad]", "angle of the cam")
    jump: float = quantity("jump[{slope}]", "jump of the derivative: what is after less what is before")  # [m or rad]


@record
class LawResult:
    """The motion of a follower at n rows."""

    positions: Positions  # (n,)
    turns: bool  # a rocker: y [rad], else [m]
    motion: Values  # (4, n): y, y', y'', y'''
    phase: Indices  # (n,) number of the phase
    part: Values = quantity("k", "part of its phase; 0 in the low dwell, 1 in the high one")  # (n,)
    speed: float | None = quantity("omega[rad/s]", "speed of the cam")
    stroke: float = quantity("stroke[{size}]", "stroke of the follower", symbol="h")
    phases: tuple[PhaseMotion, ...]
    extremes: tuple[MotionExtreme, ...]  # largest and least of y', y'', y'''
    shocks: tuple[Shock, ...]
    remarks: tuple[Said, ...]
    error: Errors  # estimates, relative: of y and its derivatives, of their extremes, of the constants

    @property
    def labels(self) -> tuple[str, ...]:
        """Labels of the rows."""
        return self.positions.labels

    @derived("phase", "phase of the turn")
    def kinds(self) -> NDArray[np.str_]:
        """(n,)."""
        return np.array([each.kind for each in self.phases])[self.phase]

    @property
    def in_time(self) -> Values | None:
        """Velocity, acceleration, jerk (3, n) [m or rad, s]; None without a speed."""
        if self.speed is None:
            return None
        return self.motion[1:] * self.speed ** np.arange(1, 4)[:, None]


def solve_law(task: CamTask) -> LawResult:
    """Rows, constants and shocks of the motion that a task gives."""
    program, rows = task.program, task.positions
    phase = program.places[0][rows.piece]
    shocks = tuple(_shocks(program))
    turns = task.asked.kind == "oscillating"
    phases, extremes = tuple(_phases(program)), tuple(_extremes(program))
    return LawResult(
        rows,
        turns,
        task.motion,
        phase,
        _parts(program, rows.phi, phase),
        None if task.loads is None else task.loads.speed,
        program.stroke,
        phases,
        extremes,
        shocks,
        (*task.remarks, *overshoot_remarks(program, turns), *_remarks(shocks, turns)),
        _errors(task, phases, extremes),
    )


def _errors(task: CamTask, phases: tuple[PhaseMotion, ...], extremes: tuple[MotionExtreme, ...]) -> Errors:
    program = task.program
    laws = [
        constant_errors(phase.law, told.constants)
        for phase, told in zip(program.wider.phases, phases, strict=True)
        if phase.law is not None and told.constants is not None
    ]
    missed = joints(program)
    found = motion_errors(program, task.positions, task.motion, missed)
    found["extremes"] = extreme_errors(
        program, missed, *zip(*((each.order, each.value, each.phi) for each in extremes), strict=True)
    )
    return found | {"constants": max(laws, default=0.0)}


def _parts(program: Program, phi: Values, phase: Indices) -> Values:
    """k (n,) of the phases that hold phi; it runs from 1 to 0 on the return."""
    angles = np.array([each.angle for each in program.phases])
    k = np.clip((phi - program.starts[phase]) / angles[phase], 0.0, 1.0)
    back = np.array([each.end < each.start for each in program.phases])
    still = np.array([-1.0 if each.moves else float(each.start > 0) for each in program.phases])
    return np.where(still[phase] >= 0, still[phase], np.where(back[phase], 1 - k, k))


def _phases(program: Program) -> Iterator[PhaseMotion]:
    for begin, each in zip(program.starts.tolist(), program.phases, strict=False):
        law = None if each.law is None else constants(each.law)
        yield PhaseMotion(each.kind, begin, begin + each.angle, each.start, each.end, law)


def _extremes(program: Program) -> Iterator[MotionExtreme]:
    """Both one-sided limits count where something jumps; of equal values the first."""
    on, sampled = program.panels, program.sampled
    for order in (1, 2, 3):
        at, found = on.turning(sampled[order])
        for sign in (1, -1):
            best = np.max(sign * found)
            level = np.flatnonzero(sign * found >= best - LEVEL * np.max(np.abs(found)))
            first = level[np.argmin(at[level])]
            yield MotionExtreme(order, float(sign * best) + 0.0, float(at[first]))


def _shocks(program: Program) -> Iterator[Shock]:
    """All jumps by angle, the gravest first at one angle."""
    for place, jumps in zip(program.edges.tolist(), program.jumps.T.tolist(), strict=False):
        for order in (1, 2, 3):
            if jumps[order]:
                yield Shock(order, place, jumps[order])


def _remarks(shocks: tuple[Shock, ...], turns: bool) -> Iterator[str]:
    factor = 1.0 if turns else 1e3
    by = "by {jump:+.6g} at phi = {phi:.6g} deg" if turns else "by {jump:+.6g} mm at phi = {phi:.6g} deg"
    for order, text in ((1, "warning: {shock}: y' jumps {places}"), (2, "note: {shock}: y'' jumps {places}")):
        found = [shock for shock in shocks if shock.order == order]
        if found:
            places = [Phrase(by, jump=factor * shock.jump, phi=degrees(shock.phi)) for shock in found]
            yield Phrase(text, shock=SHOCKS[order], places=places)


def law_columns(result: LawResult) -> dict[str, np.ndarray]:
    """Columns of all rows in SI, angles in deg, by their headers."""
    places = along(result.turns)
    motion = [DISPLACEMENT.of(**places), *(DERIVATIVE[result.turns].of(order=order) for order in (1, 2, 3))]
    found: dict[str, np.ndarray] = {"i": np.array(result.positions.labels)}
    found |= headed(result, "kinds") | headed(result.positions, "degrees") | headed(result, "part")
    found |= {told.key: row for told, row in zip(motion, result.motion, strict=True)}
    timed = result.in_time
    if timed is not None:
        found |= {told.key: row for told, row in zip(RATES[result.turns], timed, strict=True)}
    return in_degrees(found)
