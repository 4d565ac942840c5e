"""The search for the least inertia and the textbook's correction (3.60), on models that are known."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from machine.flywheel.scenes import CASES, TURN, parabola, upsetter
from tmmcalc.core.errors import AccuracyError, NoSolutionError
from tmmcalc.machine.flywheel.results import Trial
from tmmcalc.machine.flywheel.search import corrections, least_inertia, tried


def recurrence(inertia: float, n: int = 24) -> float:
    """delta over the nodes by the textbook's recurrence (3.57), periodic by the affine map; written from the book."""
    phi = np.linspace(0, TURN, n + 1)
    links, moment = upsetter(phi)
    total, step = links + inertia, TURN / n
    a, b = parabola()
    shares = np.array([(total[i] - b * step) / (total[i + 1] + b * step) for i in range(n)])
    gains = np.array([(moment[i] + moment[i + 1] + 2 * a) * step / (total[i + 1] + b * step) for i in range(n)])

    def march(y: float) -> list[float]:
        values = [y]
        for share, gain in zip(shares, gains, strict=True):
            values.append(share * values[-1] + gain)
        return values

    rest = march(0.0)[-1]
    omega = np.sqrt(march(rest / (1 - (march(1.0)[-1] - rest)))[:n])
    return float(2 * (omega.max() - omega.min()) / (omega.max() + omega.min()))


def solve(model: Callable[[float], float | None], delta: float, low: float, start: float) -> tuple[Trial, list[Trial]]:
    trials: list[Trial] = []
    first = tried(model, low, trials)
    return least_inertia(model, delta, first, tried(model, start, trials), trials), trials


class TestUpsetter:
    """Case dyn-upsetter-flywheel-motor."""

    case = CASES["dyn-upsetter-flywheel-motor"]["expected"]

    def test_history_of_corrections(self) -> None:
        history = corrections(recurrence, 0.08, 10.6, tolerance=0.0)
        assert len(history) == len(self.case["iteration_Jc_delta"]) == 12
        for trial, (inertia, delta) in zip(history, self.case["iteration_Jc_delta"], strict=True):
            assert trial.inertia == pytest.approx(inertia, abs=6e-6)
            assert trial.delta == pytest.approx(delta, abs=6e-8)

    def test_corrections_stop_within_the_tolerance(self) -> None:
        history = corrections(recurrence, 0.08, 10.6, tolerance=1e-3)
        assert len(history) == 5
        assert history[-1].delta == pytest.approx(0.08, rel=1e-3)

    def test_root(self) -> None:
        root, trials = solve(recurrence, 0.08, 10.6, 45.0)
        assert root.inertia == pytest.approx(self.case["J_const_exact_root"], abs=6e-6)
        assert len(trials) <= 6


class TestModels:
    @pytest.mark.parametrize("start", [1.1, 3.0, 9.0, 300.0])
    def test_one_harmonic_takes_one_step(self, start: float) -> None:
        """delta^2 = 1/(a + b J^2) is the straight line of the search."""

        def model(inertia: float) -> float:
            return 1 / math.sqrt(4 + 0.5 * inertia**2)

        root, trials = solve(model, 0.1, 1.0, start)
        assert root.inertia == pytest.approx(math.sqrt((100 - 4) / 0.5), rel=1e-9)
        assert len(trials) <= 4

    def test_no_motor_at_all(self) -> None:
        root, _ = solve(lambda inertia: 2 / inertia, 0.1, 1.0, 2.0)
        assert root.inertia == pytest.approx(20, rel=1e-9)

    def test_stall_below(self) -> None:
        root, _ = solve(lambda inertia: None if inertia < 7 else 5 / (inertia - 6), 0.5, 0.0, 3.0)
        assert root.inertia == pytest.approx(16, rel=1e-9)

    def test_stall_up_to_the_root(self) -> None:
        """The machine runs smoothly as soon as it runs: the edge of the stall is the answer."""
        root, _ = solve(lambda inertia: None if inertia < 7 else 0.01, 0.5, 1.0, 20.0)
        assert root.inertia == pytest.approx(7, rel=1e-9)
        assert root.delta == 0.01

    def test_bent_model(self) -> None:
        root, trials = solve(lambda inertia: math.exp(-((inertia / 10) ** 3)), 1e-3, 0.5, 1.0)
        assert root.inertia == pytest.approx(10 * math.log(1e3) ** (1 / 3), rel=1e-9)
        assert len(trials) < 30

    def test_no_inertia_is_enough(self) -> None:
        with pytest.raises(NoSolutionError, match="no constant inertia"):
            solve(lambda inertia: 0.2 + 1 / inertia, 0.1, 1.0, 2.0)

    def test_jump(self) -> None:
        """delta jumps past the asked value: the least inertia that satisfies is at the jump."""
        root, _ = solve(lambda inertia: 0.2 if inertia < math.pi else 0.05, 0.1, 1.0, 8.0)
        assert root.inertia == pytest.approx(math.pi, rel=1e-9)

    def test_not_found(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr("tmmcalc.machine.flywheel.search.RUNS", 3)
        with pytest.raises(AccuracyError):
            solve(lambda inertia: 0.2 if inertia < math.pi else 0.05, 0.1, 1.0, 8.0)

    def test_corrections_need_a_running_machine(self) -> None:
        with pytest.raises(NoSolutionError, match="stalls with a constant inertia of 3"):
            corrections(lambda inertia: None, 0.1, 3.0)
