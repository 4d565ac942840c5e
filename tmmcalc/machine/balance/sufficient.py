"""Which links can bear the counterweights of an exact static balance.

Counterweights on a set of links suffice, whatever their masses, if the unit vectors of these links and a constant span
the mass moment of the mechanism and the paths of the links' own pins.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loading import Body
from tmmcalc.machine.balance.moments import DEPENDENT, MassMoments, default_pin, least, mass_moments

EXACT = 1e-9  # part of the force left that counts as rounding


def sufficient_links(chain: Chain, bodies: Sequence[Body]) -> tuple[tuple[int, ...], ...]:
    """The smallest sets of links on which counterweights, of whatever masses, balance the shaking force exactly.

    Empty if there is none: a link of some mass moves on prismatic joints only. ``((),)`` if nothing needs balancing.
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
