"""The modified trapezoid: s'' rises as a quarter sine, stays, falls as a half cosine, stays, and rises back."""

from math import pi

from tmmcalc.cams.laws.law import Acceleration, of_acceleration

TITLE = "modified trapezoidal acceleration"
LAW = of_acceleration(
    "modified_trapezoid",
    Acceleration(0.0, amplitude=1.0, frequency=4 * pi),
    Acceleration(1 / 8, (1.0,)),
    Acceleration(3 / 8, amplitude=1.0, frequency=4 * pi, phase=pi / 2),
    Acceleration(5 / 8, (-1.0,)),
    Acceleration(7 / 8, amplitude=-1.0, frequency=4 * pi, phase=pi / 2),
)
