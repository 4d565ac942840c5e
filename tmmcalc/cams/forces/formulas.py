"""Formulas of the forces on a follower, on arrays that broadcast: motion (M,) against sizes (..., 1).

Canonical frame; the force of the cam on the follower R is positive away from the cam. Friction opposes the motion,
whose sense is +1 on the rise, -1 on the return and 0 in a dwell:

    P_c + R a cos(theta) - sense a mu |R| = 0          a = 1, of a rocker l2 and P_c the moment M_c
    RT   mu = f |sin(theta)| (1 + 2 q/l)               N1 at the lower edge of the guide, N2 at the upper (5.59 to 5.64)
    PT   mu = 2 f |S'|/l,  theta = 0                   N1 = R S'/l = -N2                                  (5.103)
    RK   mu = f r/l2                                   friction moment f r |R| in the pivot of radius r   (5.65)

Where cos(theta) is not above the friction the follower jams: there is no R. The forces are then those without
friction and a mask says so, as it does for a guide without length: so no NaN goes on.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Number, Values
from tmmcalc.cams.pressure.angle import tangent_terms

Mask = NDArray[np.bool_]


def resultant(
    motion: Values,
    inertia: float,
    stiffness: Number,
    preload: Number,
    force: Number = 0.0,
    acceleration: Values | None = None,
) -> Values:
    """P_c [N] or M_c [N*m] of inertia, spring and other forces along the lift; closed where negative (5.52, 5.53).

    ``inertia`` is m2 omega^2 or J2 omega^2, ``force`` (M,) the technological force and the weight,
    ``acceleration`` (M,) takes the place of y'' where omega, then the mean one, varies.

    >>> resultant(np.array([[0.01], [0.02], [0.03], [0.0]]), 2000.0, 9500.0, 10.0)
    array([-165.])
    """
    second = motion[2] if acceleration is None else acceleration
    total: Values = force - inertia * second - (preload + stiffness * motion[0])
    return total


def inclination(
    follower: Follower, motion: Values, start: Number | None = None, offset: Number | None = None
) -> tuple[Values, Values]:
    """Sine and cosine of the pressure angle (5.42, 5.48); sizes that are given take the place of the follower's."""
    place = follower.start if start is None else start
    across, along = tangent_terms(follower, motion, place, follower.offset if offset is None else offset)
    size = np.hypot(across, along)
    return across / size, along / size


def protrusion(motion: Values, stroke: float, roller: Number, gap: float) -> Values:
    """q = H1 - S [m] from the roller centre (or face) up to the guide that begins at H1 = S0 + h + r2 + gap (5.85)."""
    q: Values = stroke + roller + gap - motion[0]
    return q


def guide_length(top: Number, start: Number, stroke: float, roller: Number, gap: float) -> Number:
    """l = H2 - H1 [m]; not positive where the guide has no room."""
    return top - (start + stroke + roller + gap)


def friction_ratio(
    follower: Follower, motion: Values, sine: Values, protrusion: Number, length: Number, friction: float
) -> tuple[Values, Any]:
    """mu of RT or PT in a guide of ``length`` l, and where l is positive; without length mu is 0."""
    room = np.asarray(length) > 0
    inverse = np.where(room, 1 / np.where(room, length, 1.0), 0.0)
    if follower.kind == "flat":
        return 2 * friction * np.abs(motion[1]) * inverse, room
    return friction * np.abs(sine) * (room + 2 * protrusion * inverse), room


def contact_force(load: Values, cosine: Number, ratio: Number, sense: Values, arm: float = 1.0) -> tuple[Values, Any]:
    """R [N] from P_c (or M_c with the arm l2), and where it exists: elsewhere the follower jams (5.62, 5.64, 5.103).

    R < 0 is a force of the outer wall of a groove, or without one what would be needed to hold the follower.

    >>> r, works = contact_force(np.array([-100.0, 100.0]), 0.9, 0.1, np.ones(2))
    >>> r.round(9).tolist(), works.tolist()
    ([125.0, -100.0], [True, True])
    """
    lifting = np.where(load > 0, -sense, sense)
    useful = cosine - lifting * ratio
    works = useful > 0
    return -load / (arm * np.where(works, useful, cosine)), works


def guide_forces(
    follower: Follower, motion: Values, contact: Values, sine: Values, protrusion: Number, length: Number
) -> tuple[Values, Values]:
    """N1 and N2 [N] of the edges of the guide on the stem, along the canonical x (5.59, 5.60); 0 without length."""
    room = np.asarray(length) > 0
    inverse = np.where(room, 1 / np.where(room, length, 1.0), 0.0)
    if follower.kind == "flat":
        couple = contact * motion[1] * inverse
        return couple, -couple
    across = contact * sine
    upper = across * protrusion * inverse
    return -across - upper, upper


def driving_torque(load: Values, motion: Values) -> Values:
    """Torque [N*m] that drives the follower without what the guide loses, -P_c S' or -M_c psi' (5.75, 5.76)."""
    torque: Values = -load * motion[1]
    return torque


def cam_torque(contact: Values, cosine: Number, motion: Values, arm: float = 1.0) -> Values:
    """Torque [N*m] on the camshaft that R asks for, friction of guide or pivot included: R a cos(theta) S'."""
    torque: Values = arm * contact * cosine * motion[1]
    return torque


class GuidedForces(NamedTuple):
    """All that a stem in its guide carries; each broadcasts as (..., M)."""

    sine: Values
    cosine: Values
    protrusion: Values  # q [m]
    length: Any  # l [m], (..., 1)
    ratio: Values  # mu
    contact: Values  # R [N]
    lower: Values  # N1 [N]
    upper: Values  # N2 [N]
    works: Mask  # the guide has length and the follower does not jam


def guided_forces(
    follower: Follower,
    motion: Values,
    load: Values,
    sense: Values,
    *,
    stroke: float,
    friction: float,
    gap: float = 0.0,
    start: Number,
    roller: Number,
    top: Number,
) -> GuidedForces:
    """Reactions of RT or PT for sizes S0, r2 and H2 (..., 1) at the points of ``motion`` (4, M); ``load`` is P_c (M,).

    The least length of the guide follows from the sizes; of a flat face the roller has to be 0.
    """
    sine, cosine = inclination(follower, motion, start)
    q, length = protrusion(motion, stroke, roller, gap), guide_length(top, start, stroke, roller, gap)
    ratio, room = friction_ratio(follower, motion, sine, q, length, friction)
    contact, works = contact_force(load, cosine, ratio, sense)
    lower, upper = guide_forces(follower, motion, contact, sine, q, length)
    return GuidedForces(sine, cosine, q, length, ratio, contact, lower, upper, works & room)
