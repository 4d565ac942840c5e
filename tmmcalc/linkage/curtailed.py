"""Accelerations of a linkage whose equations lack a term: what a mistake in the vector equations leads to.

Positions and velocities are right. The unknown accelerations, of the base point and the angle of every link and of the
coordinate of every prismatic joint, follow from the closure of all joints at once:

    revolute    a_i + (i eps_i - n omega_i^2) d_i = a_k + (i eps_k - n omega_k^2) d_k      d from the base to the pin
    prismatic   eps_s = eps_g,  a(slider) = a(place on the guide) + c 2 i omega_g s' e + s'' e

with the parts n of the normal and c of the Coriolis term (textbook 2.8.1, 2.8.2). With whole terms they are those of
the groups, by another way. The crank's own normal acceleration is kept: it is given.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import LinkMotion, Plane, Real
from tmmcalc.linkage.dyads.base import Motions, Slide, Slides
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.results import Terms
from tmmcalc.linkage.structure import Structure


class _Reach(NamedTuple):
    """A point of a link: from the base point to it (n,) [m], and the known part of its acceleration (n,)."""

    offset: Plane
    known: Plane


def curtailed(
    mechanism: Mechanism,
    structure: Structure,
    terms: Terms,
    motions: Motions,
    slides: Slides,
    shape: tuple[int, ...],
) -> tuple[Motions, Slides]:
    """Motions and slides whose first derivatives stay and whose second ones are those of curtailed equations.

    Raises `numpy.linalg.LinAlgError` in a dead point.
    """
    return _Equations(mechanism, structure, terms, motions, slides, shape).solved()


class _Equations:
    """The linear equations of all joints for the accelerations at n positions: (n, N, N + 1), real."""

    def __init__(
        self,
        mechanism: Mechanism,
        structure: Structure,
        terms: Terms,
        motions: Motions,
        slides: Slides,
        shape: tuple[int, ...],
    ) -> None:
        self.terms, self.motions, self.slides, self.shape = terms, motions, slides, shape
        driven = structure.driven is not None
        self.given = {FRAME} if driven else {FRAME, structure.input_link}
        self.links = [k for k in motions if k not in self.given]
        own = mechanism.input.joint
        self.joints = [joint for joint in mechanism.joints if driven or joint.name != own]
        self.sliding = [joint.name for joint in self.joints if joint.kind == "prismatic" and joint.name != own]
        self.count = 3 * len(self.links) + len(self.sliding)
        self.rows: list[Any] = []

    def solved(self) -> tuple[Motions, Slides]:
        """The motions and slides with the accelerations that close all joints."""
        for joint in self.joints:
            self._revolute(joint) if joint.kind == "revolute" else self._prismatic(joint)
        system = np.moveaxis(np.array(self.rows), (0, 1), (-2, -1)).astype(float)  # (..., N, N + 1)
        found = np.linalg.solve(system[..., :-1], system[..., -1:])[..., 0]
        motions, slides = dict(self.motions), dict(self.slides)
        for at, k in enumerate(self.links):
            a = found[..., 3 * at] + 1j * found[..., 3 * at + 1]
            motions[k] = self._moved(k, a, found[..., 3 * at + 2])
        for at, name in enumerate(self.sliding, 3 * len(self.links)):
            slides[name] = Slide(slides[name].s, slides[name].ds, found[..., at])
        return motions, slides

    def _moved(self, k: int, a: Plane, eps: Real) -> LinkMotion:
        motion = self.motions[k]
        turning = 1j * eps - self._normal(k) * motion.omega**2
        v, omega = np.broadcast_to(motion.v, self.shape), np.broadcast_to(motion.omega, self.shape)
        return motion._replace(v=v, a=a, u2=turning * motion.u, omega=omega, eps=eps)

    def _normal(self, k: int) -> float:
        return 1.0 if k in self.given else self.terms.normal

    def _revolute(self, joint: Joint) -> None:
        """The pin has one acceleration on both links."""
        equation = self._equation()
        for sign, k, point in zip((1, -1), joint.links, joint.points, strict=True):
            self._add(equation, sign, k, self._reach(k, self.motions[k].u * (point - self.motions[k].base)))
        self._close(equation)

    def _prismatic(self, joint: Joint) -> None:
        """The slider's point moves along the guide, and both turn alike."""
        slider, guide = joint.links
        e = self.motions[guide].u * joint.directions[1]
        own = self.motions[slider].u * (joint.points[0] - self.motions[slider].base)
        there = self.motions[slider].r + own - self.motions[guide].r
        slide = self.slides[joint.name]
        equation = self._equation()
        self._add(equation, 1, slider, self._reach(slider, own))
        self._add(equation, -1, guide, self._reach(guide, there))
        equation[-1] = equation[-1] + self.terms.coriolis * 2j * self.motions[guide].omega * slide.ds * e
        if joint.name in self.sliding:
            at = 3 * len(self.links) + self.sliding.index(joint.name)
            equation[at] = equation[at] - e
        else:  # it drives: its second derivative is given
            equation[-1] = equation[-1] + slide.dds * e
        self._close(equation)
        turning = self._equation()
        for sign, k in ((1, slider), (-1, guide)):
            self._turn(turning, sign, k, 1.0)
        self.rows.append([part.real for part in turning])

    def _reach(self, k: int, offset: Plane) -> _Reach:
        return _Reach(offset, -self._normal(k) * self.motions[k].omega ** 2 * offset)

    def _equation(self) -> list[Plane]:
        """A complex equation without a term: the coefficients of all unknowns, then the right-hand side, (n,) each."""
        return [np.zeros(self.shape, complex) for _ in range(self.count + 1)]

    def _add(self, equation: list[Plane], sign: int, k: int, reach: _Reach) -> None:
        """Add the acceleration of a point of link k."""
        if k in self.links:
            at = 3 * self.links.index(k)
            equation[at] = equation[at] + sign
            equation[at + 1] = equation[at + 1] + 1j * sign
        else:
            equation[-1] = equation[-1] - sign * self.motions[k].a
        self._turn(equation, sign, k, 1j * reach.offset)
        equation[-1] = equation[-1] - sign * reach.known

    def _turn(self, equation: list[Plane], sign: int, k: int, by: Plane | float) -> None:
        """Add the angular acceleration of link k, times a factor."""
        if k in self.links:
            at = 3 * self.links.index(k) + 2
            equation[at] = equation[at] + sign * by
        else:
            equation[-1] = equation[-1] - sign * by * self.motions[k].eps

    def _close(self, equation: list[Plane]) -> None:
        """Enter both projections."""
        self.rows.append([part.real for part in equation])
        self.rows.append([part.imag for part in equation])
