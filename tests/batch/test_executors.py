"""Points solved by other processes: the rows are the same, and a killed process loses none."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
import sweeptoy

from tmmcalc.batch import executors
from tmmcalc.batch.choice import chosen
from tmmcalc.batch.executors import solve, solve_by, solve_there
from tmmcalc.batch.local import processes
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.task import Row, Task
from tmmcalc.core.errors import UsageError

pytestmark = pytest.mark.skipif(os.name != "posix", reason="kills processes")
CONFIGS = Path(__file__).parents[2] / "configs"


def blocks(task: Task) -> list[range]:
    return [range(at, min(at + task.block, task.count)) for at in range(0, task.count, task.block)]


def by_processes(task: Task, told: list[str]) -> list[Row]:
    return [row for rows in solve_by(processes(2), task, blocks(task), told.append) for row in rows]


@pytest.fixture(scope="module", autouse=True)
def paths() -> Iterator[None]:
    """Processes find the solvers of the tests."""
    pytest.importorskip("joblib")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", str(Path(__file__).parents[1]))
        yield


def expected(task: Task) -> list[Row]:
    return sweeptoy.square(task, range(task.count))


def sorted_rows(rows: list[Row]) -> list[Row]:
    return sorted(rows, key=lambda row: row.point)


def test_local_processes(tmp_path: Path) -> None:
    task, told = sweeptoy.task(tmp_path, 26, block=4), list[str]()
    assert sorted_rows(by_processes(task, told)) == expected(task)
    assert told == []


@pytest.mark.slow
def test_a_killed_process_loses_no_point(tmp_path: Path) -> None:
    task, told = sweeptoy.task(tmp_path, solver="killed_once"), list[str]()
    assert sorted_rows(by_processes(task, told)) == expected(task)
    assert len(told) == 1
    assert told[0].startswith("a process died")


@pytest.mark.slow
def test_a_point_that_kills_its_process_fails_alone(tmp_path: Path) -> None:
    task, told = sweeptoy.task(tmp_path, 12, solver="killed"), list[str]()
    rows = sorted_rows(by_processes(task, told))
    assert [row for row in rows if row.point != 7] == [row for row in expected(task) if row.point != 7]
    assert rows[7].status == "failed 1"
    assert "died 2 times" in rows[7].reason


def test_a_worker_of_another_version_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    task = sweeptoy.task(tmp_path)
    assert solve_there(executors.__version__, task, [3]) == solve(task, [3])
    with pytest.raises(UsageError, match="a worker has version"):
        solve_there("0.0", task, [3])


def test_processes_are_for_long_stages() -> None:
    short = task_of(CONFIGS / "shaper.toml", ["motion.inertia=40:50:50"], None, ("motion",), ())
    assert chosen(short, None, 2)[1] == 1
    assert chosen(short, 3, 2)[1] == 3
    long = task_of(CONFIGS / "elastic-drive.toml", ["motor.start=*1:1.2:50"], None, ("transient",), ())
    task, jobs = chosen(long, None, 2)
    assert (task.block, jobs) == (1, 2)
    few = task_of(CONFIGS / "elastic-drive.toml", ["motor.start=*1:1.2:3"], None, ("transient",), ())
    assert chosen(few, None, 2)[1] == 1


def test_joblib_that_is_not_there(monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "joblib", None)
    with pytest.raises(UsageError, match=r"install .*\[parallel\]"):
        processes(2)
