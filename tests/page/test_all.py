"""Every ready spec in windows of three sizes: nothing is complained of, asked of the network or out of the window."""

from __future__ import annotations

import pytest

from page.conftest import Open
from page.scenes import MOVING, SPECS

SIZES = ((1500, 1000), (900, 1100), (390, 800))
QUICK = ("shaper",)
# what has no place, for a number in it is none
LOST = """() => [...document.querySelectorAll("[transform], [d], [points], [x1], [x], [cx], [cy]")].filter((each) =>
  [...each.attributes].some((one) => /NaN|Infinity|undefined/.test(one.value))).map((each) => each.outerHTML)"""
OUTSIDE = """() => [...document.querySelectorAll("body *")].filter((each) => {
  const box = each.getBoundingClientRect();
  const whole = each.matches("pre, body > * svg.scene, .chart > svg");
  const inner = !whole && each.closest("pre, svg, .unseen, .list") !== null;
  return !inner && box.width > 0 && (box.right > innerWidth + 0.5 || box.left < -0.5);
}).map((each) => each.outerHTML.slice(0, 80))"""
LEAST = 10.7  # pixels of the window that a letter is high, of an index 0.7 of them
# letters of drawings that are smaller
SMALL = """(least) => [...document.querySelectorAll("svg text")].filter((each) => {
  const m = each.getScreenCTM();
  return each.getClientRects().length && Math.hypot(m.a, m.b) * parseFloat(getComputedStyle(each).fontSize) < least;
}).map((each) => [each.textContent, each.closest("svg").getAttribute("class")])"""


@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n in QUICK else pytest.mark.slow) for n in SPECS])
def test_opens(name: str, open_page: Open) -> None:
    for size in SIZES:
        found = open_page(name, size=size)
        page = found.page
        assert page.locator("h1").inner_text().strip()
        assert page.locator("section").count() >= 2 + (name in MOVING)
        for part in page.locator("details").all():
            part.evaluate("(part) => { part.open = true; }")
        assert page.evaluate("document.scrollingElement.scrollWidth <= innerWidth"), page.evaluate(OUTSIDE)
        assert page.evaluate(OUTSIDE) == []
        assert page.evaluate(SMALL, LEAST) == []
        if name in MOVING:
            assert page.locator("[data-view=kinematics] .spot").count() >= 2
        assert page.evaluate(LOST) == []


@pytest.mark.slow
def test_a_machine_moves_wherever_a_linkage_does(open_page: Open) -> None:
    assert len(MOVING) > 20
    assert open_page("shaper").page.locator("[data-view=kinematics]").count() == 1
