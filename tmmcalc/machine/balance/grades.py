"""Permissible residual unbalance of rigid rotors by balance quality grade, ISO 1940-1 and ISO 21940-11.

The grade G is the permissible speed of the centre of mass about the axis, e_per omega = G [mm/s], so that
U_per = G m / omega. Of a rotor on two bearings it is shared between the bearing planes A and B by the
distances of the centre of mass, U_A = U_per L_B / L and U_B = U_per L_A / L, within limits: between bearings from 0.3
to 0.7 of U_per, with an overhung centre of mass from 0.3 to 1.3.
"""

from __future__ import annotations

import math

from tmmcalc.core.errors import UsageError

GRADES = (0.4, 1.0, 2.5, 6.3, 16.0, 40.0, 100.0, 250.0, 630.0, 1600.0, 4000.0)  # [mm/s]
EXAMPLES = {
    0.4: "gyroscopes, spindles of high-precision systems",
    1.0: "grinding-machine drives",
    2.5: "turbines, compressors, machine-tool drives",
    6.3: "pumps, fans, gears, machines in general, flywheels",
    16.0: "crushing and agricultural machines, cardan shafts",
    40.0: "car wheels and drive shafts; balanced crank drives, elastically mounted",
    100.0: "complete engines of cars, lorries and locomotives",
    250.0: "unbalanced crank drives, rigidly mounted",
    630.0: "unbalanced crank drives, elastically mounted",
    1600.0: "balanced crank drives of large slow marine diesel engines",
    4000.0: "unbalanced crank drives of large slow marine diesel engines",
}
LEAST, INBOARD, OUTBOARD = 0.3, 0.7, 1.3


def permissible_eccentricity(grade: float, speed: float) -> float:
    """e_per [m] of the grade [mm/s] at the highest service speed [rad/s].

    >>> round(permissible_eccentricity(6.3, 314.16) * 1e6, 2)  # micrometres, 3000 rpm
    20.05
    """
    if not (grade > 0 and math.isfinite(grade)) or speed == 0 or not math.isfinite(speed):
        text = f"grade G {grade:g} mm/s at {speed:g} rad/s gives no tolerance"
        raise UsageError(text, where="balance quality", value=grade, remedy="give a grade above zero and the speed")
    return grade * 1e-3 / abs(speed)


def permissible_unbalance(grade: float, mass: float, speed: float) -> float:
    """U_per [kg*m] of a rotor of ``mass`` [kg]."""
    return permissible_eccentricity(grade, speed) * mass


def shared(total: float, center: float, bearings: tuple[float, float]) -> tuple[float, float]:
    """The parts of U_per for the bearing planes at z [m], the centre of mass at ``center`` [m].

    >>> shared(1.0, 0.5, (0.0, 1.0)), shared(1.0, 0.1, (0.0, 1.0))
    ((0.5, 0.5), (0.7, 0.3))
    """
    a, b = bearings
    if a == b:
        text = f"both bearings lie at {a:g} m"
        raise UsageError(text, where="balance quality", value=a, remedy="give the places of the two bearings")
    most = INBOARD if min(a, b) <= center <= max(a, b) else OUTBOARD
    parts = (abs((b - center) / (b - a)), abs((center - a) / (b - a)))
    return total * min(max(parts[0], LEAST), most), total * min(max(parts[1], LEAST), most)


def grade_reached(eccentricity: float, speed: float) -> tuple[float, float | None]:
    """The speed e omega [mm/s] of the centre of mass, and the best standard grade that it keeps; None beyond all."""
    value = abs(eccentricity * speed) * 1e3
    return value, next((grade for grade in GRADES if value <= grade * (1 + 1e-12)), None)
