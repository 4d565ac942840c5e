"""The method of the relative trajectory: link 5 held at dwell, the crank pin on the four-bar B-C-D-E draws Gamma.

Gamma acts as a curved slot in link 5: at any angle of the crank its pin lies on Gamma, moved along with link 5. A point
of Gamma at a height y' across the guide (at a distance l from F) meets the crank's circle twice, which gives one place
of link 5 on each half of the turn. A periodic cubic spline through these places is the motion. It is a cross-check: its
error is that of the spline.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.numerics.spline import periodic_spline
from tmmcalc.core.plane import Plane, Real, cross
from tmmcalc.linkage.synthesis.dwell.linkages import Linkages
from tmmcalc.linkage.synthesis.dwell.motion import dot
from tmmcalc.linkage.synthesis.dwell.turn import TURN, Turn, along

WHERE = "synthesis.dwell, relative trajectory"
SEARCH = 720  # places of a turn of bar BC at which the ends of the arc are sought
COMPARED = 1440  # angles of the crank at which the motion is compared
EDGE = 1e-12  # beyond its reach by less, relative, the four-bar BCDE is stretched
SAME = 1e-9  # angles of the crank nearer than this are one: both halves of the turn meet at the ends of the arc [rad]
FOLD = 181  # places of the arc at which it has to run one way


class RelativeTrajectory(NamedTuple):
    """How Gamma is gone along: by the angle of bar BC on one branch, or around both within the reach of BCDE.

    Where an arc runs over an end of that reach, from branch to branch, its variable is the angle t of
    psi = middle - half cos(t), in which Gamma is smooth there; 0 < t < pi is the branch of the dwell.
    """

    branch: float  # sign of the dyad CD-DE at dwell
    middle: float = 0.0
    half: float = 0.0  # 0: by the angle of bar BC

    def bar(self, x: Real) -> Real:
        """Angles (n,) of bar BC."""
        return self.middle - self.half * np.cos(x) if self.half else x

    def at(self, linkages: Linkages, x: Real) -> Plane:
        """Places (n,) of the crank pin."""
        branch = self.branch * np.sign(np.sin(x)) if self.half else self.branch
        return gamma(linkages, self.bar(x), branch)


class Arc(NamedTuple):
    """The working arc of Gamma: its course, least and largest variable."""

    course: RelativeTrajectory
    first: float
    last: float


class Accuracy(NamedTuple):
    """Largest error of the displacement, as a part of the stroke, with points of equal and of cosine spacing."""

    steps: int  # of the arc: one less than its points
    uniform: float
    cosine: float


def gamma(linkages: Linkages, psi: Real, branch: float | Real) -> Plane:
    """Places (n,) of the crank pin, link 5 at dwell, at angles of bar BC [rad]; NaN where BCDE does not close."""
    c = 1 + linkages.bar * np.exp(1j * psi)
    q = linkages.e - c
    arm = linkages.d - linkages.coupler  # C -> D in the axes of the coupler
    side, length = np.abs(arm), np.abs(q)
    along_ = (side**2 - linkages.rod**2 + length**2) / (2 * length)
    with np.errstate(invalid="ignore"):
        across = np.sqrt(np.where(np.abs(along_) < side * (1 + EDGE), np.maximum(side**2 - along_**2, 0), np.nan))
    cd = q / length * (along_ + 1j * branch * across)
    return np.asarray(c - cd / arm * linkages.coupler)


def reach(linkages: Linkages, psi0: float) -> tuple[float, float]:
    """The angles of bar BC around ``psi0`` between which the four-bar BCDE closes; a turn if it turns fully."""
    arm = np.abs(linkages.d - linkages.coupler)

    def inside(psi: Real, _: object) -> Real:
        length = np.abs(linkages.e - 1 - linkages.bar * np.exp(1j * psi))
        return np.minimum(arm + linkages.rod - length, length - np.abs(arm - linkages.rod))

    ends = []
    for way in (-1.0, 1.0):
        psi = psi0 + way * np.linspace(0.0, TURN / 2, SEARCH)
        out = np.flatnonzero(inside(psi, None) <= 0)
        k = int(out[0]) if out.size else 0
        ends.append(float(bracketed(inside, psi[[k - 1]], psi[[k]])[0]) if k else float(psi[-1]))
    return ends[0], ends[1]


def branch_of(linkages: Linkages) -> float:
    """The branch of Gamma on which the dwell lies."""
    a = linkages.crank * np.exp(1j * linkages.phi0)
    turn = np.exp(1j * linkages.theta0)
    c, d = a + turn * linkages.coupler, a + turn * linkages.d
    return float(np.sign(cross(linkages.e - c, d - c))[0])


def height(linkages: Linkages, a2: Plane) -> Real:
    """How far a point of Gamma is along the arc, from -1 to 1: y'/R of a slider; of a rocker the same with l."""
    if not linkages.rocks:
        return cross(linkages.output, a2) / linkages.crank
    centres = np.abs(linkages.output)
    least, most = np.abs(centres - linkages.crank), centres + linkages.crank
    return (2 * np.abs(a2 - linkages.output) - least - most) / (most - least)


def arc_of(linkages: Linkages) -> Arc:
    """The arc around the dwell; raises `NoSolutionError` if it does not reach both sides of the crank's circle."""
    branch = branch_of(linkages)
    a = linkages.crank * np.exp(1j * linkages.phi0)
    psi0 = float(np.angle(a + np.exp(1j * linkages.theta0) * linkages.coupler - 1)[0])
    found = _arc(linkages, RelativeTrajectory(branch), psi0)
    if found is None:
        low, high = reach(linkages, psi0)
        middle, half = (low + high) / 2, (high - low) / 2
        found = _arc(linkages, RelativeTrajectory(branch, middle, half), math.acos((middle - psi0) / half))
    if found is None:
        raise NoSolutionError(
            "the arc of Gamma around the dwell does not reach both sides of the crank's circle",
            where=WHERE,
            remedy="bring n nearer to 0.5, or take a shorter dwell",
        )
    steps = np.diff(height(linkages, found.course.at(linkages, np.linspace(found.first, found.last, FOLD))))
    if np.any(np.sign(steps) != np.sign(steps[0])):
        raise NoSolutionError(
            "the arc of Gamma turns back: one angle of the crank would have several displacements",
            where=WHERE,
            remedy="the linkage meets a fold of its assemblies: take other positions",
        )
    return found


def _arc(linkages: Linkages, course: RelativeTrajectory, start: float) -> Arc | None:
    """The arc around the dwell between both sides of the crank's circle; None if it does not reach them."""
    ends = [end for way in (1.0, -1.0) if (end := _end(linkages, course, start, way)) is not None]
    if len(ends) < 2:
        return None
    at = height(linkages, course.at(linkages, np.array(ends)))
    return Arc(course, *sorted(ends)) if abs(at[0] - at[1]) > 1 else None


def _end(linkages: Linkages, course: RelativeTrajectory, start: float, way: float) -> float | None:
    """The first place from the dwell on at which the arc reaches a side of the crank's circle."""
    psi = start + way * np.linspace(0.0, TURN, SEARCH + 1)

    def beyond(x: Real, _: object) -> Real:
        return np.abs(height(linkages, course.at(linkages, x))) - 1

    values = beyond(psi, None)
    broken = np.flatnonzero(~np.isfinite(values))
    whole = int(broken[0]) if broken.size else len(psi)
    out = np.flatnonzero(values[:whole] > 0)
    if not out.size or out[0] == 0:
        return None  # the arc begins outside, or ends where the four-bar BCDE does
    return float(bracketed(beyond, psi[out[:1] - 1], psi[out[:1]])[0])


def places(linkages: Linkages, arc: Arc, steps: int, cosine: bool) -> tuple[Real, Real]:
    """Angles of the crank from position 1, ascending within a turn, and displacements there, from both halves."""
    part = np.linspace(0.0, 1.0, steps + 1)
    if cosine:
        part = (1 - np.cos(np.pi * part)) / 2
    a2 = arc.course.at(linkages, arc.first + (arc.last - arc.first) * part)
    phi, s = _rocker(linkages, a2) if linkages.rocks else _slider(linkages, a2)
    turned = np.mod(phi - linkages.phi0, TURN)
    order = np.argsort(turned)
    turned, s = turned[order], s[order]
    keep = np.append(True, np.diff(turned) > SAME) & (turned < turned[0] + TURN - SAME)
    return turned[keep], s[keep]


def _slider(linkages: Linkages, a2: Plane) -> tuple[Real, Real]:
    """Angles of the crank and displacements, two for each point of Gamma."""
    u, r = linkages.output, linkages.crank
    local = a2 * np.conj(u)
    x, y = local.real, _ended(local.imag / r)
    phi = np.arcsin(y)
    near = r * np.cos(phi)
    return np.concatenate((phi, np.pi - phi)) + np.angle(u), np.concatenate((near - x, -near - x))


def _ended(part: Real) -> Real:
    """Sines or cosines (n,) along the arc, which ends at +-1: rounding there costs half the digits of the angle."""
    part = np.clip(part, -1.0, 1.0)
    part[[0, -1]] = np.rint(part[[0, -1]])
    return part


def _rocker(linkages: Linkages, a2: Plane) -> tuple[Real, Real]:
    """The same for a rocker, its turn continuous with that of the dwell."""
    f, r = linkages.output, linkages.crank
    centres, length = np.abs(f), np.abs(a2 - f)
    phi = np.arccos(_ended((r**2 + centres**2 - length**2) / (2 * r * centres)))
    phi = np.concatenate((phi, -phi)) + np.angle(f)
    from_f, to_f = np.concatenate((a2, a2)) - f, r * np.exp(1j * phi) - f
    return phi, np.arctan2(cross(from_f, to_f), dot(from_f, to_f))


def accuracy(turn: Turn, steps: int) -> Accuracy:
    """The method against the exact motion of one linkage; raises `NoSolutionError` where it does not apply."""
    at = np.linspace(0.0, TURN, COMPARED, endpoint=False)
    exact = along(turn, at).s
    arc = arc_of(turn.linkages)
    found = []
    for cosine in (False, True):
        phi, s = places(turn.linkages, arc, steps, cosine)
        spline = periodic_spline(phi, s, TURN)
        found.append(float(np.max(np.abs(spline(at)[0] - exact)) / np.ptp(exact)))
    return Accuracy(steps, *found)
