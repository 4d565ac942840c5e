"""``tmmcalc names``, and the same names in sweeps and constraints, as a user writes them."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from tmmcalc.rooms import STAGES

from .conftest import CONFIGS, Cli

COUNT = 821  # of configs/course-project.toml: 518 facts, 303 columns of tables
SHAPER = CONFIGS / "shaper.toml"
CRANK = "mechanism.links[id=1].points.A[0]"


def rows(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


@pytest.mark.slow
def test_all_that_a_project_can_tell(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    listed = rows(cli("names", str(CONFIGS / "course-project.toml"), "-f", "csv").out)
    told = [row for row in listed if not row["how"].endswith("by choice")]
    assert len(told) == COUNT
    assert len({(row["name"], row["how"]) for row in told}) == COUNT  # criteria.mass is a fact and a column
    choice = {row["name"] for row in listed} - {row["name"] for row in told}
    assert {"kinematics.vrel_B_A", "forces.Pi_3", "forces.warnings", "forces.counters.dense"} < choice
    assert not {row["name"] for row in listed if row["min"]} & choice  # no column by choice was made
    order = [[*STAGES].index(row["name"].partition(".")[0]) for row in listed]
    assert order == sorted(order)
    named = {row["name"]: row for row in listed}
    assert named["kinematics.S_D"]["meaning"] == "displacement of output D from position 0"
    assert named["kinematics.stroke_D"]["unit"] == "m"
    motions = [name for name in named if name.startswith("transient.") and name.endswith(".end_time")]
    assert motions == ["transient.start-up.end_time", "transient.emergency stop.end_time"]
    assert sum(bool(row["meaning"]) for row in listed) > 0.9 * len(listed)


def test_names_and_patterns(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    asked = ("motion.delta", "forces.R_A", "forces.max(R_A)@2..12", "kinematics.vS_D[phi=50 deg]")
    found = {row["name"]: row for row in rows(cli("names", str(SHAPER), *asked, "-f", "csv").out)}
    assert set(found) == set(asked)
    assert float(found["forces.R_A"]["max"]) == float(found["forces.max(R_A)@2..12"]["value"])
    assert found["kinematics.vS_D[phi=50 deg]"]["how"] == "computed there"
    people = cli("names", str(SHAPER), "motion.*").out
    assert "motion.delta" in people
    told = json.loads(cli("names", str(SHAPER), "motion.delta", "-f", "json").out)
    assert told["columns"]["name"] == ["motion.delta"]


@pytest.mark.slow
def test_every_motion_has_facts_of_its_own(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    asked = '[[constraints]]\nname = "q"\nvalue = "transient.run-down.end_time"\nat_most = "6 s"\n'
    Path("e.toml").write_text((CONFIGS / "elastic-drive.toml").read_text() + asked)
    found = {row["name"]: float(row["value"]) for row in rows(cli("names", "e.toml", "*.end_time", "-f", "csv").out)}
    motions = json.loads(cli("transient", "e.toml", "-f", "json").out)
    ends = [motions[name]["end_time[s]"] for name in ("start-up", "run-down", "emergency stop")]
    assert [*found] == [f"transient.{name}.end_time" for name in ("start-up", "run-down", "emergency stop")]
    assert [*found.values()] == pytest.approx(ends, rel=1e-12)
    judged = json.loads(cli("feasibility", "e.toml", "-f", "json").out)
    assert [float(value) for value in judged["columns"]["value"]] == pytest.approx([ends[1]])
    end = cli("names", "e.toml", "transient.end_time")
    assert (end.code, "start-up.end_time, run-down.end_time" in end.err) == (2, True)


@pytest.mark.parametrize(
    ("pattern", "words"),
    [("motion.dleta", "did you mean delta"), ("forces.max(R_Z)", "did you mean R_"), ("mx(R_A)", "did you mean max?")],
)
def test_the_nearest_names_are_told(cli: Cli, pattern: str, words: str) -> None:
    end = cli("names", str(SHAPER), pattern, "--no-store")
    assert end.code == 2
    assert words in end.err


def test_a_sweep_has_the_same_columns(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    asked = "kinematics.S_D@12,kinematics.vS_D[phi=50 deg],forces.max(R_A)@2..12,forces.at_max(R_A),max(R_A)"
    cli("sweep", str(SHAPER), "--set", f"{CRANK}=*0.95:1.05:3", "--columns", asked, "-o", "t.csv", "-q")
    table = rows((tmp_path / "t.csv").read_text())
    header = list(table[0])
    assert header[1:6] == [
        "kinematics.S_D@12[m]",
        "kinematics.vS_D[phi=50 deg][m/s]",
        "forces.max(R_A)@2..12[N]",
        "forces.at_max(R_A)[deg]",
        "forces.max(R_A)[N]",
    ]
    middle = rows(cli("names", str(SHAPER), *asked.split(","), "-f", "csv").out)
    for row in middle:
        key = f"{row['name']}[{row['unit']}]"
        assert float(table[1][key]) == pytest.approx(float(row["value"]), rel=1e-11)


def test_a_row_is_solved_together_as_alone(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    ranged = ("--set", f"{CRANK}=*0.95:1.05:33", "--columns", "kinematics.S_D@12,forces.rms(R_A)", "-q")
    cli("sweep", str(SHAPER), *ranged, "-o", "many.csv")
    cli("sweep", str(SHAPER), "--set", f"{CRANK}=*0.95:1.05:3", *ranged[2:], "-o", "few.csv")
    many, few = (rows((tmp_path / name).read_text()) for name in ("many.csv", "few.csv"))
    for key in ("kinematics.S_D@12[m]", "forces.rms(R_A)[N]"):
        assert float(many[16][key]) == pytest.approx(float(few[1][key]), rel=1e-11)


def test_constraints_by_name(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    lines = {
        "old": 'stage = "forces"\ncolumn = "R_A"\nof = "max"\nat_most = "20 kN"',
        "new": 'value = "forces.max(R_A)"\nat_most = "20 kN"',
        "mixed": 'stage = "forces"\nvalue = "max(R_A)"\nat_most = "20 kN"',
        "lone": 'value = "max(R_A)"\nat_most = "20 kN"',
        "there": 'value = "kinematics.vS_D[phi=50 deg]"\nat_most = "0 m/s"',
        "some": 'value = "forces.max(R_A)@2..12"\nat_most = "20 kN"',
        "delta": 'value = "delta"\nat_most = 0.1',
    }
    text = SHAPER.read_text().partition("[[constraints]]")[0]
    spec = tmp_path / "my.toml"
    spec.write_text(text + "".join(f'\n[[constraints]]\nname = "{name}"\n{line}\n' for name, line in lines.items()))
    found = {row["constraint"]: row for row in rows(cli("feasibility", str(spec), "-f", "csv", "--no-store").out)}
    assert len({found[name]["value"] for name in ("old", "new", "mixed", "lone", "some")}) == 1
    names = ("kinematics.vS_D[phi=50 deg]", "motion.delta")
    told = {row["name"]: row["value"] for row in rows(cli("names", str(SHAPER), *names, "-f", "csv").out)}
    assert float(found["there"]["value"]) == pytest.approx(float(told[names[0]]), rel=1e-6)
    assert float(found["delta"]["value"]) == pytest.approx(float(told[names[1]]), rel=1e-6)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ('value = "forces.mx(R_A)"\nat_most = 1', "did you mean max?"),
        ('value = "forces.max(R_*)"\nat_most = 1', "may name several results"),
        ('value = "forces.max(R_A)"\nof = "max"\nat_most = 1', "of together with a value that is a name"),
        ('value = "forces.max(R_Q)"\nat_most = 1', "forces tells no 'R_Q'"),
        ('value = "max(phi)"\nat_most = 1', "is told by several stages"),
        ('value = "motion.delta"\nat_most = "1 m"', "cannot be compared"),
    ],
)
def test_a_wrong_name_in_a_constraint_is_one_error(cli: Cli, tmp_path: Path, line: str, words: str) -> None:
    spec = tmp_path / "my.toml"
    text = SHAPER.read_text().partition("[[constraints]]")[0]
    spec.write_text(f'{text}\n[[constraints]]\nname = "calm"\n{line}\n')
    end = cli("feasibility", str(spec), "--no-store")
    assert end.code == 2
    assert words in " ".join(end.err.split())
    assert "Traceback" not in end.err


BY_CHOICE = ("forces.max(R0_A)", "kinematics.vrel_D_C[phi=50 deg]", "forces.counters.dense", "motion.error.moment")


@pytest.mark.slow
def test_by_choice_in_a_sweep_and_in_constraints(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    asked = rows(cli("names", str(SHAPER), *BY_CHOICE, "-f", "csv").out)
    named = {row["name"]: float(row["value"]) for row in asked}
    end = cli("sweep", str(SHAPER), "--set", f"{CRANK}=*0.95:1.05:17", "--columns", BY_CHOICE[0], "-o", "t.csv")
    assert "one by one: columns or facts by choice are asked for" in " ".join(end.err.split())
    column = [float(row["forces.max(R0_A)[N]"]) for row in rows((tmp_path / "t.csv").read_text())]
    assert column[8] == pytest.approx(named["forces.max(R0_A)"], rel=1e-9)
    assert column[0] != column[8]
    end = cli("sweep", str(SHAPER), "--set", f"{CRANK}=*0.95:1.05:17", "--columns", "forces.max(R_A)", "-o", "u.csv")
    assert "solved together" in end.err
    text = SHAPER.read_text().partition("[[constraints]]")[0]
    lines = (f'\n[[constraints]]\nname = "c{k}"\nvalue = "{name}"\nat_most = 0\n' for k, name in enumerate(BY_CHOICE))
    spec = tmp_path / "my.toml"
    spec.write_text(text + "".join(lines))
    first = cli("feasibility", str(spec), "-f", "json").out
    found = dict(zip(json.loads(first)["columns"]["constraint"], json.loads(first)["columns"]["value"], strict=True))
    for k, name in enumerate(BY_CHOICE):
        assert float(found[f"c{k}"]) == pytest.approx(named[name], rel=1e-6)
    again = cli("feasibility", str(spec), "-f", "json")
    assert (again.out, "computed" in again.err) == (first, False)
    loads = spec.read_text().replace("friction = 0.1", "friction = 0.12", 1)
    spec.write_text(loads)
    assert json.loads(cli("feasibility", str(spec), "-f", "json").out)["columns"] != json.loads(first)["columns"]


@pytest.mark.parametrize(
    "command",
    [("run",), ("run", "--to", "forces"), ("kinematics",), ("forces",), ("reduce",), ("motion",), ("balance",)],
    ids=" ".join,
)
def test_columns_that_nothing_can_have_are_told_at_once(
    cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: tuple[str, ...]
) -> None:
    """Nothing is computed: all of them, each with the nearest, and no folder."""
    monkeypatch.chdir(tmp_path)
    Path("my.toml").write_text(SHAPER.read_text())
    monkeypatch.setattr("tmmcalc.linkage.kinematics.solve_kinematics", lambda *_, **__: pytest.fail("computed"))
    name, *flags = command
    code, out, err = cli(name, "my.toml", *flags, "--columns", "phi,x_Dd,M_rd")
    assert (code, out) == (2, "")
    assert " has a column called 'x_Dd' or 'M_rd'" in err or "no column is called 'x_Dd' or 'M_rd'" in err
    assert "x_Dd: " in err
    assert "M_rd: " in err
    assert not Path("my.out").exists()


def test_a_column_that_only_the_results_can_tell(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A wildcard of a form that has nothing here: no friction in the pin of A."""
    monkeypatch.chdir(tmp_path)
    Path("my.toml").write_text(SHAPER.read_text())
    wrong = cli("run", "my.toml", "--to", "forces", "--columns", "phi,M_fr_A", "-q")
    assert wrong.code == 2
    assert "no stage has a column called 'M_fr_A'" in wrong.err
    assert Path("my.out/forces.toml").exists()  # the stages are kept
    assert not [*Path("my.out").glob("*.csv")]


def test_columns_by_choice_in_the_files_of_a_run(cli: Cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    spec = tmp_path / "my.toml"
    spec.write_text(SHAPER.read_text())
    wrong = cli("run", str(spec), "--columns", "phi,R0_Z", "-q")
    assert wrong.code == 2
    assert "no stage has a column called 'R0_Z'" in wrong.err
    assert "R0_" in wrong.err.partition("->")[2]
    assert not [*(tmp_path / "my.out").glob("*.csv")]
    assert cli("run", str(spec), "--columns", "phi,R_A,R0_A,vrel_D_C", "-q").code == 0
    forces = (tmp_path / "my.out" / "forces.csv").read_text()
    assert forces.splitlines()[0] == "i,phi[deg],R_A[N],R0_A[N]"
    assert (tmp_path / "my.out" / "kinematics.csv").read_text().splitlines()[0] == "i,phi[deg],vrel_D_C[m/s]"
    printed = cli("forces", str(spec), "--columns", "phi,R_A,R0_A", "-f", "csv", "-q", "--no-store").out
    assert forces == printed
    stamps = {file: file.stat().st_mtime_ns for file in (tmp_path / "my.out").glob("*.csv")}
    assert cli("run", str(spec), "--columns", "phi,R_A,R0_A,vrel_D_C", "-q").code == 0
    assert stamps == {file: file.stat().st_mtime_ns for file in (tmp_path / "my.out").glob("*.csv")}
    assert cli("run", str(spec), "-q").code == 0
    assert "R0_A[N]" not in (tmp_path / "my.out" / "forces.csv").read_text().splitlines()[0]


def test_warnings_as_data(cli: Cli) -> None:
    told = json.loads(cli("motion", str(SHAPER), "-f", "json", "--no-store", "-q").out)
    assert len(told["findings"]) == len(told["notes"])
    for sentence, held in zip(told["notes"], told["findings"], strict=True):
        words = (held["level"], *([held["place"]] if "place" in held else []), held["text"])
        assert sentence == ": ".join(words)
    overload = next(each for each in told["findings"] if each["text"].startswith("overload"))
    assert overload["value[rad/s]"] == told["omega_min[rad/s]"] < overload["limit[rad/s]"]
    assert told["counters"]["newton"] >= 1
