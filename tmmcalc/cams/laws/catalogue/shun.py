"""The 3-4-5 polynomial: the least degree whose acceleration begins and ends at zero."""

from tmmcalc.cams.laws.law import polynomial

TITLE = "3-4-5 polynomial"
LAW = polynomial("shun", (0.0, [0, 0, 0, 10, -15, 6]))
