"""What must not happen to a sweep: one slip that ends it, a fault that hides, values of a file that has changed."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest
from sparing import sparing

import tmmcalc
from tmmcalc.batch import points, preparing, stacked, stacked_results
from tmmcalc.batch.executors import solve_here
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.sweep import Swept, sweep
from tmmcalc.batch.task import Row, Task
from tmmcalc.core.errors import SingularityError
from tmmcalc.core.numerics.alike import SeveralError
from tmmcalc.machine.stacked import records

SHAPER = Path(__file__).parents[2] / "configs" / "shaper.toml"
CRANK = "mechanism.links[id=1].points.A[0]"
RANGE = ("mechanism.grid.positions=12", f"{CRANK}=0.18:0.22:17")
FACTS = ("forces.max(R_A)", "balance.*")  # not columns alone: a result of every variant
FORCE = """
[loads.table]
of = "angle"
file = "q.csv"
"""
CONSTRAINT = '\n[[constraints]]\nname = "light"\nstage = "forces"\ncolumn = "R_A"\nat_most = 1e9\n'


def exact(name: str) -> bool:
    """Whether it is a value, and neither an error, a counter nor the place of an extreme."""
    return not any(word in name for word in ("error", "residual", "counters", "passes", "_at_", "_off", "panels"))


def facts(*sets: str) -> Task:
    return task_of(SHAPER, [*RANGE, *sets], None, (), FACTS)


def swept(task: Task, out: Path | None = None) -> Swept:
    return sweep(Task(**{**vars(task), "solver": stacked.SOLVER, "block": 32}), solve_here, out)


def failing(error: Exception, broken: Callable[..., bool], real: Callable[..., Any]) -> Callable[..., Any]:
    """``real`` with an error where ``broken`` says so."""

    def given(*args: Any, **more: Any) -> Any:
        if broken(*args, **more):
            raise error
        return real(*args, **more)

    return given


@pytest.fixture(autouse=True)
def forgotten() -> Iterator[None]:
    """What was prepared with a fault is not left to others."""
    preparing._prepared.cache_clear()
    yield
    preparing._prepared.cache_clear()


@pytest.fixture
def loaded(tmp_path: Path) -> Path:
    """The shaper with its load in a file."""
    spec = tmp_path / "s.toml"
    text = SHAPER.read_text().replace('force = "7500 N"', "").replace('between = ["30 deg", "180 deg"]', FORCE)
    spec.write_text(text.split("\n[motor]")[0])
    write(tmp_path, 7500.0)
    return spec


def write(folder: Path, force: float) -> None:
    (folder / "q.csv").write_text(f"phi[deg],Q[N]\n0,0\n30,{force}\n180,{force}\n200,0\n")


def column(rows: Sequence[Row], name: str) -> list[float]:
    return [dict(zip(row.names, row.values, strict=True))[name] for row in rows]


@sparing("columns", [("forces.max(R_A)",), FACTS], every=2)
def test_a_file_that_changes_between_two_sweeps_in_one_process(loaded: Path, columns: tuple[str, ...]) -> None:
    task = task_of(loaded, RANGE, None, (), columns)
    assert not isinstance(stacked.prepared(task), str)
    before = stacked.solve_points(task, range(17))
    write(loaded.parent, 9000.0)
    after, alone = stacked.solve_points(task, range(17)), points.solve_points(task, range(17))
    name = "forces.max(R_A)[N]"
    assert column(after, name) == pytest.approx(column(alone, name), rel=1e-11)
    assert min(column(after, name)) > 1.1 * max(column(before, name))
    assert not any(row.alone for row in after)


@pytest.mark.slow
def test_a_map_of_a_file_that_changes(loaded: Path) -> None:
    loaded.write_text(
        loaded.read_text() + '\n[[constraints]]\nname="light"\nstage="forces"\ncolumn="R_A"\nat_most=1e9\n'
    )
    maps = []
    for force in (7500.0, 9000.0):
        write(loaded.parent, force)
        maps.append(tmmcalc.map_feasibility(loaded, [f"{CRANK}=0.18:0.22:17"], [RANGE[0]]))
    spec = tmmcalc.load_spec(loaded, [RANGE[0], f"{CRANK}=0.18"])
    table = tmmcalc.run(spec, target="forces").table("forces")
    largest = table.columns[table.header.index("R_A[N]")].max()
    assert maps[1].values[0, 0] == pytest.approx(largest, rel=1e-11)
    assert maps[1].values[0, 0] > 1.1 * maps[0].values[0, 0]


def test_a_map_from_another_folder(loaded: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Files are found from where the spec was named, whoever goes elsewhere meanwhile."""
    from tmmcalc.batch import outcomes, regions

    loaded.write_text(
        loaded.read_text() + '\n[[constraints]]\nname="light"\nstage="forces"\ncolumn="R_A"\nat_most=1e9\n'
    )
    folders: list[str] = []
    real = outcomes.outcomes
    monkeypatch.setattr(outcomes, "outcomes", lambda task: folders.append(task.folder) or real(task))
    monkeypatch.chdir(loaded.parent)
    regions.map_feasibility(loaded.name, [f"{CRANK}=0.18:0.22:2"], [RANGE[0]])
    assert folders == [os.fspath(loaded.parent)]


@sparing("error", [ValueError("a slip"), ZeroDivisionError("by zero")], every=2)
@sparing("where", ["stage", "told"], every=2)
def test_one_slip_fails_one_row(monkeypatch: pytest.MonkeyPatch, error: Exception, where: str) -> None:
    task, text = facts(), f"a fault of the program: {type(error).__name__}: {error}"
    if where == "stage":
        from tmmcalc.machine.stages import balance

        def odd(given: Any, kinematics: Any) -> bool:
            return bool(abs(kinematics.crank_length - 0.2) < 1e-9)

        monkeypatch.setattr(balance, "solve", failing(error, odd, balance.solve))
    else:

        def odd(results: Any, patterns: Any, scene: Any = None, stages: Any = None) -> bool:
            return bool(abs(results["kinematics"].crank_length - 0.2) < 1e-9)

        for module in (points, stacked_results):
            monkeypatch.setattr(module, "told", failing(error, odd, module.told))
    rows = stacked.solve_points(task, range(17))
    assert [row.point for row in rows if not row.ok] == [8]
    assert (rows[8].status, rows[8].reason) == ("failed 1", text)
    assert [row.point for row in rows if row.alone] == [8]
    assert text in stacked.way(task, [row.alone for row in rows if row.alone])


def test_a_slip_in_the_points_that_are_tried_first(monkeypatch: pytest.MonkeyPatch) -> None:
    from tmmcalc.batch.task import BROKEN

    task = facts()
    real, bad = preparing._solver, {task.spread()[0], task.spread()[1]}
    monkeypatch.setattr(preparing, "_solver", failing(ValueError("a slip"), lambda task, point: point in bad, real))
    assert not isinstance(stacked.prepared(task), str)
    monkeypatch.setattr(preparing, "_solver", failing(ValueError("a slip"), lambda task, point: True, real))
    preparing._prepared.cache_clear()
    assert stacked.prepared(task) == "a fault of the program: ValueError: a slip"
    assert BROKEN not in {row.status for row in stacked.solve_points(task, range(2))}


@pytest.mark.slow
def test_a_fault_where_all_are_solved_together_does_not_hide(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(records, "forces_of", failing(KeyError("A3"), lambda *_: True, records.forces_of))
    found = swept(facts())
    assert found.sheet.failed == 0
    assert len(found.alone) == 17
    said = stacked.way(facts(), found.alone)
    assert "17 of 17 alone: a fault of the program: KeyError: 'A3'" in said
    assert "limit position" not in said


@pytest.mark.slow
def test_what_asks_for_one_number_is_solved_alone_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(records, "forces_of", failing(SeveralError("float"), lambda *_: True, records.forces_of))
    found = swept(facts())
    assert (found.sheet.failed, len(found.alone)) == (0, 17)
    assert "limit position" not in stacked.way(facts(), found.alone)
    assert "fault" not in stacked.way(facts(), found.alone)


@pytest.mark.slow
def test_where_one_has_no_solution_the_others_stay_together(monkeypatch: pytest.MonkeyPatch) -> None:
    def odd(own: Any, *_: Any) -> bool:
        return bool(abs(own.scene.chain.mechanism.links[0].points["A"] - 0.2) < 1e-9)

    error = SingularityError("dead", where="forces")
    monkeypatch.setattr(records, "forces_of", failing(error, odd, records.forces_of))
    rows = stacked.solve_points(facts(), range(17))
    assert [row.point for row in rows if row.alone] == [8]
    assert "limit position" in rows[8].alone


@sparing("ends", ["0:0.3", "0.3:0"], every=2)
@sparing("columns", [("forces.max(R_A)",), FACTS], every=2)
def test_friction_from_nothing(ends: str, columns: tuple[str, ...]) -> None:
    task = task_of(SHAPER, [RANGE[0], f"mechanism.joints[name=A3].friction={ends}:17"], None, (), columns)
    rows = stacked.solve_points(task, range(17))
    none = 0 if ends.startswith("0:") else 16
    assert {row.point: row.alone for row in rows if row.alone} == {none: stacked.UNLIKE}
    which = (0, 1, 8, 15, 16)
    for one, other in zip([rows[k] for k in which], points.solve_points(task, which), strict=True):
        assert one.names == other.names
        assert one.values == pytest.approx(other.values, rel=1e-11, abs=1e-9)


@sparing(
    ("name", "key", "end", "columns"),
    [
        ("press", "mechanism.joints[name=B0].friction", 0.05, ("forces.mean(*)",)),  # two rows where it turns back
        ("scotch-yoke", "mechanism.joints[name=D0].friction", 0.05, ("reduction.*",)),  # a cause of a moment
        ("press", "mechanism.gravity", 5, ("reduction.*",)),  # another
    ],
    every=3,
)
@sparing("order", [1, -1], every=2)
def test_what_is_nothing_in_one_variant(name: str, key: str, end: float, columns: tuple[str, ...], order: int) -> None:
    ends = ":".join(["0", str(end)][::order])
    task = task_of(SHAPER.with_name(f"{name}.toml"), [RANGE[0], f"{key}={ends}:17"], None, (), columns)
    which = (0, 8, 16)
    found, alone = stacked.solve_points(task, which), points.solve_points(task, which)
    assert sum(not row.alone for row in found) == 2
    for one, other in zip(found, alone, strict=True):
        assert one.names == other.names
        values = {n: (a, b) for n, a, b in zip(one.names, one.values, other.values, strict=True) if exact(n)}
        largest = max(abs(b) for _, b in values.values())
        assert all(abs(a - b) <= 1e-9 * max(abs(b), 1e-3 * largest) for a, b in values.values())


@pytest.mark.slow
def test_friction_that_only_some_have(tmp_path: Path) -> None:
    """Each of two joints rubs where the other does not: no variant has all the friction that there is."""
    keys = [f"mechanism.joints[name={name}].friction" for name in ("A3", "D0")]
    table = tmp_path / "t.csv"
    table.write_text(",".join(keys) + "\n" + "".join(f"{0.1 * (k % 2)},{0.1 * ((k + 1) % 2)}\n" for k in range(16)))
    task = task_of(SHAPER, [RANGE[0]], table, (), ("forces.mean(R_A)",))
    rows, alone = stacked.solve_points(task, range(16)), points.solve_points(task, range(16))
    assert [row.values[0] for row in rows] == pytest.approx([row.values[0] for row in alone], rel=1e-11)
    assert {row.alone for row in rows} == {"", stacked.UNLIKE}


@pytest.mark.slow
def test_yes_and_no_are_told_where_a_number_of_the_machine_varies() -> None:
    task = task_of(SHAPER, [RANGE[0], "motion.inertia=20:40:16"], None, (), ("flywheel.existing_suffices",))
    rows = stacked.solve_points(task, range(16))
    assert [(row.alone, list(row.values)) for row in rows] == [("", [1.0])] * 16
