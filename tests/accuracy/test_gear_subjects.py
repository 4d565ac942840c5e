"""Studies of gears: orders of rasters, chords and envelopes, methods of the inverse involute, complete searches."""

from __future__ import annotations

from itertools import pairwise

import mpmath as mp
import pytest

from tmmcalc import load_spec
from tmmcalc.accuracy.measure import Clock
from tmmcalc.accuracy.pair import TERMS
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.accuracy.study import FLOOR, Series, Study

from .test_machine_subjects import CONFIGS

ONCE = Clock(repeats=1, budget=0.0)


def _studies(name: str, stage: str) -> dict[str, Study]:
    found = solve_accuracy(load_spec(CONFIGS / f"{name}.toml"), stage, ONCE)
    return {study.quantity: study for study in found.studies}


def _series(study: Study, name: str) -> Series:
    return next(series for series in study.series if series.method == name)


def _errors(series: Series) -> list[float]:
    return [point.error for point in series.points if point.error is not None]


@pytest.mark.parametrize("name", ["pair-spur", "pair-helical"])
def test_inverses_of_the_involute(name: str) -> None:
    for study in _studies(name, "pair").values():
        assert study.reference.error < 1e-18
        for point in _series(study, "bisection").points:  # within the bracket, anywhere in it
            assert (point.error or 0.0) < 3 * point.size + 1e-15
        newton = _errors(_series(study, "Newton (4.57)"))
        assert newton[-1] < 1e-14
        quadratic = [later < 40 * former**1.9 for former, later in pairwise(newton)]
        assert all(later or error < 1e-14 for later, error in zip(quadratic, newton[1:], strict=True))
        fixed, terms = _errors(_series(study, "fixed point")), _errors(_series(study, "series"))
        assert fixed == sorted(fixed, reverse=True)
        assert terms[-1] < 1e-3 * terms[2]
        assert _errors(_series(study, "Newton from the right"))[0] < 1e-14


def test_the_series_of_the_inverse_involute_ends_with_its_next_term() -> None:
    """With n terms the error is of the order (3 q)^((2 n + 1)/3)."""
    with mp.workdps(60):
        for n in range(1, len(TERMS)):
            missed = []
            for u in (mp.mpf("0.02"), mp.mpf("0.01")):
                angle = mp.findroot(lambda a, u=u: 3 * (mp.tan(a) - a) - u**3, u)
                exact = [mp.mpf(1), -mp.mpf(2) / 15, mp.mpf(3) / 175, -mp.mpf(2) / 1575, -mp.mpf(16) / 202125,
                         mp.mpf(362) / 9384375, -mp.mpf(49711) / 12415528125]  # fmt: skip
                assert [float(term) for term in exact] == list(TERMS)
                missed.append(abs(angle - u * sum(c * u ** (2 * k) for k, c in enumerate(exact[:n]))))
            assert float(mp.log(missed[0] / missed[1], 2)) == pytest.approx(2 * n + 1, abs=0.01)


@pytest.mark.parametrize("name", ["pair-spur", "pair-blocking"])
def test_rasters_are_of_first_order_and_roots_are_exact(name: str) -> None:
    area, total = _studies(name, "blocking").values()
    assert _series(area, "raster").order == pytest.approx(1.0, abs=0.25)
    assert area.reference.error < 1e-10
    edges = _errors(_series(area, "edges between corners"))
    assert edges[-1] < 1e-8 < 1e-4 < edges[0]
    assert _errors(_series(area, "raster"))[-1] > 1e-3
    assert _errors(_series(total, "edges between corners")) == pytest.approx([FLOOR] * 5, abs=1e-13)
    assert _errors(_series(total, "lines of constant sum"))[-1] > 1e-4


@pytest.mark.parametrize("name", ["pair-spur", "pair-helical"])
def test_orders_of_drawn_teeth(name: str) -> None:
    fillet, involute = _studies(name, "profile").values()
    assert _series(fillet, "positions of the rack").order == pytest.approx(2.0, abs=0.1)
    for study in (fillet, involute):
        assert _series(study, "chords").order == pytest.approx(2.0, abs=0.15)
        assert _series(study, "cubics").order == pytest.approx(4.0, abs=0.35)


def test_stepping_and_complete_search() -> None:
    """The complete search is never beaten; the textbook's program passes sets over."""
    for name in ("gears-double-planets", "gears-coaxial"):
        for study in _studies(name, "train").values():
            complete, stepping = _series(study, "complete search"), _series(study, "textbook's stepping")
            assert _errors(complete)[-1] == FLOOR
            assert study.reference.error == 0
            for one, other in zip(complete.points, stepping.points, strict=True):
                if other.error is not None:
                    assert one.error is not None
                    assert one.error <= other.error
                    assert (one.evaluations or 0) >= (other.evaluations or 0)
