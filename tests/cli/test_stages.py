"""Stage commands: results against the textbook's shaper (KIN-S01, KIN-S05), formats, flags, exit codes."""

from __future__ import annotations

import csv
import io
import json
import math
import re
import tomllib
from pathlib import Path

import pytest
from ready import LINKAGES
from sparing import sparing

from tmmcalc.core.plan import plan
from tmmcalc.project import parse_spec

from .conftest import CONFIGS, Cli
from .scenes import PISTON, PLATFORM

CASES = json.loads((Path(__file__).parents[1] / "cases" / "kinematics.json").read_text(encoding="utf-8"))
CASES = {case["id"]: case for case in (CASES["cases"] if isinstance(CASES, dict) else CASES)}
TABLE = CASES["KIN-S01"]["expected"]["columns"]
STROKES = CASES["KIN-S05"]["expected"]


def test_structure_of_the_shaper(cli: Cli) -> None:
    code, out, err = cli("structure", "my.toml", "--format", "json", "-q")
    assert (code, err) == (0, "")
    found = json.loads(out)
    assert found["mobility"] == 1
    assert found["formula"] == "I(0,1) -> II RPR(2,3) -> II RRP(4,5)"
    assert found["class_number"] == 2
    assert found["columns"]["class"] == ["II", "II"]


def test_class_three_needs_a_word_on_its_assembly(cli: Cli) -> None:
    Path("p.toml").write_text(PLATFORM)
    code, out, _ = cli("structure", "p.toml")
    assert code == 0
    assert "I(0,1) -> III(2,3,4,5)" in out
    code, out, err = cli("kinematics", "p.toml")
    assert (code, out) == (3, "")
    assert "the assembly of III(2,3,4,5) is chosen at an input coordinate" in err
    assert "->" in err
    code, out, _ = cli("structure", "p.toml", "--assemblies", "--set", 'mechanism.input.start="70 deg"')
    assert code == 0
    assert "III(2,3,4,5): the group has" in out
    assert "nothing tells which one is meant: groups after it are not listed" in " ".join(out.split())
    options = ("--set", 'mechanism.input.start="70 deg"', "--set", "mechanism.grid.span=0.1")
    numbered = ("--set", 'mechanism.assembly.variants={ "2-3-4-5" = 1 }')
    code, out, err = cli("kinematics", "p.toml", *options, *numbered)
    assert code == 0, err
    assert "III(2,3,4,5) assembly 1" in out


def test_kinematics_gives_the_table_of_the_textbook(cli: Cli) -> None:
    out = cli("kinematics", "my.toml", "-q", "-f", "json", "--dimensionless").out
    columns = json.loads(out)["columns"]
    assert columns["i"] == [str(k) for k in range(25)]
    for header, key, tolerance in (
        ("angle_3[deg]", "phi3_deg", 1e-5),
        ("angle_4[deg]", "phi4_deg", 1e-5),
        ("S_D[l_1]", "S_over_l1", 2e-6),
        ("omega_3[omega_1]", "om3", 2e-6),
        ("eps_4[omega_1^2]", "ep4", 2e-6),
        ("vS_D[l_1*omega_1]", "vD", 2e-6),
        ("aS_D[l_1*omega_1^2]", "aD", 2e-6),
    ):
        assert columns[header] == pytest.approx(TABLE[key], abs=tolerance), header


def test_kinematics_gives_strokes_and_dead_centres(cli: Cli) -> None:
    found = json.loads(cli("kinematics", "my.toml", "-q", "-f", "json").out)
    assert found["start_angle_1[deg]"] == pytest.approx(STROKES["phi1_extreme_deg"][0], abs=1e-5)
    assert found["dead_centres_D[deg]"] == pytest.approx(STROKES["phi1_extreme_deg"], abs=1e-5)
    assert found["working_D[deg]"] == pytest.approx(STROKES["working_angle_deg"], abs=1e-5)
    assert found["idle_D[deg]"] == pytest.approx(STROKES["idle_angle_deg"], abs=1e-5)
    assert found["K_D"] == pytest.approx(STROKES["time_ratio"], rel=1e-5)
    assert found["stroke_D[m]"] == pytest.approx(STROKES["stroke_m"], abs=1e-6)
    assert found["speed[rad/s]"] == pytest.approx(55 * math.pi / 30, rel=1e-15)


def test_two_step_grid_by_override(cli: Cli) -> None:
    Path("two.toml").write_text(Path("my.toml").read_text().replace("positions = 24", "working = 6\nidle = 4"))
    columns = json.loads(cli("kinematics", "two.toml", "-q", "-f", "json", "--columns", "angle_1").out)["columns"]
    assert columns["angle_1[deg]"] == pytest.approx(STROKES["grid_phi1_deg"], abs=1e-5)


ESTIMATES = ("error estimate", "last digit of the data")


@sparing("name", LINKAGES, every=12)
def test_summary_of_every_ready_spec_fits_80_columns(cli: Cli, name: str) -> None:
    code, out, err = cli("kinematics", str(CONFIGS / f"{name}.toml"), "--no-store", "-q")
    assert (code, err) == (0, "")
    assert max(map(len, out.splitlines())) <= 80
    assert "nan" not in out.lower().split()
    whole = re.sub(r"\n {8,}", " ", out)  # a fact of several lines is one
    noise = [line for line in whole.splitlines() if "e-1" in line and not line.startswith(ESTIMATES)]
    assert not noise
    assert not list(Path().glob("*.out"))


def test_plain_table_reads_well(cli: Cli) -> None:
    out = cli("kinematics", "my.toml", "-q").out
    assert "dead centres of D         angle_1 = -18.81906 and 198.81906 deg\n" in out
    assert "working stroke of D       217.63813 deg of the crank\n" in out
    assert "velocity of D             min -1.433326 m/s at angle_1 = 87.85417 deg\n" in out
    assert "angle 90 deg everywhere" in out
    assert "see my.out/kinematics.csv" in " ".join(out.split())


def test_all_formats_tell_the_same(cli: Cli) -> None:
    args = ("kinematics", "my.toml", "-q", "--columns", "phi,S_D", "--positions", "0:24:6")
    as_json = json.loads(cli(*args, "-f", "json").out)
    as_toml = tomllib.loads(cli(*args, "-f", "toml").out)
    header, *rows = csv.reader(io.StringIO(cli(*args, "-f", "csv").out))
    assert as_json == as_toml
    assert header == ["i", "phi[deg]", "S_D[m]"]
    assert [row[0] for row in rows] == ["0", "6", "12", "18", "24"]
    assert [float(row[2]) for row in rows] == as_json["columns"]["S_D[m]"]


@pytest.mark.parametrize(
    ("asked", "headers"),
    [
        ("phi,omega_3", ["phi[deg]", "omega_3[rad/s]"]),
        ("phi[deg],S_D[m]", ["phi[deg]", "S_D[m]"]),
        ("i, x_C , y_C", ["x_C[m]", "y_C[m]"]),
        ("x_[CD]", ["x_C[m]", "x_D[m]"]),
        ("[xy]_A,phi", ["x_A[m]", "y_A[m]", "phi[deg]"]),
    ],
)
def test_columns(cli: Cli, asked: str, headers: list[str]) -> None:
    answer = cli("kinematics", "my.toml", "-q", "-f", "csv", "--columns", asked)
    assert answer.out.splitlines()[0].split(",") == ["i", *headers]


@sparing(
    ("asked", "labels"),
    [
        ("3", "3"),
        ("6,0", "6 0"),
        ("0:4", "0 1 2 3 4"),
        ("22:", "22 23 24"),
        (":2", "0 1 2"),
        ("0:24:8", "0 8 16 24"),
        ("14:16,0", "14 14' 15 16 0"),
        ("13:17:2", "13 15 17"),
    ],
    every=4,
)
def test_positions(cli: Cli, asked: str, labels: str) -> None:
    args = ("kinematics", "my.toml", "-q", "-f", "json", "--set", "mechanism.grid.extremes=true")
    answer = cli(*args, "--columns", "phi", "--positions", asked)
    assert " ".join(json.loads(answer.out)["columns"]["i"]) == labels


def test_one_position_shows_no_noise(cli: Cli) -> None:
    out = cli("kinematics", "my.toml", "-q", "--columns", "vS_D,omega_3", "--positions", "0").out
    assert out.splitlines()[-1].split() == ["0", "0", "0"]


@pytest.mark.parametrize("method", ["projection", "differences"])
def test_methods_agree(cli: Cli, method: str) -> None:
    args = ("kinematics", "my.toml", "-q", "-f", "json", "--columns", "vS_D,aS_D")
    exact = json.loads(cli(*args).out)["columns"]
    other = json.loads(cli(*args, "--method", method).out)["columns"]
    assert other["vS_D[m/s]"] == pytest.approx(exact["vS_D[m/s]"], abs=1e-3)
    assert other["aS_D[m/s^2]"] == pytest.approx(exact["aS_D[m/s^2]"], abs=8e-3)


def test_compare_prints_both_and_their_difference(cli: Cli) -> None:
    answer = cli("kinematics", "my.toml", "-q", "-f", "json", "--compare", "--method", "differences", "--step", "1 deg")
    columns = json.loads(answer.out)["columns"]
    assert list(columns)[:4] == ["i", "vS_D[m/s]", "vS_D_differences[m/s]", "vS_D_diff[%]"]
    assert 0 < max(map(abs, columns["vS_D_diff[%]"])) < 0.03


def test_study_finds_the_best_step(cli: Cli) -> None:
    found = json.loads(cli("kinematics", "my.toml", "-q", "-f", "json", "--study", "--decimals", "5").out)
    assert found["best_step[deg]"] > 1
    assert "ddS[5 decimals]" in found["columns"]


@sparing(
    ("flags", "said"),
    [
        (("--columns", "omga_3"), "omega_3"),
        (("--columns", ""), "no column is named"),
        (("--positions", "25"), "positions are 0 to 24"),
        (("--positions", "0:99"), "no position is called '99'"),
        (("--positions", "5:2"), "runs backwards"),
        (("--positions", "0:24:0"), "first:last:step"),
        (("--positions", ""), "no position"),
        (("--method", "guess"), "--method"),
        (("--step", "1 deg"), "--method differences"),
        (("--decimals", "4"), "--method differences"),
        (("--method", "differences", "--step", "5 mm"), "is a length"),
        (("--method", "differences", "--step", "0 deg"), "is not above zero"),
        (("--compare",), "--method differences"),
        (("--study", "--compare"), "leave all but one of them out"),
        (("--study", "--columns", "phi"), "leave --columns"),
        (("--from", "nothing"), "no stage is called"),
        (("--set", "mechanism.grid.positions=3"), "override"),
        (("--set", "nonsense"), "override"),
        (("--no-store", "--depfile", "d.mk"), "--no-store"),
        (("--depfile", "no/d.mk"), "there is no folder no"),
        (("-o", "my.toml"), "not a folder"),
    ],
    every=4,
)
def test_wrong_flags(cli: Cli, flags: tuple[str, ...], said: str) -> None:
    code, out, err = cli("kinematics", "my.toml", *flags)
    assert (code, out) == (2, "")
    assert said in err


def test_dimensionless_needs_a_crank(cli: Cli) -> None:
    Path("p.toml").write_text(PISTON)
    code, out, err = cli("kinematics", "p.toml", "--dimensionless", "-q")
    assert (code, out) == (2, "")
    assert "crank length" in err


def test_faults_of_the_spec_leave_nothing_behind(cli: Cli) -> None:
    Path("bad.toml").write_text(Path("my.toml").read_text().replace("mass = 55", "mass = -55"))
    for command in ("structure", "kinematics", "run", "plan", "plot"):
        code, out, err = cli(command, "bad.toml")
        assert (code, out) == (2, "")
        assert "mass" in err
    assert {file.name for file in Path().iterdir()} == {"my.toml", "bad.toml"}


@pytest.mark.parametrize("command", ["structure", "kinematics", "run", "plan", "plot"])
def test_a_folder_or_nothing_in_place_of_the_spec(cli: Cli, command: str) -> None:
    assert cli(command, ".")[:2] == (2, "")
    assert cli(command, "none.toml")[:2] == (2, "")


def test_a_mechanism_that_cannot_turn_is_told_where_it_stops(cli: Cli) -> None:
    crank = 'mechanism.links[id=1].points.A=["700 mm", 0]'
    code, out, err = cli("kinematics", "my.toml", "-q", "--set", crank)
    assert (code, out) == (3, "")
    assert "RRP(4,5)" in err
    assert "290 mm" in err
    # the rod stands upright: C = 1020 mm exp(i psi) is 290 mm below the line y = 1000 mm of the ram, and the
    # crank pin r exp(i psi) is 700 mm from O = (0, 620 mm)
    psi = math.asin(0.71 / 1.02)
    r = 0.62 * math.sin(psi) + math.sqrt((0.62 * math.sin(psi)) ** 2 + 0.7**2 - 0.62**2)
    limit = math.degrees(math.atan2(r * math.sin(psi) - 0.62, r * math.cos(psi)))
    assert f"{limit:.8f}" in err


def test_warnings_fail_under_strict_only(cli: Cli) -> None:
    Path("p.toml").write_text(PISTON.replace('"150 mm"', '"169.99 mm"'))
    code, out, err = cli("kinematics", "p.toml", "-q")
    assert (code, err) == (0, "")
    assert "warning: group RRR(2,3): nearly singular" in out
    for command in ("kinematics", "run"):
        code, out, err = cli(command, "p.toml", "-q", "--strict")
        assert code == 5
        assert "warning: group RRR(2,3)" in out
        assert "2 warnings" in err
    code, out, err = cli("kinematics", "p.toml", "-q", "-f", "csv", "--columns", "phi")
    assert code == 0
    assert "warning" not in out
    assert err.count("warning") == 2


def test_driven_slider(cli: Cli) -> None:
    """Law of cosines at s = 300 mm: cos q = (0.3^2 + 0.1^2 - 0.3^2) / (2 * 0.3 * 0.1)."""
    Path("p.toml").write_text(PISTON.replace('"150 mm"', '"140 mm"'))
    found = json.loads(cli("kinematics", "p.toml", "-q", "-f", "json").out)
    assert found["columns"]["s_piston[m]"][5] == pytest.approx(0.3)
    assert found["columns"]["angle_3[deg]"][5] == pytest.approx(math.degrees(math.acos(1 / 6)))


def test_compare_takes_columns_positions_and_units(cli: Cli) -> None:
    args = ("kinematics", "my.toml", "-q", "-f", "json", "--columns", "omega_3,x_C", "--dimensionless")
    table = json.loads(cli(*args, "--positions", "0:12:6").out)["columns"]
    answer = cli(*args, "--positions", "0:12:6", "--compare", "--method", "projection")
    found = json.loads(answer.out)["columns"]
    assert found["i"] == ["0", "6", "12"]
    for name, values in table.items():
        if name != "i":
            assert found[name] == values
            assert found[name.replace("[", "_projection[")] == pytest.approx(values, abs=1e-14)
    assert len(found) == 1 + 3 * 2


TWO_OUTPUTS = """
[[mechanism.outputs]]
point = "D"
[[mechanism.outputs]]
link = 4
"""


def test_plan_and_study_of_another_output(cli: Cli) -> None:
    text = Path("my.toml").read_text()
    start = text.index("[[mechanism.outputs]]")
    end = text.index("[", start + 25)
    Path("my.toml").write_text(text[:start] + TWO_OUTPUTS + text[end:])
    code, out, err = cli("kinematics", "my.toml", "-q", "-f", "json", "--plan", "--output", "4", "--positions", "0,3,7")
    assert code == 0, err
    found = json.loads(out)
    table = json.loads(cli("kinematics", "my.toml", "-q", "-f", "json", "--positions", "0,3,7").out)
    assert found["output"] == "4"
    assert found["columns"]["4[deg]"] == pytest.approx(table["columns"]["angle_4[deg]"], abs=1e-12)
    assert found["dead_centres[deg]"] == pytest.approx(table["dead_centres_4[deg]"])
    study = json.loads(cli("kinematics", "my.toml", "-q", "-f", "json", "--study", "--output", "4").out)
    assert study["output"] == "4"
    assert cli("kinematics", "my.toml", "-q", "--plan", "--output", "Z")[:2] == (2, "")
    assert cli("kinematics", "my.toml", "-q", "--output", "4")[:2] == (2, "")
    # the dead centres of both outputs become positions
    more = cli("kinematics", "my.toml", "-q", "-f", "json", "--set", "mechanism.grid.extremes=true").out
    at = json.loads(more)["columns"]["angle_1[deg]"]
    for name in ("dead_centres_D[deg]", "dead_centres_4[deg]"):
        for centre in table[name]:
            assert min(abs((each - centre + 180) % 360 - 180) for each in at) < 1e-6


def test_links_and_fixed_points_are_named(cli: Cli) -> None:
    found = json.loads(cli("kinematics", "my.toml", "-q", "-f", "json").out)
    assert found["links_named"]["3"] == "slotted link"
    assert found["frame_points[m]"] == {"O": [0.0, 0.62], "B": [0.0, 0.0]}
    out = cli("kinematics", "my.toml", "-q").out
    assert "1 crank, 2 slider block" in out
    assert "O (0, 0.62), B (0, 0) m" in out


@pytest.mark.parametrize("size", ["1020", '"1020 m"'])
def test_a_size_a_thousand_times_too_large_is_told(cli: Cli, size: str) -> None:
    """Millimetres without their unit: the mechanism does not even assemble, and the cause is told with that."""
    code, _, err = cli("kinematics", "my.toml", "-q", "--set", f"mechanism.links[id=3].points.C=[{size}, 0]")
    assert code == 3
    assert "link 3 measures 1020 m, link 1 0.2 m, 5100 times less" in err


def test_a_size_that_assembles_is_warned_of(cli: Cli) -> None:
    sizes = {"links[id=1].points.A": "0.1", "links[id=2].points.B": "700", "links[id=3].points.B": "700"}
    flags = [f"mechanism.{key}=[{size}, 0]" for key, size in sizes.items()]
    spec = str(Path(__file__).parents[2] / "configs" / "four-bar.toml")
    every = [part for flag in flags for part in ("--set", flag)]
    answer = cli("kinematics", spec, "-q", "--no-store", "-f", "json", *every)
    assert any("is a unit missing" in note for note in json.loads(answer.out)["notes"]), answer.err


def test_assemblies_for_programs_are_numbers(cli: Cli) -> None:
    found = json.loads(cli("structure", "my.toml", "-q", "--assemblies", "-f", "json").out)["columns"]
    assert found["variant"] == [1, -1, 1, -1]
    assert found["taken"] == [True, False, True, False]
    assert found["x_C[m]"][2:] == [None, None]
    assert math.hypot(found["x_C[m]"][0], found["y_C[m]"][0]) == pytest.approx(1.02)


def test_projection_says_what_it_does_not_change(cli: Cli) -> None:
    spec = str(Path(__file__).parents[2] / "configs" / "class-three.toml")
    answer = cli("kinematics", spec, "-q", "--no-store", "--method", "projection", "-f", "json")
    assert any("only dyads differ" in note for note in json.loads(answer.out)["notes"])


def test_run_prints_a_part_for_each_stage(cli: Cli) -> None:
    code, out, err = cli("run", "my.toml")
    assert code == 0
    places = [out.index(f"\n{stage}\n") for stage in plan(parse_spec(Path("my.toml").read_text())).running]
    assert places == sorted(places)
    assert len(places) > 2
    assert out.count("structural formula") == 1
    assert not out.endswith("\n\n")
    assert re.fullmatch(
        r"6 stages computed in [\d.]+ m?s\n"
        r"files in my.out: kinematics.csv, forces.csv, reduction.csv, balance.csv, \d+ files of the stages\n",
        err,
    )
    found = json.loads(cli("run", "my.toml", "-f", "json", "-q").out)
    assert found["structure"]["mobility"] == 1
    assert found["kinematics"]["stroke_D[m]"] == pytest.approx(STROKES["stroke_m"], abs=1e-6)
    assert tomllib.loads(cli("run", "my.toml", "-f", "toml", "-q").out) == found
    rows = dict(csv.reader(io.StringIO(cli("run", "my.toml", "-f", "csv", "-q").out)))
    assert float(rows["kinematics.stroke_D[m]"]) == found["kinematics"]["stroke_D[m]"]


def test_what_was_left_out_is_told_when_asked(cli: Cli) -> None:
    """By default only what nobody expects is told of single stages, -v tells all, -q nothing."""
    told = cli("run", "my.toml", "-v").err
    assert re.search(r"^structure: computed in \d+ ms \(no stored result\)$", told, re.MULTILINE)
    assert "cam_law: left out (no [cam]: no cam is asked for)\n" in told
    assert "files in my.out: structure.toml, kinematics.toml, kinematics.npz, kinematics.csv, " in told
    assert re.fullmatch(r"2 stages loaded in \d+ ms\nfiles in my.out: .*\n", cli("kinematics", "my.toml").err)
    assert re.fullmatch(r"2 stages computed in \d+ ms\n", cli("kinematics", "my.toml", "--no-store").err)
    assert cli("run", "my.toml", "-q").err == ""
    code, out, err = cli("run", "my.toml", "-q", "-v")
    assert (code, out) == (2, "")
    assert err.startswith("error: -q: ")


def test_what_a_failed_stage_takes_with_it_is_told(cli: Cli) -> None:
    code, _, err = cli("run", "my.toml", "--set", 'mechanism.links[id=4].points.D=["29 mm", 0]')
    assert code == 3
    assert "kinematics: no result: the error stands at the end\nforces: left out (it reads kinematics)\n" in err
    assert "no [cam]" not in err
    assert "\n1 stage computed in " in err
    assert "\nfiles in my.out: 1 file of the stages\nerror: kinematics, " in err


def test_run_stops_where_asked(cli: Cli) -> None:
    assert cli("run", "my.toml", "--to", "structure", "-q").code == 0
    assert sorted(file.name for file in Path("my.out").glob("*.toml")) == ["structure.toml"]


@pytest.mark.slow
def test_plot_writes_a_picture(cli: Cli) -> None:
    assert cli("plot", "my.toml", "-q") == (0, "", "")
    assert Path("my.svg").read_bytes().startswith(b"<?xml")
    assert not Path("my.out").exists()


@pytest.mark.parametrize(
    "flags", [("structure",), ("-o", "a.doc"), ("-o", "no/a.svg"), ("--polygons", "77"), ("--positions", "77")]
)
def test_plot_refuses(cli: Cli, flags: tuple[str, ...]) -> None:
    code, out, _ = cli("plot", "my.toml", *flags)
    assert (code, out) == (2, "")
    assert not list(Path().glob("*.svg"))


def test_a_mechanism_without_output_has_no_study(cli: Cli) -> None:
    crank = """
[mechanism.input]
joint = "O"
speed = 1
start = 0
[mechanism.fixed]
O = [0, 0]
[[mechanism.links]]
id = 1
points = { O = [0, 0], A = [1, 0] }
[[mechanism.joints]]
name = "O"
kind = "revolute"
links = [0, 1]
"""
    Path("crank.toml").write_text(crank)
    code, out, err = cli("kinematics", "crank.toml", "-q", "--study")
    assert (code, out) == (3, "")
    assert "no output" in err
    assert "[[mechanism.outputs]]" in err
    assert cli("kinematics", "crank.toml", "-q")[0] == 0


@pytest.mark.slow
def test_a_long_table_shows_some_of_its_positions(cli: Cli) -> None:
    few = cli("kinematics", "my.toml", "--no-store", "--set", "mechanism.grid.positions=5000")
    assert "one position in 3: --positions names others" in few.out
    assert len(few.out.splitlines()) < 2000
    every = cli("kinematics", "my.toml", "--no-store", "-f", "csv", "--set", "mechanism.grid.positions=5000")
    assert len(every.out.splitlines()) == 5002
    assert "one position in" not in cli("kinematics", "my.toml", "--no-store").out


def test_positions_have_room_in_memory(cli: Cli) -> None:
    answer = cli("check", "my.toml", "--set", "mechanism.grid.positions=3000000")
    assert answer.code == 2
    assert "3000000 positions of 12 links and joints take more memory than 2 GB" in answer.err
    assert "write 666666 or less" in answer.err


def test_more_values_than_can_be_printed_are_refused(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tmmcalc.report.positions.PRINTED", 1000)
    answer = cli("kinematics", "my.toml", "--no-store", "-f", "json")
    assert answer.code == 2
    assert "25 positions with" in answer.err
    assert "--columns" in answer.err
