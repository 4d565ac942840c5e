"""The textbook's motion without a motor: by hand, against the exact one, and where it is not done."""

from __future__ import annotations

import math

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.machine.byenergy import by_energy
from tmmcalc.machine.diagram import from_formula, from_inertia
from tmmcalc.machine.diagram.superposition import combined
from tmmcalc.machine.facts.motion import summary
from tmmcalc.machine.positional import positional
from tmmcalc.project import load_spec, parse_spec, templates

TURN = 2 * math.pi
SCENES = ["press", "four-stroke-engine"]


@pytest.mark.parametrize("name", SCENES)
def test_by_hand_from_the_table_of_positions(name: str) -> None:
    """Trapezoids of the column M_red, T0 = J(0) w_m^2/2, w = sqrt(2 T/J), node by node."""
    found = tmmcalc.run(load_spec(templates.folder() / f"{name}.toml")).results
    reduction, motion = found["reduction"], found["motion"]
    book = motion.by_energy
    theta, moment = np.abs(reduction.phi), reduction.total * np.sign(reduction.speed)
    moment[[0, -1]] = max(moment[[0, -1]], key=abs)  # where the load jumps the larger one counts
    near = 5e-5  # within the cycle friction jumps, of which the table has the value after it
    drive = -sum((moment[i] + moment[i + 1]) / 2 * (theta[i + 1] - theta[i]) for i in range(len(theta) - 1)) / theta[-1]
    work = [0.0]
    for i in range(len(theta) - 1):
        work.append(work[-1] + ((moment[i] + moment[i + 1]) / 2 + drive) * (theta[i + 1] - theta[i]))
    inertia = reduction.inertia + motion.inertia.total
    first = inertia[0] * motion.regime.mean**2 / 2
    omega = np.sqrt(2 * (first + np.array(work)) / inertia)
    assert book.energy == pytest.approx(first, rel=1e-12)
    assert motion.omega_textbook == pytest.approx(omega, rel=near)
    assert motion.omega_textbook[0] == pytest.approx(motion.regime.mean, rel=1e-12)
    assert book.delta == pytest.approx(2 * np.ptp(omega) / (omega.max() + omega.min()), rel=100 * near)
    told = {key: value for fact in summary(motion, "").facts for key, value in fact.values.items()}
    assert told["delta_textbook"] == book.delta
    assert told["omega_textbook_error"] == np.max(np.abs(motion.omega_textbook - motion.omega)) / np.mean(motion.omega)


def machine() -> tuple[object, float]:
    at = np.arange(16) * TURN / 16
    inertia = from_inertia(at, 3 + np.cos(at) + 0.3 * np.sin(2 * at), speed=10)
    return combined([(from_formula("60*sin(theta) + 25*cos(2*theta)", 10), 0.0), (inertia, 0.0)]), 2.0


def test_with_the_right_energy_it_is_of_second_order_or_better() -> None:
    """Of a smooth periodic moment the sum of a whole cycle is exact, and that of a part of second order."""
    cycle, constant = machine()
    exact = positional(cycle, constant, 10.0)
    off = []
    for n in (24, 48, 96):
        found = by_energy(cycle, constant, 10.0, n, corrected=True)
        assert found.mean == pytest.approx(10.0, rel=1e-12)
        wanted = exact.omega_at(np.linspace(0, TURN, n + 1))
        off.append(float(np.max(np.abs(found.omega - wanted))))
    assert 3 < off[0] / off[1] < 6
    assert off[2] < 5e-3


def test_the_first_approximation_stays_off_however_many_nodes_there_are() -> None:
    """Its error is that of the mean: T0 exact minus T0 by the mean speed at position 0."""
    cycle, constant = machine()
    exact = positional(cycle, constant, 10.0)
    begins = float(exact.omega_at(np.zeros(1))[0])
    for n in (96, 768):
        found = by_energy(cycle, constant, 10.0, n)
        assert found.omega[0] - begins == pytest.approx(10.0 - begins, rel=1e-12)
        wanted = np.sqrt(
            exact.omega_at(np.linspace(0, TURN, n + 1)) ** 2 + (100 - begins**2) * _start(cycle) / _all(cycle, n)
        )
        assert found.omega == pytest.approx(wanted, rel=3e-3 if n == 96 else 5e-5)


def _start(cycle: object) -> float:
    return float(cycle.panels.at(cycle.inertia, np.zeros(1))[0]) + 2.0


def _all(cycle: object, n: int) -> np.ndarray:
    return cycle.panels.at(cycle.inertia, np.linspace(0, TURN, n + 1)) + 2.0


def test_an_energy_that_does_not_last() -> None:
    cycle = from_formula("-80*sin(theta)", 5)
    with pytest.raises(NoSolutionError, match=r"kinetic energy is -101.7 J at node 4: it does not last for the cycle"):
        by_energy(cycle, 4.0, 5.0, 8)


@pytest.mark.parametrize(("grid", "done"), [("positions = 24", True), ("positions = 24\nextra = ['7 deg']", False)])
def test_it_takes_equal_steps(grid: str, done: bool) -> None:
    text = (templates.folder() / "press.toml").read_text(encoding="utf-8").replace("positions = 12", grid)
    motion = tmmcalc.run(parse_spec(text)).results["motion"]
    assert (motion.by_energy is not None) == done
    (fact,) = (fact for fact in summary(motion, "").facts if fact.label == "textbook (3.48)")
    assert fact.text.startswith("T0 = J(0) omega_m^2/2" if done else "not done: it takes equal steps")


def test_a_motor_has_the_recurrence_and_loads_alone_have_neither() -> None:
    motion = tmmcalc.run(load_spec(templates.folder() / "shaper.toml")).results["motion"]
    assert motion.by_energy is None
    assert motion.textbook is not None
