"""[synthesis.dwell]: from the table to the task, its faults, its docs."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from tmmcalc.core.errors import SpecError
from tmmcalc.linkage.synthesis.dwell.task import DwellTask, Lengths, ThreePositions
from tmmcalc.linkage.tables.synthesis_dwell import (
    DwellLengthsTable,
    DwellTable,
    DwellWeightsTable,
    PositionsTable,
    RangesTable,
)
from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis
from tmmcalc.project import parse_spec

DOCS = Path(__file__).parents[3] / "docs" / "spec.md"
DEGREE = math.pi / 180
HEAD = '[synthesis.dwell]\ndwell = "90 deg"\n'
POSITIONS = """[synthesis.dwell.positions]
phi12 = "45 deg"
psi0 = "125 deg"
psi12 = "-43.5 deg"
psi13 = "-91.5 deg"
CB = 0.3
CD = 0.8
alpha = "-11 deg"
"""
LENGTHS = '[synthesis.dwell.lengths]\nOA = 0.28\nAC = 0.985\nCB = 0.3\nCD = 0.8\nalpha = "11 deg"\nphi0 = "1 deg"\n'
OPTIMUM = "[synthesis.dwell.optimum]\n"
ROCKER = 'output = "rocker"\nswing = "40 deg"\n'


def asked(more: str = "", tables: str = POSITIONS) -> DwellTask:
    task = to_synthesis(parse_spec(HEAD + more + tables)).asked
    assert isinstance(task, DwellTask)
    return task


# key: what is written, how it is read from the task, its value
KEYS: dict[str, tuple[str, str, Callable[[DwellTask], object], object]] = {
    "dwell": ("", POSITIONS, lambda t: t.dwell, 90 * DEGREE),
    "output": (ROCKER, POSITIONS, lambda t: t.output, "rocker"),
    "n": ("n = 0.4\n", POSITIONS, lambda t: t.n, 0.4),
    "working_angle": ('working_angle = "140 deg"\n', POSITIONS, lambda t: t.working_angle, 140 * DEGREE),
    "k": ("k = 1\n", POSITIONS, lambda t: t.reverse, True),
    "crank_sense": ('crank_sense = "cw"\n', POSITIONS, lambda t: t.clockwise, True),
    "swing": (ROCKER, POSITIONS, lambda t: t.swing, 40 * DEGREE),
    "pivot_side": (ROCKER + 'pivot_side = "right"\n', POSITIONS, lambda t: t.pivot_left, False),
    "pivot": ('output = "rocker"\npivot = [-0.6, 0.2]\n', POSITIONS, lambda t: t.pivot, -0.6 + 0.2j),
    "exact": ("exact = false\n", POSITIONS, lambda t: t.exact, False),
    "working": ('working = "away"\n', POSITIONS, lambda t: t.working, "away"),
    "frame": ('frame = "500 mm"\n', POSITIONS, lambda t: t.frame, 0.5),
    "stroke": ('stroke = "200 mm"\n', POSITIONS, lambda t: t.stroke, 0.2),
    "resistance": ('resistance = "1.5 kN"\n', POSITIONS, lambda t: t.resistance, 1500.0),
    "arc_steps": ("arc_steps = 20\n", POSITIONS, lambda t: t.arc_steps, 20),
    "positions": (
        "",
        POSITIONS,
        lambda t: t.positions,
        ThreePositions(
            math.radians(45), math.radians(125), math.radians(-43.5), math.radians(-91.5), 0.3, 0.8, math.radians(-11)
        ),
    ),
    "lengths": (
        "",
        LENGTHS + 'side = "right"\n',
        lambda t: t.lengths,
        Lengths(0.28, 0.985, 0.3, 0.8, 11 * DEGREE, DEGREE, 45 * DEGREE, left=False),
    ),
    "optimum": ("", OPTIMUM + "population = 50\n", lambda t: t.optimum and t.optimum.population, 50),
}


@pytest.mark.parametrize("key", KEYS)
def test_every_key_reaches_the_task(key: str) -> None:
    more, tables, read, value = KEYS[key]
    found = read(asked(more, tables))
    if isinstance(value, ThreePositions | Lengths):
        assert vars(found) == pytest.approx(vars(value))
    else:
        assert found == (pytest.approx(value) if isinstance(value, float) else value)


def test_every_key_has_its_test_and_its_line_in_the_docs() -> None:
    assert KEYS.keys() >= DwellTable.model_fields.keys()
    section = DOCS.read_text().split("### `[synthesis.dwell]`")[1].split("\n## ")[0]
    named = set(re.findall(r"`(\w+)`", section))
    tables = (PositionsTable, DwellLengthsTable, DwellWeightsTable, RangesTable)
    assert named >= {*KEYS} - {"positions", "lengths", "optimum"}
    assert all(named >= table.model_fields.keys() for table in tables)
    assert all(f"[synthesis.dwell.{name}]" in section for name in ("positions", "lengths", "optimum"))


def test_weights_and_ranges() -> None:
    tables = OPTIMUM + "generations = 9\npolish = 0\n[synthesis.dwell.optimum.weights]\nf1 = 10\nf4 = 0\n"
    tables += '[synthesis.dwell.optimum.ranges]\nCB = [0.2, 0.4]\npsi0 = ["20 deg", "90 deg"]\n'
    optimum = asked("", tables).optimum
    assert optimum is not None
    assert optimum.weights == (10.0, 1.0, 1.0, 0.0, 0.1)
    assert optimum.ranges == {"bar": (0.2, 0.4), "psi0": pytest.approx((20 * DEGREE, 90 * DEGREE))}
    assert (optimum.generations, optimum.polish) == (9, 0)
    rocker = asked(ROCKER, OPTIMUM).optimum
    assert rocker is not None
    assert rocker.weights[1] == 0.0


FAULTS = [
    (HEAD, "synthesis.dwell", "missing keys of [synthesis.dwell.positions]: phi12, psi0, psi12"),
    (HEAD + POSITIONS.replace("CB = 0.3\n", ""), "synthesis.dwell", "missing key of [synthesis.dwell.positions]: CB"),
    (HEAD + 'swing = "40 deg"\n' + POSITIONS, "synthesis.dwell.swing", "swing belongs to a rocker"),
    (HEAD + ROCKER + 'stroke = "0.2 m"\n' + POSITIONS, "synthesis.dwell.stroke", "stroke belongs to a slider"),
    (HEAD + 'output = "rocker"\n' + POSITIONS, "synthesis.dwell", "missing key: a rocker needs its swing or its pivot"),
    (HEAD + ROCKER + "pivot = [1, 1]\n" + POSITIONS, "synthesis.dwell.swing", "swing together with pivot"),
    (HEAD + 'n = 0.5\nworking_angle = "140 deg"\n' + POSITIONS, "synthesis.dwell.working_angle", "together with n"),
    (HEAD + "frame = 1\nstroke = 1\n" + POSITIONS, "synthesis.dwell.stroke", "stroke together with frame"),
    (HEAD + 'resistance = "4 N*m"\n' + POSITIONS, "synthesis.dwell.resistance", "is not a force"),
    (HEAD + ROCKER + 'resistance = "4 N"\n' + POSITIONS, "synthesis.dwell.resistance", "is not a moment"),
    (HEAD + POSITIONS + LENGTHS, "synthesis.dwell.positions", "positions together with lengths"),
    (HEAD + POSITIONS.replace("45 deg", "95 deg"), "synthesis.dwell.positions.phi12", "is not within the dwell of"),
    (HEAD + POSITIONS.replace("-43.5", "43.5"), "synthesis.dwell.positions.psi12", "is not between 0 and psi13"),
    (HEAD + POSITIONS.replace("-91.5 deg", "0 deg"), "synthesis.dwell.positions.psi13", "psi13 is zero"),
    (
        HEAD + OPTIMUM + '[synthesis.dwell.positions]\npsi12 = "-40 deg"\n',
        "synthesis.dwell.positions.psi12",
        "psi12 without psi13",
    ),
    (
        HEAD + OPTIMUM + "[synthesis.dwell.optimum.ranges]\nCB = [0.4, 0.2]\n",
        "synthesis.dwell.optimum.ranges.CB",
        "does not ascend",
    ),
    (
        HEAD + "n = 0.5\n" + OPTIMUM + "[synthesis.dwell.optimum.ranges]\nn = [0.2, 0.4]\n",
        "synthesis.dwell.optimum.ranges.n",
        "a range of n, which is given",
    ),
    (
        HEAD + ROCKER + OPTIMUM + "[synthesis.dwell.optimum.weights]\nf2 = 1\n",
        "synthesis.dwell.optimum.weights.f2",
        "f2 is the size of a linkage with a slider",
    ),
    (HEAD.replace("90 deg", "320 deg") + POSITIONS, "synthesis.dwell.dwell", "out of range"),
    (HEAD + 'output = "slide"\n' + POSITIONS, "synthesis.dwell.output", "slide"),
]


@pytest.mark.parametrize(("text", "path", "said"), FAULTS)
def test_faults(text: str, path: str, said: str) -> None:
    with pytest.raises(SpecError) as caught:
        parse_spec(text)
    (fault,) = caught.value.faults
    assert (fault.path, said in fault.message) == (path, True), fault
    assert fault.remedy
    assert fault.line is not None
