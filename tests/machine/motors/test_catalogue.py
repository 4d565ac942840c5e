"""The program's catalogue is consistent, its motors are found, faults of one's own file are told with their lines."""

from __future__ import annotations

import math
from collections import Counter
from itertools import pairwise
from pathlib import Path

import pytest

from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.machine.motors.catalogue import COLUMNS, find, load_catalogue
from tmmcalc.machine.motors.model import Motor, characteristic

RPM = math.pi / 30
HEADER = ",".join(COLUMNS)
MOTORS = load_catalogue()

# full-load torque as the maker prints it beside power and speed [N*m]
PRINTED = {
    "W22-4P-1.1": 7.22,
    "W22-4P-2.2": 14.6,
    "W22-4P-5.5": 35.9,
    "W22-4P-7.5": 48.9,
    "W22-4P-15": 97.5,
    "W22-4P-22": 143,
    "W22-4P-45": 291,
    "W22-4P-75": 483,
    "W22-4P-110": 705,
    "W22-6P-0.75": 7.62,
    "W22-6P-4": 39.8,
    "W22-6P-11": 108,
    "W22-6P-37": 359,
    "W22-6P-90": 869,
    "W22-8P-0.75": 10.1,
    "W22-8P-3": 40.4,
    "W22-8P-7.5": 98.2,
    "W22-8P-22": 286,
    "W22-8P-55": 710,
}

# rated slip as the table of the series prints it beside the speed [%]
SLIPS = {
    "4A71B2": 6.3,
    "4A160S2": 2.1,
    "4A250S2": 1.4,
    "4A80B4": 5.8,
    "4A132S4": 3.0,
    "4A160M4": 2.2,
    "4A250M4": 1.3,
    "4A71A6": 9.2,
    "4A132M6": 3.2,
    "4A250M6": 1.3,
    "4A132S8": 4.1,
    "4A250M8": 1.4,
}


def series(motor: Motor) -> str:
    return motor.name[:2]


def test_no_two_motors_share_a_name() -> None:
    assert max(Counter(motor.name for motor in MOTORS).values()) == 1
    for motor in MOTORS:
        assert find(motor.name.lower().replace("-", " ")) is motor


@pytest.mark.parametrize("motor", MOTORS, ids=lambda motor: motor.name)
def test_every_row_is_a_possible_motor_and_names_its_source(motor: Motor) -> None:
    assert motor.synchronous is not None
    assert motor.synchronous / RPM in (
        pytest.approx(3000),
        pytest.approx(1500),
        pytest.approx(1000),
        pytest.approx(750),
    )
    assert 0.005 < motor.nominal_slip < 0.13
    assert 250 <= motor.power <= 110e3
    assert motor.overload is not None
    assert 1.6 < motor.overload < 4
    assert motor.start is None or 1 <= motor.start <= motor.overload + 0.3
    assert motor.inertia is None or 1e-3 < motor.inertia < 10
    assert len(motor.source) > 10
    assert characteristic(motor, "kloss").moment(motor.speed) == pytest.approx(motor.nominal_moment, rel=1e-12)


def test_moment_and_inertia_grow_with_power_and_poles() -> None:
    """Within a series and a speed, as sizes follow each other."""
    groups = {(series(motor), motor.synchronous) for motor in MOTORS}
    assert len(groups) >= 12
    for group in groups:
        row = [motor for motor in MOTORS if (series(motor), motor.synchronous) == group]
        for small, large in pairwise(row):
            assert small.power < large.power, (small.name, large.name)
            assert small.nominal_moment < large.nominal_moment
            if small.inertia is not None and large.inertia is not None:
                assert small.inertia <= large.inertia
    by_key = {(series(motor), motor.power, motor.synchronous): motor for motor in MOTORS}
    for (kind, power, speed), motor in by_key.items():
        faster = by_key.get((kind, power, 1500 * RPM))
        if faster is not None and speed == 1000 * RPM:
            assert motor.nominal_moment > faster.nominal_moment


def test_moments_agree_with_those_the_maker_prints() -> None:
    for name, printed in PRINTED.items():
        assert find(name).nominal_moment == pytest.approx(printed, rel=0.006), name


def test_speeds_agree_with_the_slips_of_the_table() -> None:
    for name, slip in SLIPS.items():
        assert find(name).nominal_slip * 100 == pytest.approx(slip, abs=0.45), name


def test_range_of_the_catalogue() -> None:
    assert {round(motor.synchronous / RPM) for motor in MOTORS if motor.synchronous} == {3000, 1500, 1000, 750}
    assert min(motor.power for motor in MOTORS) == 250
    assert max(motor.power for motor in MOTORS) == 110e3
    assert sum(motor.inertia is not None for motor in MOTORS) >= 50


def test_motors_of_the_textbook() -> None:
    first, second = find("AO-2-21-4"), find("4A132S4")
    assert (first.power, first.overload) == (1100, 2.2)
    assert (first.speed, first.synchronous) == (pytest.approx(1400 * RPM), pytest.approx(1500 * RPM))
    assert (second.power, second.speed) == (7500, pytest.approx(1455 * RPM))
    assert "textbook" in first.source
    assert "textbook" in second.source


@pytest.mark.parametrize(
    ("written", "name"),
    [
        ("АО2-21-4", "AO-2-21-4"),  # Cyrillic
        ("4А132S4", "4A132S4"),
        ("4А132S4У3", "4A132S4"),
        ("4a 132 s4y3", "4A132S4"),
        ("АИР100L4", "AIR100L4"),
        ("air 100 l4", "AIR100L4"),
        ("w22 4p 7.5", "W22-4P-7.5"),
    ],
)
def test_spellings_of_a_name(written: str, name: str) -> None:
    assert find(written).name == name


def test_unknown_name() -> None:
    with pytest.raises(UsageError, match="4A132X4") as error:
        find("4A132X4")
    assert "4A132S4" in error.value.remedy
    with pytest.raises(UsageError) as other:
        find("Diesel")
    assert "catalogue of your own" in other.value.remedy
    with pytest.raises(UsageError):
        find("4A132S4", [])


def write(folder: Path, text: str) -> Path:
    file = folder / "motors.csv"
    file.write_text(text, encoding="utf-8")
    return file


def faults(folder: Path, text: str) -> list[tuple[int | None, str]]:
    with pytest.raises(SpecError) as error:
        load_catalogue(write(folder, text))
    assert error.value.exit_code == 2
    return [(fault.line, f"{fault.path}: {fault.message} {fault.remedy}") for fault in error.value.faults]


@pytest.mark.parametrize("mark", [",", ";", "\t"])
def test_own_catalogue(tmp_path: Path, mark: str) -> None:
    header = ("name", "power_kW", "synchronous_rpm", "speed_rpm", "overload", "inertia_kgm2")
    rows = [header, ("First", "1.1", "1500", "1400", "2.2", "0.003"), ("Second", "2.2", "1000", "950", "", "")]
    file = write(tmp_path, "\ufeff# mine\n\n" + "\n".join(mark.join(row) for row in rows) + "\n")
    first, second = load_catalogue(file)
    assert first == Motor("First", 1100.0, 1400 * RPM, 1500 * RPM, 2.2, 0.003)
    assert second == Motor("Second", 2200.0, 950 * RPM, 1000 * RPM)
    assert find("second", load_catalogue(file)) == second


def test_the_catalogue_of_the_document(tmp_path: Path) -> None:
    """The columns and the example that the document of the spec gives are those that are read."""
    document = (Path(__file__).parents[3] / "docs" / "spec.md").read_text(encoding="utf-8")
    assert f"`{','.join(COLUMNS)}`" in document
    example = document.partition("```csv\nname,power_kW")[2].partition("```")[0]
    first, second = load_catalogue(write(tmp_path, f"name,power_kW{example}"))
    assert first == Motor("M1", 1100.0, 1400 * RPM, 1500 * RPM, 2.2, 0.003, 2.0, source="data sheet")
    assert second == Motor("M2", 2200.0, 950 * RPM, 1000 * RPM, 2.2)


def test_quoted_cells(tmp_path: Path) -> None:
    motors = load_catalogue(write(tmp_path, f'{HEADER}\nA,1.1,1500,1400,2.2,,,"book, page 3"\n'))
    assert motors[0].source == "book, page 3"


def test_all_faults_of_the_rows_at_once(tmp_path: Path) -> None:
    text = (
        f"# own motors\n{HEADER}\n"
        'A,"1,1",1500,1400,2.2,,,x\n'
        "\n"
        "B,1.1,1500,1500,2.2,,,x\n"
        "C,1.1,1500,1400,0.9,,,x\n"
        "D,,1500,,2.2,,,x\n"
        "E,1.1,1500,1400,2.2,,,x\n"
        "e,1.5,1500,1410,2.2,,,x\n"
        "F,1.1,1500,1400,2.2,,,x,y\n"
        "G,1.1,1500,1400,2.2\n"
        "H,nan,1500,1400,2.2,,,x\n"
        ",1.1,1500,1400,2.2,,,x\n"
    )
    found = faults(tmp_path, text)
    assert [line for line, _ in found] == [3, 5, 6, 7, 7, 9, 10, 11, 12, 13]
    says = ["decimal point", "not below", "overload", "power_kW: is empty", "speed_rpm: is empty"]
    says += ["stands in line 8 already", "9 cells under 8", "5 cells under 8", "power is nan", "name: is empty"]
    for (_, message), part in zip(found, says, strict=True):
        assert part in message


def test_faults_of_the_header(tmp_path: Path) -> None:
    found = faults(tmp_path, "name,power_kW,Speed_rpm,synchronous_rpm,synchronous_rpm\nA,1,2,3,3\n")
    assert {line for line, _ in found} == {1}
    told = " ".join(message for _, message in found)
    assert "speed_rpm: column is missing" in told
    assert "Speed_rpm: unknown column" in told
    assert "synchronous_rpm: column stands twice" in told


def test_empty_files(tmp_path: Path) -> None:
    assert "no header" in faults(tmp_path, "# nothing\n\n")[0][1]
    assert faults(tmp_path, f"{HEADER}\n") == [(1, ": no motor follows the header ")]


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="cannot read"):
        load_catalogue(tmp_path / "none.csv")
    with pytest.raises(UsageError, match="cannot read"):
        load_catalogue(tmp_path)
    (tmp_path / "latin.csv").write_bytes(HEADER.encode() + b"\n\xff\xfe,1,2,3\n")
    with pytest.raises(UsageError, match="UTF-8"):
        load_catalogue(tmp_path / "latin.csv")
