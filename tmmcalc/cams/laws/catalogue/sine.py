"""The law whose acceleration is a whole sine."""

from math import pi

from tmmcalc.cams.laws.law import harmonic

TITLE = "cycloidal"
LAW = harmonic("sine", [0.0, 1.0], -1 / (2 * pi), 2 * pi, 0.0)
