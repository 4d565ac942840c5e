"""The recurrence term by term: the table of the textbook's shaper, rows by hand, the fixed point of the formula."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from linkage.forces.worked import CASES

import tmmcalc
from tmmcalc.machine.stepwise import idle_run_of, run_of
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run

CONFIGS = Path(__file__).parents[2] / "configs"
BARE = (  # dyn-shaper-motion-idle: links 2 and 4 without mass, no weights, 250 kg*m^2 that turn with the crank
    "mechanism.gravity=0",
    "mechanism.links[id=4].mass=0",
    "mechanism.links[id=4].inertia=0",
    "mechanism.joints[name=A3].friction=0",
    "mechanism.joints[name=D0].friction=0",
    "motor.inertia=0",
    "motion.inertia=64",
)


def columns(scene: RunResult) -> dict[str, np.ndarray]:
    found = scene.outcomes["motion"].stage.part("further")(scene.spec, scene.results)
    assert len({column.name for column in found}) == len(found)
    return {column.name: np.asarray(column.make()) for column in found}


@pytest.fixture(scope="module")
def bare() -> RunResult:
    return run(tmmcalc.load_spec(CONFIGS / "shaper.toml", BARE), target="motion")


@pytest.fixture(scope="module")
def shaper() -> RunResult:
    return run(tmmcalc.load_spec(CONFIGS / "shaper.toml"), target="motion")


def test_the_table_of_the_textbook(bare: RunResult) -> None:
    """Table D.2.3: moments and inertia at the nodes, the idle speeds of both turns and those that come back."""
    found, expected = columns(bare), CASES["dyn-shaper-motion-idle"]["expected"]
    reduced = CASES["dyn-shaper-reduced"]["expected"]
    np.testing.assert_allclose(found["step_M"], reduced["M_Q_Nm"], rtol=1e-5)
    np.testing.assert_allclose(found["step_J"] - 250, reduced["J_var_kgm2"], atol=1e-4)
    np.testing.assert_allclose(found["omega_idle_turn_1"], expected["omega_first_rev_from_omega_N"], atol=1e-5)
    np.testing.assert_allclose(found["omega_idle_turn_2"], expected["omega_second_rev"], atol=1e-5)
    np.testing.assert_allclose(found["omega_idle_textbook"], expected["omega_periodic_n24"], atol=2e-6)
    details = bare.outcomes["motion"].stage.part("details")(bare.spec, bare.results)
    assert [*details] == ["recurrence", "recurrence_idle", "flywheel_existing"]
    assert details["recurrence_idle"].delta == pytest.approx(expected["delta_n24"], rel=1e-5)
    assert details["recurrence"].damping == pytest.approx(expected["B"] * np.radians(15), rel=1e-6)
    assert details["recurrence"].driving == pytest.approx(2 * expected["A"] * np.radians(15), rel=1e-6)


def test_rows_by_hand(shaper: RunResult) -> None:
    """Every row from the one before it by (3.57), A and B out of the nameplate, moments of the reduction."""
    found, reduction = columns(shaper), shaper.results["reduction"]
    nominal, synchronous = (2 * np.pi * rpm / 60 / (1500 / 55) for rpm in (1450, 1500))
    b = 7500 / nominal / (synchronous**2 - nominal**2)
    a, h = b * synchronous**2, np.radians(15)
    inertia = reduction.inertia + 0.028 * (1500 / 55) ** 2 + 43.2 + 186
    speeds = shaper.results["motion"].textbook.regime.omega
    inside = [k for k in range(25) if k not in (0, 24)]  # at both ends a node stands for its neighbour, too
    np.testing.assert_allclose(found["step_M"][inside], reduction.total[inside], rtol=1e-12)
    for i in range(1, 25):
        kept = (inertia[i - 1] - b * h) * speeds[i - 1] ** 2
        gained = (found["step_M"][i - 1] + found["step_M"][i] + 2 * a) * h
        divisor = inertia[i] + b * h
        assert found["step_kept"][i] == pytest.approx(kept, rel=1e-11)
        assert found["step_gained"][i] == pytest.approx(gained, rel=1e-11)
        assert found["step_divisor"][i] == pytest.approx(divisor, rel=1e-12)
        assert found["step_omega2"][i] == pytest.approx((kept + gained) / divisor, rel=1e-12)
        assert found["step_factor"][i] == pytest.approx((inertia[i - 1] - b * h) / divisor, rel=1e-11)
    assert all(np.isnan(found[name][0]) for name in ("step_kept", "step_gained", "step_divisor", "step_factor"))
    run = run_of(shaper.results["motion"], reduction)
    assert run is not None
    assert run.told().multiplier == pytest.approx(np.prod(found["step_factor"][1:]), rel=1e-9)
    assert run.told().start == pytest.approx(speeds[-1], rel=1e-13)


def test_turns_follow_one_another(shaper: RunResult) -> None:
    found, motion = columns(shaper), shaper.results["motion"]
    turns = [found[f"omega_turn_{k + 1}"] for k in range(len(motion.textbook.turns))]
    assert turns[0][0] == pytest.approx(1450 / 1500 * 2 * np.pi * 55 / 60, rel=1e-12)  # the rated speed
    for before, after in pairwise(turns):
        assert after[0] == pytest.approx(before[-1], rel=1e-13)
    np.testing.assert_allclose(turns[-1], motion.textbook.regime.omega, atol=1e-4)


def test_none_where_the_recurrence_is_not_done() -> None:
    scene = run(tmmcalc.load_spec(CONFIGS / "press.toml"), target="motion")
    assert columns(scene) == {}
    assert idle_run_of(scene.results["motion"], scene.results["reduction"]) is None
    assert scene.outcomes["motion"].stage.part("details")(scene.spec, scene.results) == {}
