"""All facts of variants solved together: those of each by itself, names, values and failures."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from sparing import sparing

from tmmcalc.batch import points, stacked
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.stacked_results import Results
from tmmcalc.batch.task import Row, Task

CONFIGS = Path(__file__).parents[2] / "configs"
SHAPER = CONFIGS / "shaper.toml"
CRANK = "mechanism.links[id=1].points.A[0]"
SPEED = "mechanism.input.speed"
SAME = 1e-12  # relative
PLACE = 1e-10  # of a turn: an extreme is flat, so that its place has fewer digits
NOTHING = 1e-13  # of the largest with the same unit, which is rounding
TIED = {"press": ("reduction.J_red_min",)}  # of equal ones any may be told
ROUNDINGS = re.compile(r".*\.(error|residual|counters)\..*|.*friction_passes|.*_error(\[.*\])?")  # and counters


def solved(task: Task, which: range) -> tuple[list[Row], list[Row], int]:
    """Rows solved together and alone, and how many of them were so."""
    made = stacked.prepared(task)
    assert isinstance(made, Results), made
    both = stacked.solve_points(task, which), points.solve_points(task, which)
    return *both, sum(not row.alone for row in both[0])


def compared(task: Task, which: range, tied: tuple[str, ...] = ()) -> int:
    """How many of the points were solved together; all have to be the same but for rounding, and places ``tied``."""
    together, alone, count = solved(task, which)
    sizes: dict[tuple[str, str], float] = {}
    for row in alone:
        for name, value in zip(row.names, row.values, strict=True):
            sizes[kind(name)] = max(sizes.get(kind(name), 0.0), abs(value))
    for one, other in zip(together, alone, strict=True):
        assert (one.point, one.status, one.reason) == (other.point, other.status, other.reason)
        assert one.names == other.names
        off = {
            n: (a, b) for n, a, b in zip(one.names, one.values, other.values, strict=True) if not same(n, a, b, sizes)
        }
        nothings = {n for n, b in zip(other.names, other.values, strict=True) if abs(b) <= 1e-9 * sizes[kind(n)]}
        free = {*tied, *bare(nothings)}
        assert not {name: pair for name, pair in off.items() if name.partition("_at_")[0] not in free}
    return count


def same(name: str, one: float, other: float, sizes: dict[tuple[str, str], float]) -> bool:
    if ROUNDINGS.fullmatch(name):
        return True
    if "_at_" in name:  # the beginning of a turn is its end
        off = abs(one - other)
        return min(off, abs(off - 360)) <= 360 * PLACE
    return abs(one - other) <= SAME * abs(other) + NOTHING * sizes[kind(name)]


def kind(name: str) -> tuple[str, str]:
    return name.partition(".")[0], name.rpartition("[")[2]


def bare(names: set[str]) -> set[str]:
    return {name.rpartition("[")[0] if name.endswith("]") else name for name in names}


@sparing(
    ("name", "keys", "sets"),
    [
        ("shaper", (CRANK, "mechanism.links[id=5].mass", "motor.power", SPEED), ("flywheel.delta=0.1",)),
        ("press", (CRANK, "mechanism.links[id=2].mass", SPEED), ()),  # a slider that turns back in position 12
        ("inertial-conveyor", (CRANK, SPEED), ()),
        ("four-bar", ("mechanism.links[id=2].points.B[0]", "mechanism.links[id=3].points.B[0]", SPEED), ()),
        ("slotted-link", (CRANK, SPEED), ()),
        ("v-engine", (CRANK,), ()),
        ("trammel", (SPEED,), ()),
        ("extreme/inertia-huge", (CRANK, "mechanism.links[id=3].mass"), ()),  # neither weights nor loads
    ],
    every=4,
)
def test_all_facts_are_those_of_each_variant(name: str, keys: tuple[str, ...], sets: tuple[str, ...]) -> None:
    file = CONFIGS / f"{name}.toml"
    stages = () if "mass" not in file.read_text() else ("forces", "reduction", "power")
    targets = (*stages, "motion") if name == "shaper" else stages
    ranges = [f"{key}=*0.97:1.02:{2 if len(keys) > 2 else 4}" for key in keys]
    task = task_of(file, [*ranges, *sets], None, ("kinematics", *targets), ())
    which = range(0, task.count, max(1, task.count // 4))
    assert compared(task, which, TIED.get(name, ())) == len(which)


def test_the_crank_turned_the_other_way() -> None:
    task = task_of(SHAPER, [f'{SPEED}="-55 rpm"', f"{CRANK}=*0.9:1.1:6"], None, ("reduction", "forces"), ())
    assert compared(task, range(0, 6, 2)) == 3


@sparing("start", ['"0 deg"', '"137 deg"'], every=2)
def test_position_0_that_is_given(start: str) -> None:
    task = task_of(SHAPER, [f"mechanism.input.start={start}", f"{CRANK}=*0.9:1.1:6"], None, ("forces",), ())
    assert compared(task, range(0, 6, 2)) == 3


@pytest.mark.slow
def test_variants_that_fail_tell_why() -> None:
    """Cranks longer than the frame, a ram without a mass, a force that stalls the motor."""
    ranges = [f"{CRANK}=0.2:0.8:3", "mechanism.links[id=5].mass=-5:190:2", "loads[0].force=7500:60000:2"]
    task = task_of(SHAPER, ranges, None, ("motion",), ())
    together = compared(task, range(task.count))
    status = {row.status for row in points.solve_points(task, range(task.count))}
    assert status == {"ok", "failed 2", "failed 3"}
    assert together == 1


@pytest.mark.slow
def test_all_stages_of_a_scene() -> None:
    task = task_of(SHAPER, [f"{CRANK}=*0.95:1.05:3", "mechanism.grid.positions=12"], None, (), ())
    assert compared(task, range(0, 3, 2)) == 2


@sparing(
    "columns",
    [
        ("reduction.max(J_red)", "reduction.size(M_red*)", "reduction.M_red_mean"),
        ("motion.max(omega_idle)", "motion.first(omega_textbook)"),
        ("kinematics.vS_D_max", "forces.max(R_A)"),
        ("power.eta", "power.P_mean"),
    ],
    every=4,
)
def test_what_is_asked_for_by_name(columns: tuple[str, ...]) -> None:
    task = task_of(SHAPER, [f"{CRANK}=*0.95:1.05:5"], None, (), columns)
    assert compared(task, range(0, 5, 2)) == 3


@pytest.mark.slow
@sparing(
    "sets",
    [
        ("flywheel.inertia=0", "flywheel.delta=0.03"),  # searched for, and then in the motion
        ("flywheel.delta=0.08",),  # what is at hand does, on the verge of its panels
        ('flywheel.shaft="motor"', "flywheel.delta=0.02", "flywheel.inertia=0.4"),
    ],
    every=3,
)
def test_flywheels_under_the_motor(sets: tuple[str, ...]) -> None:
    task = task_of(SHAPER, [f"{CRANK}=*0.97:1.03:5", *sets], None, ("flywheel", "motion"), ())
    assert compared(task, range(0, 5, 2)) == 3
    made = stacked.prepared(task)
    assert isinstance(made, Results)
    assert made.alone == ()


@pytest.mark.slow
def test_a_positional_motion_is_found_for_each_by_itself() -> None:
    task = task_of(SHAPER, [f"{CRANK}=*0.95:1.05:5", 'motion.drive="positional"'], None, (), ("motion.max(omega)",))
    assert compared(task, range(0, 5, 4)) == 2
    made = stacked.prepared(task)
    assert isinstance(made, Results)
    assert made.alone == ("motion",)


def test_how_many_were_solved_alone_is_told_in_the_end(tmp_path: Path) -> None:
    """And is known to a sweep that goes on."""
    from tmmcalc.batch.executors import solve_here
    from tmmcalc.batch.journal import Journal
    from tmmcalc.batch.sweep import sweep

    ranges = [f"{CRANK}=0.2:0.8:16", "mechanism.grid.positions=12"]
    task = task_of(SHAPER, ranges, None, ("kinematics",), ())
    task = Task(**{**vars(task), "solver": stacked.SOLVER, "block": 32})
    swept = sweep(task, solve_here)
    failed = swept.sheet.failed
    assert 0 < failed <= len(swept.alone) < 16
    assert f"{len(swept.alone)} of 16 alone" in stacked.way(task, swept.alone)
    rows = stacked.solve_points(task, range(16))
    with Journal(tmp_path / "j.part", "key") as journal:
        journal.append(rows)
    with Journal(tmp_path / "j.part", "key") as journal:
        assert journal.rows() == rows
