"""Where an arm is singular, or near it, and where it does not reach; found over the whole time, not read off the rows.

    r = 0      the gripper on the base's axis: ψ is not defined
    l_3 = 0    the gripper at the shoulder of a spherical arm: φ_2 is not defined
    sin = 0    both arms of an angular one in line, stretched or folded: the border of its reach

Every measure is a squared length or sine, smooth through its zero.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError, SingularityError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.panels import Values, resolved
from tmmcalc.core.plane import Plane
from tmmcalc.core.timerows import over_time
from tmmcalc.linkage.results import Grade
from tmmcalc.manipulators.arms import elbow_margin, meridian
from tmmcalc.manipulators.courses import Course
from tmmcalc.manipulators.results import SingularPlace
from tmmcalc.manipulators.task import Arm

WHERE = "manipulator, inverse problem"
SINGULAR = 1e-6  # relative size below which rates have no trustworthy digits
NEARLY = 0.05  # below it the joints move 20 times as fast as elsewhere
SAME = 1e-6  # of the duration: minima nearer than this are one
BEYOND = 1e-12  # of the squared sine: rounding at the border of the reach

Gripper = Callable[[Values], Values]  # places (D, n) at times (n,)


class _Measure(NamedTuple):
    """A squared measure: its name, its values at places (D, n), the scale that it is judged by."""

    what: str
    square: Callable[[Values], Values]
    scale: float


def find_singular(arm: Arm, course: Course, place: Gripper) -> tuple[SingularPlace, ...]:
    """All local minima of the measures that are singular or nearly so, in the order of time."""
    found = [
        SingularPlace(measure.what, t, math.sqrt(max(value, 0.0)), math.sqrt(max(value, 0.0)) / measure.scale)
        for measure, minima in _minima(arm, course, place)
        for t, value in minima
        if value < (NEARLY * measure.scale) ** 2
    ]
    return tuple(sorted(found, key=lambda each: (each.t, each.what)))


def check_reach(arm: Arm, course: Course, place: Gripper) -> None:
    """Raise `NoSolutionError` where the arms do not reach, `SingularityError` at a singular place, with its time."""
    for measure, minima in _minima(arm, course, place):
        for t, value in sorted(minima):
            if value < -BEYOND:
                raise _unreached(arm, t, place)
            if value < (SINGULAR * measure.scale) ** 2:
                raise _singular(arm, measure, t, place)


def _minima(arm: Arm, course: Course, place: Gripper) -> list[tuple[_Measure, list[tuple[float, float]]]]:
    """Every measure with its local minima (t, value), both limits at breaks included."""
    sample = place(np.linspace(0.0, course.duration, 64))
    measures = _measures(arm, sample)
    if not measures:
        return []
    if not course.duration:
        return [(measure, [(0.0, float(measure.square(sample[:, :1])[0]))]) for measure in measures]
    on, values, _ = resolved(
        lambda t: np.stack([measure.square(place(t)) for measure in measures]),
        over_time(course.duration, course.breaks),
    )
    apart = SAME * course.duration
    return [(measure, _lowest(*on.turning(row), apart)) for measure, row in zip(measures, values, strict=True)]


def _lowest(at: Values, value: Values, apart: float) -> list[tuple[float, float]]:
    """The local minima among turning points, by time; of those that are not ``apart`` the lower."""
    order = np.argsort(at, kind="stable")
    merged: list[tuple[float, float]] = []
    for t, v in zip(at[order].tolist(), value[order].tolist(), strict=True):
        if not merged or t - merged[-1][0] > apart:
            merged.append((t, v))
        elif v < merged[-1][1]:
            merged[-1] = (t, v)
    values = np.array([v for _, v in merged])
    before, after = np.append(np.inf, values[:-1]), np.append(values[1:], np.inf)
    return [merged[k] for k in np.flatnonzero((values <= before) & (values <= after))]


def _measures(arm: Arm, sample: Values) -> list[_Measure]:
    """The measures of the arm; a distance is judged by the largest distance of the motion."""

    def plane(p: Values) -> Plane:
        states = np.stack((p, np.zeros_like(p), np.zeros_like(p)))
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(meridian(arm, states)[0])

    measures = []
    if arm.spatial:
        largest = float(np.max(np.abs(sample[0] + 1j * sample[1])))
        measures.append(_Measure("r", lambda p: p[0] ** 2 + p[1] ** 2, largest or 1.0))
    if arm.kind == "spherical":
        largest = float(np.max(np.abs(plane(sample))))
        measures.append(_Measure("l_3", lambda p: np.abs(plane(p)) ** 2, largest or 1.0))
    if arm.kind == "angular":
        unit = (2 * arm.upper * arm.forearm) ** 2
        measures.append(_Measure("elbow", lambda p: elbow_margin(arm, plane(p)) / unit, 1.0))
    return measures


def _distance(arm: Arm, t: float, place: Gripper) -> float:
    """Distance [m] of the gripper from the shoulder."""
    p = place(np.array([t]))
    flat = math.hypot(*p[:-1, 0].tolist())
    return math.hypot(flat, float(p[-1, 0]) - arm.height)


def _unreached(arm: Arm, t: float, place: Gripper) -> NoSolutionError:
    distance = _distance(arm, t, place)
    least, most = abs(arm.upper - arm.forearm), arm.upper + arm.forearm
    near = distance < least
    return NoSolutionError(
        f"the gripper is {distance:.9g} m from the shoulder at t = {t:.6g} s: the arms reach from {least:.9g} m "
        f"to {most:.9g} m",
        where=WHERE,
        value=distance,
        limit=least if near else most,
        remedy="move the path, or change upper_arm and forearm",
    )


def _singular(arm: Arm, measure: _Measure, t: float, place: Gripper) -> SingularityError:
    number = math.sqrt(max(float(measure.square(place(np.array([t])))[0]), 0.0))
    causes = {
        "r": "the gripper passes the axis of the base, where psi is not defined",
        "l_3": "the gripper passes the shoulder, where phi_2 is not defined",
        "elbow": "both arms are in line, at the border of their reach",
    }
    shown = f"sin = {number:.3g}" if measure.what == "elbow" else f"{measure.what} = {number:.3g} m"
    return SingularityError(
        f"singular at t = {t:.6g} s ({shown}): {causes[measure.what]}; the joints' rates are not defined",
        where=WHERE,
        value=number / measure.scale,
        limit=SINGULAR,
        remedy="lead the path past that place",
    )


def singular_grades(places: tuple[SingularPlace, ...], inverse: bool) -> tuple[Grade, ...]:
    """Warnings at places that are nearly singular; in the direct problem also at those that are."""
    grades = []
    for each in places:
        shown = (
            Phrase("sin = {value:.4g}", value=each.value)
            if each.what == "elbow"
            else Phrase("{what} = {value:.4g} m", what=each.what, value=each.value)
        )
        if each.relative < SINGULAR and not inverse:
            text = Phrase(
                "singular at t = {t:.6g} s ({shown}): the inverse problem has no rates there", t=each.t, shown=shown
            )
        else:
            text = Phrase(
                "nearly singular at t = {t:.6g} s ({shown}): the joints turn {relative:.4g} times faster",
                t=each.t,
                shown=shown,
                relative=1 / each.relative,
            )
        grades.append(Grade("warning", Phrase("joint {joint}", joint=_JOINTS[each.what]), text))
    return tuple(grades)


_JOINTS = {"r": "psi", "l_3": "phi_2", "elbow": "elbow"}
