"""Other scenes that move, in a browser: the gripper is seen where its stage has it, a rest is left by the hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from sparing import sparing

from page.conftest import Open
from page.opened import Opened, slid
from page.scenes import CONFIGS, Fit
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator
from tmmcalc.manipulators.views.space import AslantArm
from tmmcalc.project import load_spec

MIDDLE = "spot => { const m = spot.getScreenCTM(); return [m.e, m.f]; }"
OTHERS = ("extra-transloader", "pendulum-rotor", "synth-motion", "vibratory-device")


def first(found: Opened) -> Any:
    """The slider of the first view."""
    return found.page.locator(".view input[type=range]").first


def seen(found: Opened) -> complex:
    x, y = found.page.locator("[data-spot=P]").first.evaluate(MIDDLE)
    return complex(x, -y)


@sparing("name", ["manipulator", "manipulator-angular", "manipulator-direct"], every=3)
def test_the_gripper_is_seen_where_its_stage_has_it(name: str, open_page: Open) -> None:
    task = to_manipulator(load_spec(CONFIGS / f"{name}.toml"))
    result: Any = solve_manipulator(task)
    hand = result.gripper[0]
    true = AslantArm(task, result).seen(hand) if task.arm.spatial else hand[0] + 1j * hand[1]
    found = open_page(name)
    places = []
    for at in result.t:
        slid(first(found), float(at))
        places.append(seen(found))
    fit = Fit([complex(z) for z in true], places)
    assert fit.error < 1e-3 * fit.size


@pytest.mark.slow
def test_a_hand_takes_the_gripper_from_its_rest(open_page: Open) -> None:
    found = open_page("manipulator")
    start = seen(found)
    slid(first(found), 0.8)
    way = seen(found)
    slid(first(found), 0.0)
    mouse = found.page.mouse
    mouse.move(start.real, -start.imag + 6)
    mouse.down()
    for part in np.linspace(0, 1, 30):
        place = start + part * (way - start)
        mouse.move(place.real, -place.imag)
    mouse.up()
    assert float(found.page.locator(".view input[type=range]").first.input_value()) == pytest.approx(0.8, abs=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("name", OTHERS)
def test_other_scenes_move(name: str, open_page: Open) -> None:
    """Something is drawn elsewhere at another place of the input, and nothing is no number."""
    found = open_page(name)
    shapes = "() => document.querySelector('.scene').innerHTML"
    slider = first(found)
    low, high = float(slider.get_attribute("min")), float(slider.get_attribute("max"))
    drawn = set()
    for part in (0.0, 0.3, 0.55, 0.8):
        slid(first(found), low + part * (high - low))
        drawn.add(found.page.evaluate(shapes))
    assert len(drawn) == 4
    assert not any("NaN" in each for each in drawn)
