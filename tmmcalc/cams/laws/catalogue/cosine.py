"""The law whose acceleration is half a cosine."""

from math import pi

from tmmcalc.cams.laws.law import harmonic

TITLE = "simple harmonic"
LAW = harmonic("cosine", [0.5], -0.5, pi, pi / 2)
