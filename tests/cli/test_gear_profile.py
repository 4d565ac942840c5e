"""``tmmcalc gears profile``: documents, flags, and the files that it draws."""

from __future__ import annotations

import csv
import io
import json
import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from sparing import sparing

from .conftest import Cli

BOOK = '[pair]\nteeth = [13, 30]\nmodule = "5 mm"\nx1 = 0.25\nx2 = 0.15\nfillet = "circle"\n'
THREE = """[pair]
module = "5 mm"
refuse = false
[[pair.meshes]]
name = "spur"
teeth = [10, 30]
x1 = 0.0
x2 = 0.0
helix_angle = "15 deg"
[[pair.meshes]]
name = "ring"
teeth = [20, 60]
kind = "internal"
[[pair.meshes]]
name = "rack"
teeth = [14]
kind = "rack"
x1 = 0.3
"""
PROFILE = ("gears", "profile")


@pytest.fixture
def book() -> str:
    Path("book.toml").write_text(BOOK)
    return "book.toml"


@pytest.fixture
def three() -> str:
    Path("three.toml").write_text(THREE)
    return "three.toml"


def columns(text: str) -> dict[str, list[str]]:
    header, *rows = csv.reader(io.StringIO(text))
    return dict(zip(header, map(list, zip(*rows, strict=True)), strict=True))


def test_table_of_the_textbook(cli: Cli, book: str) -> None:
    code, out, _ = cli(*PROFILE, book, "--axis", "pitch", "--wheel", "1", "--intervals", "4")
    assert code == 0
    assert "phi_L = -0.359013, phi_D = -0.0969253, phi_A = 0.410741 rad" in out
    rows = [line.split() for line in out.splitlines()]
    assert ["A", "0.410741", "3.62248", "7.92231", "23.6597"] in rows
    assert ["L", "-0.359013", "-0.66194", "-0.00680", "0.1514"] in rows
    assert "wheel 2" not in out
    assert max(map(len, out.splitlines())) <= 80
    assert Path("book.out/profile.csv").is_file()


def test_all_points_in_metres(cli: Cli, book: str) -> None:
    found = columns(cli(*PROFILE, book, "-q", "-f", "csv", "--points", "30").out)
    assert list(found) == ["wheel", "part", "phi[rad]", "x[m]", "y[m]", "R[m]"]
    assert found["part"].count("involute") == found["part"].count("fillet") == 60
    stored = columns(Path("book.out/profile.csv").read_text())
    assert stored == found
    payload = json.loads(cli(*PROFILE, book, "-q", "-f", "json", "--wheel", "2").out)
    assert payload["wheel 2"]["r_f[m]"] == pytest.approx(0.0695)
    assert payload["wheel 2"]["main profile"]["columns"]["point"][0] == "A"
    assert set(payload["columns"]["wheel"]) == {"2"}
    assert 'kind = "external"' in cli(*PROFILE, book, "-q", "-f", "toml").out


def test_tables_in_metres(cli: Cli, book: str) -> None:
    out = cli(*PROFILE, book, "-q", "-f", "csv", "--wheel", "1", "--fillet", "-0.4:0:0.1", "--axis", "pitch").out
    found = columns(out)
    fillet = [k for k, table in enumerate(found["table"]) if table == "fillet"]
    assert [found["phi[rad]"][k] for k in fillet[:5]] == ["-0.4", "-0.3", "-0.2", "-0.1", "0.0"]
    assert [found["cut"][k] for k in fillet] == ["no", "yes", "yes", "yes", "no", "yes", "yes"]
    assert [found["point"][k] for k in fillet[-2:]] == ["L", "D"]
    assert found["X_S[m]"][0] == ""


@pytest.mark.slow
def test_files_of_pairs_in_mesh(cli: Cli, three: str) -> None:
    flags = ("--svg", "a.svg", "--outline", "a.csv", "--phase", "5 deg")
    code, out, err = cli(*PROFILE, three, *flags)
    assert code == 0
    assert "wrote a.svg and a.csv" in err
    assert "yes: the involute begins" in out
    assert "above the datum line" in out
    paths = ElementTree.parse("a.svg").getroot().findall(".//{http://www.w3.org/2000/svg}path")
    assert [path.get("id") for path in paths] == ["spur/1", "spur/2", "ring/1", "ring/2", "rack/1", "rack/2"]
    found = columns(Path("a.csv").read_text())
    x, y = (np.array(found[header], float) for header in ("x[m]", "y[m]"))
    tooth = (np.array(found["pair"]) == "spur") & (np.array(found["wheel"]) == "1")
    tip = json.loads(cli(*PROFILE, three, "-q", "-f", "json").out)["wheel spur/1"]["r_a[m]"]
    assert np.hypot(x, y)[tooth].max() == pytest.approx(tip, rel=1e-12)
    before = Path("a.svg").stat()
    assert cli(*PROFILE, three, *flags).code == 0
    assert Path("a.svg").stat() == before
    assert cli(*PROFILE, three, *flags[:-1], "6 deg").code == 0
    assert Path("a.svg").stat() != before


@pytest.mark.slow
def test_one_wheel_stands_upright(cli: Cli, three: str) -> None:
    assert cli(*PROFILE, three, "--wheel", "ring/2", "--outline", "ring.csv", "--tolerance", "1 um").code == 0
    found = columns(Path("ring.csv").read_text())
    places = np.array(found["x[m]"], float) + 1j * np.array(found["y[m]"], float)
    inner = np.abs(places).min()
    # the tooth of a ring on +Y: its tip circle crosses the axis
    assert np.abs(places[np.argmin(np.abs(places - 1j * inner))] - 1j * inner) < 0.003
    assert cli(*PROFILE, three, "--wheel", "spur/1", "--outline", "one.csv", "--tooth").code == 0
    one = columns(Path("one.csv").read_text())
    x = np.array(one["x[m]"], float)
    assert x[0] == pytest.approx(-x[-1], rel=1e-12)


def test_dxf(cli: Cli, book: str) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    assert cli(*PROFILE, book, "--dxf", "a.dxf").code == 0
    drawing = ezdxf.readfile("a.dxf")
    assert drawing.header["$INSUNITS"] == 4
    assert {"wheel 1", "wheel 2"} <= {layer.dxf.name for layer in drawing.layers}
    assert len(drawing.modelspace().query('SPLINE[layer=="wheel 1"]')) == 26
    before = Path("a.dxf").stat()
    assert cli(*PROFILE, book, "--dxf", "a.dxf", "--fresh").code == 0
    assert Path("a.dxf").stat() == before


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--svg", "nowhere/a.svg", "--outline", "a.csv"), "--svg: there is no folder nowhere"),
        (("--svg", ".", "--outline", "a.csv"), "is a folder"),
        (("--svg", "a.csv", "--outline", "a.csv"), "two formats"),
        (("--outline", "a.csv", "--wheel", "9"), "wheels: 1, 2"),
        (("--outline", "a.csv", "--wheel", "1", "--phase", "1 deg"), "not in mesh"),
        (("--outline", "a.csv", "--tolerance", "1 deg"), "--tolerance"),
        (("--outline", "a.csv", "--tolerance", "0 mm"), "above zero"),
        (("--outline", "a.csv", "--tolerance", "1e-12 m"), "too fine"),
        (("--outline", "a.csv", "--phase", "1 mm"), "--phase"),
        (("--outline", "a.csv", "--fillet", "1:2"), "first:last:step"),
        (("--outline", "a.csv", "--fillet", "0:1:-1"), "upward"),
        (("--outline", "a.csv", "--fillet", "0:1:1e-9"), "rows"),
        (("--tooth",), "no file to draw into"),
        (("--tolerance", "1 um"), "no file to draw into"),
    ],
)
def test_nothing_is_drawn_on_an_error(cli: Cli, book: str, flags: tuple[str, ...], said: str) -> None:
    code, out, err = cli(*PROFILE, book, *flags)
    assert (code, out) == (2, "")
    assert said in err
    assert not Path("a.csv").exists()


def test_fillet_over_rolls_is_refused_where_it_is_none(cli: Cli, three: str) -> None:
    code, out, err = cli(*PROFILE, three, "--wheel", "ring/2", "--fillet", "-0.4:0:0.1", "-q")
    assert (code, out) == (2, "")
    assert "--wheel" in err
    assert cli(*PROFILE, three, "--wheel", "ring/1", "--fillet", "-0.4:0:0.1", "-q").code == 0
    code, out, _ = cli(*PROFILE, three, "--wheel", "spur/1", "--fillet", "-0.4:0:0.1", "-q")
    assert code == 0
    assert "fillet of a circular rounding" in out
    assert "in place of the ellipse" in out
    assert max(map(len, out.splitlines())) <= 80


def test_main_profile_over_rolls(cli: Cli, book: str) -> None:
    out = cli(*PROFILE, book, "-q", "-f", "csv", "--wheel", "1", "--rolls=-0.3:0.4:0.1").out
    found = columns(out)
    main = [float(phi) for phi, table in zip(found["phi[rad]"], found["table"], strict=True) if table == "main"]
    assert main[1:-1] == pytest.approx([0.4, 0.3, 0.2, 0.1, 0.0, -0.1, -0.2, -0.3], abs=1e-12)
    code, _, err = cli(*PROFILE, book, "--rolls", "1:2")
    assert code == 2
    assert "--rolls" in err


def test_missing_extra_is_said_before_anything_runs(cli: Cli, book: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    code, _, err = cli(*PROFILE, book, "--dxf", "a.dxf", "--svg", "a.svg")
    assert code == 2
    assert "[cad]" in err
    assert not Path("book.out").exists()
    assert not Path("a.svg").exists()


def test_warnings_end_a_strict_command_before_files_are_written(cli: Cli) -> None:
    Path("sharp.toml").write_text('[pair]\nteeth = [8, 40]\nmodule = "5 mm"\nx1 = 0.75\nx2 = 0.0\nrefuse = false\n')
    code, out, err = cli(*PROFILE, "sharp.toml", "--svg", "a.svg", "--strict")
    assert code == 5
    assert "warning: wheel 1 is pointed at the radius" in out
    assert "pointed" in err
    assert not Path("a.svg").exists()
    assert cli(*PROFILE, "sharp.toml", "--svg", "a.svg").code == 0


def test_spec_without_a_pair(cli: Cli) -> None:
    code, _, err = cli(*PROFILE, "my.toml", "--points", "20")
    assert code == 2
    assert "[pair]" in err


UNSOUND = """[pair]
module = "2 mm"
refuse = false
[[pair.meshes]]
teeth = [5, 5]
x1 = -1
x2 = 2
[[pair.meshes]]
teeth = [20, 30]
x1 = 0
x2 = 0
"""
LACK = "wheel pair 1/1: the tip circle lies below the beginning of the involute: 4.44453 mm against 5.41737 mm"


@pytest.fixture
def unsound() -> str:
    Path("unsound.toml").write_text(UNSOUND)
    return "unsound.toml"


def test_sound_wheels_are_drawn_and_the_others_named(cli: Cli, unsound: str) -> None:
    code, out, _ = cli(*PROFILE, unsound, "--svg", "all.svg", "--outline", "all.csv")
    assert code == 0
    assert "wheel pair 1/1 has no profile" in " ".join(out.split())
    named = columns(Path("all.csv").read_text())
    assert set(zip(named["pair"], named["wheel"], strict=True)) == {("pair 1", "2"), ("pair 2", "1"), ("pair 2", "2")}
    code, _, err = cli(*PROFILE, unsound, "--wheel", "pair 1/1", "--svg", "one.svg")
    assert code == 3
    assert LACK in " ".join(err.split())
    assert not Path("one.svg").exists()


@pytest.mark.slow
@sparing("stage", ["pair", "profile"], every=2)
def test_sheets_of_sound_wheels(cli: Cli, unsound: str, stage: str) -> None:
    assert cli("plot", unsound, stage, "-o", "sheets.svg")[0] == 0
    assert Path("sheets.svg").exists()
    code, _, err = cli("plot", unsound, "pair", "--choose", "1", "-o", "one.svg")
    assert code == 3
    assert LACK in " ".join(err.split())


def test_names_are_refused_before_anything_is_computed(cli: Cli, three: str) -> None:
    for command, flag, said in ((PROFILE, "--wheel", "no wheel '9'"), (("gears", "pair"), "--pair", "'9'")):
        code, _, err = cli(*command, three, flag, "9")
        assert code == 2
        assert said in err
        assert "computed" not in err
    assert not Path("three.out").exists()
    assert "ring/2" in cli(*PROFILE, three, "--wheel", "9")[2]


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--phase", "1e15 deg"), "more than 100 turns"),
        (("--tolerance", "1 m"), "too coarse for the module of 5 mm"),
        (("--tolerance", "1e-9 mm"), "too fine for the module of 5 mm"),
    ],
)
def test_flags_beyond_all_sense(cli: Cli, book: str, flags: tuple[str, str], said: str) -> None:
    code, _, err = cli(*PROFILE, book, "--svg", "a.svg", *flags)
    assert code == 2
    assert said in " ".join(err.split())
    assert not Path("a.svg").exists()
