"""What moves: points where the kinematics finds them, links that stay rigid, the crank under the mouse and the keys."""

from __future__ import annotations

import re

import numpy as np
import pytest

import tmmcalc
from page.conftest import Open
from page.opened import Opened
from page.scenes import CONFIGS, MOVING, Fit, places
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

NEAR = 1e-3  # of the size on the screen
ROCKER = (  # the shortest link of a Grashof linkage is its coupler: the crank only rocks
    "mechanism.links[id=1].points.A=[0.4, 0]",
    "mechanism.links[id=2].points.B=[0.2, 0]",
    "mechanism.links[id=3].points.B=[0.5, 0]",
    "mechanism.fixed.C=[0.6, 0]",
    'mechanism.input.start="30 deg"',
    'mechanism.grid.span="50 deg"',
)


def ends(found: Opened) -> tuple[float, float]:
    low, high = found.slider.get_attribute("min"), found.slider.get_attribute("max")
    return float(low), float(high)


def compared(found: Opened, name: str, inputs: list[float], changed: tuple[str, ...] = ()) -> Fit:
    """Where points are seen at these inputs, beside where the stage finds them."""
    seen, said = [], []
    for at in inputs:
        found.move(at)
        said.append(found.at)
        seen.append(found.spots())
    true = places(name, said, changed)
    both = [(true[k][spot], each[spot]) for k, each in enumerate(seen) for spot in each if spot in true[k]]
    assert len(both) >= len(inputs)
    return Fit(*zip(*both, strict=True))


@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n == "shaper" else pytest.mark.slow) for n in MOVING])
def test_points_are_where_the_kinematics_finds_them(name: str, open_page: Open) -> None:
    """Between solved positions too, and both bodies of a pair carry its pin to one place."""
    found = open_page(name)
    low, high = ends(found)
    inputs = [low + (high - low) * part for part in np.random.default_rng(5).random(12)]
    fit = compared(found, name, inputs)
    assert fit.error < NEAR * fit.size
    mechanism = to_linkage(run(load_spec(CONFIGS / f"{name}.toml"), target=["kinematics"]).spec.linkage)
    pins = [pin for pin in find_pins(mechanism) if len(pin.at) > 1]
    pixels = found.page.evaluate("document.querySelector('[data-view=kinematics] .scene').getScreenCTM().a")
    for at in inputs:
        found.move(at)
        bodies, spots = found.bodies(), found.spots()
        for pin in pins:
            for link, place in pin.at.items():
                if str(link) in bodies:
                    a, b, c, d, e, f = bodies[str(link)]
                    x, y = place.real * fit.scale / pixels, -place.imag * fit.scale / pixels
                    carried = complex(a * x + c * y + e, -(b * x + d * y + f))
                    assert abs(carried - spots[pin.name]) < NEAR * fit.size, (pin.name, link)


def held(found: Opened, body: str) -> tuple[float, float]:
    """A place of the window where a body is taken by the mouse: the middle of its thick line."""
    place = found.page.evaluate(
        """(body) => {
          const grip = document.querySelector(`[data-view=kinematics] [data-body="${body}"] .grip`);
          const box = grip.getBBox(), m = grip.getScreenCTM();
          const [x, y] = [box.x + 0.6 * box.width, box.y + 0.6 * box.height];
          return [m.a * x + m.c * y + m.e, m.b * x + m.d * y + m.f];
        }""",
        body,
    )
    return place[0], place[1]


@pytest.mark.parametrize("name", ["shaper", pytest.param("crank-slider", marks=pytest.mark.slow)])
def test_the_crank_follows_the_mouse(name: str, open_page: Open) -> None:
    found = open_page(name)
    mechanism = to_linkage(load_spec(CONFIGS / f"{name}.toml").linkage)
    joint = mechanism.joint(mechanism.input.joint)
    body = str(max(joint.links))
    found.move(40)  # away from dead centres, where links cover each other
    pivot = found.spots()[joint.name]
    x, y = held(found, body)
    start = found.at
    mouse = found.page.mouse
    mouse.move(x, y)
    mouse.down()
    ray = complex(x, -y) - pivot
    said, seen = [], []
    for step in range(1, 30):  # a turn and a half against the clock
        to = pivot + ray * np.exp(1j * np.radians(20 * step))
        mouse.move(to.real, -to.imag, steps=2)
        said.append(found.at)
        seen.append(found.spots())
        turned = np.sign(mechanism.input.speed) * 20 * step + start
        assert abs((found.at - turned + 180) % 360 - 180) < 0.5
    mouse.up()
    mouse.move(x, y)
    assert found.at == said[-1]
    true = places(name, said)
    fit = Fit(
        *zip(*[(true[k][n], z) for k, each in enumerate(seen) for n, z in each.items() if n in true[k]], strict=True)
    )
    assert fit.error < NEAR * fit.size


@pytest.mark.slow
@pytest.mark.parametrize("name", ["hydraulic-lift", "scissor-lift"])
def test_a_driven_slider_follows_the_mouse_to_its_ends(name: str, open_page: Open) -> None:
    found = open_page(name)
    spec = load_spec(CONFIGS / f"{name}.toml")
    body = str(tmmcalc.solve_kinematics(spec).structure.input_link)
    low, high = ends(found)
    found.move((low + high) / 2)
    grip = found.page.locator(f'[data-view=kinematics] [data-body="{body}"] .grip').first
    box = grip.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    middle, before = found.at, found.spots()
    mouse = found.page.mouse
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + 30, y + 1, steps=3)
    assert abs(found.at - middle) > 1e-3 * (high - low)
    after = found.spots()
    moved = max(abs(after[name] - before[name]) for name in before)
    assert moved >= 29
    for way in (1500, -1500):
        mouse.move(x + way, y, steps=5)
        assert low <= found.at <= high
        assert re.search("cannot be reached|beyond the range that is analysed", found.refused)
    mouse.up()


@pytest.mark.slow
def test_any_link_is_dragged(open_page: Open) -> None:
    """The rocker of the four-bar linkage leads the crank."""
    found = open_page("four-bar")

    def middle(at: float) -> complex:
        found.move(at)
        points = found.spots()
        return points["C"] + 0.6 * (points["B"] - points["C"])

    start, way = middle(60), [middle(60 + 2 * step) for step in range(1, 26)]
    found.move(60)
    mouse = found.page.mouse
    mouse.move(start.real, -start.imag)
    mouse.down()
    for step, to in enumerate(way, 1):
        mouse.move(to.real, -to.imag)
        assert found.at == pytest.approx(60 + 2 * step, abs=0.5)
    mouse.up()


def test_keys_turn_step_play_and_return(open_page: Open) -> None:
    found = open_page("shaper")
    keys = found.page.keyboard
    found.page.locator("[data-view=kinematics] .scene").focus()
    step = 360 / 24
    assert found.at == 0
    keys.press("ArrowRight")
    assert found.at == pytest.approx(1)
    keys.press("ArrowLeft")
    keys.press("ArrowLeft")
    assert found.at == pytest.approx(359)
    keys.press("Home")
    assert found.at == 0
    keys.press("ArrowUp")
    assert found.at == pytest.approx(step)
    assert "in position 1\n" in found.told
    keys.press("PageUp")
    assert found.at == pytest.approx(2 * step)
    keys.press("ArrowDown")
    assert found.at == pytest.approx(step)
    keys.press(" ")
    found.wait(beyond=step + 1)
    keys.press(" ")
    found.page.wait_for_timeout(50)
    stopped = found.at
    found.page.wait_for_timeout(150)
    assert found.at == stopped
    found.slider.focus()
    keys.press("ArrowRight")
    assert found.at == pytest.approx(stopped + 1)


@pytest.mark.slow
def test_buttons_step_by_the_positions_of_the_spec(open_page: Open) -> None:
    found = open_page("shaper")
    on = found.page.get_by_role("button", name="On one position")
    back = found.page.get_by_role("button", name="Back one position")
    for k in range(1, 25):
        on.click()
        assert found.at == pytest.approx((15 * k) % 360, abs=1e-4) or found.at == pytest.approx(360)
    back.click()
    assert found.at == pytest.approx(345)


# what it plays in a second [deg], and what it has time for: a page that is shown late does not leap
PLAYED = """() => new Promise((done) => {
  const slider = document.querySelector("[data-view=kinematics] input[type=range]");
  const toggle = document.querySelector("[data-view=kinematics] .player .main");
  toggle.click();
  requestAnimationFrame((start) => {
    const from = Number(slider.value);
    let [last, time] = [start, 0];
    const look = (now) => {
      time += Math.min(now - last, 100);
      last = now;
      if (now - start < 1000) return requestAnimationFrame(look);
      toggle.click();
      done([Number(slider.value) - from, time]);
    };
    requestAnimationFrame(look);
  });
})"""


@pytest.mark.slow
def test_speed_is_what_is_chosen(open_page: Open) -> None:
    """At speed 1 a turn takes four seconds."""
    found = open_page("four-bar")
    for speed in (1, 0.25):
        found.move(0)
        found.page.locator("[data-view=kinematics] .speed select").select_option(f"{speed:g}")
        went, time = found.page.evaluate(PLAYED)
        assert went == pytest.approx(360 * speed * time / 4000, rel=0.01)


@pytest.mark.slow
def test_a_crank_that_cannot_go_round_says_where_it_closes_no_more(open_page: Open) -> None:
    """It closes from -3.6 to 56.4 deg; its travel is 50 deg."""
    found = open_page("four-bar", *ROCKER)
    assert ends(found) == pytest.approx((0, 50))
    fit = compared(found, "four-bar", [0.07, 13.3, 31.9, 49.95], ROCKER)
    assert fit.error < NEAR * fit.size
    found.move(0)
    pivot, (x, y) = found.spots()["O"], held(found, "1")
    ray, mouse = complex(x, -y) - pivot, found.page.mouse
    mouse.move(x, y)
    mouse.down()

    def drag(angle: float) -> None:
        to = pivot + ray * np.exp(1j * np.radians(angle))
        mouse.move(to.real, -to.imag, steps=4)

    for angle, at, words in (
        (20, 20, ""),
        (-2, 0, "φ = −2"),
        (-8, 0, "cannot be reached"),
        (45, 45, ""),
        (53, 50, "beyond the range"),
        (60, 50, "cannot be reached"),
        (30, 30, ""),
    ):
        drag(angle)
        assert found.at == pytest.approx(at, abs=0.6)
        assert words in found.refused
        assert bool(words) == bool(found.refused)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "changed"),
    [
        ("shaper", ('mechanism.grid.span="90 deg"',)),
        ("hydraulic-lift", ()),
        ("tipper", ()),
    ],
)
def test_beyond_its_travel_an_input_is_refused(name: str, changed: tuple[str, ...], open_page: Open) -> None:
    found = open_page(name, *changed)
    low, high = ends(found)
    found.page.locator("[data-view=kinematics] .scene").focus()
    assert found.refused == ""
    found.page.keyboard.press("ArrowLeft")
    assert found.at in (low, high)
    assert re.search("cannot be reached|beyond the range that is analysed", found.refused)
    found.page.keyboard.press("ArrowRight")
    assert found.refused == ""
    fit = compared(found, name, [low + (high - low) * part for part in (0.013, 0.41, 0.77, 0.991)], changed)
    assert fit.error < NEAR * fit.size
