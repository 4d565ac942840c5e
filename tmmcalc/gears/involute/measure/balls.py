"""Size over balls or pins in opposite spaces; lengths in normal modules.

    inv(alpha_D) = D/(z cos(alpha)) + inv(alpha_t) - (pi/2 - 2 x tan(alpha))/z        d_D = 2 r_b/cos(alpha_D)

A ring is a wheel with a negative number of teeth: its balls stand within the circle d_D and the size is between them.
"""

from __future__ import annotations

from math import cos, pi, sin, tan
from typing import Literal

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.wheel import Wheel

Body = Literal["balls", "pins"]


@record
class OverBalls:
    """The size over (of a ring: between) two balls or pins."""

    diameter: float  # D
    angle: float  # alpha_D [rad], transverse, of the circle of the centres
    centres: float  # d_D, diameter of that circle
    size: float  # M
    curvature: float  # transverse radius of curvature of the flanks where they touch
    radius: float  # radius of the circle on which they touch
    on_flank: bool  # whether they touch the usable involute
    clear: bool  # whether they stand proud of the tip circle and clear of the root circle
    width: float  # face width that pins need on a helical wheel with an odd number of teeth


def over_balls(
    wheel: Wheel, diameter: float, tip: float, lowest: float, root: float | None = None, body: Body = "balls"
) -> OverBalls:
    """M over two balls or pins of a diameter; radii are positive, of rings too.

    ``lowest`` is the radius of curvature of the usable involute farthest from the tip: at the form circle or the last
    active point. Balls lie in one transverse plane; pins are measured between parallel planes, so that on a helical
    wheel with an odd number of teeth they too stand opposite each other, half an axial pitch apart.
    Raises `NoSolutionError` for balls that slip through the space.

    >>> from math import radians
    >>> wheel = Wheel(27, 0.31, radians(15))
    >>> round(5 * over_balls(wheel, 1.7, 15.202911633942, 2.971).size, 4)
    153.6737
    """
    z, ring = wheel.teeth, wheel.teeth < 0
    angle = _angle(wheel, diameter)
    centres, reach = 2 * abs(wheel.base) / cos(angle), diameter * cos(wheel.section.base_helix) / 2
    curvature = abs(wheel.base) * tan(angle) + (reach if ring else -reach)
    odd = bool(z % 2)
    helical_pins = odd and body == "pins" and wheel.helix != 0 and not ring
    across = centres * cos(pi / (2 * z)) if odd and not helical_pins else centres
    end = float(wheel.curvature_at(tip)) if tip > abs(wheel.base) else 0.0
    low, high = (end, lowest) if ring else (lowest, end)
    foot = abs(float(wheel.root)) if root is None else root
    side = -1.0 if ring else 1.0
    return OverBalls(
        diameter,
        angle,
        centres,
        float(across + side * diameter),
        curvature,
        float(np.hypot(wheel.base, curvature)),
        bool(low <= curvature <= high),
        bool(side * (centres + side * diameter - 2 * tip) > 0 and side * (centres - side * diameter - 2 * foot) > 0),
        pi / (2 * sin(abs(wheel.helix))) if helical_pins else 0.0,
    )


def _angle(wheel: Wheel, diameter: float) -> float:
    """alpha_D [rad]."""
    space = (pi / 2 - 2 * float(wheel.shift) * tan(wheel.rack.angle)) / wheel.teeth
    least = (space - float(involute(wheel.transverse_angle))) * wheel.teeth * cos(wheel.rack.angle)
    target = diameter / (wheel.teeth * cos(wheel.rack.angle)) + float(involute(wheel.transverse_angle)) - space
    if target > 0:
        return float(inverse_involute(target))
    ring = wheel.teeth < 0
    raise NoSolutionError(
        f"balls of {diameter:.4g} modules touch the flanks beyond the base circle",
        where="size between balls" if ring else "size over balls",
        value=diameter,
        limit=least,
        remedy=f"balls {'smaller' if ring else 'larger'} than {least:.4g} modules",
    )


def ball_diameter(wheel: Wheel, radius: float) -> float:
    """D of the balls that touch the flanks on the circle of a radius (positive, of rings too), above the base circle.

    >>> wheel = Wheel(27)
    >>> ball = over_balls(wheel, ball_diameter(wheel, wheel.reference), wheel.plain_tip, 0.0)
    >>> round(ball.radius - wheel.reference, 12)
    0.0
    """
    base, squeeze = abs(wheel.base), cos(wheel.section.base_helix) ** 2
    side = 1.0 if wheel.teeth > 0 else -1.0
    touch = float(wheel.curvature_at(radius)) / base
    space = (pi / 2 - 2 * float(wheel.shift) * tan(wheel.rack.angle)) / wheel.teeth
    gap = space - float(involute(wheel.transverse_angle))  # half angle of the space on the base circle, of either sign

    def excess(angle: np.ndarray, _: np.ndarray) -> np.ndarray:
        # u = D/(2 r_b cos(beta_b)) from the angle, then where the ball touches
        u = side * (np.asarray(involute(angle)) + gap)
        return np.tan(angle) - side * u * squeeze - touch

    high = np.arctan(touch + abs(gap) + pi)
    angle = float(bracketed(excess, np.array([0.0]), np.array([high]))[0])
    return 2 * base * cos(wheel.section.base_helix) * side * float(involute(angle) + gap)


def usual_diameter(wheel: Wheel) -> float:
    """D of the balls that touch the flanks on the circle r + x, or just above the base circle: about 1.7 modules."""
    radius = abs(wheel.reference + float(wheel.shift))
    return ball_diameter(wheel, max(radius, abs(wheel.base) * (1 + 1e-6)))
