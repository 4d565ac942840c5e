"""Static balancing by mass redistribution: counterweights on links that keep the common centre of mass at rest.

For chosen masses the static moments of the counterweights are the least squares solution of a linear system
(`moments`); where the unit vectors of the chosen links suffice nothing is left, and where they depend on each other
(three links of a four-bar) the least counterweights are taken. With radii chosen instead of masses,
mu_j = |q_j| / rho_j is found by Newton's method.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.loading import Body
from tmmcalc.machine.balance.shaking import WHERE, Shaking, check_balanceable, shaking
from tmmcalc.machine.balance.weights import check_choice

if TYPE_CHECKING:
    from tmmcalc.linkage.chain import Chain
    from tmmcalc.machine.balance.moments import MassMoments

ITERATIONS = 60
NEAR = 1e-10  # one more step of Newton's method from here is exact


@record
class Place:
    """A counterweight asked for on a link, its mass or its radius chosen."""

    link: int
    mass: float | None = None  # [kg]
    radius: float | None = None  # of its centre from ``about`` [m]
    about: complex | None = None  # in the link's axes [m]; None: the link's pin on the frame, or else its outer pin


@record
class Redistribution:
    """Counterweights on several links and what they leave."""

    counterweights: tuple[Body, ...]  # point masses, in the order of the places
    exact: bool = quantity("counterweights_exact", "the common centre of mass stays at rest")
    left: float  # rms force left, as a part of the rms of all inertia forces taken singly [-]
    sufficient: tuple[tuple[int, ...], ...]  # the smallest sets of links on which counterweights balance exactly
    before: Shaking
    after: Shaking

    @derived("counterweights_added[kg]", "mass of all counterweights")
    def added(self) -> float:
        """Of those on links."""
        return sum(body.mass for body in self.counterweights)

    @property
    def message(self) -> str:
        """Whether the chosen links balance the force, what is left if not, and which links would."""
        chosen = _listed(tuple(body.link for body in self.counterweights))
        if self.exact:
            return Phrase("counterweights on {chosen} keep the centre of mass at rest", chosen=chosen)
        text = Phrase(
            "counterweights on {chosen} do not balance the shaking force: {before:.4g} N rms before, {after:.4g} "
            "N after",
            chosen=chosen,
            before=self.before.size.rms,
            after=self.after.size.rms,
        )
        if not self.sufficient:
            return Phrase("{text}; no counterweights on links can", text=text)
        would = listed([_listed(some) for some in self.sufficient], " or ")
        return Phrase("{text}; counterweights on {would} would", text=text, would=would)


def _listed(links: tuple[int, ...]) -> str:
    if not links:
        return "no link"
    if len(links) == 1:
        return Phrase("link {body}", body=links[0])
    return Phrase("links {links}", links=listed([str(link) for link in links], " and "))


def redistribute(
    chain: Chain,
    bodies: Sequence[Body],
    places: Sequence[Place],
    x: Real,
    speed: float,
    acceleration: float = 0.0,
    *,
    about: complex | None = None,
) -> Redistribution:
    """Counterweights on the chosen links for the least mean square shaking force, which may be none at all.

    A link that does not turn gets no static moment. Raises `UsageError` for a link that is not there or named twice;
    `NoSolutionError` if no masses go with the chosen radii; and what `shaking` raises.
    """
    from tmmcalc.machine.balance.moments import EXACT, default_pin, mass_moments, sufficient_links

    check_balanceable(chain, bodies, speed, acceleration)
    links = [place.link for place in places]
    _check_places(chain, places)
    pins = [default_pin(chain, place.link) if place.about is None else place.about for place in places]
    terms = mass_moments(chain, bodies, list(zip(links, pins, strict=True)), speed, acceleration)
    masses = _masses(terms, places)
    q, left = terms.solve(masses)
    counterweights = tuple(
        Body(link, float(mu), 0.0, complex(pin + moment / mu) if mu else complex(pin))
        for link, mu, moment, pin in zip(links, masses, q, pins, strict=True)
    )
    return Redistribution(
        counterweights=counterweights,
        exact=left <= EXACT,
        left=left,
        sufficient=sufficient_links(chain, bodies),
        before=shaking(chain, bodies, x, speed, acceleration, about=about),
        after=shaking(chain, (*bodies, *counterweights), x, speed, acceleration, about=about),
    )


def _masses(terms: MassMoments, places: Sequence[Place]) -> Real:
    """Masses (J,) of the counterweights: as given, or such that |q_j| = rho_j mu_j.

    Newton's method from below: |q| is a convex function of the masses, so the least of the solutions is found.
    """
    masses = np.array([place.mass or 0.0 for place in places])
    free = [j for j, place in enumerate(places) if place.mass is None]
    if free and not _matched(terms, masses, free, np.array([places[j].radius or 0.0 for j in free])):
        names = ", ".join(f"{places[j].link} at {places[j].radius:g} m" for j in free)
        raise NoSolutionError(
            f"no counterweights balance with links {names}: their own mass adds more than it takes away",
            where=WHERE,
            remedy="choose larger radii, or masses instead, or links nearer to the frame",
        )
    return masses


def _matched(terms: MassMoments, masses: Real, free: list[int], radii: Real) -> bool:
    """Set the ``free`` masses so that their moments are at their radii; False if there are none such."""
    from tmmcalc.machine.balance.moments import least

    response = least(terms.units, terms.moved)[np.ix_(free, free)]
    for _ in range(ITERATIONS):
        q = terms.solve(masses)[0][free]
        size = np.abs(q)
        excess = size - radii * masses[free]
        near = np.all(np.abs(excess) <= NEAR * (size + radii * (np.max(np.abs(masses)) + terms.mass)))
        direction = np.conj(q) / np.where(size > 0, size, 1.0)
        jacobian = (direction[:, None] * response).real - np.diag(radii)
        masses[free] -= np.linalg.lstsq(jacobian, excess, rcond=None)[0]
        if near:
            reached = masses >= -NEAR * terms.mass
            np.maximum(masses, 0.0, out=masses)
            return bool(np.all(reached))
    return False


def _check_places(chain: Chain, places: Sequence[Place]) -> None:
    """Refuse links that are not there or named twice, and places without exactly one of mass and radius."""
    known = {link.id for link in chain.mechanism.links}
    for i, place in enumerate(places):
        where = f"{WHERE}, counterweight on link {place.link}"
        if place.link not in known or place.link in [other.link for other in places[:i]]:
            text = "the link has a counterweight already" if place.link in known else "there is no such link"
            raise UsageError(text, where=where, remedy=f"one counterweight a link; links: {sorted(known)}")
        check_choice(place.mass, place.radius, where)
