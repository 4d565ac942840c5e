"""An indexing drive as plain geometry, in plain floats or 50 digits (see `exact_peaks`): a roller drawn on its cam.

The law is a rise of 1 over 1 rad, so that its angle is the part k of the step.
"""

from __future__ import annotations

from mpmath import mp, mpf

from cams.exact import motion_at
from cams.exact_peaks import EXACT, crossing, extremes
from tmmcalc.cams.program import Phase, Program

SIDES = {"A": 1, "B": -1}  # theta at k = 0, in parts of beta_0


class Wheel:
    """The drive that was found, with its sizes taken as they are."""

    def __init__(self, found, law):
        self.found = found
        self.program = Program((Phase("rise", 1.0, 0.0, 1.0, law),))

    def at(self, k):
        """s and its derivatives in 50 digits; at a break the earlier piece."""
        return motion_at(self.program, k, int(self.program.phases[0].law.piece([float(k)])[0]))

    def turned(self, lib, s, side):
        """theta, beta' and beta'' by the angle of the cam."""
        half, step = lib.pi / self.found.rollers, lib.mpf(self.found.step)
        return side * half + 2 * half * s[0], 2 * half * s[1] / step, 2 * half * s[2] / step**2

    def place(self, lib, s, side):
        """The roller in the frame, O1 at 0."""
        theta, *_ = self.turned(lib, s, side)
        wheel = lib.mpf(self.found.wheel)
        return lib.mpf(self.found.ratio) * wheel - wheel * lib.expj(-theta)

    def curve(self, lib, k, s, side):
        """The pitch curve in the axes of the cam, with two derivatives by its angle."""
        theta, rate, grown = self.turned(lib, s, side)
        arm, turn = lib.mpf(self.found.wheel) * lib.expj(-theta), lib.expj(-lib.mpf(self.found.step) * k)
        z, z1 = self.place(lib, s, side), 1j * rate * arm
        z2 = (1j * grown + rate**2) * arm
        return z * turn, (z1 - 1j * z) * turn, (z2 - 2j * z1 - z) * turn

    def bend(self, side):
        """kappa, positive where the curve bulges outwards; it is run through clockwise."""

        def found(lib, k, s, piece):
            _, z1, z2 = self.curve(lib, k, s, side)
            return -(lib.conj(z1) * z2).imag / abs(z1) ** 3

        return found

    def working(self, k, s, side):
        """A point of the working profile."""
        z, z1, _ = self.curve(EXACT, k, s, side)
        return z - 1j * mpf(self.found.roller) * z1 / abs(z1)

    def angle(self, side):
        """vartheta (1)."""

        def found(lib, k, s, piece):
            theta, rate, _ = self.turned(lib, s, side)
            a, wheel = lib.mpf(self.found.ratio) * lib.mpf(self.found.wheel), lib.mpf(self.found.wheel)
            below = a * lib.sin(theta)
            lean = a * lib.cos(theta) - wheel * (1 + rate)
            return lib.atan2(lib.where(below < 0, -lean, lean), abs(below))

        return found

    def efficiency(self, k, s, side):
        """(12) and (13) within 0 to 1; sigma between the normal and the line from O1."""
        f1, f2 = map(mpf, self.found.frictions)
        angle = abs(self.angle(side)(EXACT, k, s, None))
        z, z1, _ = self.curve(EXACT, k, s, side)
        across = mp.conj(z) * 1j * z1
        rest, slope = abs(across.real), abs(across.imag)  # cot(sigma) = rest/slope
        top, low = (1 - f1 * f2) * mp.cos(angle) - (f1 + f2) * mp.sin(angle), mp.cos(angle)
        against = _within(top * slope, low * (slope + f1 * rest))
        loss = (1 - f1 * f2) * mp.cos(angle) + (f1 + f2) * mp.sin(angle)
        return against, _within((slope - f1 * rest) * low, slope * loss)

    def tip(self, near):
        """k_m."""
        step = mpf(self.found.step)
        return crossing(lambda k: mp.arg(self.place(EXACT, self.at(k), 1)) - step * (k - mpf(1) / 2), near)

    def working_tip(self, near):
        """k_w."""
        axis = mp.expj(mpf(self.found.step) / 2)
        return crossing(lambda k: (self.working(k, self.at(k), 1) * axis).imag, near)

    def largest(self, f, low, high):
        """The largest value between two parts of the step."""
        big = 1e30

        def within(lib, k, s, piece):
            value = f(lib, k, s, piece)
            return lib.where((k >= low - 1e-12) & (k <= high + 1e-12) if lib is not EXACT else low <= k <= high,
                             value, -big)  # fmt: skip

        return extremes(self.program, within, breaks=[each for each in (low, high) if 0 < each < 1])[1][0]


def _within(above, below):
    if above <= 0 or below <= 0:
        return mpf(0)
    return min(above / below, mpf(1))
