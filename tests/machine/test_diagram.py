"""Torque diagrams without a mechanism: formulas, harmonics, pieces, tables, several cylinders on one shaft."""

from __future__ import annotations

import math
import subprocess
import sys
import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmmcalc.core.errors import AccuracyError, TmmError, UsageError
from tmmcalc.core.expression import parse
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.diagram import (
    balanced,
    combined,
    even_delays,
    from_formula,
    from_harmonics,
    from_pieces,
    from_table,
    superposed,
)
from tmmcalc.machine.flywheel.methods import positional_flywheels

TURN = 2 * math.pi


def work(cycle: Cycle) -> float:
    return float(cycle.panels.total(cycle.moment))


def has_edge(cycle: Cycle, place: float) -> bool:
    return bool(np.min(np.abs(cycle.panels.edges - place)) < 1e-12)


class TestFormula:
    @pytest.mark.parametrize(
        ("text", "area"),
        [
            ("1", TURN),
            ("abs(sin(theta))", 4.0),
            ("max(0, sin(phi))", 2.0),
            ("max(sin(theta), cos(theta), 0)", 2 + math.sqrt(2) - 1 + 1 - 0.0),
            ("100 if theta < pi/3 else -20", 100 * math.pi / 3 - 20 * 5 * math.pi / 3),
            ("1 if 1 < theta <= 2 or theta >= 6 else 0", 1 + TURN - 6),
            ("1 if not (theta > 1 and theta < 2) else 0", TURN - 1),
            ("theta % 1.5", 4 * 1.125 + (TURN - 6) ** 2 / 2),
            ("sign(cos(theta)) * cos(theta)", 4.0),
            ("exp(-theta)", 1 - math.exp(-TURN)),
            ("sqrt(theta)", 2 / 3 * TURN**1.5),
            ("log(1 + theta)", (1 + TURN) * math.log(1 + TURN) - TURN),
            ("degrees(theta) / 360", math.pi),
            ("theta ** 2 / e", TURN**3 / 3 / math.e),
            ("min(asin(0.5), acos(0.5), atan(1)) * radians(180)", math.pi / 6 * math.pi * TURN),
            ("-(-tan(0.5))", math.tan(0.5) * TURN),
        ],
    )
    def test_area(self, text: str, area: float) -> None:
        if text.startswith("max(sin(theta), cos(theta)"):
            # cos until pi/4, sin until pi, nothing until 3 pi/2, cos again
            area = math.sin(math.pi / 4) + (math.cos(math.pi / 4) + 1) + 1
        assert work(from_formula(text, 10.0)) == pytest.approx(area, rel=1e-11 if "sqrt" in text else 1e-13)

    @pytest.mark.parametrize(
        ("text", "places"),
        [
            ("abs(sin(theta))", [math.pi]),
            ("max(0, cos(theta) - 0.3)", [math.acos(0.3), TURN - math.acos(0.3)]),
            ("5 if theta < 1.7 else 2", [1.7]),
            ("theta % 2", [2.0, 4.0, 6.0]),
            ("sign(cos(theta))", [math.pi / 2, 3 * math.pi / 2]),
        ],
    )
    def test_edges_at_kinks_and_jumps(self, text: str, places: list[float]) -> None:
        cycle = from_formula(text, 10.0)
        assert all(has_edge(cycle, place) for place in places)
        assert cycle.panels.count < 40  # the kinks are found, not chased by halving
        assert cycle.error < 1e-12

    def test_constants_and_period(self) -> None:
        cycle = from_formula("M0 * sin(theta/4)**2", 20.0, period=4 * math.pi, constants={"M0": 30})
        assert cycle.period == 4 * math.pi
        assert work(cycle) == pytest.approx(30 * 2 * math.pi, rel=1e-13)
        assert cycle.speed == 20.0
        assert not np.any(cycle.inertia)

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("100*sim(theta)", "perhaps you meant sin"),
            ("100*sin(thet)", "perhaps you meant theta"),
            ("100*sin(theta", "not a formula"),
            ("", "not a formula"),
            ("2^theta", r"\*\*"),
            ("sin(theta, 2)", "one argument"),
            ("max(theta)", "two arguments"),
            ("sin(x=theta)", "one argument"),
            ("theta == 1", "no sense"),
            ("'a'", "real number"),
            ("2j", "real number"),
            ("True", "real number"),
            ("[theta]", "not arithmetic"),
            ("theta // 2", "not arithmetic"),
            ("~theta", "not arithmetic"),
            ("1/sin(theta*0)", "no finite value at theta"),
            ("log(theta - 1)", "no finite value at theta"),
            ("10**400", "no finite value"),
            ("1" + "0" * 400, "too large"),
            ("+".join(["theta"] * 1000), "longer than"),
        ],
    )
    def test_faults(self, text: str, message: str) -> None:
        with pytest.raises(UsageError, match=message):
            from_formula(text, 10.0)

    def test_fault_names_the_column(self) -> None:
        with pytest.raises(UsageError, match="column 8"):
            parse("12 + 3*speed")

    @pytest.mark.parametrize(
        "text",
        [
            "__import__('os').system('true')",
            "theta.__class__",
            "(lambda: theta)()",
            "[x for x in (1,)]",
            "theta[0]",
            "open('file')",
            "exec('1')",
            "f'{theta}'",
            "(y := theta)",
            "(" * 300 + "theta" + ")" * 300,
            "-" * 1500 + "theta",
        ],
    )
    def test_nothing_but_arithmetic_is_run(self, text: str) -> None:
        with pytest.raises(TmmError):
            from_formula(text, 10.0)

    def test_a_pole_is_refused(self) -> None:
        with pytest.raises(AccuracyError, match="not smooth enough"):
            from_formula("1/(theta - 2)", 10.0)

    @pytest.mark.parametrize(("speed", "period"), [(0.0, TURN), (-1.0, TURN), (math.inf, TURN), (1.0, 0.0)])
    def test_ranges(self, speed: float, period: float) -> None:
        with pytest.raises(UsageError, match="above zero"):
            from_formula("1", speed, period=period)


class TestHarmonics:
    def test_values(self) -> None:
        cycle = from_harmonics(20e3, [(2, -5700.0, 9500.0)], 6 * math.pi)
        x = cycle.panels.x
        np.testing.assert_allclose(cycle.moment, 20e3 + 9500 * np.sin(2 * x) - 5700 * np.cos(2 * x), rtol=1e-13)
        # the excess work of one harmonic of order k is 2 M/k
        exact = positional_flywheels(cycle, 0.0, 0.01)[0]
        assert exact.inertia == pytest.approx(math.hypot(9500, 5700) / (0.01 * (6 * math.pi) ** 2), rel=1e-13)

    def test_high_orders_are_resolved(self) -> None:
        cycle = from_harmonics(0.0, [(60, 1.0, 0.0)], 10.0)
        assert cycle.panels.extremes(cycle.moment)[1][0] == pytest.approx(1.0, rel=1e-11)
        assert float(cycle.panels.total(cycle.moment**2)) == pytest.approx(math.pi, rel=1e-12)

    def test_half_orders_need_the_double_turn(self) -> None:
        assert work(from_harmonics(3.0, [(0.5, 1.0, 2.0)], 10.0, period=2 * TURN)) == pytest.approx(3 * 2 * TURN)
        with pytest.raises(UsageError, match="does not close"):
            from_harmonics(3.0, [(0.5, 1.0, 2.0)], 10.0)


class TestPieces:
    def test_jumps_ramps_and_seam(self) -> None:
        cycle = from_pieces([(1, 0), (2, 10), (2, -5), (5, -5), (5, 4)], 10.0)
        at = np.array([1.5, 1.999999, 2.000001, 4.0, 5.0, 6.0, 0.5])
        seam = TURN - 4  # from (5, 4) down to (1 + 2 pi, 0)
        expected = [5, 9.99999, -5, -5, 4, 4 - 4 / seam, 4 - 4 * (TURN + 0.5 - 5) / seam]
        np.testing.assert_allclose(cycle.panels.at(cycle.moment, at), expected, atol=1e-11)
        assert work(cycle) == pytest.approx(5 - 15 + 2 * seam, rel=1e-13)
        assert has_edge(cycle, 2.0)
        assert cycle.error == 0

    @pytest.mark.parametrize("points", [[(0, 7)], [(3, 7)], [(0, 7), (TURN, 7)]])
    def test_constant(self, points: list[tuple[float, float]]) -> None:
        assert np.allclose(from_pieces(points, 1.0).moment, 7, rtol=1e-15)

    def test_jump_at_the_seam(self) -> None:
        cycle = from_pieces([(0, 5), (TURN, -1)], 1.0)
        assert work(cycle) == pytest.approx(2 * TURN)

    @pytest.mark.parametrize("points", [[], [(1, 0), (0.5, 1)], [(-1, 0), (2, 1)], [(0, 0), (7, 1)], [(0, math.nan)]])
    def test_faults(self, points: list[tuple[float, float]]) -> None:
        with pytest.raises(UsageError):
            from_pieces(points, 1.0)


class TestTable:
    def test_linear_is_the_pieces(self) -> None:
        theta, moment = [0.0, 1.0, 3.0, 5.0], [2.0, 5.0, -1.0, 0.0]
        a, b = from_table(theta, moment, 1.0), from_pieces(list(zip(theta, moment, strict=True)), 1.0)
        assert np.array_equal(a.moment, b.moment)

    @pytest.mark.parametrize("closed", [True, False])
    def test_pchip(self, closed: bool) -> None:
        """Against scipy's curve over five turns, and periodic in value and slope at the seam."""
        from scipy.interpolate import PchipInterpolator

        theta = np.linspace(0.3, 0.3 + TURN, 13)[:-1] % TURN
        theta.sort()
        moment = np.sin(theta) + 0.4 * np.cos(3 * theta)
        turns = np.arange(-2, 3) * TURN
        truth = PchipInterpolator(np.add.outer(turns, theta).ravel(), np.tile(moment, 5))
        if closed:
            end = TURN
            theta, moment = np.append(theta, end), np.append(moment, truth(end))
            theta, moment = np.append(0.0, theta), np.append(truth(0.0), moment)
            truth = PchipInterpolator(np.add.outer(turns, theta[:-1]).ravel(), np.tile(moment[:-1], 5))
        cycle = from_table(theta, moment, 1.0, kind="pchip")
        np.testing.assert_allclose(cycle.moment, truth(cycle.panels.x), atol=1e-13)
        slope = cycle.panels.slope(cycle.moment)
        low, high = cycle.panels.ends(slope)
        assert low[0] == pytest.approx(high[-1], abs=1e-10)

    def test_pchip_of_few_points(self) -> None:
        cycle = from_table([0.0, math.pi], [0.0, 1.0], 1.0, kind="pchip")
        assert work(cycle) == pytest.approx(math.pi, rel=1e-13)

    def test_faults(self) -> None:
        with pytest.raises(UsageError, match="kinds: linear, pchip"):
            from_table([0, 1], [0, 1], 1.0, kind="cubic")
        with pytest.raises(UsageError, match="each at its own angle"):
            from_table([0, 1, 1, 2], [0, 1, 2, 3], 1.0, kind="pchip")
        with pytest.raises(UsageError, match="same position"):
            from_table([0, 1, TURN], [0, 1, 2], 1.0, kind="pchip")


class TestSuperposition:
    def test_equal_cylinders_keep_the_harmonics_of_their_number(self) -> None:
        """Of three cylinders at 120 degrees only the orders 3, 6, ... remain, three times as large."""
        terms = [(k, 10.0 / k, 4.0 * k) for k in range(1, 7)]
        total = superposed(from_harmonics(7.0, terms, 10.0), even_delays(3))
        x = total.panels.x
        expected = 21 + sum(3 * (a * np.cos(k * x) + b * np.sin(k * x)) for k, a, b in terms if k % 3 == 0)
        np.testing.assert_allclose(total.moment, expected, atol=1e-10)

    @settings(max_examples=30, deadline=None)
    @given(st.lists(st.floats(-20, 20), min_size=1, max_size=4))
    def test_delays(self, delays: list[float]) -> None:
        """Against the pieces evaluated directly, away from the jumps."""
        points = [(0.0, 0.0), (1.0, 8.0), (2.5, 8.0), (2.5, -3.0), (6.0, -1.0)]
        one = from_pieces(points, 10.0)
        total = superposed(one, delays)
        assert work(total) == pytest.approx(len(delays) * work(one), rel=1e-6)
        x = np.linspace(0.013, TURN - 0.011, 200)
        shifted = [np.mod(x - delay, TURN) for delay in delays]
        away = np.min([np.abs(s - place) for s in shifted for place in (0.0, 2.5, TURN)], axis=0) > 1e-5
        expected = sum(one.panels.at(one.moment, s) for s in shifted)
        np.testing.assert_allclose(total.panels.at(total.moment, x)[away], expected[away], atol=1e-5)

    def test_jumps_keep_their_edges(self) -> None:
        one = from_pieces([(0, 5), (2, 5), (2, 0), (TURN, 0)], 10.0)
        total = superposed(one, (0.0, 1.5))
        assert all(has_edge(total, place) for place in (1.5, 2.0, 3.5))
        assert work(total) == pytest.approx(20.0, rel=1e-14)

    def test_masses_count_too(self) -> None:
        one = from_harmonics(0.0, [(1, 0.0, 5.0)], 10.0)
        heavy = Cycle(one.panels, 2 + np.cos(one.panels.x), -np.sin(one.panels.x), *(one.moment,) * 3, 10.0)
        pair = superposed(heavy, (0.0, math.pi))
        np.testing.assert_allclose(pair.inertia, 4, rtol=1e-13)
        np.testing.assert_allclose(pair.slope, 0, atol=1e-13)

    def test_four_stroke_engine_drives_a_compressor(self) -> None:
        engine = from_formula("400 if theta < pi else -50", 30.0, period=2 * TURN)
        compressor = from_formula("-60*max(0, sin(theta))", 30.0)
        both = combined([(engine, 0.0), (compressor, 0.5)])
        assert both.period == 2 * TURN
        assert work(both) == pytest.approx(work(engine) + 2 * work(compressor), rel=1e-12)
        assert both.panels.at(both.moment, np.array([TURN + 1.0]))[0] == pytest.approx(-50 - 60 * math.sin(0.5))

    def test_unfit_periods(self) -> None:
        with pytest.raises(UsageError, match="whole number of times"):
            combined([(from_harmonics(1, [], 1.0), 0.0), (from_harmonics(1, [], 1.0, period=9.0), 0.0)])
        with pytest.raises(UsageError, match="no diagrams"):
            combined([])

    def test_more_cylinders_need_less_flywheel(self) -> None:
        """A four-stroke engine, power stroke only: J falls as the cylinders fill the cycle."""
        one = from_formula("1000*sin(theta) if theta < pi else 0", 50.0, period=2 * TURN)
        needed = [
            positional_flywheels(superposed(one, even_delays(n, 2 * TURN)), 0.0, 0.01)[0].inertia / n for n in (1, 2, 4)
        ]
        # one cylinder: the excess above the mean 2000/(4 pi) of a half sine, by hand
        mean = 1000 / TURN
        cross = math.asin(mean / 1000)
        by_hand = (2 * 1000 * math.cos(cross) - mean * (math.pi - 2 * cross)) / (0.01 * 2500)
        assert needed[0] == pytest.approx(by_hand, rel=1e-12)
        assert needed[0] > needed[1] > needed[2]


class TestBalanced:
    def test_closes_the_work(self) -> None:
        cycle = from_formula("300*max(0, sin(theta))", 10.0)
        closed = balanced(cycle)
        assert abs(work(closed)) < 1e-11
        np.testing.assert_allclose(cycle.moment - closed.moment, 300 / math.pi, rtol=1e-13)

    def test_with_forces_that_depend_on_speed(self) -> None:
        plain = from_harmonics(100.0, [(1, 20.0, 0.0)], 10.0)
        ones = np.ones_like(plain.moment)
        fan = Cycle(plain.panels, plain.inertia, plain.slope, plain.moment, -ones, -0.1 * ones, 10.0)
        closed = balanced(fan, 8.0)
        assert closed.speed == 8.0
        assert work(closed) == pytest.approx((8 + 6.4) * TURN, rel=1e-13)


def test_scipy_stays_out() -> None:
    code = (
        "import sys; from tmmcalc.machine.diagram import from_formula, superposed;"
        "from tmmcalc.machine.flywheel.methods import positional_flywheels as f;"
        "f(superposed(from_formula('abs(sin(theta))', 1.0), (0, 1)), 0.0, 0.1);"
        "sys.exit('scipy' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.parametrize("formula", ["sign(sin(1e9*theta))", "sin(1e7*theta)", "theta % 1e-9", "abs(sin(1e6*theta))"])
def test_a_formula_that_turns_too_often_is_refused(formula: str) -> None:
    with pytest.raises(AccuracyError, match=r"changes its sense \d+ times or more in the cycle of 360 deg") as told:
        from_formula(formula, 10.0)
    assert told.value.exit_code == 4
    assert "near theta = " in str(told.value)
    assert "lower the factors of theta" in told.value.remedy


@pytest.mark.slow
def test_equal_diagrams_have_no_more_pieces_than_panels() -> None:
    cycle = from_formula("sin(3000*theta)", 10.0)
    with pytest.raises(AccuracyError, match="jumps and kinks"):
        superposed(cycle, even_delays(997))


def test_many_harmonics_take_little_memory() -> None:
    terms = [(k, 1.0, 0.0) for k in range(1, 400)]
    tracemalloc.start()
    cycle = from_harmonics(0.0, terms, 10.0)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 60 * cycle.moment.nbytes + (20 << 20)
    assert float(cycle.panels.at(cycle.moment, np.zeros(1))[0]) == pytest.approx(399.0, rel=1e-9)
