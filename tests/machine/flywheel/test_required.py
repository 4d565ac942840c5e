"""The true flywheel under a motor: closed forms, an independent integration, stall, lag and resonance."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sparing import sparing

from machine.flywheel.scenes import CASES, TURN, parabola, upsetter, upsetter_cycle
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.diagram import from_harmonics
from tmmcalc.machine.flywheel.comparison import compared
from tmmcalc.machine.flywheel.methods import positional_flywheels
from tmmcalc.machine.flywheel.required import fluctuation, required_inertia, surely_uneven
from tmmcalc.machine.flywheel.results import Trial
from tmmcalc.machine.flywheel.search import corrections, least_inertia, tried
from tmmcalc.machine.motors.characteristics import (
    ConstantMoment,
    Kloss,
    Parabolic,
    Straight,
    kloss,
    parabolic,
    straight,
)
from tmmcalc.machine.recurrence import on_nodes, periodic
from tmmcalc.machine.steady import driven

GIVEN = CASES["dyn-upsetter-flywheel-motor"]["inputs"]
NOMINAL, SYNCHRONOUS = GIVEN["omega_N"], GIVEN["omega_sync"]
RATED = GIVEN["P_N_W"] / NOMINAL


def parabola_motor() -> Parabolic:
    return parabolic(RATED, NOMINAL, SYNCHRONOUS)


def kloss_motor() -> Kloss:
    slip = 1 - NOMINAL / SYNCHRONOUS
    overload = GIVEN["K"]
    critical = slip * (overload + math.sqrt(overload**2 - 1))
    return kloss(overload * RATED, critical, SYNCHRONOUS, NOMINAL)


def straight_motor() -> Straight:
    return straight(RATED, NOMINAL, SYNCHRONOUS)


def independent_delta(inertia: float) -> float:
    """Parabola: dE/dphi is linear in E, so the periodic solution follows from two integrations by DOP853."""
    a, b = parabola()

    def rate(phi: float, energy: np.ndarray, late: bool) -> np.ndarray:
        links, moment = upsetter(np.array(phi), 0.0 if late else 1.0)
        return a + moment - 2 * b * energy / (links + inertia)

    def turn(start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        samples, energy, y = [], [], start
        for span, late in (((0, np.pi), False), ((np.pi, TURN), True)):
            run = solve_ivp(
                rate, span, y, "DOP853", rtol=1e-12, atol=1e-9, args=(late,), t_eval=np.linspace(*span, 20001)
            )
            samples.append(run.t)
            energy.append(run.y)
            y = run.y[:, -1]
        return np.concatenate(samples), np.concatenate(energy, axis=1)

    first = 1500.0
    _, pair = turn(np.array([first, 2 * first]))
    share = (pair[1, -1] - pair[0, -1]) / first
    start = (pair[0, -1] - share * first) / (1 - share)
    phi, energy = turn(np.array([start]))
    omega = np.sqrt(2 * energy[0] / (upsetter(phi)[0] + inertia))
    return float(2 * (omega.max() - omega.min()) / (omega.max() + omega.min()))


class TestClosedForm:
    """Load M1 sin theta and a parabola: omega^2 = p + q sin(theta - psi), with q = 2 M1 / sqrt((2B)^2 + J^2)."""

    @staticmethod
    def inertia(delta: float, mean_load: float, amplitude: float) -> float:
        a, b = parabola()
        p = (a - mean_load) / b
        ratio = ((1 + delta / 2) / (1 - delta / 2)) ** 2
        q = p * (ratio - 1) / (ratio + 1)
        return math.sqrt((2 * amplitude / q) ** 2 - (2 * b) ** 2)

    @pytest.mark.parametrize("delta", [0.02, 0.05, 0.09])
    @pytest.mark.parametrize("at_hand", [0.5, 3.0])
    def test_inertia(self, delta: float, at_hand: float) -> None:
        cycle = from_harmonics(-80.0, [(1, 0.0, 100.0)], 10.0)
        found = required_inertia(cycle, parabola_motor(), delta, at_hand)
        truth = self.inertia(delta, 80.0, 100.0)
        assert found.inertia == pytest.approx(truth, rel=3e-9)
        assert found.addition == pytest.approx(truth - at_hand, rel=3e-9)
        assert found.delta == pytest.approx(delta, rel=1e-9)
        assert found.needed
        assert found.monotone

    @pytest.mark.slow
    def test_motor_damps_so_that_less_is_needed(self) -> None:
        cycle = from_harmonics(-80.0, [(1, 0.0, 100.0)], 10.0)
        found = required_inertia(cycle, parabola_motor(), 0.05, 1.0)
        alone = positional_flywheels(cycle, 1.0, 0.05, found.regime.mean)[0].inertia
        assert found.inertia < alone
        # and where the motor hardly reacts, both agree
        _a, b = parabola()
        soft = Parabolic(80 + b * 1e-4 * 100, b * 1e-4, SYNCHRONOUS, NOMINAL)
        light = required_inertia(cycle, soft, 0.05, 1.0)
        assert light.inertia == pytest.approx(
            positional_flywheels(cycle, 1.0, 0.05, light.regime.mean)[0].inertia, rel=1e-6
        )

    def test_scale(self) -> None:
        """Moments and inertias ten times as large."""
        cycle = upsetter_cycle()
        larger = replace(cycle, inertia=10 * cycle.inertia, slope=10 * cycle.slope, moment=10 * cycle.moment)
        a, b = parabola()
        found = required_inertia(cycle, parabola_motor(), 0.08, 10.6)
        scaled = required_inertia(larger, Parabolic(10 * a, 10 * b, SYNCHRONOUS, NOMINAL), 0.08, 106.0)
        assert scaled.inertia == pytest.approx(10 * found.inertia, rel=3e-9)


class TestUpsetter:
    def test_against_an_independent_integration(self) -> None:
        found = required_inertia(upsetter_cycle(), parabola_motor(), 0.08, 10.6)
        assert independent_delta(found.inertia) == pytest.approx(0.08, abs=2e-9)
        assert found.regime.constant_inertia == found.inertia
        assert found.evaluations <= 7

    def test_the_case_on_the_nodes_of_the_recurrence(self) -> None:
        """The root of the case belongs to the recurrence on 24 nodes, which misses the extremes between them."""
        case = CASES["dyn-upsetter-flywheel-motor"]

        def delta(inertia: float) -> float:
            return periodic(on_nodes(upsetter_cycle(), inertia, *parabola(), case["inputs"]["n"])).delta

        trials: list[Trial] = []
        first, start = (tried(delta, inertia, trials) for inertia in (case["inputs"]["J_const_initial"], 45.0))
        root = least_inertia(delta, case["inputs"]["delta_allowed"], first, start, trials)
        assert root.inertia == pytest.approx(case["expected"]["J_const_exact_root"], rel=case["tolerance"]["rel"])

    def test_neighbours(self) -> None:
        """A little less inertia is too little."""
        for motor in (parabola_motor(), kloss_motor(), straight_motor()):
            found = required_inertia(upsetter_cycle(), motor, 0.08, 10.6)
            less = required_inertia(upsetter_cycle(), motor, 0.08, found.inertia * (1 - 1e-6))
            assert less.needed
            assert less.inertia == pytest.approx(found.inertia, rel=1e-8)
            more = required_inertia(upsetter_cycle(), motor, 0.08, found.inertia * (1 + 1e-6))
            assert not more.needed

    def test_nothing_needed(self) -> None:
        found = required_inertia(upsetter_cycle(), parabola_motor(), 0.08, 60.0)
        assert (found.needed, found.addition, found.inertia) == (False, 0.0, 60.0)
        assert found.delta < 0.08
        assert found.remarks == ()

    @sparing("at_hand", [0.0, 2.0], every=2)
    def test_stall_without_flywheel(self, at_hand: float) -> None:
        """Case dyn-upsetter-stall: below 3.265 kg*m^2 the motor does not pass the peak."""
        found = required_inertia(upsetter_cycle(), kloss_motor(), 0.08, at_hand)
        assert found.trials[0].delta is None
        (carrying,) = re.findall(r"stalls or runs away; ([0-9.]+) kg\*m\^2 of constant", found.remarks[0])
        assert float(carrying) == pytest.approx(CASES["dyn-upsetter-stall"]["expected"]["threshold_J_c"], rel=2e-3)
        full = required_inertia(upsetter_cycle(), kloss_motor(), 0.08, 10.0)
        assert found.inertia == pytest.approx(full.inertia, rel=1e-8)

    @pytest.mark.slow
    def test_coarse_demand_near_the_stall(self) -> None:
        """delta = 0.9 is met just above the stall, far below what forces of position would ask."""
        found = required_inertia(upsetter_cycle(), kloss_motor(), 0.9, 1.0)
        assert found.delta == pytest.approx(0.9, rel=1e-8)
        assert 3.265 < found.inertia < 5

    def test_overload(self) -> None:
        cycle = upsetter_cycle()
        with pytest.raises(NoSolutionError, match="mean resisting moment"):
            required_inertia(replace(cycle, moment=4 * cycle.moment), kloss_motor(), 0.08, 10.0)

    def test_no_regulation(self) -> None:
        with pytest.raises(NoSolutionError, match="does not regulate itself"):
            required_inertia(upsetter_cycle(), ConstantMoment(95.0), 0.08, 10.0)

    @pytest.mark.parametrize("delta", [0.0, 1.5])
    def test_refused(self, delta: float) -> None:
        with pytest.raises(UsageError):
            required_inertia(upsetter_cycle(), parabola_motor(), delta, 10.0)

    def test_corrections_approach_from_above(self) -> None:
        model = fluctuation(upsetter_cycle(), parabola_motor())
        history = corrections(model, 0.08, 10.6, limit=8, tolerance=0.0)
        found = required_inertia(upsetter_cycle(), parabola_motor(), 0.08, 10.6)
        inertias = [trial.inertia for trial in history]
        assert inertias == sorted(inertias)
        assert all(trial.delta > 0.08 for trial in history)
        off = [(found.inertia - inertia) / found.inertia for inertia in inertias]
        assert off[-1] < 1e-4
        rates = [b / a for a, b in pairwise(off[2:])]
        assert rates[0] == pytest.approx(rates[-1], rel=0.1)  # linear convergence


class TestLag:
    """Small load M1 sin theta, a steep straight motor M = b (w_c - w) that lags by tau.

    In the small, amplitude = M1 |1 + i tau w| / |b - J tau w^2 + i J w|, largest at J = b tau / (1 + (tau w)^2).
    """

    b, tau, load = 150.0, 0.4, 12.0
    motor = straight(150.0, NOMINAL, NOMINAL + 1.0)

    def inertias(self, delta: float) -> tuple[float, float]:
        w = NOMINAL
        target = (2 * self.load * abs(1 + 1j * self.tau * w) / (delta * w)) ** 2
        # |b - J tau w^2 + i J w|^2 = target is a quadratic for J
        roots = np.roots([self.tau**2 * w**4 + w**2, -2 * self.b * self.tau * w**2, self.b**2 - target])
        return float(min(roots.real)), float(max(roots.real))

    def cycle(self) -> Cycle:
        return from_harmonics(-150.0, [(1, 0.0, self.load)], NOMINAL)

    def test_beyond_the_resonance(self) -> None:
        found = required_inertia(self.cycle(), self.motor, 0.08, 2.5, self.tau)
        assert found.inertia == pytest.approx(self.inertias(0.08)[1], rel=0.01)
        assert found.monotone is False
        assert any("more inertia is not always better" in remark for remark in found.remarks)

    def test_before_the_resonance(self) -> None:
        """Little inertia follows the motor: nothing is needed, though more would be too much."""
        low, high = self.inertias(0.08)
        assert 0 < low < 2.5 < high
        found = required_inertia(self.cycle(), self.motor, 0.08, 0.5 * low, self.tau)
        assert not found.needed
        assert required_inertia(self.cycle(), self.motor, 0.08, 1.2 * low, self.tau).needed

    def test_lag_asks_for_more(self) -> None:
        still = required_inertia(upsetter_cycle(), kloss_motor(), 0.08, 10.0)
        lagging = required_inertia(upsetter_cycle(), kloss_motor(), 0.08, 10.0, 0.05)
        assert lagging.inertia > still.inertia
        assert lagging.delta == pytest.approx(0.08, rel=1e-9)


class TestComparison:
    def test_beside_the_true_one(self) -> None:
        table = compared(upsetter_cycle(), 10.6, 0.08, characteristic=parabola_motor())
        assert table.required is not None
        names = [row.positional.method for row in table.rows]
        assert names == ["exact", "book", "mertsalov", "artobolevsky", "excess work"]
        for row in table.rows:
            assert row.delta is not None
            assert row.error is not None
            total = 10.6 + row.positional.addition
            assert row.error == pytest.approx(total / table.required.inertia - 1)
            # forces of position ask for more than the motor needs, so the machine runs steadier than asked
            assert row.delta < 0.08
            assert row.error > 0

    def test_without_a_motor(self) -> None:
        table = compared(upsetter_cycle(), 10.6, 0.08)
        assert table.required is None
        assert all(row.delta is None and row.error is None for row in table.rows)
        assert table.rows[0].positional == positional_flywheels(upsetter_cycle(), 10.6, 0.08)[0]

    def test_method_that_stalls(self) -> None:
        """A demand so coarse that no method asks for inertia, on a machine that stalls without any."""
        table = compared(upsetter_cycle(), 2.9, 0.95, characteristic=kloss_motor())
        assert table.required is not None
        assert table.required.needed
        assert any(row.delta is None or row.delta > 0.95 for row in table.rows) == any(
            row.error < 0 for row in table.rows
        )


@pytest.mark.slow
def test_an_inertia_that_vanishes_at_a_dead_centre_bounds_no_speed() -> None:
    """J = 40 sin^2, but for rounding, and no more: no motion exists to be tried, so the search begins above."""
    base = upsetter_cycle()
    x = base.panels.x
    cycle = replace(base, inertia=4 * np.sin(x) ** 2 - 1e-14, slope=4 * np.sin(2 * x))
    assert fluctuation(cycle, parabola_motor())(0.0) is None
    found = required_inertia(cycle, parabola_motor(), 0.08, 0.0)
    motion = driven(cycle, found.inertia, parabola_motor())
    assert motion.delta == pytest.approx(0.08, rel=1e-8)


class TestSurelyUneven:
    """What is ruled out by energy alone, against the motions themselves."""

    @sparing("motor", [parabola_motor(), kloss_motor(), straight_motor()], every=3)
    @pytest.mark.parametrize("delta", [0.02, 0.08, 0.3])
    def test_no_motion_that_is_even_enough_is_ruled_out(self, motor: Kloss, delta: float) -> None:
        cycle, ruled_out = upsetter_cycle(), 0
        model = fluctuation(cycle, motor)
        for inertia in (0.0, 1.0, 3.0, 5.0, 8.0, 12.0, 20.0, 40.0):
            if surely_uneven(cycle, motor, inertia, delta):
                reached = model(inertia)
                assert reached is None or reached > delta
                ruled_out += 1
        assert ruled_out > 0 or delta > 0.1 or not isinstance(motor, Kloss)  # a line gives any moment, slow enough
        assert not surely_uneven(cycle, motor, required_inertia(cycle, motor, delta, 0.0).inertia, delta)

    def test_nothing_is_sure_where_loads_drive(self) -> None:
        cycle = upsetter_cycle()
        assert surely_uneven(cycle, kloss_motor(), 1.0, 0.02)
        driven_by_loads = replace(cycle, moment=-cycle.moment)
        assert not surely_uneven(driven_by_loads, kloss_motor(), 1.0, 0.02)
        assert not surely_uneven(replace(cycle, viscous=cycle.viscous + 0.1), kloss_motor(), 1.0, 0.02)
        assert not surely_uneven(cycle, ConstantMoment(100.0), 1.0, 0.02)

    @sparing("lag", [0.0, 0.02], every=2)
    def test_the_flywheel_is_the_same(self, lag: float) -> None:
        for at_hand in (0.0, 2.0, 10.6):
            told, short = (
                required_inertia(upsetter_cycle(), kloss_motor(), 0.08, at_hand, lag, remarked=remarked)
                for remarked in (True, False)
            )
            assert short.inertia == pytest.approx(told.inertia, rel=1e-9)
            assert short.remarks == ()
