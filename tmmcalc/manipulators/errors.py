"""What rounding leaves of a motion: rows of it again in extended precision, from the task on.

Near a singular place the joints' rates grow without bound and their errors with them, so the rows at which each
column is largest are among those that are taken. All instants are the rows' own. Errors are relative to

    place, velocity, acceleration    of the gripper: to the largest coordinate
    s, v, a                          along the path: to the largest value
    angles                           to the largest, or to a radian where all are smaller
    other joints and all rates       to the largest sum of the sizes of their terms, which is above zero in a joint that
                                     stands by the sum of them
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from tmmcalc.core.numerics.extended import CHAIN, EPS, MARGIN, PI, WIDER, spread, widened
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Plane
from tmmcalc.manipulators.arms import direct, elbow_point, inverse, meridian
from tmmcalc.manipulators.courses import course_of_laws, table_in
from tmmcalc.manipulators.motions import Motion
from tmmcalc.manipulators.routes import legs_of
from tmmcalc.manipulators.task import Arm, LawTask, ManipulatorTask, PathTask
from tmmcalc.manipulators.timedroute import timed

CHOSEN = 128  # rows, beside those of the largest values
ORDERS = ("place", "velocity", "acceleration")
Errors = dict[str, float]


def motion_errors(task: ManipulatorTask, moved: Motion, t: Values, side: Indices, p: Values, q: Values) -> Errors:
    """Estimates for the gripper (3, D, n) and the joints (3, J, n) at the instants (n,), by the names of columns."""
    rows = _rows(p, q)
    at, sides, p, q = t[rows].astype(np.longdouble), side[rows], p[..., rows], q[..., rows]
    arm: Arm = widened(task.arm)
    found: Errors = {}
    if isinstance(task.motion, PathTask):
        route = timed(legs_of(widened(task.motion.route)), widened(task.motion.drive))
        assert moved.route is not None
        ways = zip("sva", moved.route.way(t[rows], sides), route.way(at, sides), strict=True)
        found |= {name: _difference(told, exact) for name, told, exact in ways}
        hand = route.gripper(at, sides)
        joints = _whole_turns(arm, inverse(arm, hand), q)
    else:
        joints = _course(task, moved)(at, sides)
        hand = direct(arm, joints)
    found |= {name: _difference(told, exact) for name, told, exact in zip(ORDERS, p, hand, strict=True)}
    return found | dict(_of_joints(arm, hand, joints, q))


def _rows(p: Values, q: Values) -> Indices:
    """An even choice of the rows, and those of the largest values."""
    peaks = [np.argmax(np.abs(each), axis=-1).ravel() for each in (p, q)]
    return np.unique(np.concatenate((spread(p.shape[-1], CHOSEN), *peaks)))


def _course(task: ManipulatorTask, moved: Motion) -> Callable[[Values, Indices], Values]:
    """The given motion of the joints in extended precision."""
    if isinstance(task.motion, LawTask):
        names = tuple(joint.name for joint in task.arm.joints)
        return course_of_laws(widened(task.motion), names)[0].at
    assert not isinstance(task.motion, PathTask)
    return table_in(widened(task.motion), moved.given)


def _whole_turns(arm: Arm, exact: Values, told: Values) -> Values:
    """The joints with the whole turns that those told have."""
    for k, joint in enumerate(arm.joints):
        if joint.turns:
            exact[0, k] += 2 * PI * np.rint((told[0, k] - exact[0, k]) / (2 * PI))
    return exact


def _of_joints(arm: Arm, hand: Values, exact: Values, told: Values) -> Iterator[tuple[str, float]]:
    sizes = _terms(arm, hand, exact)
    for k, joint in enumerate(arm.joints):
        for order, name in enumerate((joint.name, joint.rate, joint.acceleration)):
            yield name, _difference(told[order, k], exact[order, k], sizes[k][order])
    if arm.kind == "angular":
        yield "elbow", _difference(told[0, -1] - told[0, -2], exact[0, -1] - exact[0, -2], np.ones(1))
        yield "elbow_place", _difference(elbow_point(arm, told), elbow_point(arm, exact))


def _terms(arm: Arm, hand: Values, q: Values) -> list[Sequence[Values]]:
    """Sizes of what every joint and its rates are made of, (J, 3) of rows (n,) or of one number."""
    with np.errstate(divide="ignore", invalid="ignore"):
        w = meridian(arm, hand)
        base = _polar(hand[:, 0] + 1j * hand[:, 1])[1:] if arm.spatial else []
        if arm.kind == "spherical":
            return [*base, *_polar(w)[::-1]]
        if arm.kind == "cylindrical":
            high = np.abs(w.imag)
            across = _polar(hand[:, 0] + 1j * hand[:, 1])[:1] if arm.spatial else [np.abs(w.real)]
            return [*base, (high[0] + abs(arm.height), high[1], high[2]), *across]
        return [*base, *_angular(arm, w, q[:, -2:])]


def _polar(w: Plane) -> list[Sequence[Values]]:
    """Of distance and angle."""
    length, v, a = np.abs(w)
    rate = v / length
    return [(length, v, a + v * rate), (np.ones(1), rate, a / length + 2 * rate**2)]


def _angular(arm: Arm, w: Plane, q: Values) -> list[Sequence[Values]]:
    """Of the directions of both arms."""
    v, a = np.abs(w[1]), np.abs(w[2]) + arm.upper * q[1, 0] ** 2 + arm.forearm * q[1, 1] ** 2
    sine = np.abs(np.sin(q[0, 1] - q[0, 0]))
    return [(np.ones(1), v / (length * sine), a / (length * sine)) for length in (arm.upper, arm.forearm)]


def _difference(told: Values, exact: Values, terms: Values | None = None) -> float:
    """Largest difference over the largest value or sum of terms, with its margin; one rounding at least."""
    sizes = np.abs(exact).ravel() if terms is None else np.concatenate((np.ravel(terms), np.abs(exact).ravel()))
    scale = np.max(sizes[np.isfinite(sizes)], initial=0.0)
    least = EPS if WIDER else CHAIN
    if not scale > 0:
        return least
    return max(MARGIN * float(np.max(np.abs(told - exact)) / scale), least)
