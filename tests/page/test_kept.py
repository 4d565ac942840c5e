"""What a hand has chosen stays when another variant is shown."""

from __future__ import annotations

from pathlib import Path

import pytest

from page.conftest import Open
from page.opened import Opened
from page.scenes import CONFIGS, write

HALF = ("positions = 12 ", 'positions = 12\nspan = "180 deg" ')


@pytest.fixture(scope="module")
def pairs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The four-bar linkage, the same over half a turn, and a spec without what moves."""
    folder = tmp_path_factory.mktemp("kept")
    half = folder / "half.toml"
    half.write_text((CONFIGS / "four-bar.toml").read_text(encoding="utf-8").replace(*HALF), encoding="utf-8")
    file = folder / "my.html"
    write(CONFIGS / "four-bar.toml", file, str(half), str(CONFIGS / "pair-spur.toml"))
    return file


def columns(found: Opened) -> list[str]:
    names: list[str] = found.page.eval_on_selector_all(".chart", "all => all.map(each => each.dataset.column)")
    return names


def test_the_place_is_kept_by_its_value(pairs: Path, open_page: Open) -> None:
    """At half the travel a part of it would be elsewhere; where a travel is too short the wish is kept for others."""
    found = open_page(pairs)
    found.move(100)
    found.choose(1)
    assert found.at == pytest.approx(100, abs=1e-3)
    found.choose(0)
    found.move(300)
    found.choose(1)
    assert found.at == pytest.approx(180, abs=1e-3)
    assert "beyond the range" in found.refused
    found.choose(2)
    found.choose(0)
    assert found.at == pytest.approx(300, abs=1e-3)


@pytest.mark.slow
def test_diagrams_are_kept_that_a_variant_lacks(pairs: Path, open_page: Open) -> None:
    found = open_page(pairs)
    found.page.locator(".adding select").select_option("kinematics.omega_3")
    wished = columns(found)
    assert wished[-1] == "kinematics.omega_3"
    found.choose(2)
    usual = columns(found)
    assert usual
    assert not set(usual) & set(wished)
    found.choose(1)
    assert columns(found) == wished
    for close in found.page.locator(".chart .close").all()[::-1]:
        close.click()
    found.choose(0)
    assert columns(found) == []


@pytest.mark.slow
def test_ticks_speed_details_and_search_are_kept(pairs: Path, open_page: Open) -> None:
    found = open_page(pairs)
    page = found.page
    page.locator("input[name=paths]").uncheck()
    page.locator(".speed select").select_option("0.25")
    page.locator("details.given summary").click()
    page.locator("details.plans summary").click()
    plan = page.locator("details.plans select")
    plan.select_option(index=1)
    page.get_by_role("searchbox").fill("rocker")
    rows = page.locator("tr[data-fact]:visible").count()
    found.choose(1)
    assert not page.locator("input[name=paths]").is_checked()
    assert not page.locator(".scene .paths").is_visible()
    assert page.locator(".speed select").input_value() == "0.25"
    assert page.locator("details.given").get_attribute("open") is not None
    assert plan.is_visible()
    assert plan.input_value() == "1"
    assert page.get_by_role("searchbox").input_value() == "rocker"
    assert page.locator("tr[data-fact]:visible").count() == rows


@pytest.mark.slow
def test_the_place_in_a_diagram_that_nothing_moves_along_is_kept(open_page: Open, tmp_path: Path) -> None:
    file = tmp_path / "two.html"
    write(CONFIGS / "vibratory-device.toml", file, str(CONFIGS / "vibratory-device.toml"))
    found = open_page(file)
    found.page.locator(".adding select").select_option("vibrator/curve.x")
    chart = found.page.locator('.chart[data-column="vibrator/curve.x"]')
    plane, value = chart.locator("svg[role=slider]"), chart.locator("button.value")
    first = value.inner_text()
    plane.click()
    at, told = plane.get_attribute("aria-valuenow"), value.inner_text()
    assert told != first
    found.choose(1)
    assert plane.get_attribute("aria-valuenow") == at
    assert value.inner_text() == told


@pytest.mark.slow
def test_the_point_of_a_trial_is_kept(open_page: Open, tmp_path: Path) -> None:
    """Until the button brings it back: then every variant has its own again."""
    file = tmp_path / "two.html"
    write(CONFIGS / "pair-blocking.toml", file, str(CONFIGS / "pair-blocking.toml"))
    found = open_page(file)
    trial = found.page.locator(".trial").last
    told = trial.locator(".told")
    first = told.inner_text()
    for _ in range(3):
        trial.locator(".plane").press("ArrowRight")
    moved = told.inner_text()
    assert moved != first
    found.choose(1)
    assert told.inner_text() == moved
    trial.locator(".player .main").click()
    found.choose(0)
    assert told.inner_text() == first
