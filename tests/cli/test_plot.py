"""``tmmcalc plot``: stages, their own flags, what is refused."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
from pages import dxf_lines, dxf_words, lines, size
from sparing import sparing

from tmmcalc.core.errors import NoSolutionError

from .conftest import Cli


@sparing(
    ("args", "said"),
    [
        (("reduction", "--polygons", "3"), "--polygons cannot be used with the picture of reduction"),
        (("forces", "--positions", "3"), "--positions cannot be used with the picture of forces"),
        (("forces", "--positions", "3"), "its own flags: --polygons"),
        (("reduction", "--positions", "1", "--polygons", "3"), "--positions and --polygons cannot be used"),
        (("force",), "pictures: synthesis, kinematics, paths, forces, cam_law, cam_synthesis, reduction"),
        (("forces", "--polygons", "3:1"), "'3:1' runs backwards"),
        (("forces", "--polygons", "77"), "no position is called '77'"),
        (("kinematics", "--polygons", "77"), "no position is called '77'"),
    ],
    every=4,
)
def test_what_does_not_belong_is_refused(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli("plot", "my.toml", *args)
    assert (code, out) == (2, "")
    assert said in err
    assert not list(Path().glob("*.svg"))


def test_a_scene_without_loads_has_no_forces_to_draw(cli: Cli) -> None:
    text = Path("my.toml").read_text()
    bare = "\n".join(line for line in text.splitlines() if not line.startswith(("mass", "inertia", "center")))
    Path("bare.toml").write_text(bare)
    code, out, err = cli("plot", "bare.toml", "forces")
    assert (code, out) == (2, "")
    assert "nothing acts on the links" in err


@sparing("stage", ["kinematics", "forces", "reduction"], every=3)
def test_stages_that_the_shaper_has_are_drawn(cli: Cli, stage: str) -> None:
    assert cli("plot", "my.toml", stage, "-o", f"{stage}.svg", "-q") == (0, "", "")
    assert Path(f"{stage}.svg").read_bytes().startswith(b"<?xml")
    assert not Path("my.out").exists()


def test_the_help_tells_every_picture() -> None:
    from tmmcalc.cli.plot import PICTURES, command

    told = command.__doc__ or ""
    assert {"cam_law", "cam_elastic", "indexing"} <= {*PICTURES}
    assert [stage for stage in PICTURES if f"\n{stage}  " not in told] == []


def test_a_run_with_pictures_draws_every_stage_that_has_one(cli: Cli) -> None:
    code, _, err = cli("run", "my.toml", "--to", "forces", "--plots")
    assert code == 0
    assert "kinematics.csv, forces.csv, kinematics.svg, forces.svg, 5 files of the stages\n" in err
    assert {file.name for file in Path("my.out").glob("*.svg")} == {"kinematics.svg", "forces.svg"}
    assert Path("my.out/forces.svg").read_bytes().startswith(b"<?xml")
    assert cli("plot", "my.toml", "kinematics", "-o", "alone.svg", "-q").code == 0
    assert Path("alone.svg").read_bytes() == Path("my.out/kinematics.svg").read_bytes()


def test_a_picture_that_cannot_be_drawn_does_not_stop_the_others(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    code, out, err = cli("plot", "my.toml", "--all", "--polygons", "77")
    assert (code, out) == (2, "")
    assert err.startswith(
        "picture of kinematics: not drawn: the error stands at the end\n"
        "picture of forces: not drawn: the error stands at the end\n"
        "pictures in my.out: reduction.svg, balance.svg\n"
        "error: --polygons: no position is called '77'\n"
    )

    def none(order: object) -> None:
        raise NoSolutionError("nothing to be seen", remedy="look elsewhere")

    monkeypatch.setattr("tmmcalc.linkage.pictures.kinematics.figure", none)
    code, out, err = cli("run", "my.toml", "--to", "forces", "--plots", "-q")
    assert code == 3
    assert "mobility" in out
    assert err.endswith("error: nothing to be seen\n  -> look elsewhere\n")
    assert {file.name for file in Path("my.out").glob("*.svg")} == {"reduction.svg", "balance.svg", "forces.svg"}


def test_all_pictures_of_a_spec_go_into_a_folder(cli: Cli) -> None:
    """Flags go to those pictures that have them; a stage without a solution is told at the end."""
    spec = ("my.toml", "--set", "mechanism.grid.positions=6")
    code, out, err = cli("plot", *spec, "--all", "-o", "of/all", "--polygons", "3")
    assert (code, out) == (0, "")
    assert err == "pictures in of/all: kinematics.svg, forces.svg, reduction.svg, balance.svg\n"
    assert cli("plot", *spec, "forces", "-o", "plain.svg", "-q").code == 0
    assert len(Path("of/all/forces.svg").read_bytes()) > 1.2 * len(Path("plain.svg").read_bytes())
    code, out, err = cli("plot", "my.toml", "--all", "--set", 'mechanism.links[id=4].points.D=["29 mm", 0]')
    assert (code, out) == (3, "")
    assert err.startswith("error: kinematics, ")


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("plot", "my.toml", "forces", "--all"), "--all: draws forces too"),
        (("plot", "my.toml", "--all", "-o", "my.toml"), "my.toml: File exists"),
        (("plot", "my.toml", "-o", "k.bmp"), "no picture format for the suffix '.bmp'"),
        (("run", "my.toml", "--plots", "--no-store"), "--plots: --no-store leaves no folder for pictures"),
    ],
)
def test_what_leads_to_no_picture_is_refused(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli(*args)
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert said in err
    assert not Path("my.out").exists()


@pytest.mark.parametrize(("form", "package", "extra"), [("pdf", "reportlab", "plot"), ("dxf", "ezdxf", "cad")])
def test_without_its_package_nothing_is_computed(
    cli: Cli, form: str, package: str, extra: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tmmcalc.report.drawing.find_spec", lambda name: None)
    code, out, err = cli("plot", "my.toml", "-o", f"my.{form}")
    assert (code, out) == (2, "")
    assert f"pictures as {form} need {package}" in err
    assert f"[{extra}]" in err
    assert not Path(f"my.{form}").exists()
    assert cli("plot", "my.toml", "-o", "my.svg", "-q").code == 0  # which needs none


@pytest.mark.parametrize(("form", "begins"), [("dxf", b"  0\nSECTION"), ("pdf", b"%PDF"), ("png", b"\x89PNG")])
def test_forms_of_a_picture(cli: Cli, form: str, begins: bytes) -> None:
    assert cli("plot", "my.toml", "-o", f"my.{form}", "-q").code == 0
    assert Path(f"my.{form}").read_bytes().startswith(begins)


def test_a_picture_of_a_size_keeps_its_scale(cli: Cli) -> None:
    """At 180 x 120 the crank of 200 mm is as long as the scale factor beside it says."""
    flags = ("--size", "180x120", "-q")
    assert cli("plot", "my.toml", "kinematics", "-o", "small.pdf", *flags) == (0, "", "")
    data = Path("small.pdf").read_bytes()
    assert size(data) == pytest.approx((180, 120), abs=0.01)
    assert cli("plot", "my.toml", "kinematics", "-o", "small.dxf", *flags).code == 0
    (factor,) = re.findall(r"= ([0-9.]+) m/mm", dxf_words(Path("small.dxf").read_bytes()))
    crank = 0.2 / float(factor)
    for lines_of in (lines(data), dxf_lines(Path("small.dxf").read_bytes())):
        assert any(abs(abs(line.end - line.start) - crank) < 0.01 for line in lines_of if line.width > 0.3)


@pytest.mark.parametrize("asked", ["180", "10x10", "180x120x3", "9000x200", "axb"])
def test_a_size_that_is_none_is_refused(cli: Cli, asked: str) -> None:
    code, out, err = cli("plot", "my.toml", "kinematics", "--size", asked)
    assert (code, out) == (2, "")
    assert err.startswith("error: --size: ")


def test_pictures_speak_the_language_and_say_the_title(cli: Cli) -> None:
    text = Path("my.toml").read_text()
    title = tomllib.loads(text)["project"]["title"]
    for name, given in (("flag", ("--language", "uk")), ("spec", ("--set", "sheets={language='uk'}"))):
        assert cli("plot", "my.toml", "kinematics", "-o", f"{name}.svg", "-q", *given) == (0, "", "")
    told = Path("flag.svg").read_text(encoding="utf-8")
    assert 'xml:lang="uk"' in told
    assert title in re.sub("<[^>]*>", "", told)
    assert Path("spec.svg").read_text(encoding="utf-8") == told
    assert cli("plot", "my.toml", "kinematics", "-o", "en.svg", "-q").code == 0
    assert 'xml:lang="en"' in Path("en.svg").read_text(encoding="utf-8")
    assert cli("run", "my.toml", "--to", "forces", "--plots", "--language", "uk", "-q").code == 0
    assert Path("my.out/kinematics.svg").read_text(encoding="utf-8") == told
    code, _, err = cli("run", "my.toml", "--language", "uk")
    assert code == 2
    assert "--language: nothing is drawn" in err
    assert cli("plot", "my.toml", "--language", "de").code == 2
