"""One plays in a page, and a hand stops it; views that drive each other keep together at their ends."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from page.altered import altered
from page.conftest import Open, Written
from page.opened import slid

NAME = "cam-translating"  # two views, of which one drives the other
PLACE = "[data-view={}] input[type=range]"


def place(page: Any, view: str) -> float:
    return float(page.locator(PLACE.format(view)).input_value())


def play(page: Any, view: str) -> None:
    page.locator(f"[data-view={view}] .player .main").click()


def test_one_plays_in_a_page(open_page: Open) -> None:
    page = open_page(NAME).page
    pauses = page.get_by_role("button", name="Pause")
    for view in ("cam_profile", "cam_region", "cam_profile"):
        play(page, view)
        assert pauses.count() == 1
        assert page.locator(f"[data-view={view}]").get_by_role("button", name="Pause").count() == 1
    page.evaluate("scrollTo(0, 10000)")
    page.wait_for_timeout(100)
    assert page.locator(".docked").count() <= 1
    pauses.click()
    assert pauses.count() == 0


@pytest.mark.slow
@pytest.mark.parametrize("hand", ["diagram", "Home", "other view", "other step"])
def test_a_hand_stops_what_plays(hand: str, open_page: Open) -> None:
    page = open_page(NAME).page
    play(page, "cam_profile")
    page.wait_for_function("() => Number(document.querySelector('[data-view=cam_profile] input').value) > 1")
    if hand == "diagram":
        page.locator(".chart > svg").first.click()
    elif hand == "Home":
        page.locator("[data-view=cam_profile] .scene").focus()
        page.keyboard.press("Home")
    elif hand == "other view":
        page.locator("[data-view=cam_region] .player input").focus()
        page.keyboard.press("ArrowRight")
    else:
        page.locator("[data-view=cam_region]").get_by_role("button", name="On one position").click()
    assert page.get_by_role("button", name="Pause").count() == 0
    stopped = place(page, "cam_profile")
    page.wait_for_timeout(120)
    assert place(page, "cam_profile") == stopped


@pytest.mark.slow
def test_an_end_of_one_view_is_an_end_of_the_other(written: Written, open_page: Open, tmp_path: Path) -> None:
    """The cam goes no whole turn here, so the plane that goes with it cannot leave it behind."""

    def ended(content: Any) -> None:
        [cam] = [each for each in content["scenes"][0]["views"] if each["name"] == "cam_profile"]
        cam["whole"] = False

    page = open_page(altered(written(NAME), tmp_path / "ended.html", ended)).page
    for at, true in ((100, 100), (350, 0), (20, 20)):  # from 100 the short way to 350 is back beyond 0
        if at == 350:
            slid(page.locator(PLACE.format("cam_region")), 1)
        slid(page.locator(PLACE.format("cam_region")), at)
        assert place(page, "cam_profile") == pytest.approx(true, abs=1e-3)
        assert place(page, "cam_region") == pytest.approx(true, abs=1e-3)


@pytest.mark.slow
def test_what_has_no_positions_has_no_buttons_for_them(written: Written, open_page: Open, tmp_path: Path) -> None:
    def bare(content: Any) -> None:
        for view in content["scenes"][0]["views"]:
            view.update(whole=False, steps=[])

    page = open_page(altered(written("four-bar"), tmp_path / "bare.html", bare)).page
    assert page.get_by_role("button", name="Play").count() == 1
    assert page.get_by_role("button", name="On one position").count() == 0
    assert page.get_by_role("button", name="Back one position").count() == 0
