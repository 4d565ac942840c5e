"""A table that a command prints, or leaves in the output folder, is read as the table of a load."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from cams.shaft_scene import GIVEN, LOADS, TEXT, spec_of
from faults import Faults

from cli.conftest import CONFIGS, Cli
from tmmcalc.core.errors import SpecError
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.machine.model import TorquePoints
from tmmcalc.machine.tables.tasks.machine import to_motor, to_torque
from tmmcalc.pipeline.runner import run
from tmmcalc.project import Spec, load_spec

PRESS = CONFIGS / "course-project.toml"
DIAGRAM = '[torque]\nspeed = "80 rpm"\ntable = {{ file = "{file}"{more} }}\n'


@pytest.fixture(scope="module")
def stored(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The output folder of a press with a cam on its crank."""
    folder = tmp_path_factory.mktemp("round")
    for stage in ("forces", "cam_forces"):
        run(load_spec(PRESS), target=stage, out=folder)
    return folder


def column(file: Path, name: str) -> np.ndarray:
    with file.open(encoding="utf-8") as stream:
        return np.array([float(row[name]) for row in csv.DictReader(stream)])


def diagram(folder: Path, file: str, more: str = "") -> TorquePoints:
    (folder / "spec.toml").write_text(DIAGRAM.format(file=file, more=more), encoding="utf-8")
    task = to_torque(load_spec(folder / "spec.toml"))
    assert task is not None
    assert isinstance(task.law, TorquePoints)
    return task.law


@pytest.mark.parametrize(
    ("command", "names"),
    [
        (["forces"], "phi,M_drive"),
        (["reduce"], "phi,M_red"),
        (["cam", "forces"], "phi,M_drive"),
        (["motion"], "phi,M_load"),
    ],
)
def test_what_a_command_prints(cli: Cli, tmp_path: Path, command: list[str], names: str) -> None:
    printed = cli(*command, str(PRESS), "--no-store", "-q", "-f", "csv", "--columns", names).out
    (tmp_path / "m.csv").write_text(printed, encoding="utf-8")
    header = printed.splitlines()[0].split(",")
    assert header[:2] == ["i", "phi[deg]"]
    law = diagram(tmp_path, "m.csv")
    assert np.degrees(law.theta) == pytest.approx(column(tmp_path / "m.csv", "phi[deg]"), abs=1e-12)
    assert list(law.moment) == column(tmp_path / "m.csv", header[2]).tolist()


@pytest.mark.parametrize(
    ("file", "chosen", "name"),
    [
        ("forces.csv", "M_drive", "M_drive[N*m]"),
        ("forces.csv", "phi[deg],M_fr_A", "M_fr_A[N*m]"),
        ("reduction.csv", "phi,M_red_friction", "M_red_friction[N*m]"),
        ("cam_forces.csv", "phi,T[N*m]", "T[N*m]"),
        ("motion.csv", "M_d", "M_d[N*m]"),
    ],
)
def test_what_stands_in_the_output_folder(stored: Path, file: str, chosen: str, name: str) -> None:
    law = diagram(stored, file, f', columns = "{chosen}"')
    assert list(law.moment) == column(stored / file, name).tolist()


def test_a_force_over_a_displacement(stored: Path) -> None:
    """Of kinematics and forces in one table: any column may be x."""
    load = '[[loads]]\nlink = 5\npoint = "D"\n[loads.table]\nfile = "k.csv"\n'
    (stored / "k.csv").write_text("i,s[m],phi[deg],N_A[N]\n0,0,0,10\n1,0.01,15,20\n1-,0.02,30,40\n", encoding="utf-8")
    text = PRESS.read_text(encoding="utf-8")
    (stored / "spec.toml").write_text(f'{text}{load}of = "displacement"\ncolumns = "s,N_A"\n', encoding="utf-8")
    law = to_loading(load_spec(stored / "spec.toml")).loads[1].law
    assert isinstance(law, Tabulated)
    assert (law.x, law.values) == ((0.0, 0.01, 0.02), (10.0, 20.0, 40.0))


def test_displacements_are_not_turned_round(stored: Path) -> None:
    load = '[[loads]]\nlink = 5\npoint = "D"\n[loads.table]\nfile = "n.csv"\nof = "displacement"\n'
    (stored / "n.csv").write_text("s[m],N[N]\n0,10\n-0.01,20\n", encoding="utf-8")
    (stored / "spec.toml").write_text(PRESS.read_text(encoding="utf-8") + load, encoding="utf-8")
    with pytest.raises(SpecError) as caught:
        load_spec(stored / "spec.toml")
    assert [fault.message for fault in caught.value.faults] == ["n.csv, line 3: '-0.01' is negative; x counts from 0"]


def test_kinematics_of_a_clockwise_crank_count_along_its_motion(tmp_path: Path) -> None:
    """Its phi falls from 0 to -360 deg; a table counts from position 0 along the motion."""
    text = PRESS.read_text(encoding="utf-8").replace('speed = "80 rpm"', 'speed = "-80 rpm"')
    (tmp_path / "press.toml").write_text(text[: text.index("[motor]")], encoding="utf-8")
    run(load_spec(tmp_path / "press.toml"), target="forces", out=tmp_path)
    phi = column(tmp_path / "kinematics.csv", "phi[deg]")
    assert phi[-1] == -360
    law = diagram(tmp_path, "forces.csv", ', columns = "M_drive"')
    assert np.degrees(law.theta) == pytest.approx(-phi)


def test_a_jump_of_a_load_is_two_rows(tmp_path: Path) -> None:
    """A cam of constant acceleration: its torque jumps where that does, in the rows before and after."""
    run(spec_of(law="const"), target="cam_forces", out=tmp_path)
    file = tmp_path / "cam_forces.csv"
    theta, torque = np.radians(column(file, "phi[deg]")), column(file, "T[N*m]")
    twice = np.flatnonzero((np.diff(theta) == 0) & (np.diff(torque) != 0))
    assert len(twice) >= 2
    load = '[[loads]]\nlink = 1\n[loads.table]\nfile = "cam_forces.csv"\ncolumns = "T"\n'
    text = PRESS.read_text(encoding="utf-8")
    (tmp_path / "spec.toml").write_text(text + load, encoding="utf-8")
    spec = load_spec(tmp_path / "spec.toml")
    law = to_loading(spec).loads[1].law
    assert isinstance(law, Tabulated)
    kept = np.ones(len(theta), bool)
    kept[1:] = (np.diff(theta) != 0) | (np.diff(torque) != 0)  # two rows that are the same in this column are one
    assert list(law.values) == torque[kept].tolist()
    reduction = run(spec, target="reduction").results["reduction"]
    works = {cause.name: cause.work for cause in reduction.contributions}
    name = next(name for name in works if name not in ("Q5", "weight", "friction") and not name.startswith("cam "))
    assert works[name] == pytest.approx(np.trapezoid(torque, theta), rel=1e-9)
    assert reduction.cycle.error < 1e-9


def test_a_characteristic_of_a_motor(tmp_path: Path) -> None:
    (tmp_path / "m.csv").write_text("n[rpm],M[N*m],P[kW]\n0,20,0\n1400,15,2.2\n1500,0,0\n", encoding="utf-8")
    text = '[torque]\nspeed = "80 rpm"\nformula = "1"\n[motor]\npower = "2 kW"\nspeed = "1400 rpm"\n'
    more = 'characteristic = "table"\ntable = { file = "m.csv", columns = "M" }\n'
    (tmp_path / "spec.toml").write_text(text + more, encoding="utf-8")
    choice = to_motor(load_spec(tmp_path / "spec.toml"))
    assert choice is not None
    assert choice.motor is not None
    speeds, moments = zip(*choice.motor.points, strict=True)
    assert np.array(speeds) * 30 / np.pi == pytest.approx([0, 1400, 1500])
    assert moments == (20, 15, 0)


@pytest.mark.parametrize(
    ("more", "message", "remedy"),
    [
        ("", "15 columns; a table of a torque diagram has two", 'columns = "phi,M_red"'),
        (', columns = "M_rod"', "no column is called 'M_rod'", "did you mean 'M_red'?"),
        (', columns = "phi,M_red,P_red"', "names 3 columns", '"phi,M_red"'),
        (', columns = "phi,phi"', "names one column twice", '"phi,M_red"'),
        (', columns = "J_red"', "'J_red[kg*m^2]' is not a column of moments", "M[N*m]"),
    ],
)
def test_faults_of_the_choice(stored: Path, more: str, message: str, remedy: str) -> None:
    with pytest.raises(SpecError) as caught:
        diagram(stored, "reduction.csv", more)
    (fault,) = caught.value.faults
    assert message in fault.message
    assert remedy in (fault.remedy or "")


def test_columns_are_those_of_a_file(faults_of: Faults) -> None:
    (fault,) = faults_of('[torque]\nspeed = 1\ntable = { moment = [1, 2], columns = "M" }\n')
    assert (fault.path, fault.remedy) == ("torque.table.columns", 'add file = "x.csv"')


def test_a_force_that_jumps_on_a_cam(tmp_path: Path) -> None:
    """The force of one cam, -120 N on the rise and none on the return, read back as the table of another."""
    run(load_text(tmp_path, 'force = "-120 N"'), target="cam_forces", out=tmp_path)
    first = run(load_text(tmp_path, 'force = "-120 N"'), target="cam_forces").results["cam_forces"]
    read = 'force_table = { file = "cam_forces.csv", columns = "phi,Q" }'
    again = run(load_text(tmp_path, read), target="cam_forces").results["cam_forces"]
    assert again.work.force == pytest.approx(first.work.force, rel=1e-9)
    assert again.work.driving == pytest.approx(first.work.driving, rel=1e-9)
    for one, two in zip(first.extremes, again.extremes, strict=True):
        assert two.largest == pytest.approx(one.largest, rel=1e-9)


def load_text(folder: Path, force: str) -> Spec:
    """The machine whose cam has this force and no weight, written beside the tables that it reads."""
    loads = LOADS.replace('force = "-120 N"\ngravity = "-9.81 m/s^2"', force) + GIVEN
    text = TEXT.format(cam='shaft = "crank"', torque="", loads=loads, law="shun", gears=1, phase=230)
    (folder / "cam.toml").write_text(text, encoding="utf-8")
    return load_spec(folder / "cam.toml")
