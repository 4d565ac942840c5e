"""``tmmcalc forces --iterations``: the passes of table D.3.3, the solution beside them, what is refused."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from sparing import sparing

from .conftest import CONFIGS, Cli

CASES = json.loads((Path(__file__).parents[1] / "cases" / "dynamics.json").read_text(encoding="utf-8"))
CASE = next(
    case
    for case in (CASES["cases"] if isinstance(CASES, dict) else CASES)
    if case["id"] == "dyn-press-friction-iterations"
)["expected"]
FRICTION = ("M_fr_A[N*m]", "M_fr_B[N*m]", "F_fr_B0[N]")


@pytest.fixture(autouse=True)
def spec(folder: Path) -> None:
    shutil.copy(CONFIGS / "press.toml", folder)


def passes(cli: Cli, *args: str) -> dict[str, Any]:
    code, out, err = cli("forces", "press.toml", "-q", "-f", "json", "--iterations", *args)
    assert (code, err) == (0, "")
    found: dict[str, Any] = json.loads(out)
    return found


@pytest.mark.parametrize(("place", "case"), [("1", "position_1"), ("30 deg", "position_1"), ("9-", "position_9")])
def test_the_table_of_the_textbook(cli: Cli, place: str, case: str) -> None:
    """dyn-press-friction-iterations, by label, by angle, and the limit before a jump."""
    found = passes(cli, f"RRP(2,3)@{place}")
    columns = found["columns"]
    assert found["passes"] == CASE["iterations_to_stop"][case]
    assert columns["pass"] == [*(str(k + 1) for k in range(found["passes"])), "solution"]
    for k, header in enumerate(FRICTION):
        assert columns[header][:-1] == pytest.approx([row[k] for row in CASE[case][1:]], rel=1e-5), header


def test_the_solution_is_that_of_the_stage(cli: Cli) -> None:
    """The last row against the table of the stage, and the distance of the passes from it, which they shrink."""
    found = passes(cli, "RRP(2,3)@2", "--stop", "1e-12")
    columns = found["columns"]
    stage = json.loads(cli("forces", "press.toml", "-q", "-f", "json").out)["columns"]
    k = stage["i"].index("2")
    assert columns["B0.N[N]"][-1] == pytest.approx(stage["N_B0[N]"][k], rel=1e-13)
    assert columns["F_fr_B0[N]"][-1] == pytest.approx(stage["F_fr_B0[N]"][k], rel=1e-13)
    size = (columns["A.T[N]"][-1] ** 2 + columns["A.N[N]"][-1] ** 2) ** 0.5
    assert size == pytest.approx(stage["R_A[N]"][k], rel=1e-13)
    assert columns["change[%]"][0] == columns["off[%]"][-1] == ""
    assert columns["off[%]"][-2] < 1e-9 < 1 < columns["off[%]"][0]
    assert found["settled"]


@sparing(
    ("args", "said"),
    [
        (("--iterations", "9"), "names no group and position"),
        (("--iterations", "RRP(2,4)@9"), "groups: RRP(2,3)"),
        (("--iterations", "RRP(2,3)@99"), "no position is called '99'"),
        (("--iterations", "RRP(2,3)@"), "no position is called ''"),
        (("--iterations", "RRP(2,3)@5 mm"), "an angle is needed"),
        (("--iterations", "RRP(2,3)@400 deg"), "outside the motion"),
        (("--iterations", "RRP(2,3)@1", "--stop", "0"), "not between 0 and 1"),
        (("--iterations", "RRP(2,3)@1", "--columns", "phi"), "leave --columns and --positions out"),
        (("--stop", "0.1"), "add --iterations"),
    ],
    every=3,
)
def test_what_is_refused(cli: Cli, args: tuple[str, ...], said: str) -> None:
    code, out, err = cli("forces", "press.toml", "-q", *args)
    assert (code, out) == (2, "")
    assert said in err


def test_a_group_without_friction(cli: Cli) -> None:
    frictionless = [
        word for joint in ("A", "B", "B0") for word in ("--set", f"mechanism.joints[name={joint}].friction=0")
    ]
    found = passes(cli, "RRP(2,3)@1", *frictionless)
    assert found["columns"]["A.N[N]"][0] == found["columns"]["A.N[N]"][-1]
    assert "no pair of this group has friction" in found["notes"][0]
