"""``--spec``: what was found stands in the spec; a run of that gives the numbers that were found, without a search."""

from __future__ import annotations

import json
import shutil
import tomllib
from difflib import ndiff
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sparing import sparing

import tmmcalc
from tmmcalc.cli.job import Job
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

from .conftest import CONFIGS, Cli

NEW = "new.toml"


def results(file: str | Path, *targets: str | None) -> Any:
    return run(load_spec(file), target=targets[0] if targets else None, keep_going=True)


def same(first: Any, second: Any, *stages: str, tolerance: float = 0.0) -> None:
    """The arrays of all these stages are equal, to the last bit unless a tolerance is given."""
    for stage in stages:
        one, other = (each.record(stage).arrays for each in (first, second))
        assert one.keys() == other.keys()
        for name in one:
            if np.asarray(one[name]).dtype.kind in "fc" and tolerance:
                assert np.allclose(one[name], other[name], rtol=tolerance, atol=tolerance), (stage, name)
            else:
                assert np.array_equal(one[name], other[name], equal_nan=np.asarray(one[name]).dtype.kind in "fc"), name


def altered(old: Path, new: Path) -> tuple[list[str], list[str]]:
    """Lines that went, and lines that came; the others are the same, byte for byte."""
    lines = list(ndiff(*(file.read_bytes().decode().splitlines(keepends=True) for file in (old, new))))
    assert "".join(line[2:] for line in lines if line[0] in " -") == old.read_text()
    return [li[2:].rstrip("\n") for li in lines if li[0] == "-"], [li[2:].rstrip("\n") for li in lines if li[0] == "+"]


def config(name: str, folder: Path) -> Path:
    shutil.copy(CONFIGS / f"{name}.toml", folder / "old.toml")
    return folder / "old.toml"


@pytest.mark.parametrize(
    ("name", "keys"),
    [
        ("cam-synthesis", ["start_distance", "offset", "roller_radius"]),
        ("cam-rocker-synthesis", ["centre_distance", "start_angle", "roller_radius"]),
        ("cam-flat", ["start_distance"]),
        ("cam", ["start_distance", "offset", "roller_radius"]),
    ],
)
def test_sizes_of_a_cam(cli: Cli, folder: Path, name: str, keys: list[str]) -> None:
    old = config(name, folder)
    code, _, err = cli("cam", "synth", "old.toml", "--no-store", "--spec", NEW)
    assert code == 0
    gone, came = altered(old, folder / NEW)
    assert gone == []
    assert [line.partition(" = ")[0] for line in came] == keys
    assert all(f"  [cam] {line} (was: searched)" in err for line in came)
    first, second = results(old), results(NEW)
    assert not second.failures
    same(first, second, *(stage for stage in first.outcomes if stage != "cam_synthesis"))
    assert second.results["cam_synthesis"].follower == first.results["cam_synthesis"].follower
    assert all(size.given for size in second.results["cam_synthesis"].sizes if size.symbol != "R0")


@pytest.mark.parametrize("given", ['base_radius = "160 mm"', 'start_angle = "40 deg"', 'centre_distance = "215 mm"'])
def test_sizes_of_a_rocker_beside_given_ones(cli: Cli, folder: Path, given: str) -> None:
    old = config("cam-rocker-synthesis", folder)
    old.write_text(old.read_text().replace("[cam]\n", f"[cam]\n{given}\n"))
    code, _, err = cli("cam", "synth", "old.toml", "--no-store", "--spec", NEW)
    assert code == 0, err
    assert given in (folder / NEW).read_text()
    first, second = results(old, "cam_pressure"), results(NEW, "cam_pressure")
    same(first, second, "cam_pressure", tolerance=1e-9)


@pytest.mark.slow
def test_the_lowest_cam(cli: Cli, folder: Path) -> None:
    old = config("cam-translating", folder)
    code, _, err = cli("cam", "optimize", "old.toml", "--no-store", "--spec", NEW)
    assert code == 0
    gone, came = altered(old, folder / NEW)
    assert gone == ['start_distance = "50 mm"', 'roller_radius = "8 mm"', 'top = "125 mm"', "[cam.optimum]",
                    'step = "1 mm"']  # fmt: skip
    assert came == ['start_distance = "45 mm"', 'roller_radius = "7 mm"', 'top = "97 mm"', "# [cam.optimum]",
                    '# step = "1 mm"']  # fmt: skip
    assert '  [cam.guide] top = "97 mm" (was: "125 mm")\n  [cam.optimum] is a comment now' in err
    found, made = results(old, "cam_optimum").results["cam_optimum"], results(NEW)
    assert "cam_optimum" not in made.outcomes
    assert made.results["cam_synthesis"].follower.start == found.chosen.start
    judged = {each.constraint: each.value for each in made.results["cam_strength"].margins}
    for each in found.chosen.checks:
        if each.number in (2, 8, 9) and each.value is not None:
            assert judged[each.number] == pytest.approx(each.value, rel=1e-9), each.name
    assert abs(made.results["cam_pressure"].rise.worst.value) == pytest.approx(found.theta[0], rel=1e-12)


def test_sizes_that_the_lowest_cam_does_not_have_go(cli: Cli, folder: Path) -> None:
    old = config("cam-translating", folder)
    text = old.read_text().replace('start_distance = "50 mm"', 'base_radius = "51 mm"  # mine')
    old.write_text(text.replace('top = "125 mm"', 'length = "50 mm"'))
    code, _, err = cli("cam", "optimize", "old.toml", "--no-store", "--spec", NEW)
    assert code == 0, err
    assert '\n# base_radius = "51 mm"  # mine\n' in (folder / NEW).read_text()
    assert '[cam] base_radius = "51 mm" is a comment now' in err
    assert '[cam.guide] length = "50 mm" is a comment now' in err
    assert tomllib.loads((folder / NEW).read_text())["cam"]["guide"]["top"] == "97 mm"


@pytest.mark.slow
def test_the_option_that_has_a_solution(cli: Cli, folder: Path) -> None:
    config("cam-translating", folder)
    asked = ("--set", 'cam.requirements.contact="120 MPa"', "--set", 'cam.optimum.contacts={ steel = "600 MPa" }')
    code, _, err = cli("cam", "optimize", "old.toml", "--no-store", *asked, "--spec", NEW)
    assert code == 0
    assert '[cam.requirements] contact = "600 MPa" (was: "120 MPa")' in err
    margins = results(NEW).results["cam_strength"]
    assert load_spec(NEW).cam.requirements.contact == 6e8
    assert max(margins.stress) < 6e8


@sparing(("name", "shaft"), [("press", None), ("geared-pump", 10.88)], every=2)
def test_a_flywheel(cli: Cli, folder: Path, name: str, shaft: float | None) -> None:
    old = config(name, folder)
    code, _, err = cli("flywheel", "old.toml", "--no-store", "--spec", NEW)
    assert code == 0
    first, second = results(old), results(NEW)
    found = first.results["flywheel"]
    assert "flywheel" not in second.outcomes
    assert load_spec(NEW).flywheel.inertia == found.own
    assert f'[flywheel] inertia = "{found.own!r} kg*m^2" (was: searched)' in err
    assert any(line.startswith("# delta = ") for line in (folder / NEW).read_text().splitlines())
    same(first, second, "kinematics", "reduction", "power")
    assert second.results["motion"].regime.delta == pytest.approx(first.results["motion"].regime.delta, rel=1e-9)


def test_no_flywheel_is_needed(cli: Cli, folder: Path) -> None:
    config("shaper", folder)
    code, _, err = cli("flywheel", "old.toml", "-q", "--no-store", "--spec", NEW)
    assert (code, (folder / NEW).exists()) == (2, False)
    assert "no flywheel is needed" in err


@pytest.mark.parametrize(
    "name",
    ["gears-coaxial", "gears-unfolded", "gears-three-centrals", "gears-radial-planets", "gears-double-planets",
     "gears-single-planets", "gears-circulating"],
)  # fmt: skip
def test_teeth_of_every_layout(cli: Cli, folder: Path, name: str) -> None:
    old = config(name, folder)
    if "[train]" not in old.read_text():
        pytest.skip("a written train")
    code, _, err = cli("gears", "synth", "old.toml", "--no-store", "--spec", NEW)
    assert code == 2
    assert "tooth sets, and none is better by itself" in err
    assert "add --choose N" in err
    assert cli("gears", "synth", "old.toml", "--no-store", "--spec", NEW, "--choose", "2").code == 0
    first, second = (results(file, "train").results["train"] for file in (old, NEW))
    rows = [row for variant in first.variants for row in variant.sets.teeth.tolist()]
    (variant,) = second.variants
    assert (variant.sets.teeth.tolist(), variant.synthesis.count) == ([rows[1]], 1)
    assert variant.synthesis.candidates == 1
    again = cli("gears", "synth", NEW, "--no-store", "--spec", "again.toml")
    assert "nothing is changed" in again.err
    assert (folder / "again.toml").read_bytes() == (folder / NEW).read_bytes()


@pytest.mark.parametrize("choose", [None, 5])
@pytest.mark.parametrize("name", ["gears-single-planets", "gears-double-planets", "gears-coaxial"])
def test_the_best_train(cli: Cli, folder: Path, name: str, choose: int | None) -> None:
    old = config(name, folder)
    flags = () if choose is None else ("--choose", str(choose))
    assert cli("gears", "compare", "old.toml", "--no-store", "--spec", NEW, *flags).code == 0
    first, second = (results(file, "criteria").results["criteria"] for file in (old, NEW))
    place = first.winner.place if choose is None else choose - 1
    variant, row = first.variants[int(first.pool.variant[place])], int(first.pool.row[place])
    assert second.winner.teeth == tuple(variant.sets.teeth[row].tolist())
    assert second.winner.modules == tuple(variant.module[row].tolist())
    assert second.winner.widths == tuple(variant.width[row].tolist())
    assert second.winner.planets == variant.sets.planets
    assert second.winner.inertia == variant.criteria.inertia[row]
    assert second.pairs is None


def test_one_of_several_layouts(cli: Cli, folder: Path) -> None:
    """Keys that only another layout uses go, and a row that was chosen by its number."""
    train = '[train]\nlayout = ["AIbar", "unfolded2"]\nratio = 6\nratio_kind = "u"\nring_min = 50   # of AIbar\n'
    (folder / "old.toml").write_text(train + "planets = [3]\nz_pinion_max = 22\n")
    table = json.loads(cli("gears", "synth", "old.toml", "--no-store", "-q", "--format", "json").out)
    rows = table["columns"]["layout"]
    number = rows.index("unfolded2") + 1
    assert cli("gears", "synth", "old.toml", "--no-store", "--spec", NEW, "--choose", str(number)).code == 0
    text = (folder / NEW).read_text()
    assert 'layout = "unfolded2"\n' in text
    assert "# ring_min = 50   # of AIbar\n" in text
    assert "# planets = [3]\n" in text
    assert cli("check", NEW).code == 0


def test_given_teeth_that_break_a_constraint(cli: Cli, folder: Path) -> None:
    text = '[train]\nlayout = "AIbar"\nratio = "22/3"\nplanets = 3\nteeth = [18, 48, 115]\n'
    (folder / "old.toml").write_text(text)
    code, _, err = cli("gears", "synth", "old.toml", "--no-store", "-q")
    assert code == 3
    assert "common axis removed the last 1 of 1" in err
    assert "leave teeth out" in err
    for wrong, said in (
        ("[18, 48]", "2 numbers of teeth: layout AIbar has the 3 wheels 1, 2, 3"),
        ("[18, 48, 114]\nz_max = 40", "wheel 2 with 48 teeth is above z_max = 40"),
    ):
        (folder / "old.toml").write_text(text.replace("[18, 48, 115]", wrong))
        code, _, err = cli("check", "old.toml")
        assert (code, said in err) == (2, True), err
    (folder / "old.toml").write_text(text.replace('"AIbar"', '["AIbar", "AI"]'))
    assert "given teeth are those of one layout" in cli("check", "old.toml").err
    (folder / "old.toml").write_text(text.replace("115", "114"))
    assert cli("check", "old.toml").code == 0
    assert cli("gears", "synth", "old.toml", "--no-store", "-q").code == 0


@sparing(
    "name",
    ["slider-crank", "crank-rocker", "slotted-link", "rotating-slotted-link", "trailing-rod", "function", "motion"],
    every=7,
)
def test_linkages(cli: Cli, folder: Path, name: str) -> None:
    old = config(f"synth-{name}", folder)
    code, _, err = cli("synth", "old.toml", "--no-store", "-q", "--spec", NEW)
    assert code == 0, err
    gone, came = altered(old, folder / NEW)
    assert all(f"# {line}" in came for line in gone)
    design = results(old, "synthesis").results["synthesis"].best
    (folder / "ready.toml").write_text(design.spec)
    first, second = results("ready.toml"), results(NEW)
    assert [*first.outcomes] == [*second.outcomes]
    same(first, second, *first.outcomes)


COURSE = """\
# My course project
[project]
title = "Feeder"

[synthesis]                     # the assignment
crank_speed = "60 rpm"
[synthesis.crank_rocker]
swing = "40 deg"
time_ratio = 1.2
rocker = "300 mm"               # the scale

[[loads]]                       # what it carries
name = "M"
link = 3
moment = "200 N*m"
resists = true

[motor]
name = "4A80B4"
inertia = 0.0033

[flywheel]
delta = 0.05                    # 1/20

[cam]                           # on the crank
follower = "translating"
stroke = "24 mm"
rise = "80 deg"
return_angle = "90 deg"
law = "shun"
[cam.loads]
mass = "1.2 kg"
"""


@pytest.fixture
def course(folder: Path) -> Path:
    (folder / "course.toml").write_text(COURSE.replace("resists = true\n", ""))
    return folder / "course.toml"


@pytest.mark.parametrize("choose", [None, 2])
def test_a_linkage_that_is_sought_beside_its_machine(cli: Cli, course: Path, choose: int | None) -> None:
    if choose is not None:
        course.write_text(course.read_text().replace("[synthesis.c", f"choose = {choose}\n[synthesis.c", 1))
    code, out, err = cli("run", "course.toml", "-o", "first", "-q")
    assert code == 0, err
    assert f"note: the mechanism is linkage {choose or 1} of 2, crank-rocker; --set synthesis.choose=N" in out
    code, _, err = cli("synth", "course.toml", "--no-store", "--spec", NEW)
    assert f"[mechanism] is linkage {choose or 1} of 2, crank-rocker" in err
    code, out, err = cli("run", NEW, "-o", "second", "-q")
    assert (code, "\nsynthesis\n" in out) == (0, False), err
    assert sorted(p.name for p in Path("first").glob("*.npz")) == sorted(p.name for p in Path("second").glob("*.npz"))
    for file in ("kinematics", "forces", "motion", "cam_forces"):
        assert Path(f"first/{file}.npz").read_bytes() == Path(f"second/{file}.npz").read_bytes()
    again = cli("run", "course.toml", "-o", "first", "-v")
    assert "synthesis: loaded" in again.err
    assert "computed" not in again.err


def test_a_plan_of_a_linkage_that_is_sought(cli: Cli, course: Path) -> None:
    _, out, _ = cli("plan", "course.toml", "--format", "json")
    plan = json.loads(out)["columns"]
    runs = {stage for stage, yes in zip(plan["stage"], plan["runs"], strict=True) if yes == "yes"}
    done = results(course)
    assert runs == {*done.outcomes}
    assert cli("plan", "course.toml", "--why").code == 0
    assert cli("power", "course.toml", "--no-store", "-q").code == 0
    assert cli("kinematics", "course.toml", "--no-store", "-q", "--plan").code == 0


def test_a_linkage_that_there_is_not(cli: Cli, course: Path) -> None:
    code, _, err = cli("run", "course.toml", "--no-store", "-q", "--set", "synthesis.choose=3")
    assert (code, "synthesis.choose: there is no solution 3" in err) == (2, True)
    code, _, err = cli("synth", "course.toml", "--no-store", "-q", "--choose", "3", "--spec", NEW)
    assert (code, "--choose: there is no solution 3" in err, Path(NEW).exists()) == (2, True, False)
    course.write_text(f'{course.read_text()}[torque]\nspeed = 1\nformula = "1"\n')
    assert "torque together with synthesis" in cli("check", "course.toml").err


def test_variants_of_what_is_asked(cli: Cli, course: Path) -> None:
    """A sweep finds the linkage of every variant, and the machine of each."""
    flags = ("--set", "synthesis.choose=1,2", "--to", "motion", "--columns", "motion.delta,synthesis.r", "-o", "-")
    code, out, _ = cli("sweep", "course.toml", *flags)
    assert code == 0
    rows = [line.split(",") for line in out.splitlines() if not line.startswith("#")]
    assert [float(row[2]) for row in rows[1:]] == pytest.approx([0.09698103369976, 0.09878884381871], rel=1e-12)
    for row in rows[1:]:
        delta = run(load_spec("course.toml", [f"synthesis.choose={row[0]}"])).results["motion"].regime.delta
        assert float(row[1]) == pytest.approx(delta, rel=1e-12)


def test_what_does_not_fit_the_linkage_that_was_found(cli: Cli, course: Path) -> None:
    course.write_text(course.read_text().replace("link = 3", "link = 7"))
    code, _, err = cli("run", "course.toml", "--no-store", "-q")
    assert code == 2
    assert "course.toml:14:1: loads[0].link" in err


def test_without_a_linkage_the_other_subjects_still_run(cli: Cli, course: Path) -> None:
    course.write_text(course.read_text().replace("time_ratio = 1.2", "time_ratio = 9"))
    code, _, err = cli("run", "course.toml", "--no-store", "-v")
    assert code == 3
    assert "synthesis: no result" in err
    assert "kinematics: left out" in err
    assert "cam_law: computed" in err
    assert cli("power", "course.toml", "--no-store", "-q").code == 3


@pytest.mark.parametrize("named", ['stage = "synthesis"\ncolumn = "r"', 'value = "synthesis.max(r)"'])
def test_constraints_beside_the_machine_judge_the_one_linkage(cli: Cli, course: Path, named: str) -> None:
    text = course.read_text()
    course.write_text(f'{text}[[constraints]]\nname = "R"\n{named}\nat_most = "98 mm"\n')
    assert cli("feasibility", "course.toml", "--no-store", "-q", "--strict").code == 0
    assert cli("feasibility", "course.toml", "--no-store", "-q", "--strict", "--set", "synthesis.choose=2").code == 5
    assert cli("synth", "course.toml", "--no-store", "-q", "--spec", NEW).code == 0
    assert "# [[constraints]]\n# name" in Path(NEW).read_text()
    assert cli("run", NEW, "--no-store", "-q").code == 0


def test_a_linkage_alone_stays_a_synthesis(cli: Cli, folder: Path) -> None:
    config("synth-crank-rocker", folder)
    assert [*results("old.toml").outcomes] == ["synthesis"]
    code, out, _ = cli("kinematics", "old.toml", "--no-store", "-q")
    assert (code, "linkage 1 of 2" in out) == (0, True)


def test_an_existing_file_is_kept_unless_it_is_forced(cli: Cli, folder: Path) -> None:
    old = config("cam-synthesis", folder)
    before = old.read_bytes()
    for target in (NEW, "old.toml"):
        (folder / NEW).write_text("mine")
        code, _, err = cli("cam", "synth", "old.toml", "--no-store", "--spec", target)
        assert (code, f"{target} exists" in err) == (2, True)
        assert (old.read_bytes(), (folder / NEW).read_text()) == (before, "mine")
    assert cli("cam", "synth", "old.toml", "--no-store", "-q", "--spec", "old.toml", "--force").err == ""
    assert "start_distance" in old.read_text()
    assert not list(folder.glob(".*"))


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--spec", "."), ". is a folder"),
        (("--spec", "none/new.toml"), "there is no folder none"),
        (("--force",), "there is no file to replace"),
    ],
)
def test_wrong_flags(cli: Cli, folder: Path, flags: tuple[str, ...], said: str) -> None:
    config("cam-synthesis", folder)
    code, out, err = cli("cam", "synth", "old.toml", "--no-store", *flags)
    assert (code, out, said in err) == (2, "", True)
    assert "there is no file to write it to" in cli("gears", "synth", "old.toml", "--choose", "2").err


def test_a_row_that_there_is_not(cli: Cli, folder: Path) -> None:
    config("gears-coaxial", folder)
    for command in ("synth", "compare"):
        code, _, err = cli("gears", command, "old.toml", "--no-store", "-q", "--spec", NEW, "--choose", "5000")
        assert (code, "there is no row 5000" in err, (folder / NEW).exists()) == (2, True, False)


def test_the_same_from_python(cli: Cli, folder: Path) -> None:
    config("cam-synthesis", folder)
    assert cli("cam", "synth", "old.toml", "--no-store", "--spec", NEW).code == 0
    spec = tmmcalc.load_spec("old.toml")
    assert tmmcalc.settle(spec, "cam_synthesis") == (folder / NEW).read_text()
    with pytest.raises(tmmcalc.UsageError, match="cam_law seeks nothing"):
        tmmcalc.settle(spec, "cam_law")


def test_a_spec_that_is_edited_during_the_search_is_kept(
    cli: Cli, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    old = config("cam-synthesis", folder)
    before = Job.finish

    def edited(*given: Any) -> None:
        old.write_text(old.read_text() + "# edited\n")
        before(*given)

    monkeypatch.setattr(Job, "finish", edited)
    code, _, err = cli("cam", "synth", "old.toml", "--no-store", "--spec", "old.toml", "--force")
    assert (code, "old.toml has changed since it was read" in err) == (2, True)
    assert old.read_text().endswith("# edited\n")
    assert "start_distance" not in old.read_text()


def test_nothing_is_sought(cli: Cli, folder: Path) -> None:
    config("cam-synthesis", folder)
    cli("cam", "synth", "old.toml", "--no-store", "--spec", NEW)
    code, _, err = cli("cam", "synth", NEW, "--no-store", "--spec", "more.toml")
    assert (code, "nothing was sought" in err, (folder / "more.toml").exists()) == (2, True, False)


def test_a_file_that_cannot_be_written(cli: Cli, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    config("cam-synthesis", folder)

    def full(self: Path, target: Path) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    code, _, err = cli("cam", "synth", "old.toml", "--no-store", "--spec", NEW)
    assert (code, "No space left" in err) == (2, True)
    assert [file.name for file in folder.iterdir() if NEW in file.name] == []


def test_overrides_stand_in_the_new_spec(cli: Cli, folder: Path) -> None:
    config("cam-synthesis", folder)
    flags = ("--set", 'cam.stroke="31 mm"', "--set", "cam.steps=7")
    code, _, err = cli("cam", "synth", "old.toml", "--no-store", *flags, "--spec", NEW)
    assert code == 0
    assert '[cam] stroke = "31 mm" by --set' in err
    first = run(load_spec("old.toml", [flags[1], flags[3]]), target="cam_profile")
    same(first, results(NEW, "cam_profile"), "cam_profile")


def test_files_are_found_from_another_folder(cli: Cli, folder: Path) -> None:
    old = config("cam-own-law", folder)
    shutil.copy(CONFIGS / "cam-law.csv", folder)
    lines = [line for line in old.read_text().splitlines() if not line.startswith(("start_d", "roller_r", "base_r"))]
    old.write_text("\n".join(line for line in lines if not line.startswith("offset")))
    (folder / "sub").mkdir()
    code, _, err = cli("cam", "synth", "old.toml", "--no-store", "--spec", f"sub/{NEW}")
    assert code == 0, err
    assert '"../cam-law.csv"' in err
    same(results(old, "cam_law"), results(f"sub/{NEW}", "cam_law"), "cam_law")


def test_marks_and_ends_of_lines_stay(cli: Cli, folder: Path) -> None:
    old = config("cam-synthesis", folder)
    old.write_bytes(b"\xef\xbb\xbf" + old.read_bytes().replace(b"\n", b"\r\n"))
    assert cli("cam", "synth", "old.toml", "--no-store", "--spec", NEW).code == 0
    made = (folder / NEW).read_bytes()
    assert made.startswith(b"\xef\xbb\xbf#")
    assert made.count(b"\n") == made.count(b"\r\n") == old.read_bytes().count(b"\n") + 3
    assert cli("check", NEW).code == 0


def test_other_commands_do_not_load_it(process: Cli, folder: Path) -> None:
    config("cam-synthesis", folder)
    answer = process("cam", "synth", "old.toml", "--no-store", "-q", PYTHONPROFILEIMPORTTIME="1")
    assert answer.code == 0
    assert "tmmcalc.project.found" not in answer.err
    assert "tmmcalc.cams.tables.found" not in answer.err
