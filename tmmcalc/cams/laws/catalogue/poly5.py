"""The law whose acceleration is of the fifth degree."""

from tmmcalc.cams.laws.law import polynomial

TITLE = "3-4-5-6-7 polynomial, acceleration of the fifth degree"
LAW = polynomial("poly5", (0.0, [0, 0, 0, 18, -55, 78, -56, 16]))
