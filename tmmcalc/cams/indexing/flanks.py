"""The flanks of a cam: what a roller draws on it while the wheel turns by beta = beta_m s(k) in one step.

    A      theta = beta_0 + beta        pushes its roller outwards, the front of the lobe
    B      theta = beta - beta_0        the groove, which leads a roller through the line of centres
    back   theta = beta - 3 beta_0      the back of the lobe, mirror image of A in time

theta is the angle of the roller on the wheel from O2O1, positive as the wheel turns. Axes of the cam: O1, x through O2
at k = 0, y to the left, the cam turns counter-clockwise. A flank is the curve of a rocker l_k on centres a that turns
against its cam, whence points, tangents and curvature:

    R = sqrt(a^2 + l_k^2 - 2 a l_k cos theta),  psi = atan2(l_k sin theta, a - l_k cos theta),  delta = psi - phi_p k
    tan vartheta = (a cos theta - l_k (1 + beta'))/(a sin theta)                               (1)
    rho = speed^3/(a^2 + l_k^2 w^3 - a l_k (w (1 + w) cos theta + beta'' sin theta)),  w = 1 + beta'   (4)
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from math import cos, pi
from typing import Literal

import numpy as np

from tmmcalc.cams.follower import Complex, Follower
from tmmcalc.cams.laws.law import Indices, Law, Values
from tmmcalc.cams.profile.offsets import Frame, frame
from tmmcalc.core.numerics.panels import Panels, panels, resolved
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record

WIDEST = 1 / 16  # of a first panel, of the step
Function = Callable[[Values], Values]
FlankName = Literal["A", "B", "back"]
STARTS = {"A": 1, "B": -1, "back": -3}  # theta at k = 0, in parts of beta_0
NUDGE = 1e-6  # of the step, beside a point of the groove
STILL = 1e-9  # of a: a speed of the curve that is none


@record
class Drive:
    """The geometry of an indexing drive."""

    law: Law
    rollers: int  # z2
    step: float  # phi_p [rad]
    centres: float  # a [m]
    wheel: float  # l_k [m]

    @property
    def ratio(self) -> float:
        """lambda."""
        return self.centres / self.wheel

    @property
    def half(self) -> float:
        """beta_0 [rad]."""
        return pi / self.rollers

    @property
    def base(self) -> float:
        """R_0 [m], of the pitch curve in the dwells."""
        square = self.centres**2 + self.wheel**2 - 2 * self.centres * self.wheel * cos(self.half)
        return float(np.sqrt(square))


@record
class Flank:
    """One flank of a drive."""

    drive: Drive
    name: FlankName

    @cached_property
    def follower(self) -> Follower:
        """The rocker that draws it."""
        drive = self.drive
        start = STARTS[self.name] * drive.half
        return Follower("oscillating", start, centres=drive.centres, rocker=drive.wheel, assembly=-1, sense=-1)

    def motion(self, k: Values, piece: Indices | None = None) -> Values:
        """beta and its derivatives by the angle of the cam (4, n) at parts k (n,) of the step."""
        drive = self.drive
        return 2 * drive.half / drive.step ** np.arange(4)[:, None] * drive.law.at(k, piece)

    def theta(self, k: Values) -> Values:
        """Angle (n,) [rad] of the roller from O2O1."""
        return np.asarray(self.follower.start + self.motion(k)[0])

    def roller(self, k: Values) -> Complex:
        """Place (n,) of the roller in the frame, O1 at 0, O2 at a."""
        return np.asarray(self.drive.centres - self.drive.wheel * np.exp(-1j * self.theta(k)))

    def polar(self, k: Values) -> Values:
        """psi (n,) [rad], polar angle of the roller at O1 in the frame."""
        return np.angle(self.roller(k))

    def frame(self, k: Values, piece: Indices | None = None) -> Frame:
        """The pitch curve at k, canonical; at a point of the groove the limit before it."""
        here = self._frame(k, piece)
        still = here.speed < STILL * self.drive.centres
        return self._frame(np.where(still, k - NUDGE, k), piece) if np.any(still) else here

    def _frame(self, k: Values, piece: Indices | None) -> Frame:
        with np.errstate(invalid="ignore", divide="ignore"):
            return frame(self.follower, self.drive.step * k, self.motion(k, piece))

    def points(self, k: Values, distance: float = 0.0, piece: Indices | None = None) -> Complex:
        """The offset (n,) inwards by ``distance`` in the axes of the cam; 0: the pitch curve."""
        return self.follower.placed(self.frame(k, piece).offset(distance))

    def rates(self, k: Values, distance: float = 0.0, piece: Indices | None = None) -> Complex:
        """The derivative (n,) of the offset by k."""
        return self.drive.step * self.follower.placed(self.frame(k, piece).rate(distance, flat=False))

    def curvature(self, k: Values, piece: Indices | None = None) -> Values:
        """Curvature (n,) [1/m] of the pitch curve, positive where it bulges outwards (4)."""
        return self.frame(k, piece).bend

    def pressure(self, k: Values) -> Values:
        """Pressure angle (n,) [rad] (1): positive where the cam presses the roller towards O2 as it drives the wheel.

        On B it is negative before the middle, where the groove cannot drive, and 90 deg at theta = 0.
        """
        y, rate = self.motion(k)[:2]
        return self._angle(y, 1 + rate)

    def source_pressure(self, k: Values) -> Values:
        """The same with 1 - beta' (n,) [rad], as the printed tables have it: right only for one sense of rotation."""
        y, rate = self.motion(k)[:2]
        return self._angle(y, 1 - rate)

    def _angle(self, y: Values, w: Values) -> Values:
        theta, drive = self.follower.start + y, self.drive
        below = drive.centres * np.sin(theta)
        lean = drive.centres * np.cos(theta) - drive.wheel * w
        return np.asarray(np.arctan2(np.where(below < 0, -lean, lean), np.abs(below)))

    def rise_angle(self, k: Values) -> Values:
        """sigma (n,) [rad], acute angle of the normal and the line from O1; the normal passes the pole on O1O2."""
        turned = self.rise(k)
        return np.arctan2(np.abs(turned.imag), np.abs(turned.real))

    def rise(self, k: Values) -> Complex:
        """The normal (n,) [m^2], from the pole to the roller, turned and scaled so that the line from O1 is real."""
        rate, place = self.motion(k)[1], self.roller(k)
        return np.asarray(np.conj(place) * (place * (1 + rate) - self.drive.centres * rate))


def on_panels(
    f: Function, drive: Drive, low: float, high: float, *breaks: float, scale: float | None = None
) -> tuple[Panels, Values]:
    """Panels from ``low`` to ``high`` of the step that resolve f, and its values (K, N).

    Its size is ``scale``, by default its largest value.
    """
    edges = [*drive.law.breaks.tolist(), 0.5, *breaks]
    size = None if scale is None else np.array([scale])
    on, values, _ = resolved(lambda k: f(k)[None], panels(low, high, edges, WIDEST), scale=size)
    return on, values[0]


def sign_changes(
    f: Function, drive: Drive, low: float, high: float, *breaks: float, scale: float | None = None
) -> list[float]:
    """All k between ``low`` and ``high`` at which f, of the size ``scale``, changes sign; ``breaks`` are its kinks."""
    on, values = on_panels(f, drive, low, high, *breaks, scale=scale)
    at, found = on.turning(values)
    k = np.concatenate((on.x.ravel(), at))
    order = np.argsort(k, kind="stable")
    k, value = k[order], np.concatenate((values.ravel(), found))[order]
    which = np.flatnonzero(np.signbit(value[1:]) != np.signbit(value[:-1]))
    roots: list[float] = bracketed(lambda x, _: f(x), k[which], k[which + 1]).tolist()
    return roots
