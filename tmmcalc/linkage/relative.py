"""Columns by choice of the kinematics table: the terms of the vector equations over all positions (textbook 2.7).

Sizes bear a sign. With d the line from the base to the point and i d its left normal, of a link with omega, eps:

    v_BA = omega |d| along i d        a_BA^n = omega^2 |d| along -d        a_BA^t = eps |d| along i d
    a^K = 2 omega_guide v_rel along the left normal of the guide

As in the plans, derivatives are the exact ones, whatever the method of the result. Nothing is evaluated before a
column is made.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.chain import Configuration, chain_of
from tmmcalc.linkage.columns import units_of
from tmmcalc.linkage.instant import turning_links
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.pins import Pin, find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.turning import Turning, turnings

# size, component along x, along y of each term
VELOCITY = (
    Quantity(
        "vrel_{head}_{base}[{velocity}]",
        "velocity of {head} relative to {base} of its link, along the left normal of the line from {base}",
        source="(2.31)",
    ),
    Quantity("vrelx_{head}_{base}[{velocity}]", "velocity of {head} relative to {base} of its link, along x"),
    Quantity("vrely_{head}_{base}[{velocity}]", "velocity of {head} relative to {base} of its link, along y"),
)
NORMAL = (
    Quantity(
        "an_{head}_{base}[{acceleration}]",
        "normal acceleration of {head} relative to {base} of its link, towards {base}",
        source="(2.32)",
    ),
    Quantity("anx_{head}_{base}[{acceleration}]", "normal acceleration of {head} relative to {base}, along x"),
    Quantity("any_{head}_{base}[{acceleration}]", "normal acceleration of {head} relative to {base}, along y"),
)
TANGENTIAL = (
    Quantity(
        "at_{head}_{base}[{acceleration}]",
        "tangential acceleration of {head} relative to {base} of its link, along the left normal of the line from "
        "{base}",
        source="(2.33)",
    ),
    Quantity("atx_{head}_{base}[{acceleration}]", "tangential acceleration of {head} relative to {base}, along x"),
    Quantity("aty_{head}_{base}[{acceleration}]", "tangential acceleration of {head} relative to {base}, along y"),
)
CORIOLIS = (
    Quantity(
        "aK_{slide}[{acceleration}]",
        "Coriolis acceleration of the slider of {slide}, along the left normal of its moving guide",
        source="(2.35)",
    ),
    Quantity("aKx_{slide}[{acceleration}]", "Coriolis acceleration of the slider of {slide}, along x"),
    Quantity("aKy_{slide}[{acceleration}]", "Coriolis acceleration of the slider of {slide}, along y"),
)


class Term(NamedTuple):
    """A term of a vector equation: its size with its sign (n,) and the unit vector (n,) that it is counted along."""

    size: Real
    along: Plane

    @property
    def parts(self) -> tuple[Real, Real, Real]:
        """The size and both components."""
        value = self.size * self.along
        return self.size, value.real, value.imag


def relative_columns(mechanism: Mechanism, result: Kinematics, *, dimensionless: bool = False) -> list[Column]:
    """Terms of the vector equations of every group, of the crank and of sliders on moving guides.

    Raises `UsageError` for dimensionless driven sliders.
    """
    units, terms = units_of(result, dimensionless), RelativeTerms(mechanism, result)
    found: list[Column] = []
    for each in terms.turnings:
        places = {"head": each.name, "base": each.base.name, **units.names}
        for told, make, (_, factor) in (
            (VELOCITY, terms.velocity, units.velocity),
            (NORMAL, terms.normal, units.acceleration),
            (TANGENTIAL, terms.tangential, units.acceleration),
        ):
            found += _columns([one.of(**places) for one in told], partial(make, each), factor)
    for joint in terms.sliding:
        own = [one.of(slide=joint.name, **units.names) for one in CORIOLIS]
        found += _columns(own, partial(terms.coriolis, joint), units.acceleration[1])
    return found


def _columns(told: list[Quantity], make: Callable[[], Term], factor: float) -> Iterator[Column]:
    def part(k: int) -> Real:
        return make().parts[k] * factor

    for k, one in enumerate(told):
        yield column(one, partial(part, k))


class RelativeTerms:
    """The terms over the positions of a result; the mechanism is evaluated there when the first one is asked for."""

    def __init__(self, mechanism: Mechanism, result: Kinematics) -> None:
        self.mechanism, self.result = mechanism, result
        self.turnings: tuple[Turning, ...] = turnings(mechanism, result.structure, find_pins(mechanism))
        turning = turning_links(mechanism)
        self.sliding: tuple[Joint, ...] = tuple(
            j for j in mechanism.joints if j.kind == "prismatic" and FRAME not in j.links and j.links[1] in turning
        )

    @cached_property
    def _configuration(self) -> Configuration:
        return chain_of(self.mechanism, self.result).evaluate(self.result.x)

    def velocity(self, seen: Turning) -> Term:
        """v_BA of the point from its base, (2.31)."""
        d = self._line(seen)
        return Term(self._rates(seen.link)[0] * np.abs(d), 1j * d / np.abs(d))

    def normal(self, seen: Turning) -> Term:
        """a_BA^n, (2.32)."""
        d = self._line(seen)
        return Term(self._rates(seen.link)[0] ** 2 * np.abs(d), -d / np.abs(d))

    def tangential(self, seen: Turning) -> Term:
        """a_BA^t, (2.33)."""
        d = self._line(seen)
        return Term(self._rates(seen.link)[1] * np.abs(d), 1j * d / np.abs(d))

    def coriolis(self, joint: Joint) -> Term:
        """a^K of the slider of a joint whose guide turns, (2.35)."""
        guide = self._configuration.motions[joint.links[1]]
        along = self._over(guide.u) * joint.directions[1]
        velocity = self._configuration.slides[joint.name].ds * self.result.speed
        return Term(self._over(2 * self._rates(joint.links[1])[0] * velocity), 1j * along)

    def _rates(self, link: int) -> tuple[Real, Real]:
        """omega and eps (n,) of a link in time."""
        motion = self._configuration.motions[link]
        omega, eps = self.result.in_time(motion.omega, motion.eps)
        return self._over(omega), self._over(eps)

    def _line(self, seen: Turning) -> Plane:
        """The vector (n,) from the base to the point."""
        motions = self._configuration.motions
        base = motions[seen.link].point(seen.base.at[seen.link]).r
        line: Plane = self._over(self._place(seen.head) - base)
        return line

    def _place(self, pin: Pin) -> Plane:
        link, p = next(iter(pin.at.items()))
        return self._configuration.motions[link].point(p).r

    def _over(self, values: Any) -> Any:
        """Values (n,) of what may be a constant."""
        return np.broadcast_to(values, self.result.x.shape)
