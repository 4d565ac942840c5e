"""Studies of gears: orders of rasters, chords and envelopes, methods of the inverse involute, complete searches."""

from __future__ import annotations

from itertools import pairwise

import mpmath as mp
import pytest
from sparing import sparing

from tmmcalc.core.studies.study import FLOOR
from tmmcalc.gears.accuracy.pair import TERMS

from .scenes import errors_in, errors_of, series_of, studies_of


@pytest.mark.parametrize("name", ["pair-spur", "pair-helical"])
def test_inverses_of_the_involute(name: str) -> None:
    for study in studies_of(name, "pair").values():
        assert study.reference.error < 1e-18
        for point in series_of(study, "bisection").points:  # within the bracket, anywhere in it
            assert (point.error or 0.0) < 3 * point.size + 1e-15
        newton = errors_of(study, "Newton (4.57)")
        assert newton[-1] < 1e-14
        quadratic = [later < 40 * former**1.9 for former, later in pairwise(newton)]
        assert all(later or error < 1e-14 for later, error in zip(quadratic, newton[1:], strict=True))
        fixed, terms = errors_of(study, "fixed point"), errors_of(study, "series")
        assert fixed == sorted(fixed, reverse=True)
        assert terms[-1] < 1e-3 * terms[2]
        assert errors_of(study, "Newton from the right")[0] < 1e-14


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


@sparing("name", ["pair-spur", "pair-blocking"], every=2)
def test_rasters_are_of_first_order_and_roots_are_exact(name: str) -> None:
    area, total = studies_of(name, "blocking").values()
    assert series_of(area, "raster").order == pytest.approx(1.0, abs=0.25)
    assert area.reference.error < 1e-10
    edges = errors_of(area, "edges between corners")
    assert edges[-1] < 1e-8 < 1e-4 < edges[0]
    assert errors_of(area, "raster")[-1] > 1e-3
    assert errors_of(total, "edges between corners") == pytest.approx([FLOOR] * 5, abs=1e-13)
    assert errors_of(total, "lines of constant sum")[-1] > 1e-4


@pytest.mark.parametrize("name", ["pair-spur", "pair-helical"])
def test_orders_of_drawn_teeth(name: str) -> None:
    fillet, involute = studies_of(name, "profile").values()
    assert series_of(fillet, "positions of the rack").order == pytest.approx(2.0, abs=0.1)
    for study in (fillet, involute):
        assert series_of(study, "chords").order == pytest.approx(2.0, abs=0.15)
        assert series_of(study, "cubics").order == pytest.approx(4.0, abs=0.35)


def test_stepping_and_complete_search() -> None:
    """The complete search is never beaten; the textbook's program passes sets over."""
    for name in ("gears-double-planets", "gears-coaxial"):
        for study in studies_of(name, "train").values():
            complete, stepping = series_of(study, "complete search"), series_of(study, "textbook's stepping")
            assert errors_in(complete)[-1] == FLOOR
            assert study.reference.error == 0
            for one, other in zip(complete.points, stepping.points, strict=True):
                if other.error is not None:
                    assert one.error is not None
                    assert one.error <= other.error
                    assert (one.count or 0) >= (other.count or 0)
