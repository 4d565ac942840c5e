"""Studies of vibrations and other motions in time: orders of the methods beside closed forms and finer ones."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from tmmcalc.core.studies.extrapolation import extrapolated
from tmmcalc.core.studies.timed import Run, Start, stepped

from .scenes import ONCE, errors_in, errors_of, series_of, study_of

NEAR = 100.0  # times the tolerance of a step: what a method may leave in all


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
    study = study_of("extra-ball", "falling_ball")
    assert study.reference.error < 1e-15
    assert max(errors_of(study, "closed")) < 1e-14
    assert series_of(study, "merson").order == pytest.approx(4.0, abs=0.1)
    for name in ("RK45", "DOP853", "LSODA", "Radau", "BDF"):
        found = series_of(study, name)
        for point in found.points:
            assert point.error is not None
            assert point.error < NEAR * point.size, (name, point.setting)
        falls = [former / later for former, later in pairwise(errors_in(found))]
        assert min(falls) > 10, f"{name}: a hundredth of the tolerance"
        assert series_of(study, name).order is None, "a tolerance is no step"


@pytest.mark.slow
def test_start_of_the_vibratory_device() -> None:
    study = study_of("vibratory-device", "vibrator")
    assert study.reference.error < 1e-11
    assert max(errors_of(study, "exact")) < 1e-11
    assert series_of(study, "merson").order == pytest.approx(4.0, abs=0.1)
    assert errors_of(study, "DOP853")[-1] < 1e-7


@pytest.mark.slow
def test_whirl_by_elements() -> None:
    study = study_of("pendulum-rotor", "pendulum")
    assert study.reference.error < 1e-11
    assert series_of(study, "Hermite").order == pytest.approx(4.0, abs=0.2)
    assert series_of(study, "quintics").order == pytest.approx(8.0, abs=0.5)
    one = errors_of(study, "one element")
    assert one[-1] < 1e-11 < 1e-4 < one[1], "beyond every order"


@pytest.mark.parametrize("law", ["cosine", "sine"])
def test_vibration_of_an_elastic_train(law: str) -> None:
    laws = (f'cam.rise_law="{law}"', f'cam.return_law="{law}"')
    study = study_of("cam-translating", "cam_elastic", *laws)
    assert max(errors_of(study, "exact")) < 1e-13
    for name in ("harmonics", "trapezoid"):
        assert series_of(study, name).order == pytest.approx(2.0, abs=0.2), name
        assert errors_of(study, name)[-1] < 1e-2


@pytest.mark.slow
def test_contact_on_finer_grids() -> None:
    study = study_of("extra-contact", "contact")
    assert max(errors_of(study, "Hertz")) < 1e-13
    grid = errors_of(study, "boundary")
    assert grid[-1] < 0.2 * grid[0]
    never = study.series[1].cheapest(1e-6)
    assert never is None
