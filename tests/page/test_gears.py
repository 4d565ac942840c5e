"""Gears on a page, in a browser: members of trains and wheels of pairs turn as the stages say."""

from __future__ import annotations

import math
from typing import Any

import pytest

import tmmcalc
from page.conftest import Open
from page.opened import slid
from page.scenes import CONFIGS
from tmmcalc.pipeline.runner import run

ANGLES = """view => Object.fromEntries([...view.querySelectorAll(".body")].map((body) => {
  const m = body.getScreenCTM();
  return [body.dataset.body, Math.atan2(-m.b, m.a)];
}))"""
TOLD = """view => [...view.querySelectorAll(".readings tr")].map((row) =>
  [...row.children].map((cell) => cell.textContent))"""


def turned(view: Any, begin: float, end: float) -> dict[str, float]:
    """How far bodies turn on the screen while the input goes on a little, counter-clockwise [rad]."""
    slider = view.locator("input[type=range]").first
    slid(slider, begin)
    before = view.evaluate(ANGLES)
    slid(slider, end)
    after = view.evaluate(ANGLES)
    return {name: math.remainder(after[name] - before[name], 2 * math.pi) for name in before}


@pytest.mark.slow
def test_members_of_a_train_turn_at_their_true_speeds(open_page: Open) -> None:
    result = run(tmmcalc.load_spec(CONFIGS / "gears-ravigneaux.toml"), target=["gearing"]).results["gearing"]
    speeds = {name: result.motion.speed(name) for name in result.motion.members}
    view = open_page("gears-ravigneaux").page.locator("[data-view=gearing]")
    found = turned(view, 40.0, 50.0)
    for name, speed in speeds.items():
        copies = [each for each in found if each.partition("#")[0] == name]
        assert len(copies) == (3 if name in ("short", "long") else 1)
        for each in copies:
            assert found[each] == pytest.approx(math.radians(10) * speed / speeds["small"], abs=1e-5)
    told = {row[1]: row[2] for row in view.evaluate(TOLD)}
    assert float(told["ωring"].split()[0]) == pytest.approx(speeds["ring"], rel=1e-3)


def test_wheels_of_a_pair_roll(open_page: Open) -> None:
    pair = run(tmmcalc.load_spec(CONFIGS / "pair-spur.toml"), target=["pair"]).results["pair"].pairs[0]
    first, second = pair.task.teeth
    view = open_page("pair-spur").page.locator("[data-view^=pair]").first
    slider = view.locator("input[type=range]").first
    begin, end = (float(slider.get_attribute(each)) for each in ("min", "max"))
    found = turned(view, begin + 0.1 * (end - begin), begin + 0.6 * (end - begin))
    assert abs(found["1"]) > 0
    assert found["2"] / found["1"] == pytest.approx(-first / second, abs=1e-4)
