"""Thickness of the teeth on a circle and along chords; lengths in normal modules.

Radii are those of the wheel; of a ring they are negative, as are its number of teeth and its reference circle.
"""

from __future__ import annotations

from math import cos, pi, sin, tan

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.gears.involute.wheel import Number, Wheel
from tmmcalc.gears.model import Values


@record
class Thickness:
    """The tooth on n circles of the radii asked for, any shape."""

    radius: Values  # r_y
    pressure_angle: Values  # alpha_y [rad], transverse
    helix: Values  # beta_y [rad]
    transverse: Values  # s_ty, arc in the transverse section
    normal: Values  # s_ny, arc in the normal section
    chord: Values  # chord in the normal section
    height: Values  # from the tip circle down to the chord
    space: Values  # e_ny, arc of the space in the normal section


@record
class ConstantChord:
    """The chord between the points where a symmetrical rack tooth touches: the same for every number of teeth."""

    chord: Number  # s_c
    height: Number  # from the tip circle down to it
    curvature: Number  # transverse radius of curvature of the involute where it ends
    range: tuple[Number, Number]  # of the radii of curvature between which the involute is usable
    valid: NDArray[np.bool_]  # whether it ends on the usable involute


def thickness(wheel: Wheel, radius: Number, tip: Number) -> Thickness:
    """Thickness and chords at radii from the base to the tip circle (4.96).

    >>> from math import radians
    >>> at = thickness(Wheel(27, 0.31, radians(15)), 67 / 5, 76.01455816971045 / 5)
    >>> round(5 * float(at.chord), 4), round(5 * float(at.height), 4)
    (10.2955, 9.2003)
    """
    r = np.asarray(radius, dtype=float)
    half, helix = np.asarray(wheel.half_angle_at(r)), np.asarray(wheel.helix_at(r))
    cosine = np.cos(helix)
    turn = half * cosine**3  # half the angle of the tooth on the circle of curvature of the normal section
    rise = 2 * r * np.sin(turn / 2) ** 2 / cosine**2
    space = np.asarray(2 * r * (pi / wheel.teeth - half) * cosine)
    return Thickness(
        r,
        np.arccos(np.minimum(wheel.base / r, 1.0)),
        helix,
        2 * r * half,
        2 * r * half * cosine,
        2 * r * np.sin(turn) / cosine**2,
        tip - r + rise,
        space,
    )


def constant_chord(wheel: Wheel, tip: Number, lowest: Number) -> ConstantChord:
    """The constant chord; ``lowest`` is the radius of curvature of the lowest usable point of the involute.

    >>> from math import radians
    >>> chord = constant_chord(Wheel(27, 0.31, radians(15)), 76.01455816971045 / 5, 0.0)
    >>> round(5 * float(chord.chord), 6), round(5 * float(chord.height), 5)
    (7.931561, 4.68999)
    """
    rack, cut = wheel.rack, wheel.section
    chord = pi / 2 * cos(rack.angle) ** 2 + wheel.shift * sin(2 * rack.angle)
    height = tip - wheel.reference - chord * tan(rack.angle) / 2
    curvature = wheel.base * tan(cut.angle) + chord * cos(cut.base_helix) / (2 * cos(rack.angle))
    highest = wheel.curvature_at(tip)
    valid = (np.asarray(lowest) <= curvature) & (curvature <= np.asarray(highest))
    return ConstantChord(chord, height, curvature, (lowest, highest), valid)


def base_pitch_normal(wheel: Wheel) -> float:
    """p_bn = pi m cos(alpha): the normal base pitch, the distance of neighbouring flanks (4.60)."""
    return pi * cos(wheel.rack.angle)
