"""Several machines on a page: the variants of a sweep, several specs."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from page.conftest import Open
from page.opened import slid
from page.scenes import CONFIGS, Fit, command, places, write
from page.test_all import SIZES
from page.test_diagrams import number
from tmmcalc.cli import main
from tmmcalc.core.errors import UsageError
from tmmcalc.page.swept import swept as swept_variants

CRANK = "mechanism.links[id=1].points.A[0]"
LENGTHS = (0.08, 0.1, 0.12)
# of every ghost what brings the axes of its bodies to pixels of the window
GHOSTS = """() => [...document.querySelectorAll("[data-view=kinematics] .ghost")].map((ghost) =>
  [...ghost.children].map((body) => { const m = body.getScreenCTM(); return [m.a, m.b, m.c, m.d, m.e, m.f]; }))"""


@pytest.fixture(scope="module")
def swept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The four-bar linkage with cranks of three lengths."""
    folder = tmp_path_factory.mktemp("swept")
    spec = CONFIGS / "four-bar.toml"
    table, file = folder / "my.csv", folder / "my.html"
    command("sweep", str(spec), "--set", f"{CRANK}={','.join(map(str, LENGTHS))}", "-o", str(table), "--quiet")
    write(spec, file, "--sweep", str(table))
    return file


def test_the_swept_key_is_a_slider(swept: Path, open_page: Open) -> None:
    found = open_page(swept)
    found.move(123.4)
    seen = []
    for k, length in enumerate(LENGTHS):
        found.choose(k)
        label = found.page.locator(".variants").inner_text()
        assert CRANK in label
        assert f"{length:g}" in label
        assert found.at == pytest.approx(123.4, abs=1e-3)
        points, at = found.spots(), found.at
        [true] = places("four-bar", [at], [f"{CRANK}={length}"])
        fit = Fit([*true.values()], [points[name] for name in true])
        assert fit.error < 1e-3 * fit.size
        seen.append(number(found.page.locator(".chart button.value").first.inner_text()))
    assert len(set(seen)) == len(LENGTHS)


@pytest.mark.slow
def test_the_slider_is_dragged_over_all_variants(swept: Path, open_page: Open) -> None:
    """By one hand that does not let go; keys go on from there."""
    found = open_page(swept)
    choice = found.variants
    box = choice.bounding_box()
    mouse, said = found.page.mouse, []
    mouse.move(box["x"] + 8, box["y"] + box["height"] / 2)
    mouse.down()
    for part in (0.5, 1, 0.5, 0):
        mouse.move(box["x"] + 8 + part * (box["width"] - 16), box["y"] + box["height"] / 2, steps=4)
        said.append((choice.input_value(), found.page.locator(".variants").inner_text().split(": ")[1]))
        assert found.page.locator("[data-view=kinematics]").count() == 1
    mouse.up()
    assert said == [(str(k), f"{LENGTHS[k]:g} m") for k in (1, 2, 1, 0)]
    found.page.keyboard.press("ArrowRight")
    assert choice.input_value() == "1"


@pytest.mark.slow
def test_other_variants_are_ghosts(swept: Path, open_page: Open) -> None:
    """They stand where the same variant does when it is shown itself, to the same scale."""
    found = open_page(swept)
    found.choose(1)
    found.move(123.4)
    ghosts = [[np.array(each) for each in machine] for machine in found.page.evaluate(GHOSTS)]
    assert len(ghosts) == len(LENGTHS) - 1
    for machine, k in zip(ghosts, (0, 2), strict=True):
        found.choose(k)
        own = list(found.bodies().values())
        assert len(own) == len(machine)
        for ghost, body in zip(machine, own, strict=True):
            np.testing.assert_allclose(ghost, body, rtol=0, atol=0.05)
    box = found.page.locator("input[name=ghosts]")
    assert box.is_checked()
    box.click()
    assert not found.page.locator(".ghosts").is_visible()


@pytest.mark.slow
def test_what_plays_ends_when_another_is_chosen(swept: Path, open_page: Open) -> None:
    found = open_page(swept)
    found.page.get_by_role("button", name="Play").click()
    found.page.wait_for_timeout(150)
    found.choose(1)
    assert found.page.get_by_role("button", name="Play").count() == 1
    asked = found.page.evaluate(
        """() => new Promise((done) => {
          let count = 0;
          const own = window.requestAnimationFrame;
          window.requestAnimationFrame = (act) => { count += 1; return own.call(window, act); };
          setTimeout(() => done(count), 300);
        })"""
    )
    assert asked <= 1


@pytest.mark.slow
def test_several_specs_are_overlaid(open_page: Open, tmp_path: Path) -> None:
    file = tmp_path / "several.html"
    write(CONFIGS / "four-bar.toml", file, str(CONFIGS / "crank-slider.toml"))
    for size in SIZES:
        found = open_page(file, size=size)
        for k, name in enumerate(("four-bar", "crank-slider")):
            found.choose(k)
            assert name in found.page.locator(".variants").inner_text()
            assert found.page.locator("[data-view=kinematics]").count() == 1
            assert found.page.locator("details.plans option").count() >= 2
            assert found.page.evaluate("document.scrollingElement.scrollWidth <= innerWidth")


@pytest.mark.parametrize(
    ("cells", "rule"),
    [
        ("nothing,status\n1,ok", "no table of a sweep"),
        (f"{CRANK},status\nlong,ok", f"row 2, {re.escape(CRANK)}: 'long' is no number"),
    ],
)
def test_what_is_no_sweep_is_refused(cells: str, rule: str, tmp_path: Path) -> None:
    table = tmp_path / "my.csv"
    table.write_text(cells, encoding="utf-8")
    with pytest.raises(UsageError, match=rule) as refused:
        swept_variants(table)
    assert refused.value.where == "--sweep"


def test_variants_are_called_by_their_values(tmp_path: Path) -> None:
    """As numbers are written elsewhere on the page."""
    table = tmp_path / "my.csv"
    table.write_text("a.one[deg],a.two,a.three[mm],status\n-30,1.2e-05,2.5,ok\n", encoding="utf-8")
    [(name, changed)] = swept_variants(table).variants
    assert name == ["−30°; 0.000012; 2.5 mm", "−30°; 0,000012; 2,5 мм"]
    assert changed == ('a.one="-30 deg"', "a.two=1.2e-05", 'a.three="2.5 mm"')


@pytest.mark.parametrize("key", [CRANK, "mechanism.links[id=1].nothing"])
def test_faults_of_all_variants_are_said(
    key: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Those of stages, and those of the spec; each with its variant."""
    table, page = tmp_path / "my.csv", tmp_path / "my.html"
    table.write_text(f"{key},status\n5,ok\n6,ok\n", encoding="utf-8")
    spec = str(CONFIGS / "four-bar.toml")
    monkeypatch.setattr(
        "sys.argv", ["tmmcalc", "page", spec, "--sweep", str(table), "-o", str(page), "--no-store", "-q"]
    )
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code
    told = capsys.readouterr().err
    assert "error: variant 5: " in told
    assert "error: variant 6: " in told


@pytest.mark.slow
@pytest.mark.parametrize(("name", "view"), [("hydraulic-lift", "kinematics"), ("manipulator", "manipulator")])
def test_views_over_a_way_or_the_time_are_compared_too(name: str, view: str, open_page: Open, tmp_path: Path) -> None:
    """Their units are said in two languages; the place is kept, the machine that is the same stands there."""
    file = tmp_path / "two.html"
    write(CONFIGS / f"{name}.toml", file, str(CONFIGS / f"{name}.toml"))
    found = open_page(file)
    for language in ("en", "uk"):
        found.page.locator("select[name=language]").select_option(language)
        assert found.page.locator(f"[data-view={view}] .ghost").count() == 1
    slider = found.page.locator(f"[data-view={view}] .player input[type=range]").first
    slid(slider, sum(float(slider.get_attribute(end)) for end in ("min", "max")) / 2)
    at = float(slider.input_value())
    found.choose(1)
    assert float(slider.input_value()) == pytest.approx(at)
    assert found.page.locator(f"[data-view={view}] .ghost:not(.lost)").count() == 1


@pytest.mark.slow
def test_specs_of_one_name_are_told_apart_in_both_languages(open_page: Open, tmp_path: Path) -> None:
    """By their folders; that it is a variant is said in the language, what it is called is no word of it."""
    files = [tmp_path / folder / "my.toml" for folder in ("one", "two")]
    for file in files:
        file.parent.mkdir()
        file.write_text((CONFIGS / "four-bar.toml").read_text(encoding="utf-8"), encoding="utf-8")
    write(files[0], tmp_path / "my.html", str(files[1]))
    found = open_page(tmp_path / "my.html")
    others = found.page.locator(".chart .other > title")
    for language, said in (("en", "Variant"), ("uk", "Варіант")):
        found.page.locator("select[name=language]").select_option(language)
        for k, name in enumerate(("one/my", "two/my")):
            found.choose(k)
            assert found.page.locator(".variants").inner_text() == f"{said}: {name}"
            assert found.variants.get_attribute("aria-valuetext") == name
            assert {*others.all_text_contents()} == {("two/my", "one/my")[k]}
