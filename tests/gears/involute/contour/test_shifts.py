"""Points of interest and strategies against the worked case and against a raster of the plane."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from sparing import sparing

from gears.involute.contour.pairs import PAIRS, case, task
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.contour.contour import contour
from tmmcalc.gears.involute.contour.curves import contact_ratio_line, sliding_line, strength_line, thickness_line
from tmmcalc.gears.involute.contour.margins import margins
from tmmcalc.gears.involute.formfactor import tooth_form
from tmmcalc.gears.involute.pair import pair_of_shifts
from tmmcalc.gears.involute.shifts import choose
from tmmcalc.gears.involute.strategies import STRATEGIES
from tmmcalc.gears.involute.wheel import Wheel


def test_points_of_the_worked_case():
    expected = case("IG-S09")["expected"]
    best = choose(task(14, 17), "max_contact_strength")
    assert best.x1 + best.x2 == pytest.approx(expected["max_contact_strength_eps1"]["x_sum"], abs=1e-5)
    best = choose(task(14, 17, 1.2, 0.25), "max_contact_strength")
    assert best.x1 + best.x2 == pytest.approx(expected["max_contact_strength_eps1_2_sa0_25"]["x_sum"], abs=1e-5)
    d, e = choose(task(14, 17), "equal_sliding", desired=1.2), choose(task(14, 17), "max_contact_ratio")
    assert (d.x1, d.x2) == pytest.approx(tuple(expected["equal_sliding_eps1_2"].values()), abs=1e-5)
    assert float(d.margins.theta1) == pytest.approx(float(d.margins.theta2), rel=1e-9)
    assert float(d.margins.contact_ratio) == pytest.approx(0.2, abs=1e-10)
    assert (e.x1, e.x2) == pytest.approx((0.18116, 0.00569), abs=1e-5)
    assert float(e.margins.contact_ratio) == pytest.approx(0.41823, abs=1e-5)


@pytest.mark.parametrize("asked", PAIRS, ids=lambda t: f"{t.first.teeth}/{t.second.teeth}")
def test_optima_are_not_beaten_by_a_raster(asked):
    area = contour(asked)
    one, two = area.region.outline
    x1, x2 = np.meshgrid(np.linspace(one.min(), one.max(), 250), np.linspace(two.min(), two.max(), 250))
    found = margins(asked, x1, x2)
    inside = (found.least() >= 0) & (x1 > -1) & (x2 > -1)
    for strategy, value in (("max_contact_strength", x1 + x2), ("max_contact_ratio", found.contact_ratio)):
        best = choose(asked, strategy)
        assert best.inside
        own = best.x1 + best.x2 if strategy == "max_contact_strength" else float(best.margins.contact_ratio)
        raster = float(value[inside].max())
        assert raster <= own + 1e-9
        assert own - raster < 0.05


@sparing("asked", PAIRS, ids=lambda t: f"{t.first.teeth}/{t.second.teeth}", every=3)
def test_every_strategy_stays_inside(asked):
    distance = asked.first.reference + asked.second.reference + 0.7
    for strategy in STRATEGIES:
        if strategy in ("given", "zero"):
            continue
        try:
            found = choose(asked, strategy, distance=distance)
        except NoSolutionError:
            assert strategy in ("equal_shift", "given_aw", "equal_strength")
            continue
        assert found.inside, (strategy, found)


def test_equal_strength_gives_equal_form_factors():
    found = choose(task(20, 60), "equal_strength")
    pair = pair_of_shifts(Wheel(20, found.x1), Wheel(60, found.x2))
    factors = [float(tooth_form(w, t).factor) for w, t in zip(pair.wheels, pair.tips, strict=True)]
    assert factors[0] == pytest.approx(factors[1], abs=1e-8)


@pytest.mark.parametrize("asked", [*PAIRS, task(37, 37, helix=15)], ids=lambda t: f"{t.first.teeth}/{t.second.teeth}")
def test_no_equal_strength_has_a_larger_sum(asked):
    area = contour(asked)
    line = strength_line(area)
    found = choose(asked, "equal_strength")
    assert found.inside
    assert np.max(line.x1 + line.x2) <= found.x1 + found.x2 + 1e-9
    pair = pair_of_shifts(*asked.wheels(found.x1, found.x2))
    factors = [float(tooth_form(wheel, tip).factor) for wheel, tip in zip(pair.wheels, pair.tips, strict=True)]
    assert factors[0] == pytest.approx(factors[1], abs=1e-9)


def test_form_factors_of_the_worked_case():
    worked = case("IG-S15")
    for k, (z, x) in enumerate(worked["inputs"]["gears"]):
        found = tooth_form(Wheel(z, x))
        assert float(found.factor) == pytest.approx(worked["expected"]["Y_F"][k], abs=1e-4)
        assert float(found.chord) == pytest.approx(worked["expected"]["s_Fn_over_m"][k], abs=1e-4)
        assert float(found.arm) == pytest.approx(worked["expected"]["h_F_over_m"][k], abs=1e-4)


def test_lines_hold_their_quantity():
    area = contour(task(20, 60, helix=15))
    asked = area.task
    ratio, tip = contact_ratio_line(area.frame, 1.2), thickness_line(area.frame, 1, 0.25)
    assert margins(asked, ratio.x1, ratio.x2).contact_ratio == pytest.approx(0.2, abs=1e-9)
    assert margins(asked, tip.x1, tip.x2).thickness1 == pytest.approx(0.25, abs=1e-9)
    equal = margins(asked, *(getattr(sliding_line(area), name) for name in ("x1", "x2")))
    assert equal.theta1 == pytest.approx(equal.theta2, rel=1e-6)
    assert strength_line(area).x1.size > 10


def test_a_point_outside_is_told_what_it_breaks_and_where_to_go():
    found = choose(task(14, 17), "zero")
    assert not found.inside
    assert {"undercut1", "undercut2"} <= set(found.broken)
    assert found.nearest == pytest.approx((0.18116, 0.00569), abs=1e-4)
    with pytest.raises(NoSolutionError, match="base radii"):
        choose(task(14, 17), "given_aw", distance=10.0)
    with pytest.raises(UsageError, match="strategy"):
        choose(task(14, 17), "best")


@pytest.mark.slow
def test_scipy_is_not_needed():
    import subprocess

    code = (
        "import sys; from tmmcalc.gears.involute.shifts import choose;"
        "from tmmcalc.gears.involute.contour.task import Task;"
        "from tmmcalc.gears.involute.wheel import Wheel; choose(Task(Wheel(14), Wheel(17)), 'balanced');"
        "sys.exit(any(m.startswith('scipy') for m in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
