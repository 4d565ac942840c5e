"""Stall: where the machine stops, the least inertia that carries it, and what is said."""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sparing import sparing

from machine.motion import CASES, TURN, Kloss, Lossy, of_pieces, upsetter, upsetter_functions, upsetter_motor
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.collocation import Orbit
from tmmcalc.machine import settling
from tmmcalc.machine.onemass import OneMass
from tmmcalc.machine.settling import Halt, directly, followed
from tmmcalc.machine.stall import stall_inertia
from tmmcalc.machine.steady import driven

KLOSS = upsetter_motor("kloss")
CASE = CASES["dyn-upsetter-stall"]


def passes(constant: float, turns: int = 12) -> tuple[bool, float]:
    """Whether the upsetter runs on from synchronous speed, by scipy in time; and the angle where it stops."""

    def rhs(_: float, y: np.ndarray) -> list[float]:
        variable, slope, _ = upsetter_functions(1.0)(y[0] % TURN)
        load = upsetter_functions(1.0)(y[0] % TURN)[2]
        return [y[1], (KLOSS.moment(y[1]) + load - y[1] ** 2 * slope / 2) / (variable + constant)]

    def stopped(_: float, y: np.ndarray) -> float:
        return y[1] - 1e-3

    stopped.terminal = True
    found = solve_ivp(
        rhs, (0, 0.6 * turns), [0, KLOSS.synchronous], rtol=1e-9, atol=1e-10, events=stopped, max_step=0.02
    )
    return not len(found.t_events[0]), float(found.y[0, -1])


def test_stall_case() -> None:
    for constant, status, least in zip(
        CASE["inputs"]["J_c_list"], CASE["expected"]["status"], CASE["expected"]["omega_min"], strict=True
    ):
        if status == "periodic":
            assert driven(upsetter(), constant, KLOSS).omega_min == pytest.approx(least, rel=1e-4)
        else:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                with pytest.raises(NoSolutionError, match="stalls"):
                    driven(upsetter(), constant, KLOSS)


@pytest.mark.slow
def test_threshold_case() -> None:
    threshold = stall_inertia(upsetter(), KLOSS)
    assert threshold == pytest.approx(CASE["expected"]["threshold_J_c"], abs=2e-4)
    assert passes(threshold * 1.0005)[0]
    assert not passes(threshold * 0.9995)[0]
    assert driven(upsetter(), threshold * 1.0001, KLOSS).delta > 1.8


@sparing("constant", [2.0, 3.0], every=2)
def test_where_it_stops_and_what_would_do(constant: float) -> None:
    with pytest.raises(NoSolutionError) as caught:
        driven(upsetter(), constant, KLOSS)
    runs, angle = passes(constant)
    assert not runs
    assert f"{math.degrees(angle):.4g}"[:3] in caught.value.message
    assert caught.value.value == constant
    assert caught.value.limit == pytest.approx(CASE["expected"]["threshold_J_c"], rel=2e-3)
    assert caught.value.limit > CASE["expected"]["threshold_J_c"] - 2e-4  # at least enough
    halt = followed(OneMass(upsetter(), constant, KLOSS))
    assert isinstance(halt, Halt)
    assert halt.theta == pytest.approx(angle, abs=1e-3)
    assert halt.turn == 1


@pytest.mark.slow
def test_a_machine_that_stops_in_a_later_cycle() -> None:
    """Just below the threshold the first cycle from the no-load speed is not the last."""
    load, motor = of_pieces([-700.0, 0.0], [0.0, 1.0, TURN]), Kloss(10.7, 10.0, 8.0, pull_out=160.0, slip=0.25)
    threshold = stall_inertia(load, motor)
    machine = OneMass(load, threshold * 0.98, motor)
    halt = directly(machine) or followed(machine)
    assert isinstance(halt, Halt)
    assert halt.stall
    assert 0 < halt.theta <= 1.001
    assert isinstance(directly(OneMass(load, threshold * 1.001, motor)), Orbit)


@pytest.mark.slow
def test_many_cycles_to_a_stop_are_followed_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Just below the threshold the machine creeps on; a cycle solved from the last one is that of panel after panel."""
    load, motor = of_pieces([-290.0, 0.0], [0.0, TURN / 2, TURN]), Kloss(10.7, 10.0, 8.0, pull_out=160.0, slip=0.25)
    machine = OneMass(load, 12.8, motor)  # 13.142 kg*m^2 carry it
    alone: list[int] = []
    piecewise = settling._turn

    def counted(machine: OneMass, y: np.ndarray, turn: int) -> Any:
        alone.append(turn)
        return piecewise(machine, y, turn)

    monkeypatch.setattr(settling, "_turn", counted)
    halt = followed(machine)
    assert isinstance(halt, Halt)
    assert halt.turn > 8
    assert len(alone) <= 5
    assert (alone[0], alone[-1]) == (1, halt.turn)
    first = len(alone)
    monkeypatch.setattr(settling, "_again", lambda *_: None)
    slowly = followed(machine)
    assert isinstance(slowly, Halt)
    assert alone[first:] == list(range(1, slowly.turn + 1))
    assert (slowly.stall, slowly.turn) == (halt.stall, halt.turn)
    assert slowly.theta == pytest.approx(halt.theta, rel=1e-6)


@sparing(("sense", "told"), [(1.0, "stalls at 6"), (-1.0, "stalls at -6")], every=2)
def test_the_angle_is_the_coordinate_of_the_input(sense: float, told: str) -> None:
    load, motor = (
        of_pieces([0.0, -700.0, 0.0], [0.0, 1.0, 2.0, TURN]),
        Kloss(10.7, 10.0, 8.0, pull_out=160.0, slip=0.25),
    )
    with pytest.raises(NoSolutionError, match=told) as caught:
        driven(load, 0.5, motor, sense=sense)
    degrees = float(caught.value.message.split(" deg")[0].split()[-1])
    halt = followed(OneMass(load, 0.5, motor))
    assert isinstance(halt, Halt)
    assert 1.0 < halt.theta < 2.0
    assert degrees == pytest.approx(sense * math.degrees(halt.theta), rel=1e-5)


@pytest.mark.parametrize("constant", [3.3, 4.0, 30.6, 1e3])
def test_following_the_motion_ends_in_the_same_regime(constant: float) -> None:
    machine = OneMass(upsetter(), constant, KLOSS)
    direct, along = directly(machine), followed(machine)
    assert isinstance(direct, Orbit)
    assert isinstance(along, Orbit)
    x = np.linspace(0, TURN, 50)
    speeds = [orbit.panels.at(machine.speed(orbit.panels, orbit.y[0]), x) for orbit in (direct, along)]
    np.testing.assert_allclose(speeds[0], speeds[1], rtol=1e-12)


@pytest.mark.slow
def test_a_lagging_motor_needs_more() -> None:
    static = stall_inertia(upsetter(), KLOSS, tolerance=1e-4)
    lagging = stall_inertia(upsetter(), KLOSS, time_constant=0.02, tolerance=1e-4)
    assert lagging > static * 1.02
    with pytest.raises(NoSolutionError, match="stalls"):
        driven(upsetter(), static, KLOSS, time_constant=0.02)


def test_losses_of_the_gearing_count() -> None:
    lossy = Lossy(KLOSS.synchronous, KLOSS.nominal, KLOSS.critical, base=KLOSS, efficiency=0.9)
    assert stall_inertia(upsetter(), lossy, tolerance=1e-4) > 3.4


def test_no_inertia_needed() -> None:
    assert stall_inertia(upsetter(0.1), KLOSS, tolerance=1e-3) == 0.0


def test_none_helps() -> None:
    with pytest.raises(NoSolutionError, match="whatever its inertia"):
        stall_inertia(upsetter(7.0), KLOSS)


def test_what_is_said_without_a_remedy_in_inertia() -> None:
    """A constant load beyond the break-down moment stops the machine; the mean load tells it before any motion."""

    class Weak(Kloss):
        def moment(self, omega: Any) -> Any:
            return super().moment(omega) * 0.5

        def slope(self, omega: Any) -> Any:
            return super().slope(omega) * 0.5

    with pytest.raises(NoSolutionError, match="largest moment of the motor, 121"):
        driven(of_pieces([-125.0], [0.0, TURN]), 10.0, Weak(10.714, 10.0, 7.74, pull_out=242.0, slip=0.2773))
