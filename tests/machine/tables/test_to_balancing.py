"""Balancing of a linkage, an engine and a rotor, from the tables of a spec to plain values."""

from __future__ import annotations

import math

import pytest
from project.scenes import ENGINE, MACHINE, ROTOR

from tmmcalc.machine.balance.arrangements import FIRING, THROWS
from tmmcalc.machine.balance.cylinders import Cylinder
from tmmcalc.machine.balance.firing import firing
from tmmcalc.machine.balance.redistribution import Place
from tmmcalc.machine.balance.rotors import state
from tmmcalc.machine.balance.schemes import RotatingWeight
from tmmcalc.machine.balance.solve import BalanceTask
from tmmcalc.machine.model import EngineTask
from tmmcalc.machine.tables.tasks.balance import to_balance, to_engine, to_rotor
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project import parse_spec

SIZES = 'speed = "3000 rpm"\ncrank_radius = "40 mm"\nrod_length = "140 mm"\nreciprocating_mass = 0.6\n'
UP = math.pi / 2


def engine_of(text: str) -> EngineTask:
    task = to_engine(parse_spec(text))
    assert task is not None
    return task


def test_balance_of_a_linkage(shaper: str) -> None:
    task = to_balance(parse_spec(shaper + MACHINE))
    assert task == BalanceTask(
        mass=None,
        radius=0.15,
        point=0j,
        schemes=("minimax", "lanchester 2"),
        places=(Place(1, radius=0.06), Place(3, mass=4.5)),
        weights=(RotatingWeight(-1, 0.12j, -0.2j),),
    )


def test_balance_without_a_word(shaper: str) -> None:
    assert to_balance(parse_spec(shaper)) == to_balance(parse_spec(f"{shaper}\n[balance]\n")) == BalanceTask()


def test_a_weight_without_axis_turns_about_the_pivot_of_the_crank(shaper: str) -> None:
    text = f"{shaper}\n[balance]\npoint = [1, 2]\nadd = [{{ order = 1, mass = 2, radius = 0.1 }}]\n"
    task = to_balance(parse_spec(text))
    assert task.weights == (RotatingWeight(1, 0.2 + 0j, 0.62j),)
    assert task.point == 1 + 2j


def test_an_engine_in_line() -> None:
    task = engine_of(ENGINE)
    assert (task.speed, task.orders, task.strokes, task.firing_order) == (100 * math.pi, (1, 2), 4, (1, 3, 4, 2))
    assert [c.position_along_shaft for c in task.cylinders] == pytest.approx([0, 0.09, 0.18, 0.27])
    assert [c.crank_angle - UP for c in task.cylinders] == pytest.approx([0, math.pi, math.pi, 0])
    assert {c.axis_angle for c in task.cylinders} == {UP}
    assert {(c.crank_radius, c.rod_length, c.reciprocating_mass) for c in task.cylinders} == {(0.04, 0.14, 0.6)}


@pytest.mark.parametrize("count", FIRING)
@pytest.mark.parametrize("strokes", [2, 4])
def test_customary_engines_fire_at_equal_intervals(count: int, strokes: int) -> None:
    text = f'[engine]\n{SIZES}arrangement = "in-line"\nspacing = 0.1\ncylinders = {count}\nstrokes = {strokes}\n'
    task = engine_of(text)
    assert task.firing_order == FIRING[count]
    assert firing(task.cylinders, task.firing_order, strokes=strokes).even


@pytest.mark.parametrize("throws", THROWS)
def test_a_vee(throws: int) -> None:
    text = f'[engine]\n{SIZES}arrangement = "vee"\nspacing = 0.1\ncylinders = {2 * throws}\nangle = "60 deg"\n'
    task = engine_of(text + 'offset = "1 mm"\nrotating_mass = 0.3\n')
    assert len(task.cylinders) == 2 * throws
    assert task.firing_order is None
    axes = [cylinder.axis_angle for cylinder in task.cylinders]
    assert axes == pytest.approx([UP + math.radians(30), UP - math.radians(30)] * throws)
    assert {(c.offset, c.rotating_mass) for c in task.cylinders} == {(0.001, 0.3)}


def test_a_boxer() -> None:
    text = f'[engine]\n{SIZES}arrangement = "vee"\ncylinders = 2\nangle = "180 deg"\nsplit = "180 deg"\n'
    left, right = engine_of(text + 'stagger = "40 mm"\nfiring_order = [1, 2]\nstrokes = 2\n').cylinders
    assert right.axis_angle - left.axis_angle == pytest.approx(-math.pi)
    assert right.crank_angle - left.crank_angle == pytest.approx(math.pi)
    assert right.position_along_shaft - left.position_along_shaft == pytest.approx(0.04)


def test_cylinders_have_what_they_lack_from_the_engine() -> None:
    listed = (
        '[[engine.cylinders]]\ncrank_angle = "90 deg"\nposition = 0\n'
        '[[engine.cylinders]]\naxis_angle = 0\ncrank_angle = "180 deg"\nposition = "90 mm"\n'
        "crank_radius = 0.05\nrod_length = 0.2\nreciprocating_mass = 1\nrotating_mass = 0\noffset = 0\n"
    )
    task = engine_of(f"[engine]\n{SIZES}rotating_mass = 0.4\noffset = 0.01\n{listed}")
    assert task.cylinders == (
        Cylinder(UP, UP, 0.0, 0.04, 0.14, 0.6, 0.4, 0.01),
        Cylinder(0.0, math.pi, 0.09, 0.05, 0.2, 1.0, 0.0, 0.0),
    )
    assert (task.orders, task.firing_order) == ((1, 2, 4, 6), None)


def test_a_rotor() -> None:
    task = to_rotor(parse_spec(ROTOR))
    assert task is not None
    assert (task.planes, task.static_plane, task.grade, task.radius) == ((0.05, 0.35), None, 6.3, 0.08)
    moment, hole = task.rotor.unbalances
    assert moment.moment == pytest.approx(12e-6j, rel=1e-15)
    assert (moment.position, hole.position) == (0.12, 0.3)
    assert hole.moment == pytest.approx(-0.005 * 0.08)
    # the load on bearing A at 0 by the levers of the two planes, 280 and 100 mm of 400 mm from B
    load = state(task.rotor).loads[0] / (100 * math.pi) ** 2
    assert load == pytest.approx(12e-6j * 0.7 - 4e-4 * 0.25, rel=1e-12)


def test_what_a_spec_has_not(shaper: str) -> None:
    assert to_engine(parse_spec(shaper)) is None
    assert to_rotor(parse_spec(shaper)) is None


def test_what_stages_read_can_be_hashed(shaper: str) -> None:
    spec = parse_spec(shaper + MACHINE + ENGINE + ROTOR)
    assert len({content_hash(make(spec)) for make in (to_balance, to_engine, to_rotor)}) == 3
