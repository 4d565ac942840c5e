"""Variants solved together: the same numbers as one by one, the same reasons where one fails."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from tmmcalc.batch import points, stacked
from tmmcalc.batch.choice import chosen
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.stacked import SOLVER
from tmmcalc.batch.stacked_inputs import Inputs
from tmmcalc.batch.task import Row, Task

CONFIGS = Path(__file__).parents[2] / "configs"
SHAPER = CONFIGS / "shaper.toml"
FEW = "mechanism.grid.positions=18"
CRANK = "mechanism.links[id=1].points.A[0]"
ROD = "mechanism.links[id=4].points.D[0]"
RAM = "mechanism.links[id=5].mass"
MOTION = (
    "kinematics.max(v_D0)",
    "forces.max(R_*)",
    "forces.size(M_drive)",
    "motion.*(omega)",
    "motion.size(eps)",
    "motion.delta",
)
NOISE = 1e-3  # of the largest number with the same unit: what is smaller is measured against that
SAME = 1e-11
LINE = CONFIGS / "best-straight-line.toml"


def differences(task: Task, which: range) -> tuple[int, float]:
    """How many of the points were solved together, and the largest relative difference from those solved alone."""
    together, alone = stacked.solve_points(task, which), points.solve_points(task, which)
    return len(solved_together(task).keys() & {*which}), difference_of(together, alone)


def difference_of(together: list[Row], alone: list[Row]) -> float:
    """The largest relative difference of rows from those solved alone; all else of them is the same."""
    for one, other in zip(together, alone, strict=True):
        assert (one.point, one.status, one.reason, one.names) == (other.point, other.status, other.reason, other.names)
    largest: dict[tuple[str, str], float] = {}
    for row in alone:
        for name, value in zip(row.names, row.values, strict=True):
            largest[kind(name)] = max(largest.get(kind(name), 0.0), abs(value))
    found = [
        abs(a - b) / max(abs(b), NOISE * largest[kind(name)], 1e-300)
        for one, other in zip(together, alone, strict=True)
        for name, a, b in zip(one.names, one.values, other.values, strict=True)
    ]
    return max(found, default=0.0)


def kind(name: str) -> tuple[str, str]:
    return name.partition(".")[0], name.rpartition("[")[2]


def solved_together(task: Task) -> dict[int, Row]:
    made = stacked.prepared(task)
    assert not isinstance(made, str), made
    return made.rows(range(task.count), np.array([task.values(point) for point in range(task.count)])).found


def table(file: Path, count: int, keys: dict[str, tuple[float, float]], seed: int = 1) -> Path:
    rng = np.random.default_rng(seed)
    with file.open("w") as stream:
        writer = csv.writer(stream)
        writer.writerow(keys)
        writer.writerows([repr(float(rng.uniform(*ends))) for ends in keys.values()] for _ in range(count))
    return file


@pytest.mark.slow
def test_random_variants_of_all_kinds_of_keys(tmp_path: Path) -> None:
    keys = {
        f"{CRANK}[mm]": (150, 250),
        "mechanism.fixed.O[1]": (0.55, 0.7),
        f"{ROD}[mm]": (250, 350),
        RAM: (100, 250),
        "mechanism.links[id=3].center[0]": (0.4, 0.6),
        "mechanism.joints[name=A3].friction": (0.05, 0.15),
        "mechanism.joints[name=D0].length": (0.3, 0.5),
        "loads[0].force": (4000, 9000),
        "mechanism.input.speed[rpm]": (52, 55),
        "transmission.ratio": (26, 28),
        "flywheel.inertia": (100, 250),
        "motor.inertia": (0.02, 0.04),
    }
    facts = ("kinematics.stroke_D", "kinematics.K_D", "kinematics.working_D", "motion.omega_min", "motion.P_mean")
    columns = (*MOTION, *facts, "motion.last(t)", "motion.M_d_mean", "motion.cycle_time", "motion.omega_time_mean")
    task = task_of(SHAPER, [FEW], table(tmp_path / "points.csv", 20, keys), (), columns)
    together, difference = differences(task, range(20))
    assert together == 20
    assert difference < SAME


@pytest.mark.slow
def test_directions_of_guides_and_the_motor_s_characteristic(tmp_path: Path) -> None:
    keys = {
        "mechanism.joints[name=A3].guide.angle[deg]": (-1, 1),
        "mechanism.joints[name=D0].guide.angle[deg]": (-2, 2),
        "motor.speed[rpm]": (1435, 1465),
        "motor.synchronous_speed[rpm]": (1495, 1510),
        "motor.start": (1.8, 2.3),
    }
    task = task_of(SHAPER, [FEW], table(tmp_path / "points.csv", 6, keys), (), MOTION)
    together, difference = differences(task, range(6))
    assert together == 6
    assert difference < SAME


@pytest.mark.slow
def test_variants_that_fail_end_with_the_same_reason(tmp_path: Path) -> None:
    """Cranks longer than the frame, rods too short, friction that locks, a force that stalls the motor, no spec."""
    keys = {
        CRANK: (0.1, 0.9),
        ROD: (-0.02, 0.3),
        "mechanism.joints[name=A3].friction": (0.05, 1.2),
        "loads[0].force": (5000, 60000),
        RAM: (-10, 190),
    }
    task = task_of(SHAPER, [FEW], table(tmp_path / "points.csv", 40, keys), (), MOTION)
    rows = points.solve_points(task, range(40))
    difference, together = difference_of(stacked.solve_points(task, range(40)), rows), len(solved_together(task))
    assert {row.status for row in rows} >= {"ok", "failed 2", "failed 3"}
    assert 0 < together <= sum(row.ok for row in rows)
    assert difference < SAME


def test_a_value_that_is_refused_in_the_middle_of_its_range() -> None:
    task = task_of(SHAPER, [FEW, f"{ROD}=-0.29:0.29:17"], None, (), ("kinematics.max(v_D0)",))
    differences(task, range(6, 11))
    rows = stacked.solve_points(task, range(17))
    assert [row.point for row in rows if not row.ok] == [8]
    assert "the link has no length" in rows[8].reason


def test_numbers_that_are_not_affine_are_read() -> None:
    """The direction of a load is an angle in the spec and a unit vector in what the forces read."""
    task = task_of(SHAPER, [FEW, "loads[0].direction=-20 deg:20 deg:16"], None, (), ("forces.max(R_A)",))
    together, difference = differences(task, range(0, 16, 3))
    assert together == 6
    assert difference < SAME


@sparing(
    ("name", "keys"),
    [
        ("crank-slider", ("mechanism.links[id=1].points.A[0]",)),
        ("four-bar", ("mechanism.links[id=2].points.B[0]", "mechanism.links[id=3].points.B[0]")),
        ("inertial-conveyor", ("mechanism.links[id=1].points.A[0]",)),
        ("scotch-yoke", ("mechanism.links[id=1].points.A[0]",)),
        ("trammel", ("mechanism.input.speed",)),
        ("v-engine", ("mechanism.links[id=1].points.A[0]",)),
    ],
    every=3,
)
def test_other_mechanisms(name: str, keys: tuple[str, ...]) -> None:
    file = CONFIGS / f"{name}.toml"
    columns = ("kinematics.max(x_*)", "kinematics.mean(angle_*)", "kinematics.last(S_*)", "kinematics.size(a*)")
    ranges = [f"{key}=*0.98:1.02:4" for key in keys]
    more = ("forces.max(R_*)",) if "mass" in file.read_text() else ()
    task = task_of(file, ranges, None, (), (*columns, *more))
    together, difference = differences(task, range(task.count))
    assert together == task.count
    assert difference < SAME


def test_a_point_has_the_same_digits_whatever_it_is_solved_with() -> None:
    task = task_of(SHAPER, [FEW, f"{CRANK}=0.15:0.25:300"], None, (), ("kinematics.max(v_D0)", "forces.max(R_A)"))
    rows = stacked.solve_points(task, range(300))
    for point in (0, 255, 256, 299):
        assert stacked.solve_points(task, [point]) == [rows[point]]


@sparing(
    ("sets", "columns", "reason"),
    [
        ((f"{CRANK}=0.15:0.25:20", 'reduction.rods="lumped"'), ("reduction.max(J_red)",), "rods are lumped"),
        ((f"{CRANK}=0.15:0.25:20", "mechanism.grid.extremes=true"), ("kinematics.max(v_D0)",), "strokes"),
        (("loads[name=Q5].between[0]=20 deg:40 deg:20",), ("forces.max(R_A)",), "window"),
    ],
    every=3,
)
def test_what_cannot_be_solved_together_says_why(sets: tuple[str, ...], columns: tuple[str, ...], reason: str) -> None:
    assert reason in str(stacked.prepared(task_of(SHAPER, sets, None, (), columns)))


def test_many_points_are_solved_together_by_themselves() -> None:
    columns = ("kinematics.max(v_D0)",)
    many = task_of(SHAPER, [FEW, f"{CRANK}=0.15:0.25:20"], None, (), columns)
    few = task_of(SHAPER, [FEW, f"{CRANK}=0.15:0.25:3"], None, (), columns)
    assert chosen(many, 1, 2)[0].solver == SOLVER
    assert chosen(few, 1, 2)[0].solver != SOLVER


def test_specs_are_not_read_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    task = task_of(SHAPER, [FEW, f"{CRANK}=0.15:0.25:1000"], None, (), ("kinematics.max(v_D0)",))
    inputs = Inputs(task, 0, loaded=False, driven=False, traced=False)
    monkeypatch.setattr(Inputs, "_read", lambda *_: pytest.fail("a spec was read"))
    numbers, there = inputs.numbers(np.array([task.values(point) for point in range(1000)]))
    crank = [numbers[:, k] for k in range(numbers.shape[1]) if np.ptp(numbers[:, k].real)]
    assert there.all()
    assert all(np.allclose(column.real, np.linspace(0.15, 0.25, 1000), rtol=1e-14) for column in crank)
    assert len(crank) == 2  # as a point of the link, and as a pin of its joint


def test_the_sweep_says_how_its_variants_were_solved() -> None:
    columns = ("kinematics.max(v_D0)",)
    many = task_of(SHAPER, [FEW, f"{CRANK}=0.15:0.25:20"], None, (), columns)
    assert stacked.way(many) == "variants solved together"
    near = f"variants solved together; 3 of 20 alone, {stacked.UNLIKE}"
    assert stacked.way(many, [stacked.UNLIKE] * 3) == near
    assert stacked.way(many, [stacked.UNLIKE, "a fault", *[stacked.UNLIKE] * 2]) == f"{near}; 1 of 20 alone: a fault"
    facts = task_of(SHAPER, [FEW, f"{CRANK}=0.15:0.25:20"], None, (), ())
    assert stacked.way(facts) == "variants solved together, balance of each by itself"
    strict = task_of(SHAPER, [FEW, f"{CRANK}=0.15:0.25:20"], None, (), (), 1e-6)
    assert stacked.way(strict) == "variants solved one by one: a tolerance is asked for"


@pytest.mark.slow
def test_a_row_of_a_table_is_solved_together() -> None:
    """Whose columns are made of the motion alone, not of what the textbook has beside it."""
    names = ("motion.omega@3", "forces.R_A@3", "motion.max(omega)")
    task = task_of(SHAPER, ["motion.inertia=20:200:20"], None, (), names)
    rows = stacked.solve_points(task, range(task.count))
    assert {row.alone for row in rows} == {""}
    for row, alone in zip(rows, points.solve_points(task, range(task.count)), strict=True):
        assert row.names == alone.names
        assert list(row.values) == pytest.approx(list(alone.values), rel=SAME)


@pytest.mark.slow
def test_variants_with_friction_where_the_first_has_none() -> None:
    key = "mechanism.joints[name=A3].friction"
    task = task_of(SHAPER, [FEW, f"{key}=0:0.15:16"], None, (), ("forces.max(R_A)",))
    _, difference = differences(task, range(0, 16, 5))
    assert difference < SAME


def near_to_limits(file: Path, count: int, seed: int) -> tuple[Path, np.ndarray]:
    """Four-bars whose coupler and rocker come near to their limit positions or miss them by a bit.

    And the least squared sines (n,) of their angles over the turn, by the distances of the pins in closed form.
    """
    rng = np.random.default_rng(seed)
    r1, r2, r3 = np.exp(rng.uniform(np.log(8.0), np.log(50.0), (3, 20 * count)))
    off = rng.choice([-1.0, 1.0], r1.size) * 10 ** rng.uniform(-11.0, -1.0, r1.size)
    pins = np.array([r1 + r2, np.abs(r1 - r2)])
    stretched, folded = (1 + off) * pins[0] - r3, r3 + rng.choice([-1.0, 1.0], r1.size) * (1 - off) * pins[1]
    r4 = np.where(rng.random(r1.size) < 0.5, stretched, folded)
    sines = (((r3 + r4) ** 2 - pins**2) * (pins**2 - (r3 - r4) ** 2) / (2 * r3 * r4) ** 2).min(axis=0)
    fits = np.flatnonzero((r4 > 5) & (r4 < 60) & (np.abs(sines) < 0.1))[:count]
    r1, r2, r3, r4 = (row[fits] for row in (r1, r2, r3, r4))
    keys = ("fixed.C[0]", "links[id=1].points.A[0]", "links[id=2].points.B[0]", "links[id=3].points.B[0]")
    with file.open("w") as stream:
        writer = csv.writer(stream)
        writer.writerow([f"mechanism.{key}[mm]" for key in keys])
        writer.writerows([[repr(float(v)) for v in row] for row in zip(49.0 + r1, r2, r3, r4, strict=True)])
    return file, sines[fits]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("columns", "sets", "least", "within"),
    [
        (("paths.deviation_sum_P", "paths.deviation_max_P"), (), 1e-8, 1e-12),
        (
            ("paths.deviation_sum_P",),
            ('paths[0].at=["0 deg","60 deg","100 deg","180 deg","181 deg","240 deg"]',),
            1e-8,
            1e-12,
        ),
        (("kinematics.max(x_P)", "kinematics.size(a_P)", "kinematics.max(y_P)"), (), 1e-3, 1e-12),
        (("kinematics.mean(angle_3)", "kinematics.last(omega_2)"), (), 0.1, 1e-12),
        # a cosine that is off by 2e-15 makes 1e-11 of an angle of 0.7 deg
        (("kinematics.transmission_min_RRR(2,3)", "kinematics.max(x_P)"), (), 0.1, 2e-11),
        (("kinematics.transmission_min_RRR(2,3)", "kinematics.stroke_*"), (), 0.1, SAME),  # which some have not
    ],
)
def test_variants_near_to_a_limit_position(
    tmp_path: Path, columns: tuple[str, ...], sets: tuple[str, ...], least: float, within: float
) -> None:
    """They are solved together from a squared sine of ``least`` on, and nothing is solved that does not turn."""
    file, sines = near_to_limits(tmp_path / "points.csv", 600, len(columns) + len(sets))
    assert np.count_nonzero(sines > 0) > 150
    assert np.count_nonzero(sines < 0) > 150
    task = task_of(LINE, ['mechanism.fixed.C[1]="5 mm"', FEW, *sets], file, (), columns)
    rows = points.solve_points(task, range(task.count))
    sure = np.abs(sines) > 1e-9
    assert [row.ok for row, each in zip(rows, sure, strict=True) if each] == (sines[sure] > 0).tolist()
    together = stacked.solve_points(task, range(task.count))
    assert difference_of(together, rows) < within
    alone = np.array([bool(row.alone) for row in together])
    assert not alone[sines > 1.01 * least].any()
    made = stacked.prepared(task)
    assert not isinstance(made, str)
    refused = made.rows(range(task.count), np.array([task.values(point) for point in range(task.count)])).refused
    assert {*refused} >= {*np.flatnonzero(sines < -1e-8).tolist()}
    assert not {*refused} & {k for k, row in enumerate(rows) if row.ok}
