"""A cam that loads a shaft of the machine: against the forces stage, an integration by scipy, energies and limits."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from project.scenes import CONFIGS
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from cams.shaft_scene import LOADS, TURN, breaks, inertia, moment, results, spec_of
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.forces.state import carried, state
from tmmcalc.cams.forces.turn import at_angles
from tmmcalc.cams.tables.tasks.cam import to_cam
from tmmcalc.core.errors import UsageError
from tmmcalc.machine.attached import backwards, with_attached
from tmmcalc.pipeline.runner import run
from tmmcalc.project import parse_spec

RATIOS = [("1", ""), ("0.5", 'period = "720 deg"'), ("2", ""), ('"3/2"', 'period = "1440 deg"')]


def geared(ratio: str) -> str:
    return f'shaft = "crank"\nratio = {ratio}'


@pytest.mark.parametrize(("ratio", "torque"), RATIOS)
def test_its_torque_is_that_of_the_forces(ratio: str, torque: str) -> None:
    """At the mean speed the causes of the cam with the inertia are the driving torque times the ratio, everywhere."""
    spec = spec_of(geared(ratio), torque)
    found, task = results(spec, "reduction"), to_cam(spec)
    reduction, follower = found["reduction"], found["cam_synthesis"].follower
    forces = solve_forces(task, follower)
    assert task.loads is not None
    of = carried(task, follower, task.loads, forces.spring.stiffness, forces.spring.preload)
    on = reduction.cycle.panels
    phi = np.mod((on.x.ravel() - task.begin) * task.ratio, TURN)
    asked = state(of, at_angles(task, task.loads, phi)).driving.reshape(on.x.shape)
    own = sum(
        part
        for cause, part in zip(reduction.contributions, reduction.parts, strict=True)
        if cause.name.startswith("cam ")
    )
    given = own - reduction.cycle.slope * reduction.speed**2 / 2
    assert given == pytest.approx(-task.ratio * asked, abs=1e-9 * np.max(np.abs(asked)))
    turns = reduction.cycle.period * task.ratio / TURN
    works = {cause.name: cause.work for cause in reduction.contributions}
    assert works["cam friction"] == pytest.approx(-forces.work.friction * turns, rel=1e-9)
    assert works["cam force"] == pytest.approx(forces.work.force * turns, rel=1e-9)
    assert sum(work for name, work in works.items() if name.startswith("cam ")) == pytest.approx(
        -forces.work.driving * turns, rel=1e-9
    )


def test_without_a_force_it_takes_its_friction_alone() -> None:
    """Inertia, spring and weight give back over the cycle what they take."""
    loads = 'mass = "1.2 kg"\nfriction = 0.1\n[cam.spring]\nstiffness = "30 N/mm"\npreload = "300 N"'
    found = results(spec_of(loads=loads), "power")
    works = {part.name: part.work for part in found["power"].parts}
    forces = solve_forces(to_cam(spec_of(loads=loads)), found["cam_synthesis"].follower)
    assert works["cam friction"] == pytest.approx(-forces.work.friction, rel=1e-9)
    assert works["cam spring"] == pytest.approx(0, abs=1e-10 * forces.work.given)
    assert found["power"].losses == works["cam friction"]
    assert found["power"].mean_moment == pytest.approx(5 + forces.work.friction / TURN, rel=1e-12)


def energy_over(ratio: float, period: float, energy: float) -> list[tuple[float, float, Any]]:
    """Kinetic energy over the cycle from its value at the start: dE/dtheta = M + M_d(omega)."""

    def rate(theta: float, e: Any) -> list[float]:
        omega = np.sqrt(2 * e[0] / inertia(theta, ratio))
        return [moment(theta, ratio) + 60 - 0.5 * omega]

    parts = []
    for low, high in pairwise(breaks(ratio, period)):
        span = (low + 1e-13, high - 1e-13)
        solved = solve_ivp(rate, span, [energy], method="DOP853", rtol=1e-10, atol=1e-10, dense_output=True)
        energy = float(solved.y[0, -1])
        parts.append((low, high, solved.sol))
    return parts


@pytest.mark.parametrize(("ratio", "torque", "period"), [(1.0, "", TURN), (0.5, 'period = "720 deg"', 2 * TURN)])
def test_the_motion_is_that_of_an_independent_integration(ratio: float, torque: str, period: float) -> None:
    regime = results(spec_of(geared(str(ratio)), torque), "motion")["motion"].regime
    x, omega = regime.panels.x.ravel()[::7], regime.omega.ravel()[::7]

    def gap(energy: float) -> float:
        _, high, last = energy_over(ratio, period, energy)[-1]
        return float(last(high - 1e-13)[0]) - energy

    begin = brentq(gap, 50.0, 2000.0, xtol=1e-9)
    parts = energy_over(ratio, period, begin)
    energy = [next(float(sol(theta)[0]) for low, high, sol in parts if low <= theta <= high) for theta in x]
    expected = np.sqrt(2 * np.array(energy) / [inertia(theta, ratio) for theta in x])
    assert omega == pytest.approx(expected, rel=2e-9)


def test_reduced_inertia_is_that_of_the_follower() -> None:
    reduction = results(spec_of(geared("2")), "reduction")["reduction"]
    expected = [inertia(theta, 2.0) for theta in reduction.phi]
    assert reduction.inertia == pytest.approx(np.array(expected), rel=1e-12)
    spread = reduction.inertia_range
    assert spread[0].value == pytest.approx(0.05, rel=1e-9)
    assert max(expected) <= spread[1].value


def test_a_follower_without_mass_and_forces_changes_nothing() -> None:
    plain, loaded = (results(spec_of(cam, loads='force = "0 N"'), "motion") for cam in ("", 'shaft = "crank"'))
    before, after = plain["motion"].regime, loaded["motion"].regime
    assert "cam_load" not in plain
    assert loaded["reduction"].total.tolist() == pytest.approx(plain["reduction"].total.tolist(), rel=1e-13)
    theta = np.linspace(0.0, TURN, 50)
    assert after.panels.at(after.omega, theta) == pytest.approx(before.panels.at(before.omega, theta), rel=1e-10)


def test_without_the_key_the_machine_does_not_feel_the_cam() -> None:
    found = results(spec_of(""), "reduction")
    assert [cause.name for cause in found["reduction"].contributions] == ["torque"]
    assert "cam_synthesis" not in found


def test_a_crank_that_does_not_turn_fully_is_refused() -> None:
    text = (CONFIGS / "course-project.toml").read_text(encoding="utf-8")
    spec = parse_spec(text.replace("positions = 24 ", 'positions = 24\nspan = "90 deg" '))
    with pytest.raises(UsageError, match="does not turn fully"):
        run(spec, target="reduction")


@pytest.mark.parametrize("law", ["const", "cosine"])
def test_jumps_of_the_acceleration_stand_on_edges(law: str) -> None:
    found = results(spec_of(law=law), "reduction")["reduction"]
    assert found.cycle.error < 1e-10
    assert found.error.work < 1e-10


def test_a_cam_on_the_shaft_of_the_motor_turns_with_it() -> None:
    """A ratio of 1/3 behind gears of 3 is the crank's own speed."""
    crank = results(spec_of(gears=3), "reduction")["reduction"]
    motor = results(spec_of('shaft = "motor"\nratio = "1/3"', gears=3), "reduction")["reduction"]
    assert motor.total.tolist() == crank.total.tolist()
    assert motor.inertia.tolist() == crank.inertia.tolist()


def test_turned_back_its_friction_alone_turns_round() -> None:
    found = results(spec_of(), "reduction")
    reduction, attached = found["reduction"], found["cam_load"]
    back, _ = backwards(reduction.cycle, reduction.idle, (attached,))
    friction = next(cause for cause in attached.causes if cause.kind == "friction")
    on = reduction.cycle.panels
    change = attached.on(on, friction.back - friction.moment)
    assert back.moment == pytest.approx(reduction.cycle.moment + change, rel=1e-12)
    assert np.min(friction.back) >= 0 >= np.max(friction.moment)


def test_idle_is_without_its_force() -> None:
    found = results(spec_of(), "reduction")
    idle, own = found["reduction"].idle, found["cam_load"]
    loaded = {cause.name: cause for cause in own.causes}
    assert not np.any(loaded["cam force"].idle)
    assert np.max(np.abs(loaded["cam friction"].idle)) < np.max(np.abs(loaded["cam friction"].moment))
    assert idle.inertia == pytest.approx(found["reduction"].cycle.inertia)


@pytest.mark.parametrize(("ratio", "torque", "told"), [("0.5", 'period = "720 deg"', False), ("2", "", True)])
def test_a_cam_with_several_turns_in_a_cycle_says_so(ratio: str, torque: str, told: bool) -> None:
    forces = results(spec_of(geared(ratio), torque), "cam_forces")["cam_forces"]
    assert any("repeats after 2 turns of the cam" in note for note in forces.notes) is told
    assert any("turns with the crank at" in note for note in forces.notes) is not told


def test_the_spring_is_that_of_the_machine() -> None:
    """The machine moves with the spring of the mean speed, so that the forces at its speed have this one too."""
    loads = f'{LOADS}method = "safety"\nsafety = 1.4'
    found = results(spec_of(loads=loads), "cam_forces")
    task = to_cam(spec_of(loads=loads))
    steady = solve_forces(task, found["cam_synthesis"].follower).spring
    assert found["cam_forces"].spring.stiffness == steady.stiffness
    assert found["cam_forces"].spring.reached != pytest.approx(steady.reached, rel=1e-6)
    assert found["cam_forces"].error["spring"] < 1e-9


def test_a_stored_load_is_the_same(tmp_path: Path) -> None:
    spec = spec_of()
    first, again = (run(spec, target="motion", out=tmp_path) for _ in range(2))
    assert {event.kind for event in again.events if event.stage == "cam_load"} == {"loaded"}
    assert again.results["motion"].regime.omega.tolist() == first.results["motion"].regime.omega.tolist()


def test_two_are_joined_one_after_the_other() -> None:
    """Nothing of what is attached is known to the reduction but its record."""
    found = results(spec_of(), "reduction")
    twice = with_attached(found["reduction"], [found["cam_load"]])
    own = found["cam_load"]
    assert twice.cycle.inertia.max() - 0.05 == pytest.approx(2 * own.inertia_max, rel=1e-2)
    assert len(twice.contributions) == len(found["reduction"].contributions) + len(own.causes)


def press(cam: str) -> str:
    text = (CONFIGS / "course-project.toml").read_text(encoding="utf-8")
    return text.replace('shaft = "crank"', cam)


def test_a_cam_at_half_the_speed_makes_two_turns_of_a_linkage_a_cycle() -> None:
    alone, both = (results(parse_spec(press(cam)), "reduction") for cam in ("", 'shaft = "crank"\nratio = "1/2"'))
    one, two = alone["reduction"], both["reduction"]
    assert two.cycle.period == 2 * one.cycle.period
    assert two.labels[-1] == str(2 * int(one.labels[-1]))
    works = {cause.name: cause.work for cause in two.contributions}
    for cause in one.contributions:
        assert works[cause.name] == pytest.approx(2 * cause.work, rel=1e-9, abs=1e-9)
    rows = len(one.phi) - 1
    own = both["cam_load"].along(both["cam_load"].inertia, np.abs(two.phi))
    assert two.inertia[:rows] - own[:rows] == pytest.approx(one.inertia[:-1], rel=1e-12)
    assert two.inertia[rows:] - own[rows:] == pytest.approx(one.inertia, rel=1e-12)
    assert two.slope[rows + 1] == pytest.approx(
        one.slope[1] + both["cam_load"].along(both["cam_load"].slope, np.abs(two.phi))[rows + 1], rel=1e-9
    )


def test_a_motion_that_comes_to_rest_may_turn_a_machine_with_a_cam_back() -> None:
    """Pushed back by a load that drives backwards the energies close: friction takes in both senses."""
    lines = '[[transients]]\nname = "back"\nduration = "1.2 s"\nstart_speed = "10 rpm"\nmotor = "off"\n'
    text = press('shaft = "crank"')
    text = text[: text.index("[[transients]]")] + f'{lines}standstill = "pass"\n\n' + text[text.index("[cam]") :]
    motion = results(parse_spec(text.replace("delta = 0.05", 'inertia = "0.01 kg*m^2"')), "transient")[
        "transient"
    ].motions[0]
    assert np.min(motion.omega) < -0.1
    assert motion.imbalance < 1e-6
