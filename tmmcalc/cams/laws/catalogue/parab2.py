"""The law whose acceleration is two parabolas."""

from tmmcalc.cams.laws.law import polynomial

TITLE = "acceleration of two parabolas"
LAW = polynomial("parab2", (0.0, [0, 0, 0, 8, -8]), (0.5, [0.5, 2, 0, -8, 8]))
