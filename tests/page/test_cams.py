"""Cams on a page, in a browser: they turn by hand and with their crank, buttons lead to marked places."""

from __future__ import annotations

from typing import Any

import pytest

from page.conftest import Open
from page.opened import slid


def slider(page: Any, view: str) -> Any:
    return page.locator(f"[data-view={view}] input[type=range]").first


def stands(page: Any, view: str) -> float:
    return float(slider(page, view).input_value())


@pytest.mark.slow
def test_a_cam_on_the_crank_turns_with_it(open_page: Open) -> None:
    """Its rise begins where the crank has turned by 230 degrees."""
    page = open_page("course-project").page
    assert stands(page, "cam_profile") == pytest.approx(130)
    slid(slider(page, "kinematics"), 250)
    assert stands(page, "cam_profile") == pytest.approx(20)
    slid(slider(page, "cam_profile"), 300)
    assert stands(page, "kinematics") == pytest.approx(170)
    assert stands(page, "cam_region") == pytest.approx(300)


def test_buttons_lead_to_ends_of_phases_and_the_worst_angle(open_page: Open) -> None:
    page = open_page("cam-translating").page
    view = page.locator("[data-view=cam_profile]")
    view.get_by_role("button", name="beginning: return").click()
    assert stands(page, "cam_profile") == pytest.approx(100)
    view.get_by_role("button", name="largest pressure angle: rise").click()
    told = view.locator("[data-layer=pressure] text").text_content()
    value = page.locator("[data-column='cam_pressure.theta'] .value").text_content()
    assert told.startswith("θ = ")
    assert float(told[4:-1]) == pytest.approx(float(value.split("°")[0]), rel=0.01)


@pytest.mark.slow
def test_a_cam_is_turned_by_hand(open_page: Open) -> None:
    page = open_page("cam-flat").page
    box = page.locator("[data-view=cam_profile] [data-body=cam]").bounding_box()
    x, y, reach = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, 0.25 * box["width"]
    page.mouse.move(x - reach, y)
    page.mouse.down()
    page.mouse.move(x - 0.7 * reach, y - 0.7 * reach, steps=4)
    page.mouse.up()
    assert 20 < stands(page, "cam_profile") < 70  # clockwise, about an eighth of a turn


# how many legs there are, and how many of them end beyond the drawing
LEGS = """() => [[...document.querySelectorAll(".view .layer .leg")]].map((legs) => [legs.length, legs.filter((leg) => {
  const { width, height } = leg.ownerSVGElement.viewBox.baseVal;
  const end = new DOMPoint(leg.getAttribute("x2"), leg.getAttribute("y2"));
  const at = end.matrixTransform(leg.ownerSVGElement.getCTM().inverse().multiply(leg.getCTM()));
  return at.x < -1 || at.x > width + 1 || at.y < -1 || at.y > height + 1;
}).length])[0]"""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["cam", "cam-rocker-optimum"])
def test_legs_of_the_pressure_angle_end_in_sight(name: str, open_page: Open) -> None:
    page = open_page(name).page
    for at in range(0, 360, 15):
        slid(slider(page, "cam_profile"), at)
        assert page.evaluate(LEGS) == [4, 0]  # of the cam and of the places of its axis
