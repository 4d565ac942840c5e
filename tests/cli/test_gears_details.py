"""What the gear commands give out by choice: conditions, Willis' equations, plans, factors, angles; faults."""

from __future__ import annotations

import csv
import io
import json
import tomllib

import pytest
from gears.formulas import worked

from tmmcalc.rooms import STAGES

from .conftest import CONFIGS, Cli

COMMON = ("--no-store", "-q")
DOUBLE, RAVIGNEAUX = str(CONFIGS / "gears-double-planets.toml"), str(CONFIGS / "gears-ravigneaux.toml")
PAIR = str(CONFIGS / "pair-helical.toml")


def test_conditions_of_the_chosen_train(cli: Cli) -> None:
    code, out, err = cli("gears", "planetary", DOUBLE, "--conditions", *COMMON)
    assert (code, err) == (0, "")
    assert "24/132/23/127, row 18 of 69: conditions" in out
    assert "(24 + 132)*sin(pi/3)" in out
    assert "error estimate" not in out


def test_conditions_as_a_table(cli: Cli) -> None:
    out = cli("gears", "planetary", DOUBLE, "--conditions", "--choose", "3", *COMMON, "-f", "csv").out
    rows = list(csv.DictReader(io.StringIO(out)))
    assert {row["kept"] for row in rows if row["asked"] == "yes"} == {"yes"}
    for row in rows:
        left, right = row["numbers"].split(f" {row['relation']} ")
        assert worked(left) == pytest.approx(float(row["left"]), rel=1e-7)
        assert worked(right) == pytest.approx(float(row["right"]), rel=1e-7)


def test_several_at_once_are_parts(cli: Cli) -> None:
    out = cli("gears", "planetary", DOUBLE, "--conditions", "--willis", "--plans", *COMMON, "-f", "json").out
    found = json.loads(out)
    parts = [name for name in found if isinstance(found[name], dict)]
    assert [part.rpartition(": ")[2] for part in parts] == ["conditions", "Willis' equations", "plans"]
    plans = found[parts[-1]]
    assert plans["plan of velocities"]["columns"]["x[m]"][0] == 0
    assert found == tomllib.loads(
        cli("gears", "planetary", DOUBLE, "--conditions", "--willis", "--plans", *COMMON, "-f", "toml").out
    )


def test_a_written_train_has_equations_and_plans(cli: Cli) -> None:
    out = cli("gears", "planetary", RAVIGNEAUX, "--willis", "--plans", *COMMON).out
    assert "(-Z_short/Z_small)*(-Z_long/Z_short)*(Z_ring/Z_long)" in out
    assert "note: no module is known: m_1 is 1 mm" in out
    assert "P_short-long" in out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("planetary", RAVIGNEAUX, "--conditions"), "no conditions are known"),
        (("planetary", DOUBLE, "--conditions", "--choose", "1000"), "1000"),
        (("strength", DOUBLE, "--factors", "--train", "1000"), "there is no row 1000"),
        (("pair", PAIR, "--angles", "--pair", "7"), "no pair is called '7'"),
    ],
)
def test_wrong_input(cli: Cli, arguments: tuple[str, ...], said: str) -> None:
    found = cli("gears", *arguments, *COMMON)
    assert (found.code, found.out) == (2, "")
    assert said in found.err
    assert "Traceback" not in found.err


def test_factors_of_a_set(cli: Cli) -> None:
    code, out, err = cli("gears", "strength", DOUBLE, "--factors", "--train", "18", *COMMON)
    assert (code, err) == (0, "")
    assert "wheels 1, 2, 2', 3  sigma_Hlim = 670 MPa: Table D.4.4" in out
    assert max(map(len, out.splitlines())) <= 80
    rows = list(csv.DictReader(io.StringIO(cli("gears", "strength", DOUBLE, "--factors", *COMMON, "-f", "csv").out)))
    assert {row["table"] for row in rows} == {"", *(f"D.4.{k}" for k in (1, 3, 4, 5, 6, 7, 8))}


def test_angles_of_a_pair(cli: Cli) -> None:
    code, out, err = cli("gears", "pair", PAIR, "--angles", *COMMON)
    assert (code, err) == (0, "")
    assert "inv_alpha_tw = inv_alpha_t + gamma = 0.0164533899 + 0.0263513022" in out
    rows = list(csv.DictReader(io.StringIO(cli("gears", "pair", PAIR, "--angles", *COMMON, "-f", "csv").out)))
    (tip,) = [row for row in rows if row["of"] == "wheel 1" and row["quantity"] == "alpha_a[rad]"]
    assert worked(tip["numbers"]) == pytest.approx(float(tip["value"]), rel=1e-7)


@pytest.mark.parametrize(
    ("name", "stage", "told"),
    [
        ("gears-double-planets", "train", {"conditions", "willis", "plans"}),
        ("gears-ravigneaux", "gearing", {"willis", "plans"}),
        ("gears-pairs", "pair", None),
        ("gears-double-planets", "strength", None),
        ("geared-press", "open_pair", {"strength"}),
    ],
)
def test_details_of_the_stages(name: str, stage: str, told: set[str] | None) -> None:
    """What a stage tells by choice is a record, or records by name, of declared quantities."""
    import tmmcalc
    from tmmcalc.core.quantity import quantities
    from tmmcalc.pipeline.runner import run

    spec = tmmcalc.load_spec(CONFIGS / f"{name}.toml")
    found = STAGES[stage].part("details")(spec, run(spec).results)
    records = found if isinstance(found, dict) else {"": found}
    assert told is None or {*records} == told
    assert records
    for each in records.values():
        assert quantities(type(each))
