"""The modified sine: s'' rises as a quarter sine, falls as a slower half cosine, and rises back."""

from math import pi

from tmmcalc.cams.laws.law import Acceleration, of_acceleration

TITLE = "modified sine acceleration"
LAW = of_acceleration(
    "modified_sine",
    Acceleration(0.0, amplitude=1.0, frequency=4 * pi),
    Acceleration(1 / 8, amplitude=1.0, frequency=4 * pi / 3, phase=pi / 2),
    Acceleration(7 / 8, amplitude=-1.0, frequency=4 * pi, phase=pi / 2),
)
