"""``tmmcalc sweep``, several specs in one ``run``, overrides from a table, and the class of the examples."""

from __future__ import annotations

import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from sparing import sparing

from .conftest import CONFIGS, ROOT, Cli, environment
from .test_process import on_terminal

CRANK = "mechanism.links[id=1].points.A[0]"
FEW = ("--set", "mechanism.grid.positions=12")
SWEEP = ("sweep", "my.toml", "--set", f"{CRANK}=0.15:0.25:5", *FEW)
MANY = ("sweep", "my.toml", "--set", f"{CRANK}=*0.5:1.5:60", *FEW, "--to", "kinematics", "--to", "balance")
posix = pytest.mark.skipif(os.name != "posix", reason="sends signals")


def table(file: str = "my.sweep.csv") -> list[dict[str, str]]:
    with Path(file).open(newline="") as lines:
        return list(csv.DictReader(lines))


def left() -> set[str]:
    return {path.name for path in Path().iterdir()} - {"my.toml"}


def test_one_row_a_variant(cli: Cli) -> None:
    code, out, err = cli(*SWEEP, "--columns", "kinematics.stroke_D,max(vS_D)")
    assert (code, err) == (0, "wrote my.sweep.csv\n")
    rows = table()
    assert [*rows[0]] == [f"{CRANK}[m]", "kinematics.stroke_D[m]", "kinematics.max(vS_D)[m/s]", "status", "reason"]
    for row in rows:  # S = 2 l_BC l_OA / l_OB
        assert float(row["kinematics.stroke_D[m]"]) == pytest.approx(2 * 1.02 * float(row[f"{CRANK}[m]"]) / 0.62)
        assert (row["status"], row["reason"]) == ("ok", "")
    assert "points                     5, all solved" in out
    assert "kinematics.stroke_D[m]     0.4935484 (row 1) to 0.8225806 (row 5)" in out
    assert left() == {"my.sweep.csv", "my.sweep.csv.toml"}


def test_formats_and_standard_output(cli: Cli) -> None:
    told = json.loads(cli(*SWEEP, "--columns", "stroke_D", "-f", "json").out)
    assert (told["points"], told["failed"]) == (5, 0)
    assert told["kinematics.stroke_D[m]"]["least_row"] == 1
    code, out, err = cli(*SWEEP, "--columns", "stroke_D", "-o", "-")
    assert (code, err) == (0, "")
    assert out == Path("my.sweep.csv").read_text()


def test_a_point_that_fails_keeps_its_row(cli: Cli) -> None:
    code, out, _ = cli("sweep", "my.toml", "--set", f"{CRANK}=0,0.2,0.7", *FEW, "--to", "kinematics")
    assert code == 0
    rows = table()
    assert [row["status"] for row in rows] == ["failed 2", "ok", "failed 3"]
    assert "group" in rows[2]["reason"]
    for row in (rows[0], rows[2]):
        assert {value for name, value in row.items() if name.startswith("kinematics.")} == {""}
    assert "3, 2 of them failed" in out
    assert "nan" not in Path("my.sweep.csv").read_text().lower()


def test_where_no_variant_has_a_solution_the_reasons_are_written(cli: Cli) -> None:
    code, _, err = cli("sweep", "my.toml", "--set", f"{CRANK}=0.7,0.8", *FEW, "--to", "kinematics")
    assert code == 3
    assert "no variant has all that was asked for" in err
    assert [row["status"] for row in table()] == ["failed 3"] * 2


@sparing(
    ("args", "said"),
    [
        ((), "nothing would vary"),
        (("--set", "motion.inertia=5"), "nothing would vary"),
        (("--set", "mechanism.links[id=3].mas=1:2:3"), 'did you mean "mass"?'),
        (("--set", "mechanism.links[id=3].mass=-1:-2:3"), "-1 is negative"),
        (("--set", "mechanism.links[id=9].mass=1:2:3"), "no element with id = 9"),
        (("--set", f"{CRANK}=1:2:1"), "'1' values"),
        (("--set", f"{CRANK}=1:2:3", "--to", "kinematic"), "did you mean kinematics?"),
        (("--set", f"{CRANK}=0.1:0.2:3", "--to", "cam_law"), "no [cam]"),
        (("--set", f"{CRANK}=0.1:0.2:3", "--columns", "kinematics.strok_D"), "did you mean kinematics.stroke_D[m]"),
        (("--set", f"{CRANK}=0.1:0.2:3", "--columns", "kinematics.max(vD)"), "did you mean kinematics.max("),
        (("--set", f"{CRANK}=0.1:0.2:3", "--jobs", "2", "--scheduler", "tcp://x:1"), "leave --jobs or --scheduler out"),
        (("--set", f"{CRANK}=0.1:0.2:3", "-o", "no/t.csv"), "there is no folder no"),
        (("--set", f"{CRANK}=0.1:0.2:3", "-o", "-", "--depfile", "d"), "standard output is no file"),
        (("--points", "none.csv"), "there is no file none.csv"),
        (("--set", f"{CRANK}=0.1:0.2:3", "-o", "my.toml"), "my.toml is what the sweep is made from"),
        (("--set", f"{CRANK}=0.1:0.2:3", "--tolerance", "2"), "2 is no relative error"),
    ],
    every=3,
)
def test_bad_input_is_one_error_and_leaves_nothing(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli("sweep", "my.toml", *args)
    assert (code, out) == (2, "")
    assert said in err
    assert err.count("error: ") == 1
    assert left() == set()


@pytest.mark.slow
def test_a_sweep_that_is_up_to_date_says_so(cli: Cli) -> None:
    first = cli(*SWEEP, "--columns", "stroke_D")
    again = cli(*SWEEP, "--columns", "stroke_D")
    assert (again.out, again.err) == (first.out, "my.sweep.csv is up to date\n")
    assert cli(*SWEEP, "--columns", "stroke_D", "--fresh").err == "wrote my.sweep.csv\n"
    assert cli(*SWEEP, "--columns", "stroke_D", "-q").err == ""


@pytest.mark.slow
def test_processes_give_the_same_bytes(cli: Cli) -> None:
    pytest.importorskip("joblib")
    columns = ("--columns", "forces.max(R_?),kinematics.*")
    cli(*SWEEP, *columns, "-q")
    assert cli(*SWEEP, *columns, "--jobs", "2", "-o", "two.csv").code == 0
    assert Path("two.csv").read_bytes() == Path("my.sweep.csv").read_bytes()


def begun(folder: Path, *more: str) -> subprocess.Popen[bytes]:
    """A sweep of many points that has some of them in its journal."""
    process = subprocess.Popen(
        [sys.executable, "-m", "tmmcalc", *MANY, *more],
        cwd=folder,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # a background job inherits it as ignored
    )
    journal = folder / "my.sweep.csv.part"
    until = time.monotonic() + 60
    while not (journal.exists() and journal.read_bytes().count(b"\n") > 10):
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < until
        time.sleep(0.005)
    return process


@pytest.mark.slow
@posix
@pytest.mark.parametrize("jobs", ["1", "2"])
def test_a_killed_sweep_goes_on_to_the_same_bytes(cli: Cli, folder: Path, jobs: str) -> None:
    if jobs != "1":
        pytest.importorskip("joblib")
    process = begun(folder, "--jobs", jobs)
    process.kill()
    process.communicate()
    assert left() == {"my.sweep.csv.part"}
    code, _, err = cli(*MANY)
    assert code == 0
    resumed = int(err.split(", ")[1].split()[0])
    assert 8 < resumed < 60
    assert cli(*MANY, "-q", "-o", "whole.csv").code == 0
    assert Path("my.sweep.csv").read_bytes() == Path("whole.csv").read_bytes()
    assert not Path("my.sweep.csv.part").exists()


@pytest.mark.slow
@posix
@pytest.mark.parametrize("jobs", ["1", "2"])
def test_an_interrupted_sweep_keeps_its_points(folder: Path, jobs: str) -> None:
    process = begun(folder, "--jobs", jobs)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    status = process.returncode if process.returncode >= 0 else 128 - process.returncode
    assert (status, out) == (130, b"")
    assert b"Traceback" not in err
    assert left() == {"my.sweep.csv.part"}


@pytest.mark.slow
@posix
def test_a_terminal_shows_how_far_a_sweep_is(folder: Path) -> None:
    shown = on_terminal(folder, 80, *MANY, "--columns", "vS_D_max")
    assert "points" in shown
    assert "/60" in shown
    assert shown.index("/60") < shown.index("wrote my.sweep.csv")
    assert "/60" not in on_terminal(folder, 80, *MANY, "--columns", "vS_D_max", "--fresh", "-q")


def test_the_depfile_names_the_spec_its_files_and_the_table(cli: Cli) -> None:
    Path("q.csv").write_text("phi[deg],Q[N]\n0,0\n180,1500\n")
    load = '\n[[loads]]\nlink = 5\npoint = "D"\n[loads.table]\nfile = "q.csv"\n'
    Path("my.toml").write_text(Path("my.toml").read_text() + load)
    Path("class.csv").write_text(f"variant,{CRANK}[mm]\n01,180\n02,200\n")
    code, _, err = cli("sweep", "my.toml", "--points", "class.csv", *FEW, "--to", "forces", "--depfile", "s.d", "-q")
    assert (code, err) == (0, "")
    assert Path("s.d").read_text().startswith("my.sweep.csv: my.toml q.csv class.csv\n")
    rows = table()
    assert [(row["variant"], row[f"{CRANK}[mm]"]) for row in rows] == [("01", "180"), ("02", "200")]


def test_more_failures_than_allowed(cli: Cli) -> None:
    code, out, err = cli(
        "sweep", "my.toml", "--set", f"{CRANK}=0.2,0.7,0.8", *FEW, "--to", "kinematics", "--limit-errors", "1"
    )
    assert (code, out) == (3, "")
    assert "2 points have failed" in err


def test_overrides_from_a_row_of_a_table(cli: Cli) -> None:
    Path("class.csv").write_text(f"variant,{CRANK}[mm],mechanism.grid.positions\n01,180,12\n02,190,24\n")
    row = cli("kinematics", "my.toml", "--set", "@class.csv:02", "--no-store", "-q", "-f", "csv")
    alone = cli("kinematics", "my.toml", "--set", f'{CRANK}="190 mm"', "--no-store", "-q", "-f", "csv")
    assert row == alone
    assert row.code == 0
    code, _, err = cli("check", "my.toml", "--set", "@class.csv:03")
    assert code == 2
    assert "no row is called '03'" in err


def test_several_specs_in_one_run(cli: Cli) -> None:
    text = Path("my.toml").read_text()
    Path("bad.toml").write_text(text.replace('kind = "prismatic"', 'kind = "slider"', 1))
    Path("long.toml").write_text(text.replace('A = ["200 mm", 0]', 'A = ["700 mm", 0]'))
    code, out, err = cli("run", "long.toml", "bad.toml", "my.toml", "none.toml", "--to", "kinematics", "-o", "all")
    assert code == 3
    assert {path.name for path in Path("all").iterdir()} == {"long.out", "my.out"}
    assert Path("all/my.out/kinematics.npz").exists()
    assert "my.toml, Shaper" in out
    assert "specs  4, 3 of them failed" in out
    for result in ("long.toml  failed 3", "bad.toml   failed 2", "my.toml    ok", "none.toml  failed 2"):
        assert result in out
    assert err.count("error: ") == 3


def test_several_specs_for_programs(cli: Cli) -> None:
    shutil.copy("my.toml", "other.toml")
    code, out, err = cli("run", "my.toml", "other.toml", "--to", "structure", "-f", "json", "-q")
    assert (code, err) == (0, "")
    told = json.loads(out)
    assert told["columns"] == {"spec": ["my.toml", "other.toml"], "result": ["ok", "ok"], "reason": ["", ""]}
    assert told["my.toml"]["structure"] == told["other.toml"]["structure"]
    assert left() == {"other.toml", "my.out", "other.out"}


@pytest.mark.parametrize(
    ("args", "said"),
    [(("my.toml", "a/my.toml"), "they would have one folder, my.out"), (("a.toml", "--depfile", "d"), "one by one")],
)
def test_several_specs_that_are_refused(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli("run", "my.toml", *args)
    assert (code, out) == (2, "")
    assert said in err


def make(*targets: str) -> str:
    """What make says that it does."""
    command = ["make", "-j2", f"TMMCALC={sys.executable} -m tmmcalc", *targets]
    done = subprocess.run(command, env=environment(), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def a_class(variants: int, **settings: str) -> None:
    """The examples here, with the first variants of the class."""
    shutil.copytree(ROOT / "examples", "class")
    os.chdir("class")
    numbers = Path("class.csv")
    numbers.write_text("".join(numbers.read_text().splitlines(keepends=True)[: variants + 1]))


def check_class(variants: int) -> None:
    assert make().count("tmmcalc run") == variants
    assert "Nothing to be done" in make()
    for at in range(1, variants + 1):
        assert "motion" in Path(f"out/{at:02d}.txt").read_text()
    assert make("sheet").count("tmmcalc sweep") == 1
    assert "Nothing to be done" in make("sheet")
    check_answers(variants)


def check_answers(variants: int) -> None:
    rows = table("answers.csv")
    assert [row["variant"] for row in rows] == [f"{at:02d}" for at in range(1, variants + 1)]
    assert {row["status"] for row in rows} == {"ok"}


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("make") is None, reason="needs make")
def test_the_class_of_the_examples(folder: Path) -> None:
    a_class(2)
    check_class(2)
    now = time.time()
    os.utime("class.csv", (now + 1, now + 1))
    assert make().count("tmmcalc run") == 2  # all is loaded, nothing computed
    assert Path("out/01/run.log").read_text().count("computed") == Path("out/01/run.log").read_text().count("loaded")


@pytest.mark.slow
def test_the_whole_class_of_the_examples(cli: Cli) -> None:
    """The commands of the makefile for all variants, here in one process."""
    a_class(30)
    for at in range(1, 31):
        variant = ("--set", f"@class.csv:{at:02d}", "-o", f"out/{at:02d}", "--depfile", f"{at:02d}.d", "--quiet")
        code, out, _ = cli("run", "assignment.toml", *variant)
        assert code == 0
        assert "motion" in out
    columns = re.search("ANSWERS *:= (.*)", Path("Makefile").read_text())
    assert columns
    asked = ("--points", "class.csv", "--columns", columns[1], "-o", "answers.csv", "--quiet")
    assert cli("sweep", "assignment.toml", *asked).code == 0
    check_answers(30)


def test_the_task_of_the_examples_is_the_ready_shaper() -> None:
    import tmmcalc

    task, ready = (tmmcalc.load_spec(file) for file in (ROOT / "examples" / "assignment.toml", CONFIGS / "shaper.toml"))
    assert task.model_copy(update={"project": ready.project}) == ready
