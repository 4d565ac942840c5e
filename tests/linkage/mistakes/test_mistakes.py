"""Mistakes in linkages against the mechanism worked out by hand: a crank-slider with masses, in closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mistakes import items, key, right, wrong

from tmmcalc.linkage.readings import analogue, in_time

R, L, N, G = 0.1, 0.32, 120.0, 9.81  # crank, rod [m]; speed [rpm]
W = N * math.pi / 30
M2, J2, S2, M3 = 8.0, 0.19, 0.12, 15.0  # rod and slider
LOAD = 900.0
SPEC = f"""
[project]
title = "Crank-slider"

[mechanism.grid]
positions = 12

[mechanism.input]
joint = "O"
speed = "{N} rpm"
start = "0 deg"

[[mechanism.outputs]]
point = "B"
direction = "0 deg"
resistance = "negative"

[mechanism.fixed]
O = [0, 0]

[[mechanism.links]]
id = 1
points = {{ O = [0, 0], A = ["100 mm", 0] }}

[[mechanism.links]]
id = 2
points = {{ A = [0, 0], B = ["320 mm", 0] }}
mass = {M2}
inertia = {J2}
center = ["120 mm", 0]

[[mechanism.links]]
id = 3
points = {{ B = [0, 0] }}
mass = {M3}

[[mechanism.joints]]
name = "O"
kind = "revolute"
links = [0, 1]

[[mechanism.joints]]
name = "A"
kind = "revolute"
links = [1, 2]
friction = 0.1
radius = "20 mm"

[[mechanism.joints]]
name = "B"
kind = "revolute"
links = [2, 3]

[[mechanism.joints]]
name = "B0"
kind = "prismatic"
links = [3, 0]
guide = {{ through = [0, 0], angle = "0 deg" }}

[mechanism.assembly]
variants = {{ "2-3" = 1 }}

[[loads]]
name = "Q"
link = 3
point = "B"
direction = "180 deg"
force = "{LOAD} N"
stroke = "working"
"""
SMOOTH = ("mechanism.joints[name=A].friction=0",)
POSITIONS = (2, 5, 8, 11)  # two on either stroke


class Hand:
    """The crank-slider at a position, per unit of the crank's angle; ``side`` is that of the slider."""

    def __init__(self, position: float, side: int = 1, sense: int = 1) -> None:
        phi = sense * math.radians(30 * position)
        self.a, self.va, self.aa = (R * factor * np.exp(1j * phi) for factor in (1, 1j, -1))
        self.e = side * math.sqrt(1 - (R * math.sin(phi) / L) ** 2) - 1j * R * math.sin(phi) / L
        self.omega = -self.va.imag / (L * self.e.real)
        self.eps = (-self.aa.imag + self.omega**2 * L * self.e.imag) / (L * self.e.real)
        self.x, self.v, self.b = (each.real for each in (self.at(L), self.rate(L), self.rate2(L)))
        self.forward = self.v * sense > 0

    def at(self, s: float) -> complex:
        return complex(self.a + s * self.e)

    def rate(self, s: float) -> complex:
        return complex(self.va + 1j * self.omega * s * self.e)

    def rate2(self, s: float) -> complex:
        return complex(self.aa + (1j * self.eps - self.omega**2) * s * self.e)

    def drive(self, w: float = W, g: complex = -1j * G, j: float = J2, inert: float = 1.0, load: float = LOAD) -> float:
        """Moment on the crank by virtual power, without friction."""
        forces = M2 * ((g - inert * self.rate2(S2) * w * w) * np.conj(self.rate(S2))).real
        forces += M3 * ((g - inert * self.b * w * w) * self.v).real
        return float(-(forces - inert * j * self.eps * self.omega * w * w - load * self.v))

    def useful(self) -> float:
        return LOAD if self.forward else 0.0


@pytest.mark.parametrize("position", POSITIONS)
def test_by_hand_it_is_the_same_without_a_mistake(position: int) -> None:
    hand = Hand(position)
    assert right(SPEC, f"kinematics.x_B@{position} m", f"forces.M_drive@{position} N*m", sets=SMOOTH) == pytest.approx(
        [hand.x, hand.drive(load=hand.useful())], rel=1e-10
    )


@pytest.mark.parametrize("position", POSITIONS)
@pytest.mark.parametrize(
    ("mistake", "changed"),
    [
        ("weights_left_out", {"g": 0}),
        ("weights_twice", {"g": -2j * G}),
        ("weights_upwards", {"g": 1j * G}),
        ("mass_for_weight", {"g": -1j}),
        ("gravity_again", {"g": -1j * G * G}),
        ("inertia_about_pin", {"j": J2 + M2 * S2**2}),
        ("inertia_less_steiner", {"j": J2 - M2 * S2**2}),
        ("inertia_couples_left_out", {"j": 0.0}),
        ("inertia_left_out", {"inert": 0.0}),
        ("speed_in_rpm", {"w": N}),
        ("speed_in_turns", {"w": N / 60}),
        ("load_left_out", {"load": 0.0}),
        ("idle_stroke_loaded", {"load": LOAD}),
        ("load_reversed", {"load": None}),
        ("strokes_swapped", {"load": None}),
    ],
)
def test_the_drive_with_a_mistake(mistake: str, changed: dict[str, float], position: int) -> None:
    hand = Hand(position)
    given = {"load": hand.useful(), **changed}
    if mistake == "load_reversed":
        given["load"] = -hand.useful()
    if mistake == "strokes_swapped":
        given["load"] = LOAD - hand.useful()
    (got,) = wrong(SPEC, f"linkage.{mistake}", f"forces.M_drive@{position} N*m", sets=SMOOTH)
    assert got == pytest.approx(hand.drive(**given), rel=1e-9)


@pytest.mark.parametrize("position", POSITIONS)
def test_turned_back_and_assembled_otherwise(position: int) -> None:
    asked = f"kinematics.x_B@{position} m", f"kinematics.vS_B@{position} m/s", f"kinematics.aS_B@{position} m/s^2"
    hand = Hand(position, sense=-1)
    assert wrong(SPEC, "linkage.crank_turned_back", *asked) == pytest.approx([hand.x, -hand.v * W, hand.b * W * W])
    hand = Hand(position, side=-1)
    assert wrong(SPEC, "linkage.other_assembly:2-3", *asked) == pytest.approx([hand.x, hand.v * W, hand.b * W * W])


@pytest.mark.parametrize("position", POSITIONS)
def test_counted_from_the_other_extreme_position(position: int) -> None:
    extreme = ('mechanism.input.start="extreme"',)
    asked = f"kinematics.x_B@{position} m", f"kinematics.S_B@{position} m"
    first, begin = Hand(position + 6), Hand(0)
    assert right(SPEC, *asked, sets=extreme) == pytest.approx([first.x, first.x - Hand(6).x], abs=1e-12)
    assert wrong(SPEC, "linkage.other_extreme", *asked, sets=extreme) == pytest.approx(
        [Hand(position).x, Hand(position).x - begin.x], abs=1e-12
    )


@pytest.mark.parametrize("position", POSITIONS)
def test_friction_of_a_pin(position: int) -> None:
    """The moment f r R of the crank pin, against or along its motion: R with it, which is little, from the program."""
    asked = f"forces.M_drive@{position} N*m", f"forces.R_A@{position} N"
    hand = Hand(position)
    smooth, relative = hand.drive(load=hand.useful()), hand.omega - 1

    def lost(moment: float, reaction: float, sense: float, radius: float) -> None:
        assert moment == pytest.approx(smooth + sense * 0.1 * radius * reaction * abs(relative), rel=1e-9)

    lost(*right(SPEC, *asked), 1.0, 0.02)
    lost(*wrong(SPEC, "linkage.friction_reversed", *asked), -1.0, 0.02)
    lost(*wrong(SPEC, "linkage.pin_diameter", *asked), 1.0, 0.04)
    assert wrong(SPEC, "linkage.friction_left_out", *asked)[0] == pytest.approx(smooth, rel=1e-9)


def test_reversed_friction_helps_over_the_cycle() -> None:
    (loss,), (gain,) = right(SPEC, "power.A_F J"), wrong(SPEC, "linkage.friction_reversed", "power.A_F J")
    assert loss < 0 < gain


@pytest.mark.parametrize(
    ("mistake", "asked", "value"),
    [
        ("analogue_given", "kinematics.vS_B@2 m/s", lambda hand: hand.v),
        ("analogue_given", "kinematics.aS_B@2 mm/s^2", lambda hand: 1000 * hand.b),
        ("analogue_given", "kinematics.eps_2@2 rad/s^2", lambda hand: hand.eps),
        ("rate_given", "kinematics.dS_B@2 m/rad", lambda hand: hand.v * W),
        ("rate_given", "kinematics.ddangle_2@2 rad/rad^2", lambda hand: hand.eps * W * W),
        ("speed_not_squared", "kinematics.aS_B@2 m/s^2", lambda hand: hand.b * W),
        ("dimensionless_given", "kinematics.x_B@2 mm", lambda hand: hand.x / R),
        ("dimensionless_given", "kinematics.vS_B@2 mm/s", lambda hand: hand.v / R),
        ("projections_swapped", "kinematics.vx_A@2 m/s", lambda hand: hand.va.imag * W),
        ("projections_swapped", "kinematics.ddy_A@2 m/rad^2", lambda hand: hand.aa.real),
    ],
)
def test_what_is_read_off_wrongly(mistake: str, asked: str, value) -> None:  # type: ignore[no-untyped-def]
    assert wrong(SPEC, f"linkage.{mistake}", asked) == pytest.approx([value(Hand(2))], rel=1e-10)


def test_angles_of_the_strokes_are_swapped() -> None:
    found = key("shaper", items("kinematics.working_D deg", "kinematics.idle_D deg"), "linkage.strokes_angles_swapped")
    assert found.mistaken[0] == pytest.approx(found.values[::-1])
    assert sum(found.values) == pytest.approx(360)


def test_names_that_have_no_such_reading() -> None:
    for name in ("forces.R_A@2", "kinematics.S_D@2", "kinematics.stroke_D", "power.eta"):
        assert analogue(name) == in_time(name) == ""
