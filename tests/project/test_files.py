"""Files that a spec names: tables of loads in CSV, read beside the spec, and the place of a catalogue."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from tmmcalc.core.errors import Fault, SpecError
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.machine.model import TorquePoints
from tmmcalc.machine.tables.tasks.machine import to_torque
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project import load_spec, parse_spec
from tmmcalc.project.files import MOST_BYTES, MOST_ROWS, named_files
from tmmcalc.spec.units import parse

HEAD = '\n[[loads]]\nlink = 5\npoint = "D"\n[loads.table]\nfile = "q.csv"\n'
Written = Callable[..., Path]


@pytest.fixture
def written(tmp_path: Path, shaper: str) -> Written:
    """Write a spec with a load table and the table's file; return the spec's place."""

    def write(content: bytes | str, more: str = "", text: str = shaper) -> Path:
        (tmp_path / "q.csv").write_bytes(content.encode() if isinstance(content, str) else content)
        (tmp_path / "spec.toml").write_text(text + HEAD + more, encoding="utf-8")
        return tmp_path / "spec.toml"

    return write


def faults(file: Path) -> list[Fault]:
    with pytest.raises(SpecError) as caught:
        load_spec(file)
    return caught.value.faults


def law(file: Path) -> Tabulated:
    found = to_loading(load_spec(file)).loads[0].law
    assert isinstance(found, Tabulated)
    return found


@pytest.mark.parametrize(
    "content",
    [
        "phi[deg],Q[kN]\n0,0\n90,1.5\n270,-2\n",
        "phi[deg];Q[kN]\r\n0;0\r\n90;1.5\r\n270;-2e0\r\n",
        "\ufeffangle [°]\tforce [ kN ]\n0\t0\n\n# a remark, 1\n90\t1.5\n270\t−2",
        '"phi[deg]","Q[kN]"\n"0","0"\n"90","1.5"\n"270","-2"\n',
        "phi[rad],Q[N]\n0,0\n1.5707963267948966,1500\n4.71238898038469,-2000\n",
    ],
)
def test_every_form_gives_the_same_values(written: Written, content: str) -> None:
    table = law(written(content))
    assert table == Tabulated("angle", (0.0, math.pi / 2, 3 * math.pi / 2), (0.0, 1500.0, -2000.0), period=2 * math.pi)


def test_a_file_is_the_same_as_its_values_in_the_spec(written: Written, shaper: str, tmp_path: Path) -> None:
    inside = HEAD.replace('file = "q.csv"', 'x = ["0 deg", "90 deg"]\nforce = ["1 kN", 2]')
    from_file = to_loading(load_spec(written("phi[deg],Q[N]\n0,1000\n90,2\n")))
    assert from_file == to_loading(parse_spec(shaper + inside))
    (tmp_path / "q.csv").write_text("phi[deg],Q[N]\n0,1000\n90,3\n")
    assert content_hash(to_loading(load_spec(tmp_path / "spec.toml"))) != content_hash(from_file)


@pytest.mark.parametrize(
    ("of", "content", "x", "kind"),
    [
        ("position", "i,M[N*m]\n0,1\n12,2\n", (0.0, 12.0), "moment"),
        ("stroke", "x/H[-],F[kN]\n0,1\n0.5,2\n1,3\n", (0.0, 0.5, 1.0), "force"),
        ("displacement", "S[mm],F[N]\n0,1\n500,2\n", (0.0, 0.5), "force"),
    ],
)
def test_abscissae_of_every_kind(
    written: Written, shaper: str, of: str, content: str, x: tuple[float, ...], kind: str
) -> None:
    file = written(content, f'of = "{of}"\n')
    if kind == "moment":
        file.write_text(file.read_text().replace('point = "D"\n[loads.table]', "[loads.table]"))
    load = to_loading(load_spec(file)).loads[0]
    assert isinstance(load.law, Tabulated)
    assert (load.kind, load.law.of, load.law.x) == (kind, of, x)


def test_the_place_counts_from_the_spec(written: Written, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = written("phi[deg],Q[N]\n0,1\n90,2\n")
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert law(Path("..") / file.name).values == (1.0, 2.0)
    text = file.read_text()
    assert parse_spec(text, folder=tmp_path).loads == load_spec(file).loads
    with pytest.raises(SpecError, match=r"there is no file 'q\.csv'"):
        parse_spec(text)


MOTORS = "name,power_kW,synchronous_rpm,speed_rpm\nM1,1,1500,1400\n"


def test_a_catalogue_is_named_by_its_place(tmp_path: Path, shaper: str) -> None:
    (tmp_path / "motors.csv").write_text(MOTORS)
    (tmp_path / "spec.toml").write_text(f'{shaper}\n[motor]\nname = "choose"\ncatalogue = "motors.csv"\n')
    motor = load_spec(tmp_path / "spec.toml").motor
    assert motor is not None
    assert motor.catalogue == str(tmp_path / "motors.csv")


@pytest.mark.parametrize(
    ("content", "more", "message", "remedy"),
    [
        ("", "", "{folder}/q.csv is empty", "write a header such as phi[deg],Q[N]"),
        ("# remarks\n\n", "", "{folder}/q.csv is empty", "write a header such as phi[deg],Q[N]"),
        (b"\xff\xfe", "", "{folder}/q.csv is not UTF-8 text", "save it as CSV in UTF-8"),
        (
            "phi[deg],Q[N]\n0,1\n",
            "",
            "q.csv, line 1: fewer than two rows under the header",
            "write one row for each x",
        ),
        (
            "phi[deg]\n0\n1\n",
            "",
            "q.csv, line 1: 1 column; a table of a load has two, x and the values",
            "write a header such as phi[deg],Q[N]",
        ),
        (
            "\nphi[deg],Q[N],P[N]\n0,0,1\n",
            "",
            "q.csv, line 2: 3 columns; a table of a load has two, x and the values",
            'write a header such as phi[deg],Q[N], or choose two: columns = "phi,Q"',
        ),
        (
            "phi,Q[N]\n0,1\n1,2\n",
            "",
            "q.csv, line 1: 'phi' is not a column of angles or lengths with its unit",
            "write a header such as phi[deg],Q[N]",
        ),
        (
            "phi[deg],Q\n0,1\n1,2\n",
            "",
            "q.csv, line 1: 'Q' is not a column of forces or moments with its unit",
            "write a header such as phi[deg],Q[N]",
        ),
        (
            "phi[deg],Q[kg]\n0,1\n1,2\n",
            "",
            "q.csv, line 1: 'Q[kg]' is not a column of forces or moments with its unit",
            "write a header such as phi[deg],Q[N]",
        ),
        (
            "phi[grad],Q[N]\n0,1\n1,2\n",
            "",
            "q.csv, line 1: 'phi[grad]' is not a column of angles or lengths with its unit",
            "write a header such as phi[deg],Q[N]",
        ),
        (
            "0,1\n1,2\n",
            "",
            "q.csv, line 1: '0' is not a column of angles or lengths with its unit",
            "write a header such as phi[deg],Q[N]",
        ),
        (
            "phi[deg],Q[N]\n0,1\n1,2\n",
            'of = "position"\n',
            "q.csv, line 1: 'phi[deg]' has a unit; x are numbers of positions",
            "write a name without unit, such as i",
        ),
        (
            "phi[deg],Q[N]\n0,1\n\n1,two\n2,3\n",
            "",
            "q.csv, line 4: 'two' is not a number",
            "write a number without its unit",
        ),
        ("phi[deg];Q[N]\n0;1\n1;2,5\n", "", "q.csv, line 3: '2,5' is not a number", "write a decimal point: 2.5"),
        (
            "phi[deg],Q[N]\n0,1\n1,2,5\n",
            "",
            "q.csv, line 3: 3 values in a table of two columns",
            "write x, value",
        ),
        (
            "phi[deg],Q[N]\n-10,1\n1,2\n",
            "",
            "q.csv, line 2: '-10' is negative; x counts from 0",
            "write it without the minus",
        ),
        ("phi[deg],Q[N]\n0,1\n1\n", "", "q.csv, line 3: 1 value in a table of two columns", "write x, value"),
        (
            "phi[deg],Q[N]\n0,1\n1,1e999\n",
            "",
            "q.csv, line 3: '1e999 N' is not a finite number of ordinary size",
            'write a number and its unit in quotes, such as "1.5 kN"',
        ),
        (
            "phi[deg],Q[N]\n0,1\n\n20,2\n10,3\n",
            "",
            "q.csv, line 5: 0.17453292519943295 does not come after 0.3490658503988659; x ascends",
            "put the values in order",
        ),
        (
            "phi[mm],Q[N]\n0,1\n1,2\n",
            "",
            "'1 mm' is a length; the input joint \"O\" is revolute, so an angle is needed",
            'write an angle, such as "30 deg"',
        ),
        (
            "S[deg],Q[N]\n0,1\n1,2\n",
            'of = "displacement"\n',
            "'1 deg' is an angle; the displacement of the output is a length",
            'write a length, such as "200 mm"',
        ),
        (
            "i,Q[N]\n0,1\n25,2\n",
            'of = "position"\n',
            "q.csv, line 3: there is no position 25.0",
            "the positions are 0 to 24 ([mechanism.grid])",
        ),
        (
            "x,Q[N]\n0,1\n1.5,2\n",
            'of = "stroke"\n',
            "q.csv, line 3: 1.5 is more than 1, the whole stroke",
            'write parts of the stroke from 0 to 1, or of = "displacement"',
        ),
    ],
)
def test_a_fault_names_the_file_and_its_line(
    written: Written, tmp_path: Path, content: bytes | str, more: str, message: str, remedy: str
) -> None:
    file = written(content, more)
    (fault,) = faults(file)
    assert fault.path == "loads[0].table.file"
    assert (fault.message, fault.remedy) == (message.format(folder=tmp_path), remedy)
    assert file.read_text().splitlines()[(fault.line or 0) - 1] == 'file = "q.csv"'


def test_all_rows_and_the_spec_are_reported_together(written: Written) -> None:
    found = faults(written("phi[deg],Q[N]\na,1\n1,b\n2,3\n", 'interpolation = "cubic"\n'))
    assert [fault.message for fault in found] == [
        "q.csv, line 2: 'a' is not a number",
        "q.csv, line 3: 'b' is not a number",
        '\'cubic\' is not allowed here; the value is "linear" or "pchip"',
    ]


def test_many_faults_are_counted(written: Written) -> None:
    found = faults(written("phi[deg],Q[N]\n" + "x,1\n" * 500))
    assert len(found) == 11
    assert found[-1].message == "q.csv: 490 more faults"


def test_the_last_angle_lies_within_the_period(written: Written) -> None:
    (fault,) = faults(written("phi[deg],Q[N]\n0,1\n361,2\n"))
    assert fault.message.startswith("q.csv, line 3: 6.3")
    assert law(written("phi[deg],Q[N]\n0,1\n361,2\n", 'period = "720 deg"\n')).period == 4 * math.pi


@pytest.mark.parametrize("name", ["none.csv", "../q.csv", "x" * 3000])
def test_a_file_that_is_not_there(written: Written, name: str) -> None:
    file = written("phi[deg],Q[N]\n0,1\n1,2\n")
    file.write_text(file.read_text().replace("q.csv", name))
    (fault,) = faults(file)
    assert fault.message.startswith("there is no file")
    assert fault.remedy == "its path counts from the folder of the spec"


@pytest.mark.parametrize(("name", "kind"), [("", "a folder"), ("/dev/zero", "a device"), ("pipe", "a pipe")])
def test_what_is_no_file_is_told_at_once(written: Written, tmp_path: Path, name: str, kind: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    file = written("phi[deg],Q[N]\n0,1\n1,2\n")
    file.write_text(file.read_text().replace("q.csv", name))
    (fault,) = faults(file)
    assert fault.message.endswith(f"is {kind}, not a file")


@pytest.mark.parametrize(
    ("row", "fragment"),
    [("1,1\n" * (MOST_ROWS + 2), "rows, more than 100000"), ("1" * 2000 + ",1\n", "line 3: a row of more than 1000")],
)
def test_a_file_of_too_many_or_too_long_rows(written: Written, row: str, fragment: str) -> None:
    (fault,) = faults(written(f"phi[deg],Q[N]\n0,1\n{row}"))
    assert fragment in fault.message


def test_a_file_without_end(written: Written) -> None:
    (fault,) = faults(written("#" * (MOST_BYTES + 1)))
    assert fault.message.endswith("q.csv is larger than 10 MB")


def test_an_override_names_another_file(written: Written, tmp_path: Path) -> None:
    file = written("phi[deg],Q[N]\n0,1\n1,2\n")
    (tmp_path / "r.csv").write_text("phi[deg],Q[N]\n0,3\n1,4\n")
    spec = load_spec(file, ['loads[link=5].table.file="r.csv"'])
    assert spec.loads[0].table is not None
    assert spec.loads[0].table.force == [3.0, 4.0]
    with pytest.raises(SpecError, match="set by an override"):
        load_spec(file, ['loads[0].table.file="s.csv"'])


TORQUE = '[torque]\nspeed = "180 rpm"\nperiod = "720 deg"\ntable = { file = "m.csv" }\n'


@pytest.fixture
def diagram(tmp_path: Path) -> Written:
    """Write a torque diagram with its file; return the spec's place."""

    def write(content: str, more: str = "") -> Path:
        (tmp_path / "m.csv").write_text(content)
        (tmp_path / "torque.toml").write_text(TORQUE.replace(" }", f"{more} }}"))
        return tmp_path / "torque.toml"

    return write


def test_a_torque_diagram_of_a_file(diagram: Written) -> None:
    """Angles beyond a turn too: the period is that of a four-stroke engine."""
    task = to_torque(load_spec(diagram("theta[deg];M[kN*m]\n0;0\n180;1.5\n700;-2\n")))
    assert task is not None
    assert task.law == TorquePoints((0.0, math.pi, parse("700 deg", "angle")), (0.0, 1500.0, -2000.0))


@pytest.mark.parametrize(
    ("content", "more", "message", "remedy"),
    [
        (
            "theta,M[N*m]\n0,1\n1,2\n",
            "",
            "m.csv, line 1: 'theta' is not a column of angles with its unit",
            "write a header such as theta[deg],M[N*m]",
        ),
        (
            "s[mm],M[N*m]\n0,1\n1,2\n",
            "",
            "m.csv, line 1: 's[mm]' is not a column of angles with its unit",
            "write a header such as theta[deg],M[N*m]",
        ),
        (
            "theta[deg],F[N]\n0,1\n1,2\n",
            "",
            "m.csv, line 1: 'F[N]' is not a column of moments with its unit",
            "write a header such as theta[deg],M[N*m]",
        ),
        (
            "theta[deg],M[N*m],x\n0,1,2\n",
            "",
            "m.csv, line 1: 3 columns; a table of a torque diagram has two, theta and the values",
            'write a header such as theta[deg],M[N*m], or choose two: columns = "theta,M"',
        ),
        (
            "theta[rad],M[N*m]\n0,1\n\n2,2\n1,5\n",
            "",
            "m.csv, line 5: '1.0 rad' does not come after '2.0 rad'; the angles ascend",
            "put the points in order",
        ),
        (
            "theta[rad],M[N*m]\n0,1\n15,2\n",
            "",
            "m.csv, line 3: '15.0 rad' lies outside the period, 0 to 720 deg",
            "count from the beginning of the cycle, or give its period",
        ),
        (
            "theta[deg],M[N*m]\n0,1\n90,3\n720,2\n",
            ', interpolation = "pchip"',
            "m.csv, line 4: the curve ends with 2.0 and begins with 1.0 at the same position of the shaft",
            'make the two equal; a jump needs interpolation = "linear"',
        ),
    ],
)
def test_a_fault_of_a_torque_diagram_names_its_line(
    diagram: Written, content: str, more: str, message: str, remedy: str
) -> None:
    (fault,) = faults(diagram(content, more))
    assert (fault.path, fault.line, fault.message, fault.remedy) == ("torque.table.file", 4, message, remedy)


def test_the_files_of_a_spec(written: Written, diagram: Written, tmp_path: Path, shaper: str) -> None:
    (tmp_path / "motors.csv").write_text(MOTORS)
    motor = '[motor]\nname = "choose"\ncatalogue = "motors.csv"\n'
    spec = load_spec(written("phi[deg],Q[N]\n0,1\n90,2\n", HEAD + HEAD + motor))
    assert named_files(spec, tmp_path) == [tmp_path / "q.csv", tmp_path / "motors.csv"]
    torque = load_spec(diagram("theta[deg],M[N*m]\n0,1\n90,3\n"))
    assert named_files(torque, tmp_path) == [tmp_path / "m.csv"]
    assert named_files(parse_spec(shaper), tmp_path) == []
