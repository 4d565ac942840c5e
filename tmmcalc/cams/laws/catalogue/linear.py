"""The law whose acceleration falls on a straight line."""

from tmmcalc.cams.laws.law import polynomial

TITLE = "acceleration on a falling straight line"
LAW = polynomial("linear", (0.0, [0, 0, 3, -2]))
