"""Whoever reads it: both languages, light and dark, without a mouse, by a screen reader, who wants nothing to move."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from sparing import sparing

from page.altered import altered
from page.conftest import Open, Written
from page.opened import Opened
from page.scenes import CONFIGS, command, write
from page.test_all import SIZES
from page.test_diagrams import number
from tmmcalc.core.stage import STAGES
from tmmcalc.page.lists import tables
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.document import Document, View

LATIN = re.compile(r"[A-Za-z]{3,}")
# all that the page says of itself: its headings, what is beside its fields, what its buttons are called
CONTROLS = """() => [
  ...[...document.querySelectorAll("h2, legend, label > span, summary, th, .told, .wrong, .nothing, .errors")]
    .map((each) => each.textContent),
  ...[...document.querySelectorAll("[aria-label]:not(.chart > svg), [title]:not(td)")]
    .flatMap((each) => [each.getAttribute("aria-label"), each.title ?? ""]),
  ...[...document.querySelectorAll("svg.scene > title")].map((each) => each.textContent),
].filter(Boolean)"""
FOCUSED = """() => {
  const each = document.activeElement;
  const all = [...document.querySelectorAll("*")];
  const box = each.getBoundingClientRect();
  return [all.indexOf(each), each.tagName, getComputedStyle(each).outlineStyle, box.width * box.height];
}"""
SEEN = "each => each.getBoundingClientRect().top >= 0 && each.getBoundingClientRect().bottom <= innerHeight"
COLOURS = ("ink", "faint", "accent", "blue", "orange", "green", "purple", "olive", "warn")


def channels(colour: str) -> list[int]:
    """Of a colour as #rrggbb or #rgb."""
    digits = colour.strip().lstrip("#")
    digits = "".join(2 * digit for digit in digits) if len(digits) == 3 else digits
    return [int(digits[k : k + 2], 16) for k in (0, 2, 4)]


def luminance(colour: str) -> float:
    """By WCAG 2."""
    parts = (part / 255 for part in channels(colour))
    red, green, blue = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def colours(found: Opened) -> dict[str, str]:
    names = [*COLOURS, "paper", "soft", "warn-soft"]
    read = "names => names.map(name => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`))"
    return dict(zip(names, found.page.evaluate(read, names), strict=True))


@pytest.mark.parametrize("name", ["shaper", pytest.param("cam-translating", marks=pytest.mark.slow)])
def test_the_language_is_switched(name: str, open_page: Open) -> None:
    found = open_page(name)
    page = found.page
    page.evaluate("document.querySelectorAll('details').forEach(each => { each.open = true; })")
    english = page.evaluate(CONTROLS)
    assert "Diagrams" in english
    page.get_by_label("Language").select_option("uk")
    assert page.evaluate("document.documentElement.lang") == "uk"
    ukrainian = page.evaluate(CONTROLS)
    assert len(ukrainian) == len(english)
    assert [text for text in ukrainian if LATIN.search(text)] == []
    if name == "shaper":
        found.move(12.5)
        assert "12,5°" in found.told
        assert re.fullmatch(r"−?[\d,]+(·10\S+)? м", page.locator(".chart button.value").first.inner_text())
    page.get_by_label("Мова").select_option("en")
    if name == "shaper":
        found.move(0)
    assert page.evaluate(CONTROLS) == english


@pytest.mark.slow
def test_variants_of_a_sweep_are_named_in_the_language(open_page: Open, tmp_path: Path) -> None:
    spec, table, file = CONFIGS / "four-bar.toml", tmp_path / "my.csv", tmp_path / "my.html"
    key = "mechanism.links[id=1].points.A[0]"
    command("sweep", str(spec), "--set", f"{key}=82.5 mm:97.5 mm:2", "-o", str(table), "--quiet")
    write(spec, file, "--sweep", str(table))
    page = open_page(file).page
    slider, others = page.locator(".variants input"), page.locator(".chart .other > title")
    assert slider.get_attribute("aria-valuetext") == "82.5 mm"
    assert set(others.all_text_contents()) == {"97.5 mm"}
    page.get_by_label("Language").select_option("uk")
    assert slider.get_attribute("aria-valuetext") == "82,5 мм"
    assert page.locator(".variants").inner_text() == f"{key}: 82,5 мм"
    assert set(others.all_text_contents()) == {"97,5 мм"}
    assert page.locator(".speed option").all_text_contents()[:2] == ["0,1×", "0,25×"]
    page.evaluate("document.querySelectorAll('details').forEach(each => { each.open = true; })")
    said = [text.replace(key, "") for text in page.evaluate(CONTROLS)]
    assert [text for text in said if LATIN.search(text)] == []


@pytest.mark.slow
def test_languages_call_themselves_by_their_own_names(open_page: Open) -> None:
    page = open_page("extra-tie-down").page
    assert page.locator("select[name=language] option").all_text_contents() == ["English", "Українська"]


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_light_and_dark_can_be_read(scheme: str, open_page: Open) -> None:
    found = open_page("shaper", color_scheme=scheme)
    button = found.page.get_by_role("button", name="Light or dark")
    for now in (scheme, {"light": "dark", "dark": "light"}[scheme], scheme):
        of = colours(found)
        assert (luminance(of["paper"]) > 0.5) == (now == "light")
        body = found.page.evaluate("getComputedStyle(document.body).backgroundColor")
        assert body == "rgb({}, {}, {})".format(*channels(of["paper"]))
        assert {
            name: contrast(of[name], of["paper"]) for name in COLOURS if contrast(of[name], of["paper"]) < 4.5
        } == {}
        assert contrast(of["ink"], of["soft"]) > 7
        assert contrast(of["ink"], of["warn-soft"]) > 7
        button.click()


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("motion", ["reduce", "no-preference"])
def test_it_starts_still_and_pause_is_in_sight(size: tuple[int, int], motion: str, open_page: Open) -> None:
    found = open_page("shaper", size=size, reduced_motion=motion)
    page = found.page
    start = found.at
    page.wait_for_timeout(250)
    assert found.at == start
    page.get_by_role("button", name="Play").click()
    found.wait(beyond=start)
    pause = page.get_by_role("button", name="Pause")
    for scrolled in (0, 600, 10_000):  # wherever one reads on
        page.evaluate("(y) => scrollTo(0, y)", scrolled)
        page.wait_for_function(SEEN, arg=pause.element_handle())
    pause.click()
    stopped = found.at
    page.wait_for_timeout(150)
    assert found.at == stopped


def _named(page: Any) -> list[tuple[str, str]]:
    """Role and name of all that a screen reader can reach."""
    tree = page.context.new_cdp_session(page).send("Accessibility.getFullAXTree")
    found = []
    for node in tree["nodes"]:
        if not node.get("ignored"):
            found.append((node["role"]["value"], node.get("name", {}).get("value", "")))
    return found


@sparing("name", ["extra-tie-down", "shaper", "press"], every=3)
def test_everything_has_a_name_for_a_screen_reader(name: str, open_page: Open) -> None:
    found = open_page(name)
    page = found.page
    page.evaluate("document.querySelectorAll('details').forEach(each => { each.open = true; })")
    reached = _named(page)
    used = {
        "button",
        "combobox",
        "checkbox",
        "slider",
        "searchbox",
        "image",
        "img",
        "heading",
        "group",
        "DisclosureTriangle",
    }
    unnamed = [role for role, called in reached if role in used - {"group"} and not called.strip()]
    assert unnamed == []
    roles = {role for role, _ in reached}
    assert {"main", "heading", "button", "combobox", "searchbox"} <= roles
    if name != "extra-tie-down":
        assert {"slider", "checkbox"} <= roles
    assert page.evaluate("document.querySelectorAll('main').length") == 1
    assert page.evaluate("document.querySelectorAll('h1').length") == 1


def test_tab_goes_through_all_in_the_order_of_reading(open_page: Open) -> None:
    found = open_page("shaper")
    page = found.page
    expected = page.evaluate(
        """() => [...document.querySelectorAll("button, input, select, summary, [tabindex]")]
          .filter((each) => each.checkVisibility() && !each.disabled && each.tabIndex >= 0).length"""
    )
    seen = []
    for _ in range(expected + 3):
        page.keyboard.press("Tab")
        at, tag, outline, area = page.evaluate(FOCUSED)
        if tag == "BODY":
            break
        seen.append(at)
        assert outline != "none"
        assert area > 0
    assert seen == sorted(seen)
    assert len(seen) == expected


def test_print_leaves_the_controls_out(open_page: Open) -> None:
    found = open_page("shaper")
    page = found.page
    page.emulate_media(media="print")
    assert page.locator(".player:visible, nav:visible, .adding:visible").count() == 0
    assert page.locator("svg.scene:visible").count() == 1
    assert page.locator(".chart:visible").count() >= 2
    assert page.locator(".told:visible").count() == 1


@pytest.mark.slow
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_print_has_the_colours_of_paper(scheme: str, open_page: Open) -> None:
    """Whatever is chosen on the screen, and by the system."""
    found = open_page("shaper", color_scheme=scheme)
    lit = colours(found) if scheme == "light" else {}
    button = found.page.get_by_role("button", name="Light or dark")
    for _ in range(3):
        found.page.emulate_media(media="print")
        of = colours(found)
        assert channels(of["paper"]) == [255, 255, 255]
        assert all(contrast(of[name], of["paper"]) > 4.5 for name in COLOURS)
        assert luminance(of["warn-soft"]) > 0.8
        if lit:
            assert {name: of[name] for name in ("blue", "orange", "green", "purple", "olive", "warn")} == {
                name: lit[name] for name in ("blue", "orange", "green", "purple", "olive", "warn")
            }
        found.page.emulate_media(media="screen")
        button.click()


@pytest.mark.slow
def test_what_is_folded_is_printed_and_folded_again(open_page: Open) -> None:
    page = open_page("shaper").page
    folded = page.locator("details:not([open])")
    before = folded.count()
    assert before > 3
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    assert folded.evaluate_all("all => all.map((each) => each.className).sort()") == ["plans", "source"]
    assert page.locator("details.given tbody tr:visible").count() > 5
    assert page.locator("details.stage").evaluate_all("all => all.every((each) => each.open)")
    page.emulate_media(media="screen")
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert folded.count() == before


@pytest.mark.slow
def test_print_tells_where_the_point_of_shifts_is(open_page: Open) -> None:
    page = open_page("pair-blocking").page
    page.emulate_media(media="print")
    assert page.locator(".trial .player:visible").count() == 0
    told = page.locator(".trial .told")
    assert told.count() == page.locator(".trial .told:visible").count() > 0
    assert "within the" in told.first.inner_text()
    refusal = page.locator(".trial .wrong").first
    assert not refusal.is_visible()
    page.emulate_media(media="screen")
    plane = page.locator(".plane").first
    plane.focus()
    for _ in range(200):
        plane.press("ArrowDown")
        if refusal.inner_text():
            break
    page.emulate_media(media="print")
    assert refusal.is_visible()


def test_results_are_told_in_words(open_page: Open) -> None:
    """Truth values, names of methods and formulas stand among the numbers, and are found by their words."""
    page = open_page("shaper").page

    def value(fact: str) -> str:
        return str(page.locator(f"[data-fact='{fact}'] button.value").text_content())

    assert value("structure.formula").startswith("I(0,1) → II RPR(2,3)")
    assert value("kinematics.assembles_everywhere") == "yes"
    assert value("motion.stability") == "stable"
    page.locator("select[name=language]").select_option("uk")
    assert value("kinematics.assembles_everywhere") == "так"
    assert value("motion.stability") == "стійкий"
    page.locator(".find input").fill("стійкий")
    assert page.locator("[data-fact='motion.stability']").is_visible()
    assert not page.locator("[data-fact='structure.formula']").is_visible()


@pytest.mark.slow
def test_the_page_is_lit_as_the_system_is_until_it_is_chosen(open_page: Open) -> None:
    page = open_page("extra-tie-down", color_scheme="light").page
    root = page.locator(":root")
    for scheme in ("dark", "light"):
        page.emulate_media(color_scheme=scheme)
        page.wait_for_function("(scheme) => document.documentElement.dataset.theme === scheme", arg=scheme)
        assert root.evaluate("each => getComputedStyle(each).colorScheme") == scheme
    page.get_by_role("button", name="Light or dark").click()
    for scheme in ("dark", "light"):
        page.emulate_media(color_scheme=scheme)
        assert root.get_attribute("data-theme") == "dark"


@pytest.mark.slow
def test_numbers_keep_their_powers_and_counts_their_digits(written: Written, open_page: Open, tmp_path: Path) -> None:
    numbers = {8.50541e-10: "8.50541·10⁻¹⁰", -3e20: "−3·10²⁰", 1.25e-100: "1.25·10⁻¹⁰⁰", 120.0: "120", 0.5: "0.5"}

    def changed(content: Any) -> None:
        facts = content["scenes"][0]["stages"][-1]["facts"]
        asked = [*((value, "m") for value in numbers), (78074900, ""), ("−1/4", "")]
        for fact, (value, unit) in zip(facts, asked, strict=False):
            fact.update(value=value, unit=unit)

    page = open_page(altered(written("four-bar"), tmp_path / "numbers.html", changed)).page
    page.locator("details.stage").last.evaluate("(part) => { part.open = true; }")
    found = page.locator("details.stage").last.locator("tr[data-fact] .value").all_inner_texts()
    assert found[:7] == [*(f"{text} m" for text in numbers.values()), "78074900", "−1/4"]


@pytest.mark.slow
def test_a_stage_that_failed_says_why(open_page: Open, tmp_path: Path) -> None:
    file = tmp_path / "failed.html"
    spec = CONFIGS / "extreme" / "never-assembles.toml"
    with pytest.raises(AssertionError):  # the command ends with an error, and writes what there is
        write(spec, file)
    page = open_page(file).page
    said = page.locator('[data-stage="kinematics"] .warning')
    assert "cannot be assembled at any crank angle" in said.inner_text()
    assert "-> " in said.inner_text()  # signs stay as the command has them
    assert page.locator('[data-fact="structure.mobility"]').is_visible()


@pytest.mark.slow
def test_texts_have_the_signs_of_print(open_page: Open) -> None:
    page = open_page("geared-press").page
    warnings = " ".join(page.locator(".warning").all_inner_texts())
    assert "N·m" in warnings
    assert not re.search(r"N\*m|\d deg\b|->", page.locator(".results").inner_text())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "stage"), [("cam-oscillating", "cam_strength"), ("pair-blocking", "pair"), ("rotor", "balance")]
)
def test_tables_of_summaries_stand_among_the_results(name: str, stage: str, open_page: Open) -> None:
    """Checks with their limits, several pairs, states: as the command prints them."""
    true = STAGES[stage].summary(run(load_spec(CONFIGS / f"{name}.toml"), target=[stage]).results[stage], "").table
    page = open_page(name).page
    part = page.locator(f'details.stage[data-stage="{stage}"]')
    part.evaluate("(part) => { part.open = true; }")
    rows = [row.split("\t") for row in part.locator(".list tbody").inner_text().split("\n")]
    assert len(rows) == len(true.columns[0])
    assert len(rows[0]) == len(true.headers)
    for k, column in enumerate(true.columns):
        for cell, row in zip(column, rows, strict=True):
            if isinstance(cell, float):
                assert number(row[k]) == pytest.approx(cell, rel=6e-5)
            elif cell:
                assert str(cell).replace("*", "·").split(" = ")[-1] in row[k].replace("−", "-")
    page.get_by_label("Language").select_option("uk")
    assert not LATIN.search(" ".join(part.locator(".list :is(td, th:not(.sign))").all_inner_texts()))


def test_values_in_tables_are_written_as_elsewhere() -> None:
    cells = ["beta = -30 deg", "1.2e-05", "2.5 mm", "1.2.3"]
    [table] = tables(Document("", table=View(["value", "no."], [cells, [1, 2, 3, 4]], [0.0, 0.0])))
    told = [row["cells"] for row in table["columns"]]
    assert told[0] == ["β = −30°", ["0.000012", "0,000012"], ["2.5 mm", "2,5 мм"], "1.2.3"]


@pytest.mark.slow
def test_what_moves_stays_beside_what_is_read(open_page: Open) -> None:
    """All of it where the window has room, else its end; on a phone it goes with the page."""
    seen = """(y) => {
      scrollTo(0, y);
      const box = document.querySelector(".moving").getBoundingClientRect();
      return [scrollY, box.top, box.bottom];
    }"""
    for size, whole in (((1500, 1000), True), ((1500, 600), False), ((390, 1000), None)):
        page = open_page("class-four", size=size).page
        page.evaluate("document.querySelectorAll('.results details').forEach((each) => { each.open = true; })")
        page.wait_for_timeout(50)
        scrolled, top, bottom = page.evaluate(seen, 2500)
        assert scrolled == 2500
        if whole is None:
            assert bottom < 0
        else:
            assert bottom <= size[1]
            assert (top >= 0) == whole
            assert whole or bottom > size[1] - 20
