"""Torque diagrams, gears, shafts and motions in time, from the tables of a spec to plain values."""

from __future__ import annotations

import math

import pytest
from project.scenes import MACHINE, TORQUE

from tmmcalc.machine.diagram import from_formula, superposed
from tmmcalc.machine.model import (
    DriveShaft,
    Gears,
    TorqueFormula,
    TorqueHarmonics,
    TorquePoints,
    TorqueTask,
)
from tmmcalc.machine.tables.tasks.machine import to_flywheel, to_gears, to_scenarios, to_shafts, to_torque
from tmmcalc.machine.transient.methods import Method
from tmmcalc.machine.transient.model import Shaft
from tmmcalc.machine.transient.scenario import Brake, LoadStep, Scenario
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project import parse_spec
from tmmcalc.spec.units import parse

TURN = 2 * math.pi
HEAD = '[torque]\nspeed = "180 rpm"\n'


def test_a_formula() -> None:
    task = to_torque(parse_spec(TORQUE))
    law = TorqueFormula("M0*sin(theta)**2 - 120", (("M0", 500.0),))
    assert task == TorqueTask("torque", 6 * math.pi, TURN, law, (0.0, math.pi), 3.0, True)


def test_a_formula_has_the_work_of_its_integral() -> None:
    """The mean of 500 sin^2 is 250, and there are two diagrams: (250 - 120) 2 pi 2."""
    task = to_torque(parse_spec(TORQUE))
    assert task is not None
    assert isinstance(task.law, TorqueFormula)
    cycle = superposed(from_formula(task.law.text, task.speed, constants=dict(task.law.constants)), task.delays)
    assert float(cycle.panels.total(cycle.moment)) == pytest.approx(4 * math.pi * 130, rel=1e-12)


@pytest.mark.parametrize(
    ("law", "expected"),
    [
        (
            'harmonics = { constant = "20 N*m", terms = [{ order = 1, sin = 5 }, { order = 2, cos = "1 kN*m" }] }',
            TorqueHarmonics(20.0, ((1.0, 0.0, 5.0), (2.0, 1000.0, 0.0))),
        ),
        (
            'pieces = [["0 deg", 5], ["90 deg", "1 kN*m"], ["90 deg", -3]]',
            TorquePoints((0.0, math.pi / 2, math.pi / 2), (5.0, 1000.0, -3.0)),
        ),
        (
            'table = { theta = [0, "180 deg"], moment = [1, 2], interpolation = "pchip" }',
            TorquePoints((0.0, math.pi), (1.0, 2.0), "pchip"),
        ),
        ("table = { moment = [1, 2, 3, 4] }", TorquePoints((0.0, math.pi / 2, math.pi, 1.5 * math.pi), (1, 2, 3, 4))),
    ],
)
def test_every_other_law(law: str, expected: TorqueHarmonics | TorquePoints) -> None:
    task = to_torque(parse_spec(HEAD + law))
    assert task == TorqueTask("torque", 6 * math.pi, TURN, expected)


def test_delays_and_period() -> None:
    text = HEAD + 'formula = "5"\nperiod = "720 deg"\n'
    even, own = (to_torque(parse_spec(text + key)) for key in ("count = 4\n", 'delays = ["0 deg", "-90 deg"]\n'))
    assert even is not None
    assert own is not None
    assert even.period == 2 * TURN
    assert even.delays == (0.0, math.pi, TURN, 3 * math.pi)
    assert own.delays == (0.0, -math.pi / 2)


def test_the_drive_from_the_motor_to_the_crank(shaper: str) -> None:
    spec = parse_spec(shaper + MACHINE)
    assert to_shafts(spec) == (
        DriveShaft("shaft 1", Shaft(5000.0, 2.0, 4.0), 0.5),
        DriveShaft("low", Shaft(80e3, 0.0, 6.6, True), 0.0),
    )
    assert to_gears(spec) == Gears(4.0 * 6.6, 0.95)
    assert to_shafts(parse_spec(shaper)) == ()
    assert to_gears(parse_spec(shaper)) == Gears()


def test_a_shaft_without_stiffness_is_rigid(shaper: str) -> None:
    motor = '[motor]\nname = "4A132S4"\n'
    (shaft,) = to_shafts(parse_spec(f"{shaper}\n{motor}[[shafts]]\nratio = 3\n"))
    assert shaft.shaft == Shaft(math.inf, ratio=3.0)
    given = parse_spec(f"{shaper}\n{motor}[[shafts]]\nratio = 3\n[transmission]\nratio = 3\n")
    assert to_gears(given) == Gears(3.0)


def test_motions_in_time(shaper: str) -> None:
    start, stop = to_scenarios(parse_spec(shaper + MACHINE))
    full, low, high = (parse(f"{n} rpm", "angular speed") for n in (50, 20, 40))
    assert start.scenario == Scenario(
        "transient",
        5.0,
        load=(LoadStep(0.0), LoadStep(1.0, speed=full, quiet=True), LoadStep(0.5, time=3.0)),
        targets=(low, high),
        end_angle=20 * TURN,
    )
    assert (start.method, start.steady) == (Method(), False)
    assert stop.scenario == Scenario(
        "stop",
        10.0,
        settled=True,
        motor=((0.0, 2.0),),
        brake=Brake(200.0, 1.5, 0, 2.0, 8.0),
        standstill="pass",
    )
    assert (stop.method, stop.steady) == (Method("merson", 0.001), True)


def test_a_motion_without_motor_and_a_brake_to_the_end(shaper: str) -> None:
    text = '[[transients]]\nduration = "1 min"\nmotor = "off"\nstart_speed = "60 rpm"\nbrake = { viscous = 2 }\n'
    (task,) = to_scenarios(parse_spec(f"{shaper}\n{text}"))
    assert task.scenario == Scenario("transient", 60.0, TURN, motor=(), brake=Brake(viscous=2.0))
    assert not task.scenario.motor_on(0.0)


@pytest.mark.parametrize(
    ("own", "names"),
    [
        (["", "", ""], ["transient", "transient 2", "transient 3"]),
        (["start", ""], ["start", "transient 2"]),
        (["", "transient"], ["transient 1", "transient"]),
    ],
)
def test_names_of_motions(own: list[str], names: list[str]) -> None:
    motion = '[[transients]]\nduration = 1\nmotor = "off"\n'
    text = "".join(motion + (f'name = "{name}"\n' if name else "") for name in own)
    assert [task.scenario.name for task in to_scenarios(parse_spec(TORQUE + text))] == names


def test_what_stages_read_can_be_hashed(shaper: str) -> None:
    """And tells one drive from another."""
    text = shaper + MACHINE
    one, other = (parse_spec(t) for t in (text, text.replace('moment = "200 N*m"', 'moment = "201 N*m"')))
    assert content_hash(to_shafts(one)) == content_hash(to_shafts(other))
    assert content_hash(to_scenarios(one)) != content_hash(to_scenarios(other))
    diagrams = (parse_spec(t) for t in (TORQUE, TORQUE.replace("1000/2", "1000/3")))
    assert len({content_hash(to_torque(spec)) for spec in diagrams}) == 2


def test_a_rim_is_of_cast_iron_if_nothing_else_is_said(shaper: str) -> None:
    wheel = to_flywheel(parse_spec(f"{shaper}\n[flywheel]\ndelta = 0.04\n"))
    assert wheel is not None
    assert (wheel.material, wheel.density, wheel.speed_limit) == ("cast iron", None, None)
