"""Diagrams: a click turns the crank there, values are those of the stages at the nearest solved position."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from page.altered import altered, contents, stored
from page.conftest import Open, Written
from page.opened import Opened
from page.scenes import CONFIGS, Real, solved, write
from tmmcalc.core.stage import STAGES
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

ERROR = 6e-6  # of a value that is written with six digits, and of a single float
LEFT, RIGHT, WIDE = 62, 14, 560  # of the plane of a diagram
SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


def number(text: str) -> float:
    """A number as the page writes it, with its unit after it."""
    found = re.match(r"([−\d.,]+)(?:·10([⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+))?", text)
    assert found, text
    mantissa = float(found[1].replace("−", "-").replace(",", "."))
    return mantissa * 10.0 ** int((found[2] or "⁰").translate(SUPERSCRIPTS))


def click(found: Opened, column: str, part: float) -> None:
    """Click a diagram at a part of its axis."""
    plane = found.page.locator(f'.chart[data-column="{column}"] > svg')
    plane.scroll_into_view_if_needed()
    box = plane.bounding_box()
    x = (LEFT + part * (WIDE - LEFT - RIGHT)) / WIDE * box["width"]
    found.page.mouse.click(box["x"] + x, box["y"] + box["height"] / 2)


def value(found: Opened, column: str) -> float:
    return number(found.page.locator(f'.chart[data-column="{column}"] button.value').inner_text())


def column(table: dict[str, Real], name: str) -> Real:
    return next(values for header, values in table.items() if header.split("[")[0] == name)


def test_a_click_turns_the_crank_there(open_page: Open) -> None:
    found = open_page("shaper")
    names = found.page.eval_on_selector_all(".chart", "all => all.map(each => each.dataset.column)")
    assert {"kinematics.S_D", "kinematics.vS_D", "forces.M_drive"} <= set(names)
    true = {stage: solved("shaper", stage) for stage in {name.split(".")[0] for name in names}}
    for k, part in enumerate((0.031, 0.25, 0.5, 0.777, 0.999)):
        click(found, names[k % len(names)], part)
        assert found.at == pytest.approx(360 * part, abs=0.5)
        for name in names:
            stage, key = name.split(".")
            along = column(true[stage], "phi")
            row = int(np.argmin(np.abs(along - found.at)))
            values = column(true[stage], key)
            assert abs(value(found, name) - values[row]) <= ERROR * abs(values[row]) + 1e-7 * np.abs(values).max()
        assert re.search(rf"nearest solved position, φ = {along[row]:.4g}°", found.told)


@pytest.mark.slow
def test_a_diagram_is_followed_by_the_pointer_that_is_held(open_page: Open) -> None:
    found = open_page("shaper")
    plane = found.page.locator('.chart[data-column="kinematics.S_D"] > svg')
    box = plane.bounding_box()
    mouse = found.page.mouse
    mouse.move(box["x"] + 0.3 * box["width"], box["y"] + 60)
    assert found.at == 0
    mouse.down()
    before = found.at
    mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 60, steps=4)
    assert found.at > before + 90
    mouse.up()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["crane-luffing", "four-stroke-engine", "press"])
def test_any_column_can_be_shown(name: str, open_page: Open) -> None:
    found = open_page(name)
    choice = found.page.locator(".adding select")
    options = choice.evaluate("all => [...all.options].map(each => each.value).filter(Boolean)")
    asked = [one for one in options if one.split(".")[0] in ("kinematics", "forces")][:: max(1, len(options) // 25)]
    true = {stage: solved(name, stage) for stage in {one.split(".")[0] for one in asked}}
    found.move(float(found.slider.get_attribute("max")) * 0.3371)
    for one in asked:
        choice.select_option(one)
        stage, key = one.split(".", 1)
        along, values = column(true[stage], "phi"), column(true[stage], key)
        row = int(np.argmin(np.abs(along - found.at)))
        near = np.flatnonzero(np.isclose(along, along[row]))
        largest = np.nanmax(np.abs(values))
        differences = np.abs(value(found, one) - values[near])
        assert differences.min() <= ERROR * np.abs(values[near]).max() + 1e-7 * largest, one


@pytest.mark.slow
def test_diagrams_are_added_once_and_taken_away(open_page: Open) -> None:
    found = open_page("shaper")
    charts = found.page.locator(".chart")
    count = charts.count()
    for _ in range(2):
        found.page.locator(".adding select").select_option("kinematics.omega_3")
        assert charts.count() == count + 1
    found.page.locator('.chart[data-column="kinematics.omega_3"]').get_by_role("button", name="Take away").click()
    assert charts.count() == count


@pytest.mark.slow
def test_a_result_leads_to_its_diagram(open_page: Open) -> None:
    found = open_page("shaper")
    row = found.page.locator('[data-fact="forces.R_A_max"]')
    part = found.page.locator('details[data-stage="forces"]')
    part.evaluate("part => { part.open = true; }")
    row.get_by_role("button", name="Diagram").click()
    assert found.page.locator('.chart[data-column="forces.R_A"]').count() == 1


@pytest.mark.slow
def test_a_value_is_copied(open_page: Open) -> None:
    found = open_page("shaper", permissions=["clipboard-read", "clipboard-write"])
    copy = found.page.locator('.chart[data-column="kinematics.S_D"] button.value')
    click(found, "kinematics.S_D", 0.4)
    copy.click()
    found.page.wait_for_selector("button.value.done")
    assert found.page.evaluate("navigator.clipboard.readText()") == copy.inner_text()


def test_results_are_found_by_a_word(open_page: Open) -> None:
    found = open_page("shaper")
    field = found.page.get_by_role("searchbox")
    field.fill("largest reaction")
    rows = found.page.locator("tr[data-fact]:visible")
    assert rows.count() >= 5
    assert all("largest reaction" in text for text in rows.all_inner_texts())
    field.fill("no such word")
    assert rows.count() == 0
    assert found.page.get_by_text("nothing is found").is_visible()
    field.fill("")
    assert not found.page.get_by_text("nothing is found").is_visible()


@pytest.mark.slow
def test_rows_of_tables_and_warnings_are_found(written: Written, open_page: Open, tmp_path: Path) -> None:
    """In both languages; of a table the other rows are hidden, and the whole where none is left."""

    def more(content: Any) -> None:
        stages = content["scenes"][0]["stages"]
        names = {"name": ["Verdict", "Висновок"], "sign": False, "unit": ""}
        verdicts = ["quite fit", ["much too weak", "надто слабкий"]]
        for stage, cells in zip(stages[-2:], (verdicts, ["x", "y"]), strict=True):
            stage.update(facts=[], tables=[{"title": "", "columns": [{**names, "cells": cells}]}])
        stages[-1].update(warnings=["a tooth is too weak", "a rim is hot"])

    page = open_page(altered(written("shaper"), tmp_path / "more.html", more)).page
    field = page.get_by_role("searchbox")
    field.fill("TOO WEAK")
    assert page.locator(".list tbody tr:visible").all_inner_texts() == ["much too weak"]
    assert page.locator(".warning:visible").all_inner_texts() == ["a tooth is too weak"]
    assert page.locator("details.stage:visible").count() == 2
    assert page.locator(".list:visible").count() == 1
    page.get_by_label("Language").select_option("uk")
    field.fill("слабкий")
    assert page.locator(".list tbody tr:visible").all_inner_texts() == ["надто слабкий"]
    assert page.locator("details.stage:visible").count() == 1
    field.fill("")
    assert page.locator(".warning:visible").count() == page.locator(".warning").count() > 2


@pytest.mark.slow
def test_a_diagram_that_is_added_comes_into_sight(open_page: Open) -> None:
    found = open_page("shaper", size=(900, 700))
    found.page.locator('details[data-stage="forces"]').evaluate("part => { part.open = true; }")
    found.page.locator('[data-fact="forces.R_A_max"]').get_by_role("button", name="Diagram").click()
    box = found.page.locator('.chart[data-column="forces.R_A"]').bounding_box()
    assert box["y"] >= -1
    assert box["y"] + box["height"] <= 701


@pytest.mark.slow
def test_a_search_that_is_cleared_leaves_stages_as_they_were(open_page: Open) -> None:
    page = open_page("shaper").page
    unfolded = "() => [...document.querySelectorAll('details.stage')].map((each) => each.open)"
    page.locator('details[data-stage="forces"] summary').click()
    before = page.evaluate(unfolded)
    assert any(before)
    field = page.get_by_role("searchbox")
    for text in ("largest reaction", "no such word"):
        field.fill(text)
        assert page.evaluate(unfolded) != before
        field.fill("")
        assert page.evaluate(unfolded) == before


@pytest.mark.slow
def test_keys_move_the_input_in_a_diagram(open_page: Open) -> None:
    found = open_page("shaper")
    keys = found.page.keyboard
    plane = found.page.locator(".chart > svg").first
    plane.focus()
    keys.press("ArrowRight")
    assert found.at == pytest.approx(1)
    assert plane.get_attribute("aria-valuetext").startswith("1°: ")
    keys.press("ArrowUp")
    assert found.at == pytest.approx(15)
    keys.press("Home")
    assert found.at == 0


@pytest.mark.slow
def test_what_no_key_moves_takes_no_focus(open_page: Open) -> None:
    page = open_page("pair-blocking").page
    page.locator(".adding select").select_option("blocking/no undercut.x2")  # a list
    plane = page.locator('.chart[data-column="blocking/no undercut.x2"] > svg')
    assert plane.get_attribute("tabindex") is None
    assert plane.get_attribute("role") == "img"


@pytest.mark.slow
def test_a_diagram_that_is_taken_away_is_drawn_no_more(open_page: Open) -> None:
    found = open_page("shaper")
    found.page.evaluate(
        """() => {
          const card = document.querySelector(".chart");
          window.changes = 0;
          new MutationObserver((all) => { window.changes += all.length; })
            .observe(card, { subtree: true, childList: true, attributes: true });
          card.querySelector(".close").click();
        }"""
    )
    found.page.evaluate("() => new Promise((done) => setTimeout(() => { window.changes = 0; done(); }, 50))")
    found.move(77)
    found.page.get_by_label("Language").select_option("uk")
    assert found.page.evaluate("() => new Promise((done) => setTimeout(() => done(window.changes), 50))") == 0


@pytest.mark.slow
def test_beyond_its_rows_a_diagram_has_no_value(written: Written, open_page: Open, tmp_path: Path) -> None:
    def halved(content: Any) -> None:
        for stage in content["scenes"][0]["stages"]:
            if stage["rows"]:
                stage["rows"]["values"][1] = 181
                for each in stage["columns"]:
                    each["values"][1] = 181

    found = open_page(altered(written("four-bar"), tmp_path / "half.html", halved))
    card = found.page.locator(".chart").first
    for at, known in ((180, True), (200, False), (20, True)):
        found.move(at)
        assert (card.locator("button.value").inner_text() != "–") == known
        assert card.locator(".dot").is_visible() == known
        assert card.locator(".cursor:not(.lost)").count() == known


@pytest.mark.slow
def test_an_axis_may_end_at_nothing(written: Written, open_page: Open, tmp_path: Path) -> None:
    def before(content: Any) -> None:
        [stage] = content["scenes"][0]["stages"][-1:]
        assert stage["name"] == "kinematics"
        stage["rows"]["values"] = stored(content, np.linspace(-360, 0, 361).tolist())

    found = open_page(altered(written("four-bar"), tmp_path / "before.html", before))
    texts = found.page.locator(".chart").first.locator(".grid text[text-anchor=middle]")
    assert texts.last.inner_html() == "0"
    view = found.page.locator(".chart > svg").first.get_attribute("viewBox").split()
    assert float(texts.last.get_attribute("x")) == pytest.approx(float(view[2]) - RIGHT)


@pytest.mark.slow
def test_a_diagram_overlays_what_is_alike_in_its_whole_length(open_page: Open, tmp_path: Path) -> None:
    """The other variant goes twice as far; then its values are in another unit, then over something else."""
    file = tmp_path / "two.html"
    write(CONFIGS / "four-bar.toml", file, str(CONFIGS / "four-bar.toml"))

    def kinematics(content: Any) -> Any:
        [stage] = [each for each in content["scenes"][1]["stages"] if each["name"] == "kinematics"]
        return stage

    def longer(content: Any) -> None:
        kinematics(content)["rows"]["values"] = stored(content, np.linspace(0, 720, 361).tolist())

    def in_inches(content: Any) -> None:
        for each in kinematics(content)["columns"]:
            each["unit"] = "in"

    def over_time(content: Any) -> None:
        kinematics(content)["rows"].update(header="t[s]", unit="s")

    for change, count in ((longer, 1), (in_inches, 0), (over_time, 0)):
        page = open_page(altered(file, tmp_path / f"{change.__name__}.html", change)).page
        card = page.locator(".chart").first
        assert card.locator(".curve.other").count() == count
        if count:
            wide = float(card.locator("svg[role=slider]").get_attribute("viewBox").split()[2])
            ends = [
                float(re.findall(r"[\d.]+", card.locator(f"path.curve{kind}").first.get_attribute("d"))[-2])
                for kind in (".other", ":not(.other)")
            ]
            assert ends == pytest.approx([wide - RIGHT, (LEFT + wide - RIGHT) / 2], abs=0.2)


# how near a curve comes to the middles of the texts beside its extremes, over their heights
APART = """() => [...document.querySelectorAll(".chart")].flatMap((chart) => {
  const curve = chart.querySelector("path.curve:not(.other):not(.jump)");
  const steps = Array.from({ length: 4001 }, (_, k) => curve.getPointAtLength((k / 4000) * curve.getTotalLength()));
  return [...chart.querySelectorAll("text.extreme")].map((text) => {
    const { x, y, width, height } = text.getBBox();
    const inside = steps.filter((at) => x < at.x && at.x < x + width && y + 3 < at.y && at.y < y + height - 3);
    return [chart.dataset.column, text.textContent, inside.length];
  });
})"""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["cam", "shaper", "crane-luffing"])
def test_values_of_extremes_stand_beside_the_curve(name: str, open_page: Open) -> None:
    found = open_page(name).page.evaluate(APART)
    assert len(found) >= 8
    assert [each for each in found if each[2]] == []


@pytest.mark.slow
def test_what_has_no_columns_asks_for_no_diagram(open_page: Open) -> None:
    page = open_page("dyad").page
    assert not page.get_by_label("Add a diagram").is_visible()
    assert page.get_by_role("searchbox").is_visible()


@pytest.mark.slow
def test_a_first_diagram_is_a_curve(open_page: Open) -> None:
    """Neither a straight line nor what rounding leaves."""
    for name, shown in (("pair-rack", ["pair.theta1"]), ("synth-dwell", ["synthesis.theta"])):
        charts = open_page(name).page.eval_on_selector_all(".chart", "all => all.map(each => each.dataset.column)")
        assert charts == shown


@pytest.mark.slow
def test_long_numbers_of_an_axis_are_whole(written: Written, open_page: Open, tmp_path: Path) -> None:
    def tiny(content: Any) -> None:
        [stage] = [each for each in content["scenes"][0]["stages"] if each["name"] == "kinematics"]
        for each in stage["columns"]:
            each["values"] = stored(content, (-3.5e-16 + 1e-16 * np.sin(np.arange(361))).tolist())

    page = open_page(altered(written("four-bar"), tmp_path / "tiny.html", tiny)).page
    ends = page.eval_on_selector_all(".chart .grid text[text-anchor=end]", "all => all.map((text) => text.getBBox().x)")
    assert min(ends) >= 0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "stage", "course", "along", "names"),
    [
        ("vibratory-device", "vibrator", "start", "t[s]", {"psi", "omega", "x", "E", "W"}),
        ("vibratory-device", "vibrator", "curve", "omega[rad/s]", {"x", "y", "phi"}),
        ("pendulum-rotor", "pendulum", "swing", "t[s]", {"v", "w", "x_O", "E"}),
        ("electric-braking", "transient", "plugging", "t[s]", {"theta", "omega"}),
    ],
)
def test_courses_of_one_table_have_diagrams_of_their_own(
    name: str, stage: str, course: str, along: str, names: set[str], written: Written
) -> None:
    """Modes, a resonance curve, motions in time stand below one another: no curve goes through all of them."""
    table: Any = STAGES[stage].table(run(load_spec(CONFIGS / f"{name}.toml"), target=[stage]).results[stage])
    here = np.asarray(table.columns[0]) == course
    content, block = contents(written(name))
    stages = {each["name"]: each for each in content["scenes"][0]["stages"]}
    assert stages[stage]["rows"] is None
    found = stages[f"{stage}/{course}"]
    assert found["rows"]["header"] == along
    assert names <= {column["name"] for column in found["columns"]}
    for column in found["columns"]:
        [k] = [k for k, header in enumerate(table.header) if header.split("[")[0] == column["name"]]
        true: Real = np.asarray(table.columns[k])[here].astype(float)
        at, count = column["values"]
        assert count == len(true)
        assert np.allclose(block[at : at + count], true, rtol=1e-6, atol=1e-9 * np.abs(true).max())


@pytest.mark.slow
def test_a_resonance_curve_below_resonance_is_over_the_speed(written: Written) -> None:
    """There amplitudes grow with it, one way as it goes itself."""
    content, block = contents(written("vibratory-device", 'vibrator.curve={ from = "50 rpm", to = "150 rpm" }'))
    [found] = [each for each in content["scenes"][0]["stages"] if each["name"] == "vibrator/curve"]
    at, count = found["columns"][0]["values"]
    assert found["columns"][0]["name"] == "x"
    assert (np.diff(block[at : at + count]) > 0).all()
    assert found["rows"]["header"] == "omega[rad/s]"


@pytest.mark.slow
def test_a_course_is_known_by_its_label(open_page: Open, tmp_path: Path) -> None:
    """The second one of one machine is none of the other: neither overlaid nor taken for it."""
    file = tmp_path / "two.html"
    write(CONFIGS / "electric-braking.toml", file, str(CONFIGS / "series-braking.toml"))
    found = open_page(file)
    both, alone = "transient/regenerative.omega", "transient/dynamic.omega"
    for name, count in ((both, 1), (alone, 0)):
        found.page.locator(".adding select").select_option(name)
        assert found.page.locator(f'.chart[data-column="{name}"] .curve.other').count() == count
    found.choose(1)
    shown = found.page.eval_on_selector_all(".chart", "all => all.map(each => each.dataset.column)")
    assert both in shown
    assert alone not in shown
    assert "self-excited" not in "".join(shown)


def test_arrows_and_values_are_of_the_same_rows(tmp_path: Path) -> None:
    """However many positions are asked for."""
    file = tmp_path / "many.html"
    write(CONFIGS / "four-bar.toml", file, "--positions", "1440")
    content, block = contents(file)
    [view] = content["scenes"][0]["views"]
    at, count = view["values"]
    rows = [each["rows"] for each in content["scenes"][0]["stages"] if each["rows"]]
    assert rows
    for each in rows:
        assert each["header"] == view["column"]
        assert each["kept"] == each["of"] == count == 1441
        assert (block[each["values"][0] :][:count] == block[at : at + count]).all()


@pytest.mark.slow
def test_a_number_without_a_unit_has_none(open_page: Open) -> None:
    found = open_page("shaper")
    found.page.locator(".adding select").select_option("forces.virtual")
    value = found.page.locator("[data-column='forces.virtual'] button.value").inner_text()
    assert re.fullmatch(r"−?[\d.]+(·10\S+)?", value)


@pytest.mark.slow
def test_numbers_along_an_axis_are_seen_whole(written: Written, open_page: Open, tmp_path: Path) -> None:
    def listed(content: Any) -> None:
        for stage in content["scenes"][0]["stages"]:
            if stage["rows"]:
                count = stage["rows"]["of"]
                stage["rows"].update(header="", name="", unit="", values=stored(content, np.linspace(0, 1e5, count)))

    found = open_page(altered(written("four-bar"), tmp_path / "listed.html", listed), size=(390, 800))
    assert "100000" in found.page.locator(".chart text").all_text_contents()
    beyond = """() => [...document.querySelectorAll(".chart > svg")].flatMap((svg) => {
      const right = svg.getBoundingClientRect().right;
      return [...svg.querySelectorAll("text")].filter((each) => each.getBoundingClientRect().right > right + 0.5)
        .map((each) => each.textContent);
    })"""
    assert found.page.evaluate(beyond) == []


@pytest.mark.slow
def test_a_result_of_another_kind_leads_to_no_diagram(open_page: Open) -> None:
    """Whether a torque is assumed is no torque; where it is largest is told beside how large it is."""
    rows = open_page("gears-ravigneaux").page
    assert rows.locator('[data-fact="gearing.torque_is_assumed"] .show').count() == 0
    assert rows.locator('[data-fact="gearing.power_in"] .show').count() == 1
    rows = open_page("shaper").page
    assert rows.locator('[data-fact="forces.R_A_max_at_phi"] .show').count() == 1


@pytest.mark.slow
def test_where_nothing_moves_a_diagram_is_read_by_hand(open_page: Open) -> None:
    """Of a resonance curve and a start: a click and keys show values; diagrams of one course go together."""
    page = open_page("vibratory-device").page
    page.locator(".adding select").select_option("vibrator/curve.y")
    values = [
        page.locator(f'.chart[data-column="{name}"] button.value') for name in ("vibrator/curve.x", "vibrator/curve.y")
    ]
    before = [each.inner_text() for each in values]
    other = page.locator('.chart[data-column="vibrator/start.x"] button.value')
    still = other.inner_text()
    assert all(each.endswith(" m") for each in before)
    plane = page.locator('.chart[data-column="vibrator/curve.x"] > svg')
    plane.click()
    after = [each.inner_text() for each in values]
    assert all(one != two for one, two in zip(before, after, strict=True))
    plane.focus()
    page.keyboard.press("Home")
    assert [each.inner_text() for each in values] == before
    assert other.inner_text() == still
