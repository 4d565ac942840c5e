"""Positions and transfer functions of all points, links and prismatic joints, stacked in arrays.

Long runs go through the chain in blocks that stay in cache, which halves their time. Angles are made
continuous against the survey of the range, whose steps are short enough that no turn can be missed.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.core.plane import PLANE, Plane, Real
from tmmcalc.linkage import solvers
from tmmcalc.linkage.chain import Chain, Configuration, Layout
from tmmcalc.linkage.results import Trace

# rows: temporaries of 115 kB stay in cache, and below the 128 kB at which malloc maps fresh pages for every one
BLOCK = 7200
TURN = 2 * np.pi
SEAM = 1e-9  # an angle that exceeds -pi by less [rad] is pi


def trace(chain: Chain, x: Real, method: solvers.Method = solvers.closed, order: int = 2) -> Trace:
    """Evaluate the chain at ``x`` (n,) and stack everything; angles are not yet continuous.

    With ``order=0`` the derivatives are left at zero.
    """
    what = chain.layout
    n = len(x)
    r, angle, s = _stacks(what, x, np.empty if order else np.zeros)
    crank = what.links.index(chain.structure.input_link) if chain.turns else None
    if crank is not None:
        angle[0, crank] = x
    for at in range(0, n, BLOCK):
        rows = slice(at, min(at + BLOCK, n))
        configuration = chain.evaluate(x[rows], order=order, method=method)
        _store(configuration, what, r[..., rows], angle[..., rows], s[..., rows], order, crank)
    names = tuple(name for name, _, _ in what.points)
    return Trace(names, r[0], r[1], r[2], what.links, angle[0], angle[1], angle[2], what.joints, s[0], s[1], s[2])


def _stacks(what: Layout, x: Real, make: Callable[..., Real]) -> tuple[Plane, Real, Real]:
    """The arrays r (3, P, n), angle (3, L, n) and s (3, J, n), cut from one piece of memory.

    One large piece gets huge pages from the system, many smaller ones are paid for page by page.
    """
    n, points, links, joints = len(x), len(what.points), len(what.links), len(what.joints)
    first, last = 6 * points, 6 * points + 3 * links
    memory = make((last + 3 * joints, n), x.dtype)
    r, angle, s = memory[:first], memory[first:last], memory[last:]
    return r.reshape(3, points, 2 * n).view(PLANE[x.dtype]), angle.reshape(3, links, n), s.reshape(3, joints, n)


def _store(
    configuration: Configuration, what: Layout, r: Plane, angle: Real, s: Real, order: int, crank: int | None
) -> None:
    motions = configuration.motions
    for row, (_, link, p) in enumerate(what.points):
        motion = motions[link]
        d = p - motion.base
        states = ((motion.r, motion.u), (motion.v, motion.u1), (motion.a, motion.u2))
        for place, (at, turn) in zip(r[:, row], states if order else states[:1], strict=False):
            if d == 0:  # as `LinkMotion.point`, written in place
                place[...] = at
            else:
                np.multiply(d, turn, out=place)
                if at.ndim or at:
                    np.add(place, at, out=place)
    _store_angles(configuration, what, angle, order, crank)
    for row, joint in enumerate(what.joints):
        slide = configuration.slides[joint]
        s[0, row] = slide.s
        if order:
            s[1, row], s[2, row] = slide.ds, slide.dds


def _store_angles(configuration: Configuration, what: Layout, angle: Real, order: int, crank: int | None) -> None:
    """Angles of all links but the crank; of links that turn together, only the first pays for an arc tangent."""
    leaders: dict[int, int] = {}
    for row, link in enumerate(what.links):
        motion = configuration.motions[link]
        if order:
            angle[1, row], angle[2, row] = motion.omega, motion.eps
        if row == crank:
            continue
        leader = leaders.setdefault(id(motion.omega), row) if order else row
        first = configuration.motions[what.links[leader]].u
        if leader == row:
            np.arctan2(motion.u.imag, motion.u.real, out=angle[0, row])
        elif motion.u is first:
            angle[0, row] = angle[0, leader]
        else:
            np.add(angle[0, leader], np.angle(motion.u.flat[0] / first.flat[0]), out=angle[0, row])


def unwrapped(angle: Real) -> Real:
    """Continuous angles (..., n) from samples that turn less than half a turn a step."""
    turns = np.rint(np.diff(angle, axis=-1) / TURN)
    if not turns.any():
        return angle
    result = angle.copy()
    result[..., 1:] -= TURN * np.cumsum(turns, axis=-1)
    return result


def principal(angle: Real) -> Real:
    """The angles in (-pi, pi]; what rounding alone keeps from pi is pi."""
    return np.asarray(angle - TURN * np.ceil((angle - SEAM) / TURN - 0.5))


def continuous(angle: Real, x: Real, survey_x: Real, link_angles: Real) -> Real:
    """Angles (L, n) at ``x`` in the turns of the continuous ``link_angles`` (L, m) at ascending ``survey_x``."""
    result = np.empty_like(angle)
    for row, track in enumerate(link_angles):
        near = np.interp(x, survey_x, track)
        result[row] = angle[row] + TURN * np.rint((near - angle[row]) / TURN)
    return result
