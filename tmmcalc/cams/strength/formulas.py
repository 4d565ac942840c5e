"""Formulas of slip, shaft, stem, pin and contact, on arrays that broadcast: points (M,) against sizes (..., 1).

Each value has its limit; the margin is what is left of the limit as a part of it,

    margin = 1 - value/limit        (or 1 - least/size where a size has to reach a least one)

0 at the limit, negative beyond it. Where a value does not exist (undercut, a jammed follower, no contact force for a
roller to roll on) a mask says so and `unused` gives the finite margin BAD.
"""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Number, Values

BAD = -1e9  # margin where there is no value
HERTZ = 0.418  # of the contact of two cylinders with Poisson's ratio 0.3
WHOLE = 1e-3  # [m] to which the radius of the shaft is rounded up
THIN = 1e-9  # [m] roller of a knife edge, so that what grows without limit stays finite
ROUNDING = 1e-9  # of a whole mm: a radius that is one but for rounding


def rolling(
    follower: Follower, motion: Values, start: Number | None = None, offset: Number | None = None
) -> tuple[Values, Values]:
    """Curvature kappa [1/m] of the pitch curve (5.35) and A [m], what its speed grows by a radian (5.71); RT and RK.

    Of a knife edge the pitch curve is the profile. Sizes that are given take the place of the follower's.
    """
    y, y1, y2 = motion[0], motion[1], motion[2]
    place = y + (follower.start if start is None else start)
    if follower.kind == "oscillating":
        turned = np.cos(place), np.sin(place)
        return rocker_rolling(follower.assembly, motion, turned, follower.centres, follower.rocker)
    slide = y1 + (follower.offset if offset is None else offset)
    square = place * place + slide * slide
    speed = np.sqrt(square)
    return (square + slide * y1 - place * y2) / (square * speed), (place * y1 + slide * y2) / speed


def rocker_rolling(
    assembly: int, motion: Values, turned: tuple[Values, Values], centres: Number, rocker: Number
) -> tuple[Values, Values]:
    """The same of a rocker whose psi has this cosine and sine, with l0 and l2 [m] (..., 1)."""
    y1, y2 = motion[1], motion[2]
    w = 1 - assembly * y1
    cosine, sine = rocker * turned[0], rocker * turned[1]
    # derivatives along the line of centres and across it
    x1, along = -assembly * w * sine, centres - w * cosine
    x2, across = w * w * cosine + y2 * sine - centres, assembly * (y2 * cosine - w * w * sine)
    square = x1 * x1 + along * along
    speed = np.sqrt(square)
    return (x1 * across - along * x2) / (square * speed), (x1 * x2 + along * across) / speed


def flat_radius(motion: Values, start: Number) -> Values:
    """rho = S + S'' [m] of the profile under a flat face (5.95)."""
    radius: Values = start + motion[0] + motion[2]
    return radius


def contact_square(contact: Values, curvature: Values, roller: Number, modulus: float = 1.0) -> tuple[Values, Any]:
    """E_n R (1/(rho - r2) + 1/r2) of the wall that presses, and where that has no cusp (5.90): smooth through R = 0.

    Written with kappa it is regular where the profile turns from convex to concave.
    """
    bulge = np.where(contact < 0, -1.0, 1.0) * curvature * roller
    works = bulge < 1
    gap = np.where(works, 1 - bulge, 1.0)
    return modulus * np.abs(contact) / (np.maximum(roller, THIN) * gap), works


def contact_stress(
    contact: Values, curvature: Values, roller: Number, width: float, modulus: float
) -> tuple[Values, Any]:
    """sigma_H [Pa] of a roller on the inner wall (R > 0) or the outer one; where that has no cusp (5.86 to 5.90)."""
    square, works = contact_square(contact, curvature, roller, modulus / width)
    return HERTZ * np.sqrt(square), works


def allowed_square(stress: float, width: float, modulus: float) -> float:
    """R (1/(rho - r2) + 1/r2) [N/m] at which sigma_H [Pa] is reached (5.90)."""
    return (stress / HERTZ) ** 2 * width / modulus


def flat_stress(contact: Values, radius: Values, width: float, modulus: float) -> tuple[Values, Any]:
    """sigma_H [Pa] under a flat face, and where the profile is convex."""
    works = radius > 0
    size = np.where(works, radius, 1.0)
    return HERTZ * np.sqrt(modulus / width * np.abs(contact) / size), works


def resisting(arm: float, pin_friction: float, pin: Number, friction: float, roller: Number) -> Any:
    """C1 of the slip function: what rolling and pin resist over what the cam can drive (5.70)."""
    return (arm + pin_friction * pin) / (friction * np.maximum(roller, THIN))


def cylinder(width: float, density: float, roller: Number, pin: Number) -> Any:
    """Moment of inertia [kg*m^2] of a roller as a hollow cylinder on its pin."""
    return pi / 2 * width * density * (roller**4 - pin**4)


def slip(
    contact: Values, run: Values, resisting: Number, inertia: Number, speed: float, friction: float, roller: Number
) -> tuple[Values, Any]:
    """C1 + C2 A/|R| with its sign, and where R is not 0; the roller rolls where its size D is at most 1 (5.72).

    C2 = J omega^2/(f r2^2) (5.71); ``run`` is A of `rolling`, ``inertia`` J of the roller.
    """
    size = np.abs(contact)
    works = size > 0
    square = np.maximum(roller, THIN) ** 2
    grown: Values = resisting + inertia * speed**2 / (friction * square) * run / np.where(works, size, 1.0)
    return grown, works


def reduced_moment(contact: Values, torque: Values, span: float, torsion: float) -> Values:
    """M_E [N*m] of bending R l_s/4 and torque of the camshaft by the energy theory (5.73, 5.74)."""
    moment: Values = np.sqrt((contact * (span / 4)) ** 2 + torsion * torque * torque)
    return moment


def shaft_by_strength(moment: Number, bending: float) -> Any:
    """r1' [m] from the largest M_E [N*m] (5.77)."""
    return np.cbrt(4 * moment / (pi * bending))


def shaft_by_stiffness(contact: Any, span: float, young: float, deflection: float) -> Any:
    """r1'' [m] from the largest |R| [N] by the deflection in the middle (5.78)."""
    return (contact * span**3 / (12 * pi * young * deflection)) ** 0.25


def whole(radius: Any) -> Any:
    """A radius [m] rounded up to a whole mm.

    >>> round(float(whole(0.0071492)), 9), round(float(whole(0.007)), 9)
    (0.008, 0.007)
    """
    return WHOLE * np.ceil(radius / WHOLE - ROUNDING)


def stem_moment(follower: Follower, motion: Values, contact: Values, sine: Values, protrusion: Number) -> Values:
    """|M_T| [N*m] that bends the stem at the lower edge: R sin(theta) q (5.79), under a flat face R S'."""
    moment = contact * motion[1] if follower.kind == "flat" else contact * sine * protrusion
    return np.abs(moment)


def stem_stress(moment: Number, radius: float) -> Any:
    """Bending stress [Pa] of a round stem."""
    return moment * (4 / (pi * radius**3))


def guide_pressure(edge: Any, land: float, radius: float) -> Any:
    """Pressure [Pa] of a reaction N1 or N2 on a ground land of the stem (fig. 5.26)."""
    return abs(edge) / (2 * land * radius)


def pin_radius(contact: Any, pressure: float, ratio: float) -> Any:
    """r0 [m] from the largest |R| [N] by the pressure on it, its length being alpha2 diameters (5.82, 5.83).

    >>> round(1e3 * float(pin_radius(196.9718, 5e6, 1.4)), 6)
    2.652302
    """
    return np.sqrt(contact / (ratio * pressure)) / 2


def pin_pressure(contact: Any, pin: Number, ratio: float) -> Any:
    """Pressure [Pa] of R on the projected area of a pin of radius r0 that is alpha2 diameters long."""
    return abs(contact) / (4 * ratio * pin * pin)


def convex_margin(curvature: Number, roller: Number, least: float) -> Any:
    """Margin of r2 <= rho2 - r_m from the largest kappa (5.39); regular where no part is convex."""
    return 1 - (roller + least) * curvature


def concave_margin(curvature: Number, roller: Number, least: float) -> Any:
    """Margin of rho1 + r2 >= r_i from the least kappa (5.41); above 1 where no tool is too large."""
    return 1 + (least - roller) * np.minimum(curvature, 0.0)


def unused(value: Number, limit: Number, works: Mask | bool = True) -> Any:
    """Margin 1 - value/limit; BAD where the value does not exist."""
    return np.where(works, 1 - value / limit, BAD)


def shafted(base: Number, roller: Number, shaft: Number) -> Any:
    """Margin of r2 <= R0 - r1*: the base circle of the working profile clears the shaft."""
    return unused(roller + shaft, base)
