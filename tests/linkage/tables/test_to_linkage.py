from __future__ import annotations

import math

import pytest

from tmmcalc.linkage.model import Assembly, Grid, Input, Joint, Output
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.project import parse_spec
from tmmcalc.spec.units import parse, unit_direction


def test_shaper(shaper: str) -> None:
    mechanism = to_linkage(parse_spec(shaper).mechanism)
    assert mechanism.frame.points == {"O": 0.62j, "B": 0j}
    assert mechanism.link(3).points == {"B": 0j, "C": 1.02 + 0j, "S3": 0.5 + 0j}
    assert mechanism.joint("A") == Joint("A", "revolute", (1, 2), (0.2 + 0j, 0j))
    assert mechanism.joint("D0") == Joint("D0", "prismatic", (5, 0), (0j, 1j))
    assert mechanism.input == Input("O", parse("55 rpm", "angular speed"))
    assert mechanism.outputs == (Output("D"),)
    assert mechanism.grid == Grid()
    assert mechanism.assembly == Assembly()


def test_pins_lines_and_assembly(shaper: str) -> None:
    text = shaper.replace('name = "C"\n', 'name = "C"\npoints = ["C", "C4"]\n')
    text = text.replace("points = { C = [0, 0], D", "points = { C4 = [0.25, -1], D")
    text = text.replace('guide = { through = "B", angle = "0 deg" }', 'guide = { through = "C", angle = "90 deg" }')
    text = text.replace("links = [2, 3] ", 'slider = { through = "A", angle = "30 deg" }\nlinks = [2, 3] ')
    text = text.replace("positions = 24", 'working = 8\nidle = 4\nextra = ["180 deg"]\nextremes = true')
    text += '[mechanism.assembly]\nsketch = { C = ["330 mm", 0.965] }\nvariants = { "3-2" = -1 }\nat = "90 deg"\n'
    mechanism = to_linkage(parse_spec(text).mechanism)
    assert mechanism.joint("C").points == (1.02 + 0j, 0.25 - 1j)
    line = mechanism.joint("A3")
    assert line.points == (0j, 1.02 + 0j)
    assert line.directions[0] == pytest.approx(complex(math.sqrt(3) / 2, 0.5))
    assert line.directions[1] == 1j
    assert mechanism.grid == Grid(24, 8, 4, None, (math.pi,), True)
    assert mechanism.assembly == Assembly({"C": 0.33 + 0.965j}, {(3, 2): -1}, math.pi / 2)


@pytest.mark.parametrize("turns", range(-9, 10))
def test_right_angles_are_exact(turns: int) -> None:
    exact = (1, 1j, -1, -1j)[turns % 4]
    assert unit_direction(parse(f"{90 * turns} deg", "angle")) == exact
    assert unit_direction(turns * math.pi / 2) == exact


def test_other_angles_are_not_rounded() -> None:
    assert unit_direction(1.5708).real == pytest.approx(math.cos(1.5708))
    assert unit_direction(1e-12) == complex(1.0, 1e-12)
