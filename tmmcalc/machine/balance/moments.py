"""The total mass moment of a mechanism with counterweights, as harmonics of the shaking force.

A counterweight of mass mu on link j, at the vector p from the link's point A_j, has the static moment q = mu p in the
axes of the link. The total mass moment is

    h(phi) = sum of m_i S_i + sum over j of (mu_j A_j + q_j u_j),        u_j unit vector of link j,

and the shaking force is -(h'' omega^2 + h' eps_1). For given masses it is linear in the complex numbers q_j. The
functions are held by the Fourier coefficients of their derivatives, where constants drop out, times what makes forces
of them; so the squares summed are those of the force, and vectors u_j that depend on each other show as such.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from tmmcalc.core.numerics.fourier import FEWEST, TURN, Complex, resolved
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.assembly import reach_of
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.model import FRAME
from tmmcalc.machine.balance.shaking import WHERE, check_sound, crank_angle

EXACT = 1e-9  # part of the force left that counts as rounding
DEPENDENT = 1e-10  # singular values below this part of the largest are dependences


@record
class MassMoments:
    """Force coefficients of the mechanism, of a unit mass at every pin and of every unit vector, by order."""

    given: Complex  # of all bodies (2 K + 1,)
    moved: Complex  # of A_j (2 K + 1, J)
    units: Complex  # of u_j (2 K + 1, J)
    single: float  # rms of the forces of all bodies taken singly
    mass: float  # of all bodies [kg]

    def solve(self, masses: Real) -> tuple[Plane, float]:
        """Static moments q (J,) [kg*m] for masses (J,) [kg], and the rms force left as a part of the whole."""
        target = self.given + self.moved @ masses
        q = least(self.units, target[:, None])[:, 0]
        whole = self.single + float(np.linalg.norm(self.moved, axis=0) @ masses)
        left = float(np.linalg.norm(target + self.units @ q))
        return q, left / whole if whole else 0.0


def least(columns: Complex, targets: Complex) -> Complex:
    """Least q with columns q = -targets, in the least squares sense; columns of links that do not turn get none."""
    size = np.linalg.norm(columns, axis=0)
    unit = np.where(size > DEPENDENT * np.max(size, initial=1.0), size, 1.0)
    q: Complex = np.linalg.lstsq(columns / unit, -targets, rcond=DEPENDENT)[0]
    return q / unit[:, None]


def mass_moments(
    chain: Chain, bodies: Sequence[Body], pins: Sequence[tuple[int, complex]], speed: float, acceleration: float
) -> MassMoments:
    """Forces of the bodies, of masses on the ``pins`` (link, A_j in its axes [m]) and of the links' unit vectors.

    They are per unit of the larger of omega^2 and |eps_1|. Raises what `check_sound` raises.
    """
    lag, count = crank_angle(chain), len(pins)

    def rates(phi: Real) -> Complex:
        motions = chain.evaluate(phi - lag).motions
        rows = [body.mass * motions[body.link].point(body.center).v for body in bodies]
        rows += [motions[link].point(pin).v for link, pin in pins]
        rows += [motions[link].u1 for link, _ in pins]
        values = np.array([np.broadcast_to(row, phi.shape) for row in rows], np.complex128).reshape(-1, *phi.shape)
        check_sound(chain, values)
        return values

    reach = reach_of(chain.mechanism)
    natural = np.array([*(body.mass * reach for body in bodies), *[reach] * count, *[1.0] * count])
    found = rates(np.arange(FEWEST) * (TURN / FEWEST))
    series, _ = resolved(rates, np.maximum(natural, np.max(np.abs(found), axis=1, initial=0.0)), where=WHERE)
    whole = max(speed * speed, abs(acceleration))
    w2, eps = speed * speed / whole, acceleration / whole
    orders = series[0].orders if series else np.zeros(1)
    forces = -np.array([s.coefficients * (1j * orders * w2 + eps) for s in series]).reshape(-1, len(orders)).T
    given, moved, units = np.split(forces, (len(bodies), len(bodies) + count), axis=1)
    single = float(np.linalg.norm(given, axis=0).sum())
    return MassMoments(given.sum(axis=1), moved, units, single, sum(body.mass for body in bodies))


def default_pin(chain: Chain, link: int) -> complex:
    """The link's pin on the frame, or else its outer pin or base point, in the axes of the link [m]."""
    for joint in chain.mechanism.joints:
        if joint.kind == "revolute" and set(joint.links) == {FRAME, link}:
            return joint.points[joint.links.index(link)]
    return chain.evaluate(np.zeros(1), order=0).motions[link].base


def sufficient_links(chain: Chain, bodies: Sequence[Body]) -> tuple[tuple[int, ...], ...]:
    """The smallest sets of links on which counterweights, of whatever masses, balance the shaking force exactly.

    They do if the unit vectors of these links and a constant span the mass moment of the mechanism and the paths of the
    links' own pins. Empty if there is none: a link of some mass moves on prismatic joints only. ``((),)`` if nothing
    needs balancing.
    """
    links = [link.id for link in chain.mechanism.links]
    terms = mass_moments(chain, bodies, [(link, default_pin(chain, link)) for link in links], 1.0, 0.0)
    turning = [j for j in range(len(links)) if np.linalg.norm(terms.units[:, j]) > DEPENDENT]
    for size in range(len(turning) + 1):
        sets = [some for some in combinations(turning, size) if _suffices(terms, some)]
        if sets:
            return tuple(tuple(links[j] for j in some) for some in sets)
    return ()


def _suffices(terms: MassMoments, some: tuple[int, ...]) -> bool:
    """Whether the unit vectors of these links span the mechanism's force and that of a mass on each of their pins."""
    columns = terms.units[:, some]
    targets = np.column_stack((terms.given, terms.moved[:, some]))
    left = np.linalg.norm(targets + columns @ least(columns, targets), axis=0)
    # pins on the frame stand still but for rounding
    moving = np.linalg.norm(terms.moved, axis=0)
    whole = np.array([terms.single, *np.maximum(moving[list(some)], DEPENDENT * np.max(moving))])
    return bool(np.all(left <= EXACT * whole))
