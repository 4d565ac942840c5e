"""The 4-5-6-7 polynomial, whose jerk begins and ends at zero."""

from tmmcalc.cams.laws.law import polynomial

TITLE = "4-5-6-7 polynomial"
LAW = polynomial("poly4567", (0.0, [0, 0, 0, 0, 35, -84, 70, -20]))
