"""Efficiency of a drive at an instant, with the load against the motion (12) and with it (13), and over a step.

    against   eta = (1 - f1 f2 - (f1 + f2) tan|vartheta|)/(1 + f1 cot sigma)
    aiding    eta = (1 - f1 cot sigma)/(1 - f1 f2 + (f1 + f2) tan|vartheta|)

f1 is the friction of the roller on the cam, f2 on its pin; sigma is the acute angle between the normal and the line
from O1 to the roller. Where a formula leaves 0 to 1 (self-locking; sigma near 0 at the ends of the step) it is cut off
there, which is flagged. Over a step A drives up to k_m, B after it; means are integrals. The forms below are quotients
without tangents, which grow without limit.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmmcalc.cams.indexing.flanks import Drive, Flank, on_panels, sign_changes
from tmmcalc.cams.indexing.results import EfficiencyTable, Flags
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.records import record

Terms = tuple[Values, Values]
Formula = Callable[[Values, Values, float, float], Terms]


def against(angle: Values, sigma: Values, f1: float, f2: float) -> tuple[Values, Flags]:
    """Efficiency (n,) with the load against the motion (12), and where it was cut off.

    >>> against(np.radians([20.0]), np.radians([35.0]), 0.18, 0.2286)[0].round(6).tolist()
    [0.644464]
    """
    return cut(*against_terms(angle, sigma, f1, f2))


def aiding(angle: Values, sigma: Values, f1: float, f2: float) -> tuple[Values, Flags]:
    """Efficiency (n,) with the load along the motion (13), and where it was cut off.

    >>> aiding(np.radians([20.0]), np.radians([35.0]), 0.18, 0.2286)[0].round(6).tolist()
    [0.670778]
    """
    return cut(*aiding_terms(angle, sigma, f1, f2))


def against_terms(angle: Values, sigma: Values, f1: float, f2: float) -> Terms:
    """Numerator and denominator of (12), the latter not negative."""
    cosine, sine, sigma = np.cos(angle), np.abs(np.sin(angle)), _effective_angle(sigma, f1)
    gain = (1 - f1 * f2) * cosine - (f1 + f2) * sine
    return gain * np.sin(sigma), cosine * (np.sin(sigma) + f1 * np.cos(sigma))


def aiding_terms(angle: Values, sigma: Values, f1: float, f2: float) -> Terms:
    """Numerator and denominator of (13), which has no sense where the latter is not positive."""
    cosine, sine, sigma = np.cos(angle), np.abs(np.sin(angle)), _effective_angle(sigma, f1)
    loss = (1 - f1 * f2) * cosine + (f1 + f2) * sine
    return (np.sin(sigma) - f1 * np.cos(sigma)) * cosine, np.sin(sigma) * loss


def _effective_angle(sigma: Values, f1: float) -> Values:
    """sigma, or a right angle where the rollers have no friction on the cam and it does not matter."""
    return sigma if f1 else np.full_like(sigma, np.pi / 2)


def cut(above: Values, below: Values) -> tuple[Values, Flags]:
    """The quotient within 0 to 1, and where it was outside or is undefined."""
    low, high = (above <= 0) | (below <= 0), above > below
    inside: Any = ~(low | high)
    value = np.where(inside, above / np.where(inside, below, 1.0), np.where(low, 0.0, 1.0))
    return value, np.asarray(~inside)


@record
class _Drawn:
    """One formula along one flank that drives."""

    formula: Formula
    flank: Flank
    frictions: tuple[float, float]

    def terms(self, k: Values) -> Terms:
        """Numerator and denominator (n,)."""
        return self.formula(self.flank.pressure(k), self.flank.rise_angle(k), *self.frictions)

    def total(self, low: float, high: float) -> Values:
        """The integral of the efficiency, and how much of the step is cut off, (2,)."""
        drive, flank = self.flank.drive, self.flank
        kinks = [
            *sign_changes(flank.pressure, drive, low, high),
            *sign_changes(lambda k: flank.rise(k).real, drive, low, high),
        ]
        # both terms are of the size of 1: with little friction their difference is rounding, which no panel resolves
        zero = sign_changes(lambda k: self.terms(k)[0], drive, low, high, *kinks, scale=1.0)
        one = sign_changes(lambda k: np.subtract(*self.terms(k)), drive, low, high, *kinks, scale=1.0)
        on, values = on_panels(lambda k: cut(*self.terms(k))[0], drive, low, high, *kinks, *zero, *one)
        flags = cut(*self.terms(on.x[:, on.order // 2]))[1]
        return np.array([on.total(values), np.sum(on.width[flags])])


def efficiency_table(drive: Drive, k: Values, end: float, f1: float, f2: float) -> EfficiencyTable:
    """Both efficiencies at k (n,), their means, and how much of the step is cut off; ``end`` is k_m."""
    load, help_ = (
        tuple(_Drawn(formula, Flank(drive, name), (f1, f2)) for name in ("A", "B"))
        for formula in (against_terms, aiding_terms)
    )
    up, out = load[0].total(0.0, end), load[1].total(end, 1.0)
    up_with, out_with = help_[0].total(0.0, end), help_[1].total(end, 1.0)
    (here, here_cut), (along, along_cut) = (
        cut(*np.where(k <= end, each[0].terms(k), each[1].terms(k))) for each in (load, help_)
    )
    return EfficiencyTable(
        against=here,
        aiding=along,
        against_cut=here_cut,
        aiding_cut=along_cut,
        against_a=float(up[0]),
        against_b=float(out[0]),
        aiding_a=float(up_with[0]),
        aiding_b=float(out_with[0]),
        mean_against=float(up[0] + out[0]),
        mean_aiding=float(up_with[0] + out_with[0]),
        mean_paper=float(up[0] + out_with[0]),
        against_share=float(up[1] + out[1]),
        aiding_share=float(up_with[1] + out_with[1]),
    )
