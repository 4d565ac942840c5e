"""Points of grids and tables, and the names of quantities."""

from __future__ import annotations

from pathlib import Path

import pytest

from tmmcalc.batch.quantities import unknown, unmatched
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.table import read_points, row_of
from tmmcalc.batch.task import Task
from tmmcalc.core.errors import UsageError
from tmmcalc.naming.language import rank, stages_of
from tmmcalc.spec.variants import Axis, grid

SHAPER = Path(__file__).parents[2] / "configs" / "shaper.toml"
AXES = (Axis("a.x", (1.0, 2.0, 3.0)), Axis("a.y", (5.0, 6.5), "mm"), Axis("b[0].z", (7.0, 8.0, 9.0, 10.0)))


def test_points_are_those_of_the_grid() -> None:
    task = Task("", "", "", (), AXES)
    assert task.count == 24
    assert [task.values(point) for point in range(24)] == list(grid(AXES))
    assert task.assignments(5) == ["a.x=1", 'a.y="6.5 mm"', "b[0].z=8"]


def test_points_of_a_table_are_its_rows() -> None:
    task = Task("", "", "", (), (Axis("a.x", (1.0, 2.0)), Axis("a.y", (5.0, 6.5))), listed=True)
    assert task.count == 2
    assert [task.values(point) for point in range(2)] == [(1.0, 5.0), (2.0, 6.5)]


@pytest.mark.parametrize(
    ("name", "pattern"),
    [
        ("kinematics.stroke_D[m]", "kinematics.stroke_D[m]"),
        ("kinematics.stroke_D[m]", "kinematics.stroke_D"),
        ("kinematics.stroke_D[m]", "stroke_D"),
        ("kinematics.stroke_D[m]", "stroke_D[m]"),
        ("kinematics.stroke_D[m]", "kinematics.*"),
        ("kinematics.stroke_D[m]", "*[m]"),
        ("forces.max(R_A)[N]", "forces.max(R_*)"),
        ("forces.max(R_A)[N]", "max(R_?)"),
        ("kinematics.variants.RPR(2,3)", "variants.RPR(2,3)"),
    ],
)
def test_a_pattern_that_names(name: str, pattern: str) -> None:
    assert rank(name, ["zzz", pattern]) == 1


@pytest.mark.parametrize("pattern", ["stroke_d", "stroke_D[mm]", "kinematics.stroke", "max(R_A)", "[k]*"])
def test_a_pattern_that_does_not(pattern: str) -> None:
    assert rank("kinematics.stroke_D[m]", [pattern]) is None
    assert unmatched(["kinematics.stroke_D[m]"], ["stroke*", pattern]) == pattern


def test_a_quantity_in_another_unit_is_told_with_its_own() -> None:
    told = unknown("manipulator.psi_min[rad]", ["manipulator.psi_min[deg]", "manipulator.T[s]"])
    assert told.remedy == "it is manipulator.psi_min[deg]"
    assert unknown("psi_min[rad]", ["manipulator.psi_min[deg]"]).remedy == "it is manipulator.psi_min[deg]"


def test_the_stages_that_patterns_ask_about() -> None:
    known = ("structure", "kinematics", "forces")
    assert stages_of(["forces.max(R_A)", "kinematics.stroke*"], known) == ("kinematics", "forces")
    assert stages_of(["forces.max(R_A)", "stroke*"], known) == ()
    assert stages_of([], known) == ()


def test_headers_tell_the_unit_of_bare_numbers() -> None:
    ranges = [
        "mechanism.links[id=3].mass=50,60",
        "mechanism.input.speed=5,6",
        "mechanism.links[id=1].points.A[0]=*0.9,1.1",
        "motor.start=2,2.2",
        "mechanism.grid.positions=12,24",
    ]
    names = [axis.name for axis in task_of(SHAPER, ranges, None, (), ()).axes]
    assert names == [
        "mechanism.links[id=3].mass[kg]",
        "mechanism.input.speed[rad/s]",
        "mechanism.links[id=1].points.A[0][mm]",
        "motor.start",
        "mechanism.grid.positions",
    ]


def test_plain_values_are_those_of_all_variants() -> None:
    sets = ["mechanism.links[id=3].mass=40", "motion.inertia=*1,2"]
    task = task_of(SHAPER, sets, None, ("motion", "forces"), ())
    assert task.fixed == ("mechanism.links[id=3].mass=40",)
    assert [axis.values for axis in task.axes] == [(43.2, 86.4)]
    assert task.targets == ("forces", "motion")  # in the order of the pipeline


@pytest.mark.parametrize(
    ("sets", "said"),
    [
        ([], "nothing would vary"),
        (["motion.inertia=3"], "nothing would vary"),
        (["motion.inertia=1:2:3", "motion.inertia=4"], "set twice"),
        (["motion.inertia=1:2:3", "motion.inertia=1,2"], "set twice"),
        (["motion.inertia=1:2:2000", "motor.start=1:2:2000"], "4000000 points"),
    ],
)
def test_a_sweep_that_is_refused(sets: list[str], said: str) -> None:
    with pytest.raises(UsageError, match=said):
        task_of(SHAPER, sets, None, (), ())


TABLE = "variant,student,a.links[id=1].A[0][mm],a.speed,b.c[2]\n01,Eve,180,5,1e3\n\n02,Bob, 190,5.5,-2\n"


def test_a_table_of_variants(tmp_path: Path) -> None:
    file = tmp_path / "class.csv"
    file.write_text(TABLE)
    labels, axes = read_points(file)
    assert labels == (("variant", ("01", "02")), ("student", ("Eve", "Bob")))
    assert axes == (
        Axis("a.links[id=1].A[0]", (180.0, 190.0), "mm"),
        Axis("a.speed", (5.0, 5.5)),
        Axis("b.c[2]", (1000.0, -2.0)),
    )
    assert row_of(file, "02") == ['a.links[id=1].A[0]="190 mm"', "a.speed=5.5", "b.c[2]=-2"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no rows"),
        ("variant,a.x\n", "no rows"),
        ("variant,a.x\n01\n", "1 cells under 2 headers"),
        ("variant,a.x\n01,x\n", "'x' is no number"),
        ("variant,a.x\n01,nan\n", "'nan' is no number"),
        ("variant,name\n01,x\n", "no key"),
        ("variant,a.x\n01,1\n01,2\n", "2 rows are called '01'"),
        ("variant,a.x\n1,1\n02,2\n", "no row is called '01'"),
        ("a.x,a.y\n1,1\n", "no row is called '01'"),
    ],
)
def test_a_table_that_is_refused(tmp_path: Path, text: str, said: str) -> None:
    file = tmp_path / "class.csv"
    file.write_text(text)
    with pytest.raises(UsageError, match=said):
        row_of(file, "01")
