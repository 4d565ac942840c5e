"""Efficiency over a step: A drives up to k_m, B after it; means are integrals over the step."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tmmcalc.cams.indexing.efficiency import Terms, against_terms, aiding_terms, cut
from tmmcalc.cams.indexing.flanks import Drive, Flank, changes, sampled
from tmmcalc.cams.indexing.results import EfficiencyTable
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.records import record

Formula = Callable[[Values, Values, float, float], Terms]


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
        kinks = [*changes(flank.pressure, drive, low, high), *changes(lambda k: flank.rise(k).real, drive, low, high)]
        zero = changes(lambda k: self.terms(k)[0], drive, low, high, *kinks)
        one = changes(lambda k: np.subtract(*self.terms(k)), drive, low, high, *kinks)
        on, values = sampled(lambda k: cut(*self.terms(k))[0], drive, low, high, *kinks, *zero, *one)
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
        mean_against=float(up[0] + out[0]),
        mean_aiding=float(up_with[0] + out_with[0]),
        mean_paper=float(up[0] + out_with[0]),
        against_share=float(up[1] + out[1]),
        aiding_share=float(up_with[1] + out_with[1]),
    )
