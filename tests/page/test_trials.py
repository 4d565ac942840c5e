"""The blocking contour in a browser: the point of shifts is dragged and moved by keys, sizes and teeth follow."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from gears.outlines import far, followed
from numpy.typing import NDArray
from sparing import sparing

from page.conftest import Open
from page.opened import Opened
from page.scenes import CONFIGS, write
from page.test_diagrams import number
from tmmcalc.core.plane import Plane, Real
from tmmcalc.gears.meshing.blocking import solve_blocking
from tmmcalc.gears.meshing.contours import Outline
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.pictures.placedpair import placed_pair
from tmmcalc.gears.tables.tasks.pair import to_pairs
from tmmcalc.project import load_spec

NAME = "pair-blocking"
TRIAL = "[data-trial=blocking_2]"
HEIGHT = 350  # of the drawing, in its pixels
REACH = 3.1  # modules above the pitch point that are in sight
MICROMETRE = 1e-6
STEP = 0.01  # of an arrow key


def chosen() -> MeshPair:
    """The pair whose plane is looked at, whose contour tolerates undercut."""
    return solve_pair(to_pairs(load_spec(CONFIGS / f"{NAME}.toml")).pairs[1])


def pressed(found: Opened, across: int, up: int) -> tuple[float, float]:
    """Where the point is after so many presses of arrow keys, from the chosen shifts."""
    plane = found.page.locator(f"{TRIAL} .plane")
    plane.focus()
    for count, ways in ((across, ("ArrowLeft", "ArrowRight")), (up, ("ArrowDown", "ArrowUp"))):
        for _ in range(abs(count)):
            plane.press(ways[count > 0])
    x1, x2 = chosen().shifts
    return x1 + STEP * across, x2 + STEP * up


def outlines(found: Opened, pitch: complex, module: float) -> list[Plane]:
    """Points of the outlines of both wheels [m], from the paths that are drawn."""
    paths = found.page.locator(f"{TRIAL} .sketch .gear").evaluate_all(
        "all => all.map((each) => each.getAttribute('d'))"
    )
    box = found.page.locator(f"{TRIAL} .sketch").get_attribute("viewBox").split()
    scale = REACH * module / (HEIGHT / 2)
    lines = []
    for path in paths:
        numbers = np.array(re.findall(r"-?[\d.]+", path.split("L")[0]), float).reshape(-1, 2)
        x, y = numbers.T - np.array([[float(box[2]) / 2], [HEIGHT / 2]])
        controls = pitch + scale * (x - 1j * y)
        lines.append(followed(controls))
    return lines


@sparing("way", [(0, 0), (-24, -13), (31, -12)], every=3)
def test_teeth_are_drawn_as_the_program_has_them(way: tuple[int, int], open_page: Open) -> None:
    """To a micrometre where the chosen pair, an undercut one and one that cannot work stand."""
    found = open_page(NAME)
    shifts = pressed(found, *way)
    pair = placed_pair(solve_pair(replace(chosen().task, strategy="given", shifts=shifts, refuse=False)))
    module = pair.found.task.module
    for body, drawn in zip(pair.bodies, outlines(found, pair.pitch_point, module), strict=True):
        assert far(body.edge[::4], drawn) < MICROMETRE
    told = found.page.locator(f"{TRIAL} tr").all_inner_texts()
    ratio = next(text for text in told if text.startswith("transverse contact ratio of the flanks that are left"))
    assert number(ratio.split("\t")[2]) == pytest.approx(pair.found.shortened, abs=1e-5)


def test_the_point_is_dragged_and_teeth_follow(open_page: Open) -> None:
    found = open_page(NAME)
    plane, gear = found.page.locator(f"{TRIAL} .plane"), found.page.locator(f"{TRIAL} .sketch .gear").first
    plane.scroll_into_view_if_needed()
    hand = found.page.locator(f"{TRIAL} .hand").bounding_box()
    x, y = hand["x"] + hand["width"] / 2, hand["y"] + hand["height"] / 2
    mouse, seen = found.page.mouse, {gear.get_attribute("d")}
    mouse.move(x, y)
    mouse.down()
    for k in range(1, 6):
        mouse.move(x - 6 * k, y + 4 * k)
        seen.add(gear.get_attribute("d"))
        moved = found.page.locator(f"{TRIAL} .hand").bounding_box()
        assert moved["x"] + moved["width"] / 2 == pytest.approx(x - 6 * k, abs=0.6)
        assert moved["y"] + moved["height"] / 2 == pytest.approx(y + 4 * k, abs=0.6)
    mouse.up()
    assert len(seen) == 6
    assert not any("NaN" in path for path in seen)


@pytest.mark.slow
def test_plane_and_sketch_follow_the_width_of_the_window(open_page: Open) -> None:
    """The point stays where it is, and keys move it on."""
    found = open_page(NAME)
    shifts = pressed(found, -3, 2)
    told = found.page.locator(f"{TRIAL} .told")
    for wide in (390, 1280):
        found.page.set_viewport_size({"width": wide, "height": 800})
        shape = 360 if wide < 600 else 760
        for drawing in (".plane", ".sketch"):
            found.page.wait_for_selector(f"{TRIAL} {drawing}[viewBox^='0 0 {shape} ']")
            assert found.page.locator(f"{TRIAL} {drawing}").count() == 1
        assert number(told.inner_text().split("= ")[1]) == pytest.approx(shifts[0], abs=1e-4)
    found.page.locator(f"{TRIAL} .plane").press("ArrowRight")
    assert number(told.inner_text().split("= ")[1]) == pytest.approx(shifts[0] + STEP, abs=1e-4)


@pytest.mark.slow
def test_keys_with_alt_or_ctrl_belong_to_the_browser(open_page: Open) -> None:
    page = open_page(NAME).page
    plane, told = page.locator(f"{TRIAL} .plane"), page.locator(f"{TRIAL} .told")
    taken = """(plane, init) =>
      !plane.dispatchEvent(new KeyboardEvent("keydown", { bubbles: true, cancelable: true, ...init }))"""
    before = told.inner_text()
    for more in ("altKey", "ctrlKey", "metaKey"):
        assert not plane.evaluate(taken, {"key": "ArrowLeft", more: True})
    assert told.inner_text() == before
    for key in ("ArrowLeft", "Home"):
        assert plane.evaluate(taken, {"key": key})  # or the window would scroll
    assert told.inner_text() == before


@pytest.mark.slow
def test_named_points_are_reached_by_keys(open_page: Open) -> None:
    page = open_page(NAME).page
    names = page.locator(f"{TRIAL} .stops button")
    assert [*names.all_inner_texts()] == ["chosen", "C", "D", "E", "balanced", "equal strength"]
    names.nth(2).focus()
    page.keyboard.press("Enter")
    said = page.locator(f"{TRIAL} .told").inner_text()
    assert number(said.split("= ")[1]) == pytest.approx(0.39477, abs=1e-4)
    assert number(said.split("= ")[2]) == pytest.approx(0.11346, abs=1e-4)


@pytest.mark.slow
def test_contacts_lie_on_the_line_of_action(open_page: Open) -> None:
    """As many as the pair has at the pitch point, between the ends of the contact."""
    found = open_page(NAME)
    pressed(found, -10, 5)
    dots = found.page.locator(f"{TRIAL} .sketch [data-mark=dot]:not(.lost)")
    shifts = chosen().shifts
    pair = placed_pair(
        solve_pair(replace(chosen().task, strategy="given", shifts=(shifts[0] - 0.1, shifts[1] + 0.05), refuse=False))
    )
    scale = (HEIGHT / 2) / (REACH * pair.found.task.module)
    places = dots.evaluate_all("all => all.map((each) => each.getAttribute('transform'))")
    true = pair.on_line(pair.contacts()) - pair.pitch_point
    ours = [complex(*map(float, re.findall(r"-?[\d.]+", place))) for place in places]
    assert len(ours) == len(true) >= 1
    for mine, other in zip(ours, true, strict=True):
        assert mine == pytest.approx(complex(380 + scale * other.real, HEIGHT / 2 - scale * other.imag), abs=2e-3)


@pytest.mark.slow
@pytest.mark.parametrize(("language", "said"), [("en", "there is no such pair"), ("uk", "такої пари немає")])
def test_where_there_is_no_pair_it_is_said_why(language: str, said: str, tmp_path: Path, open_page: Open) -> None:
    """The sum of shifts of this pair is too small in a corner of its plane; within it teeth come back."""
    spec = tmp_path / "pair.toml"
    spec.write_text('[pair]\nteeth = [12, 40]\nmodule = "3 mm"\nhelix_angle = "20 deg"\n', encoding="utf-8")
    write(spec, tmp_path / "pair.html")
    found = open_page(tmp_path / "pair.html")
    page = found.page
    page.locator("select[name=language]").select_option(language)
    plane, told = page.locator(".plane"), page.locator(".trial .wrong")
    assert told.inner_text() == ""
    plane.scroll_into_view_if_needed()
    box = page.locator(".plane rect.frame").bounding_box()
    page.mouse.click(box["x"] + 3, box["y"] + box["height"] - 3)
    assert told.inner_text().startswith(said)
    assert not page.locator(".sketch .gear").first.is_visible()
    plane.press("Home")
    assert told.inner_text() == ""
    assert page.locator(".sketch .gear").first.is_visible()


@pytest.mark.slow
@pytest.mark.parametrize("size", [(1500, 1000), (900, 1100), (390, 800)])
def test_plane_and_teeth_are_in_sight_together(size: tuple[int, int], open_page: Open) -> None:
    found = open_page(NAME, size=size)
    section = found.page.locator(TRIAL)
    section.evaluate("each => each.scrollIntoView()")
    for part in (".plane", ".sketch"):
        box = section.locator(part).bounding_box()
        assert box["y"] >= 0
        assert box["y"] + box["height"] <= size[1]
    module = found.page.locator(f"{TRIAL} .sketch").bounding_box()["height"] / (2 * REACH)
    assert module > 35


@pytest.mark.slow
def test_parts_of_the_contour_that_lie_apart_are_what_they_are(tmp_path: Path, open_page: Open) -> None:
    """One without undercut is no tolerated one, and both are said to lie apart."""
    spec = tmp_path / "pair.toml"
    spec.write_text('[pair]\nteeth = [20, 40]\nmodule = "2 mm"\nstrategy = "given"\nx1 = 0\nx2 = 0\n', encoding="utf-8")
    write(spec, tmp_path / "pair.html")
    contour = solve_blocking(Pairs((solve_pair(to_pairs(load_spec(spec)).pairs[0]),), "", ())).pairs[0]
    page = open_page(tmp_path / "pair.html").page
    told = page.locator(".trial .told")
    assert told.inner_text().endswith(": within the contour")
    content = page.evaluate("JSON.parse(document.getElementById('content').textContent)")
    left, bottom, right, top = content["scenes"][0]["trials"][0]["box"]
    page.locator(".plane").scroll_into_view_if_needed()
    frame = page.locator(".plane rect.frame").bounding_box()
    parts = np.linspace(0.01, 0.99, 66)
    x, y = np.meshgrid(left + parts * (right - left), bottom + parts * (top - bottom))
    main, piece = (_held(each, x, y) for each in ([contour.strict.main], contour.strict.pieces))
    wide, far_off = (_held(each, x, y) for each in ([contour.tolerated.main], contour.tolerated.pieces))
    for where, said in (
        (main, "within the contour"),
        (piece & ~main, "within the contour, in a part that lies apart"),
        (wide & ~main & ~piece, "within the tolerated contour only"),
        (far_off & ~wide & ~main & ~piece, "within the tolerated contour only, in a part that lies apart"),
        (~(main | piece | wide | far_off), "outside the contour"),
    ):
        inner = where.copy()  # a point whose neighbours are alike
        inner[1:-1, 1:-1] &= where[:-2, 1:-1] & where[2:, 1:-1] & where[1:-1, :-2] & where[1:-1, 2:]
        row, k = np.argwhere(inner)[len(np.argwhere(inner)) // 2]
        page.mouse.click(frame["x"] + parts[k] * frame["width"], frame["y"] + (1 - parts[row]) * frame["height"])
        assert told.inner_text().endswith(f": {said}")


def _held(outlines: Sequence[Outline | None], x: Real, y: Real) -> NDArray[np.bool_]:
    """Whether one of the outlines goes round points."""
    found = np.zeros(x.shape, bool)
    for each in outlines:
        if each is not None:
            edge = each.x1 + 1j * each.x2 - (x + 1j * y)[..., None]
            found |= np.abs(np.angle(np.roll(edge, -1, axis=-1) / edge).sum(axis=-1)) > np.pi
    return found
