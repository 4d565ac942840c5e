"""The crank turned back: friction and quadratic resistances against independent solutions and integrations."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from machine.transient.scenes import constant, cycle, event, line, run
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.scenario import Brake, LoadStep, Scenario

METHODS = ["merson", "collocation", "LSODA"]
WEIGHT, RUB, J = 12.0, 1.5, 2.0


def rubbing(moment: float, friction: float, mass: float = J, **more: object) -> Drive:
    """A constant moment and a constant friction on a drum."""

    def back() -> tuple[Cycle, Cycle | None]:
        return cycle(moment + friction), None

    return Drive((Mass(mass),), cycle=cycle(moment - friction), back=back, **more)


@pytest.mark.parametrize("method", METHODS)
def test_a_weight_on_a_rubbing_drum_goes_up_and_down(method: str) -> None:
    """Up with -(G + F)/J, down with -(G - F)/J."""
    result = run(rubbing(-8.0, 2.0), Scenario("slip", 3.0, speed=5.0, standstill="pass"), method)
    back = event(result, "reversal")
    assert back.time == pytest.approx(1.0, abs=1e-8)
    assert back.angle == pytest.approx(2.5, abs=1e-8)
    assert result.omega[0, -1] == pytest.approx(-3.0 * 2.0, abs=1e-7)
    assert result.theta[0, -1] == pytest.approx(2.5 - 1.5 * 4.0, abs=1e-7)
    assert result.load_moment[-1] == pytest.approx(-6.0)
    assert result.imbalance < 1e-9
    assert [e.kind for e in result.events] == ["reversal"]


def test_friction_holds_what_it_can() -> None:
    held = run(rubbing(-8.0, 9.0), Scenario("held", 9.0, speed=5.0, standstill="pass"))
    assert held.end == "standstill"
    assert held.t[-1] == pytest.approx(5.0 * J / 17.0, abs=1e-9)
    assert next(e.kind for e in held.events) == "standstill"


def test_a_motor_must_overcome_friction_in_either_direction() -> None:
    """At 0.5 s the motor, 5 N*m backwards, pulls a crank loose that friction of 3 N*m holds."""
    drive = rubbing(0.0, 3.0, characteristic=constant(-5.0))
    result = run(drive, Scenario("plug", 2.0, standstill="pass", motor=((0.5, 1.5),)))
    assert np.all(result.omega[0, result.t <= 0.5] == 0.0)
    assert result.omega[0].min() == pytest.approx(-1.0, abs=1e-9)
    assert result.omega[0, -1] == pytest.approx(-1.0 + 0.5 * 3.0 / 2.0, abs=1e-9)
    weak = rubbing(0.0, 3.0, characteristic=constant(-2.0))
    assert run(weak, Scenario("plug", 2.0, standstill="pass")).end == "stall"


def pendulum(back: bool = True) -> Drive:
    def turned() -> tuple[Cycle, Cycle | None]:
        return cycle(lambda p: -WEIGHT * np.sin(p) + RUB * (1 + 0.3 * np.cos(p))), None

    forwards = cycle(lambda p: -WEIGHT * np.sin(p) - RUB * (1 + 0.3 * np.cos(p)), 0.2)
    return Drive((Mass(J),), cycle=forwards, back=_with(turned, 0.2) if back else None)


def _with(turned: object, inertia: float) -> object:
    def made() -> tuple[Cycle, Cycle | None]:
        one, _ = turned()
        return replace(one, inertia=one.inertia + inertia), None

    return made


def test_a_rubbing_pendulum_swings_out() -> None:
    """Every half swing loses the friction's work: WEIGHT (cos b - cos a) = RUB (|a - b| + 0.3 |sin a - sin b|)."""
    result = run(pendulum(), Scenario("swing", 30.0, speed=4.0, standstill="pass"), tolerance=1e-11)
    turns = [e.angle for e in result.events if e.kind == "reversal"]
    assert len(turns) >= 4
    for a, b in pairwise(turns):
        lost = RUB * (abs(a - b) + 0.3 * abs(math.sin(a) - math.sin(b)))
        assert WEIGHT * (math.cos(b) - math.cos(a)) == pytest.approx(lost, abs=1e-7)
    assert result.end == "standstill"
    rest = float(result.theta[0, -1])
    assert abs(WEIGHT * math.sin(rest)) <= RUB * (1 + 0.3 * math.cos(rest))
    assert result.imbalance < 1e-9


def test_quadratic_resistance_against_another_integration() -> None:
    """J w' = -G sin(theta) - 0.8 w |w| - 0.3 w, which scipy follows with the sign in the formula."""
    drive = Drive((Mass(J),), cycle=cycle(lambda p: -WEIGHT * np.sin(p), viscous=-0.3, quadratic=-0.8))
    times = np.linspace(0.2, 6.0, 30)
    result = run(drive, Scenario("swing", 6.0, speed=3.0, standstill="pass"), "merson", times, tolerance=1e-12)

    def f(_: float, y: np.ndarray) -> list[float]:
        return [y[1], (-WEIGHT * math.sin(y[0]) - 0.8 * y[1] * abs(y[1]) - 0.3 * y[1]) / J]

    truth = solve_ivp(f, (0, 6), [0.0, 3.0], t_eval=times, rtol=1e-12, atol=1e-13, max_step=0.02)
    rows = np.searchsorted(result.t, times)
    np.testing.assert_allclose(result.omega[0, rows], truth.y[1], atol=1e-8)
    np.testing.assert_allclose(result.theta[0, rows], truth.y[0], atol=1e-8)
    assert sum(e.kind == "reversal" for e in result.events) >= 3


def test_a_rubbing_crank_on_an_elastic_shaft_sticks_and_slips() -> None:
    """A held rotor, a shaft, a crank that rubs: it comes to rest where the shaft no longer overcomes the friction."""
    chain = Drive(
        (Mass(0.5), Mass(J)),
        (Shaft(200.0),),
        cycle=cycle(-6.0),
        back=lambda: (cycle(6.0), None),
    )
    result = run(chain, Scenario("stop", 3.0, speed=3.0, standstill="pass", brake=Brake(1e4, mass=0)))
    assert np.all(result.omega[0, result.t > 0.05] == 0.0)
    assert result.omega[1, -1] == 0.0
    assert abs(float(result.shaft_moment[0, -1])) <= 6.0
    # amplitude falls by 2 F/c every half swing
    turns = [e.angle for e in result.events if e.kind == "reversal"]
    base = float(result.theta[0, -1])
    sizes = [abs(angle - base) for angle in turns]
    assert len(sizes) >= 2
    np.testing.assert_allclose(-np.diff(sizes), 2 * 6.0 / 200.0, atol=1e-6)


def test_the_cycle_backwards_is_made_only_when_the_crank_may_turn_back() -> None:
    def never() -> tuple[Cycle, Cycle | None]:
        raise NoSolutionError("asked for", where="test")

    drive = replace(rubbing(-1.0, 1.0, characteristic=constant(20.0)), back=never)
    moving = Scenario("run", 1.0, speed=3.0, standstill="pass")
    assert run(drive, moving).omega[0, -1] == pytest.approx(3 + 18.0 / J)
    assert run(drive, Scenario("stop", 1.0)).omega[0, -1] == pytest.approx(18.0 / J)
    with pytest.raises(NoSolutionError, match="asked for"):
        run(drive, replace(moving, duration=9.0, motor=()))


def test_load_factors_count_backwards_too() -> None:
    """Half of the load's -8 with friction 1 + 1: up against 3 + 2, down with 3."""
    drive = Drive(
        (Mass(J),),
        cycle=cycle(-8.0 - 2.0),
        idle=cycle(-1.0),
        back=lambda: (cycle(-8.0 + 2.0), cycle(1.0)),
    )
    result = run(drive, Scenario("half", 3.0, speed=2.75, standstill="pass", load=(LoadStep(0.5),)))
    assert event(result, "reversal").time == pytest.approx(1.0, abs=1e-9)
    assert result.omega[0, -1] == pytest.approx(-2.5 / 2 * 2.0, abs=1e-8)
    assert any("friction at the load factor 0.5" in str(verdict) for verdict in result.verdicts)
    full = run(drive, Scenario("full", 0.1, speed=2.75, standstill="pass", load=(LoadStep(0.0), LoadStep(1.0, 0.05))))
    assert not any("friction at" in str(verdict) for verdict in full.verdicts)


def test_a_motor_overpowered_is_told() -> None:
    drive = Drive((Mass(J),), characteristic=line(2.0, 3.0), cycle=cycle(-10.0))
    result = run(drive, Scenario("hoist", 1.0, speed=1.0, standstill="pass"))
    assert "the load drives it against the 6 N*m of the motor" in result.verdicts[0].message
    assert result.verdicts[0].severity == "warning"
    off = run(drive, Scenario("hoist", 1.0, speed=1.0, standstill="pass", motor=()))
    assert [v.severity for v in off.verdicts if "turns back" in v.message] == ["note"]
