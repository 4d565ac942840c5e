"""``tmmcalc vibrator`` and ``tmmcalc pendulum``: tables, formats, columns, faults, pictures."""

from __future__ import annotations

import csv
import io
import json

import pytest

from .conftest import CONFIGS, Cli

pytestmark = pytest.mark.slow

DEVICE, ROTOR = str(CONFIGS / "vibratory-device.toml"), str(CONFIGS / "pendulum-rotor.toml")
SHORT = ("--set", "vibrator.start.duration='0.1 s'", "--set", "vibrator.drive.duration='0.05 s'")


def test_the_table_of_a_device(cli: Cli) -> None:
    code, out, _ = cli("vibrator", DEVICE, "-q", "--no-store", *SHORT)
    assert code == 0
    for said in ("c_t = 133.0073 N*m/rad", "24.8039, 25.0542, 32.6228", "steady motion", "path of A", "steady regimes"):
        assert said in out


def test_the_values_of_a_device(cli: Cli) -> None:
    code, out, _ = cli("vibrator", DEVICE, "-q", "--no-store", "--format", "json", *SHORT)
    found = json.loads(out)
    assert code == 0
    assert found["natural_frequencies[Hz]"][6] == pytest.approx(72.64508, abs=5e-6)
    assert found["M"][0][4] == pytest.approx(-0.9 * 0.04)
    assert found["drive"]["energy_error"] < 1e-8
    series = found["columns"]["series"]
    assert [name for k, name in enumerate(series) if k == 0 or series[k - 1] != name] == [
        "modes",
        "curve",
        "steady",
        "start",
        "drive",
    ]


def test_the_series_as_csv(cli: Cli) -> None:
    code, out, _ = cli("vibrator", DEVICE, "-q", "--format", "csv", "--columns", "t,x,ux_A", *SHORT)
    rows = list(csv.DictReader(io.StringIO(out)))
    assert code == 0
    assert list(rows[0]) == ["series", "t[s]", "x[m]", "ux_A[m]"]
    first = next(row for row in rows if row["series"] == "curve")
    assert first["t[s]"] == ""
    assert float(first["x[m]"]) > 0
    turn = [row for row in rows if row["series"] == "steady"]
    assert float(turn[0]["x[m]"]) == pytest.approx(float(turn[-1]["x[m]"]), rel=1e-9)


def test_the_rotor_is_stuck(cli: Cli) -> None:
    drive = ("--set", "vibrator.drive.initial_speed='1300 rpm'", "--set", "motor.power='0.8 W'")
    short = ("--set", "vibrator.start.duration='0.1 s'", "--set", "vibrator.drive.duration='2.5 s'")
    code, out, _ = cli("vibrator", DEVICE, "-q", "--no-store", *short, *drive, "--strict")
    assert code == 5
    assert "warning: the rotor is stuck at resonance (Sommerfeld)" in out


def test_the_table_of_a_pendulum(cli: Cli) -> None:
    code, out, _ = cli("pendulum", ROTOR, "-q", "--no-store")
    assert code == 0
    for said in ("forward: 0.79396", "critical speeds", "the same of a rigid rod", "Campbell diagram", "motion of the"):
        assert said in out
    code, out, _ = cli("pendulum", ROTOR, "-q", "--no-store", "--columns", "t,v")
    assert code == 2


def test_the_values_of_a_pendulum(cli: Cli) -> None:
    code, out, _ = cli("pendulum", ROTOR, "-q", "--format", "json")
    found = json.loads(out)
    assert code == 0
    assert found["frequency_error"] < 1e-10
    assert len(found["critical[rad/s]"]["forward"]) == 4
    assert set(found["columns"]["series"]) == {"modes", "campbell", "swing"}


def test_a_second_run_is_loaded(cli: Cli) -> None:
    assert cli("pendulum", ROTOR).code == 0
    code, out, err = cli("pendulum", ROTOR)
    assert code == 0
    assert "loaded" in err or "unchanged" in err
    assert "Campbell diagram" in out


def test_exit_codes(cli: Cli) -> None:
    code, _, err = cli("vibrator", DEVICE, "-q", "--set", "vibrator.gripper.drop='-30 m'")
    assert code == 3
    assert "stiffness matrix of the device" in err
    code, _, err = cli("pendulum", ROTOR, "-q", "--set", "pendulum.spin=1500")
    assert code == 2
    assert '"1500 rpm"' in err
    code, _, err = cli("pendulum", DEVICE, "-q")
    assert code == 2
    assert "no [pendulum]" in err


@pytest.mark.parametrize(("stage", "spec"), [("vibrator", DEVICE), ("pendulum", ROTOR)])
def test_pictures(cli: Cli, stage: str, spec: str, tmp_path) -> None:
    file = tmp_path / f"{stage}.svg"
    short = SHORT if stage == "vibrator" else ()
    assert cli("plot", spec, stage, "-o", str(file), "-q", *short).code == 0
    first = file.read_bytes()
    assert first.startswith(b"<?xml")
    assert len(first) > 30_000
