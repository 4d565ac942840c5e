"""The law whose acceleration is constant on either half."""

from tmmcalc.cams.laws.law import polynomial

TITLE = "piecewise constant acceleration"
LAW = polynomial("const", (0.0, [0, 0, 2]), (0.5, [0.5, 2, -2]))
