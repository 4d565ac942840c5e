"""Vectors at their points to the scale that is told; what is shown and hidden; plans of vectors."""

from __future__ import annotations

import numpy as np
import pytest
from sparing import sparing

from page.conftest import Open
from page.scenes import CONFIGS, solved
from page.test_diagrams import column, number
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.project import load_spec

CENTIMETRE = 37.8  # pixels of a drawing
# of a layer that is shown: the columns of its arrows, and how these are drawn, y upwards
ARROWS = """(name) => {
  const content = JSON.parse(document.getElementById("content").textContent);
  const layer = content.scenes[0].views[0].layers.find((each) => each.name === name);
  const lines = document.querySelectorAll(`[data-view=kinematics] [data-layer=${name}] line`);
  return layer.arrows.map(({ x, y, sense }, k) => [x, y, sense, lines[k].classList.contains("lost"),
    ["x1", "y1", "x2", "y2"].map((key) => Number(lines[k].getAttribute(key)))]);
}"""

VECTORS = """(name) => {
  const content = JSON.parse(document.getElementById("content").textContent);
  const layer = content.scenes[0].views[0].layers.find((each) => each.name === name);
  const lines = document.querySelectorAll(`[data-view=kinematics] [data-layer=${name}] line`);
  return layer.vectors.map(({ sign }, k) => [sign, lines[k].classList.contains("lost"),
    ["x1", "y1", "x2", "y2"].map((key) => Number(lines[k].getAttribute(key)))]);
}"""


@sparing("layer", ["velocity", "acceleration", "reaction"], every=3)
def test_vectors_are_drawn_to_the_scale_that_is_told(layer: str, open_page: Open) -> None:
    found = open_page("shaper")
    box = found.page.locator(f"[data-view=kinematics] input[name={layer}]")
    box.check()
    told = box.locator("xpath=..").inner_text()
    per = number(told.split("1 cm: ")[1]) / CENTIMETRE  # of the unit to a pixel
    tables = {stage: solved("shaper", stage) for stage in ("kinematics", "forces")}
    drawn = 0
    for at in (10.2, 97.7, 200.0, 299.1):
        found.move(at)
        for x, y, sense, lost, (x1, y1, x2, y2) in found.page.evaluate(ARROWS, layer):
            (stage, right), (_, up) = x.split(".", 1), y.split(".", 1)
            rows = np.flatnonzero(np.abs(column(tables[stage], "phi") - found.at) < 0.51)
            true = sense * (column(tables[stage], right) + 1j * column(tables[stage], up))[rows] / per
            if lost:
                assert np.abs(true).min() < 1.1
            else:
                assert np.abs(complex(x2 - x1, y1 - y2) - true).min() < 0.11
                drawn += 1
    assert drawn >= 8


@pytest.mark.slow
@pytest.mark.parametrize("layer", ["given", "inertia"])
def test_weights_and_forces_of_inertia_are_drawn_to_scale(layer: str, open_page: Open) -> None:
    """Weights as they are given, forces of inertia against the accelerations that the kinematics finds."""
    found = open_page("press")
    box = found.page.locator(f"[data-view=kinematics] input[name={layer}]")
    assert not box.is_checked()
    box.check()
    per = number(box.locator("xpath=..").inner_text().split("1 cm: ")[1]) / CENTIMETRE
    loading = to_loading(load_spec(CONFIGS / "press.toml"))
    bodies = {f"{body.link}": body for body in loading.bodies}
    table, seen = solved("press", "kinematics"), set()
    for at in (10.2, 97.7, 200.0, 299.1):
        found.move(at)
        row = int(np.argmin(np.abs(column(table, "phi") - found.at)))
        for sign, lost, (x1, y1, x2, y2) in found.page.evaluate(VECTORS, layer):
            link = sign[3:-1]
            if sign[0] not in "GP" or lost or f"ax_S{link}[m/s^2]" not in table:
                continue
            a = column(table, f"ax_S{link}")[row] + 1j * column(table, f"ay_S{link}")[row]
            true = bodies[link].mass * (loading.gravity if layer == "given" else -a)
            assert complex(x2 - x1, y1 - y2) == pytest.approx(true / per, abs=0.11)
            seen.add(sign)
    assert len(seen) >= 2
    box.uncheck()
    assert found.page.locator(f"[data-layer={layer}] line:visible").count() == 0


@pytest.mark.slow
def test_what_is_not_wanted_is_hidden(open_page: Open) -> None:
    found = open_page("shaper")
    for name, shown in (
        ("paths", ".paths path"),
        ("numbers", ".number"),
        ("names", ".spot.pin .name"),
        ("masses", ".spot.mass"),
        ("centres", ".centre:not(.lost)"),
        ("velocity", "[data-layer=velocity] line:not(.lost)"),
    ):
        found.move(33.3)
        box = found.page.locator(f"[data-view=kinematics] input[name={name}]")
        parts = found.page.locator(f"[data-view=kinematics] {shown}:visible")
        box.check()
        assert parts.count() > 0, name
        box.uncheck()
        assert parts.count() == 0, name


@pytest.mark.slow
def test_plans_are_closed_figures_at_every_position(open_page: Open) -> None:
    found = open_page("shaper")
    part = found.page.locator("details.plans")
    part.evaluate("each => { each.open = true; }")
    choice = part.locator("select")
    for k in range(choice.locator("option").count()):
        choice.select_option(index=k)
        for at in (0.0, 71.3, 188.8):
            found.move(at)
            lines = part.locator("svg line").evaluate_all(
                "all => all.map(each => ['x1', 'y1', 'x2', 'y2'].map(key => Number(each.getAttribute(key))))"
            )
            assert len(lines) >= 2
            assert np.isfinite(lines).all()
            wide, high = part.locator("svg").last.evaluate(
                "each => [each.viewBox.baseVal.width, each.viewBox.baseVal.height]"
            )
            across = np.array(lines)[:, [0, 2]]
            upwards = np.array(lines)[:, [1, 3]]
            assert across.min() >= 0
            assert across.max() <= wide
            assert upwards.min() >= 0
            assert upwards.max() <= high


# of all arrows that are seen: how long they are, how long their heads are, how wide, how far from their tips these are
HEADS = """(where) => [...document.querySelectorAll(`${where}:not(.lost)`)].map((line) => {
  const [ax, ay, bx, by] = ["x1", "y1", "x2", "y2"].map((key) => Number(line.getAttribute(key)));
  const at = line.nextElementSibling.getAttribute("d").match(/-?[\\d.]+/g).map(Number);
  const [x, y] = [(at[2] + at[4]) / 2, (at[3] + at[5]) / 2];
  const head = Math.hypot(at[0] - x, at[1] - y);
  const wide = Math.hypot(at[2] - at[4], at[3] - at[5]);
  return [Math.hypot(bx - ax, by - ay), head, wide, Math.hypot(bx - at[0], by - at[1])];
})"""


@pytest.mark.slow
@pytest.mark.parametrize(
    "where",
    [".layer[data-layer=velocity] > line", ".plan .edge:not(.arm, .turned) line"],
)
def test_heads_of_short_arrows_are_shorter_than_their_shafts(where: str, open_page: Open) -> None:
    found = open_page("shaper")
    found.page.locator("details.plans").evaluate("each => { each.open = true; }")
    shortest, longest = np.inf, 0.0
    for at in (0.0, 3.0, 17.5, 95.0, 170.0, 188.8, 230.0):
        found.move(at)
        for long, head, wide, off in found.page.evaluate(HEADS, where):
            assert head == pytest.approx(min(9, long / 2), abs=0.1)
            assert wide <= min(6, 0.6 * long) + 0.1
            assert off < 0.1
            shortest, longest = min(shortest, long), max(longest, long)
    assert shortest < 9
    assert longest > 20


# of a plan the boxes of its letters, without the air above and below them, and its vectors from end to end
SIGNS = """() => {
  const svg = document.querySelector("svg.plan");
  const boxes = [...svg.querySelectorAll("text")].map((each) => {
    const { x, y, width, height } = each.getBBox();
    return [x + 0.5, y + 0.22 * height, x + width - 0.5, y + 0.82 * height];
  });
  const lines = [...svg.querySelectorAll(".edge line")].map((each) =>
    ["x1", "y1", "x2", "y2"].map((key) => Number(each.getAttribute(key))));
  return [boxes, lines];
}"""
AIR = 2.0  # pixels that a corner keeps around itself


def within(box: list[float], line: list[float]) -> bool:
    """Whether a vector has a part within a box, looked for at points that are half a pixel apart."""
    (left, top, right, bottom), (ax, ay, bx, by) = box, line
    part = np.linspace(0, 1, 2 + int(2 * np.hypot(bx - ax, by - ay)))
    x, y = ax + part * (bx - ax), ay + part * (by - ay)
    return bool(((x > left) & (x < right) & (y > top) & (y < bottom)).any())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "least"),
    [("shaper", 4.0), ("press", 4.0), ("class-four", 4.0)],
)
def test_signs_of_plans_lie_on_nothing(name: str, least: float, open_page: Open) -> None:
    """On no other sign, no vector, no corner; ``least`` is how many there are in the mean."""
    found = open_page(name)
    part = found.page.locator("details.plans")
    part.evaluate("each => { each.open = true; }")
    choice, count, shown = part.locator("select"), 0, 0
    for k in range(choice.locator("option").count()):
        choice.select_option(index=k)
        for at in np.linspace(1.0, 351.0, 15):
            found.move(float(at))
            boxes, lines = found.page.evaluate(SIGNS)
            ends = [end for ax, ay, bx, by in lines for end in ((ax, ay), (bx, by))]
            for j, (left, top, right, bottom) in enumerate(boxes):
                others = boxes[:j]
                assert not [b for b in others if left < b[2] and b[0] < right and top < b[3] and b[1] < bottom]
                assert not [x for x, y in ends if left - AIR < x < right + AIR and top - AIR < y < bottom + AIR]
                assert not [each for each in lines if within([left, top, right, bottom], each)]
            shown += len(boxes)
            count += 1
    assert shown > least * count
