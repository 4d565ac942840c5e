"""Studies of vibrations and other motions in time: orders of the methods beside closed forms and finer ones."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tmmcalc import load_spec
from tmmcalc.accuracy.measure import Clock
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.accuracy.study import Series, Study
from tmmcalc.accuracy.timed import Run, Start, extrapolated, stepped

CONFIGS = Path(__file__).parents[2] / "configs"
ONCE = Clock(repeats=1, budget=0.0)


def _study(name: str, stage: str, *overrides: str) -> Study:
    (found,) = solve_accuracy(load_spec(CONFIGS / f"{name}.toml", overrides), stage, ONCE).studies
    return found


def _series(study: Study, name: str) -> Series:
    return next(series for series in study.series if series.method.startswith(name))


def _errors(series: Series) -> list[float]:
    return [point.error for point in series.points if point.error is not None]


def _turning(_: float, y: list[float]) -> list[float]:
    return [y[1], -y[0]]


def test_merson_is_of_fourth_order_and_the_reference_is_exact() -> None:
    """A harmonic motion, of which both are known."""
    instants = np.arange(1, 5) * 0.5
    exact = np.array([np.cos(instants), -np.sin(instants)])
    start = Start(_turning, np.array([1.0, 0.0]), instants, np.ones(2))

    def error(run: Run) -> float:
        return float(np.max(np.abs(run.states - exact)))

    steps = stepped(start, (8, 16, 32, 64, 128), error, ONCE)
    # with constant coefficients Merson's step is of the fifth order over a step and in all of the fourth
    assert steps.order == pytest.approx(4.0, abs=0.1)
    found = extrapolated(_turning, np.array([1.0, 0.0]), instants, 2)
    wide = instants.astype(np.longdouble)
    assert float(np.max(np.abs(found - np.array([np.cos(wide), -np.sin(wide)])))) < 3e-17


def test_fall_of_a_ball() -> None:
    study = _study("extra-ball", "falling_ball")
    assert study.reference.error < 1e-15
    assert max(_errors(_series(study, "closed"))) < 1e-14
    assert _series(study, "merson").order == pytest.approx(4.0, abs=0.1)
    for name in ("RK45", "DOP853", "LSODA", "Radau", "BDF"):
        errors = _errors(_series(study, name))
        assert errors[-1] < 1e-7 < errors[0] * 1e3, name
        assert _series(study, name).order is None, "a tolerance is no step"


@pytest.mark.slow
def test_start_of_the_vibratory_device() -> None:
    study = _study("vibratory-device", "vibrator")
    assert study.reference.error < 1e-11
    assert max(_errors(_series(study, "exact"))) < 1e-11
    assert _series(study, "merson").order == pytest.approx(4.0, abs=0.1)
    assert _errors(_series(study, "DOP853"))[-1] < 1e-7


@pytest.mark.slow
def test_whirl_by_elements() -> None:
    study = _study("pendulum-rotor", "pendulum")
    assert study.reference.error < 1e-11
    assert _series(study, "Hermite").order == pytest.approx(4.0, abs=0.2)
    assert _series(study, "quintics").order == pytest.approx(8.0, abs=0.5)
    one = _errors(_series(study, "one element"))
    assert one[-1] < 1e-11 < 1e-4 < one[1], "beyond every order"


@pytest.mark.parametrize("law", ["cosine", "sine"])
def test_vibration_of_an_elastic_train(law: str) -> None:
    laws = (f'cam.rise_law="{law}"', f'cam.return_law="{law}"')
    study = _study("cam-translating", "cam_elastic", *laws)
    assert max(_errors(_series(study, "exact"))) < 1e-13
    for name in ("harmonics", "trapezoid"):
        assert _series(study, name).order == pytest.approx(2.0, abs=0.2), name
        assert _errors(_series(study, name))[-1] < 1e-2


@pytest.mark.slow
def test_contact_on_finer_grids() -> None:
    study = _study("extra-contact", "contact")
    assert max(_errors(_series(study, "Hertz"))) < 1e-13
    grid = _errors(_series(study, "boundary"))
    assert grid[-1] < 0.2 * grid[0]
    never = study.series[1].cheapest(1e-6)
    assert never is None
