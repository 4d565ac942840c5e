"""A sweep from its task to its table: order, what fails, what is kept, what is not done again."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
import sweeptoy

from tmmcalc.batch.executors import Block, solve_here
from tmmcalc.batch.sheet import csv_bytes, voucher
from tmmcalc.batch.sweep import part, sweep
from tmmcalc.batch.task import Row, Task
from tmmcalc.core.errors import NoSolutionError, SpecError, UsageError


def counting(met: list[int], stop: int | None = None):
    """A solver that notes the points which it was asked for, and is interrupted after ``stop`` of them."""

    def solver(task: Task, blocks: Iterable[Block]) -> Iterator[list[Row]]:
        for block in blocks:
            if stop is not None and len(met) >= stop:
                raise KeyboardInterrupt
            met.extend(block)
            yield from solve_here(task, [block])

    return solver


def backwards(task: Task, blocks: Iterable[Block]) -> Iterator[list[Row]]:
    return solve_here(task, reversed(list(blocks)))


@pytest.fixture(params=["t.csv", "t.parquet"])
def out(tmp_path: Path, request: pytest.FixtureRequest) -> Path:
    return tmp_path / str(request.param)


def test_the_table(tmp_path: Path) -> None:
    out = tmp_path / "t.csv"
    swept = sweep(sweeptoy.task(tmp_path, 6), solve_here, out)
    assert out.read_text() == (
        "flywheel.delta,flywheel.inertia[kg*m^2],flywheel.square,flywheel.cube[m],status,reason\n"
        "1,0,1.0,1.0,ok,\n"
        "1,0.5,2.25,3.375,ok,\n"
        "2,0,4.0,8.0,ok,\n"
        "2,0.5,6.25,15.625,ok,\n"
        "3,0,9.0,27.0,ok,\n"
        '3,0.5,,,failed 3,"toy: 3.5, as asked"\n'
    )
    assert (swept.loaded, swept.resumed, swept.sheet.failed) == (False, 0, 1)
    assert not part(out).exists()


def test_the_order_in_which_points_are_solved_changes_no_byte(out: Path, tmp_path: Path) -> None:
    sweep(sweeptoy.task(tmp_path), solve_here, out)
    sweep(sweeptoy.task(tmp_path, block=5), backwards, out.with_stem("b"))
    nowhere = sweep(sweeptoy.task(tmp_path, block=100), backwards)
    assert out.read_bytes() == out.with_stem("b").read_bytes()
    assert out.suffix != ".csv" or out.read_bytes() == csv_bytes(nowhere.sheet)


def test_a_sweep_goes_on_where_it_was_stopped(out: Path, tmp_path: Path) -> None:
    task = sweeptoy.task(tmp_path)
    sweep(task, solve_here, out.with_stem("whole"))
    first: list[int] = []
    with pytest.raises(KeyboardInterrupt):
        sweep(task, counting(first, stop=10), out)
    assert part(out).exists()
    assert not out.exists()
    second: list[int] = []
    swept = sweep(task, counting(second), out)
    assert (swept.resumed, sorted(first + second)) == (10, list(range(24)))
    assert out.read_bytes() == out.with_stem("whole").read_bytes()
    assert not part(out).exists()


def test_one_that_is_up_to_date_is_not_repeated(out: Path, tmp_path: Path) -> None:
    task = sweeptoy.task(tmp_path)
    first = sweep(task, solve_here, out)
    before = out.stat().st_mtime_ns
    met: list[int] = []
    again = sweep(task, counting(met), out)
    assert (again.loaded, met, out.stat().st_mtime_ns) == (True, [], before)
    assert csv_bytes(again.sheet) == csv_bytes(first.sheet)
    assert sweep(task, counting(met), out, fresh=True).loaded is False
    assert (len(met), out.stat().st_mtime_ns) == (24, before)  # the same bytes: the file is not touched


def test_points_that_broke_are_tried_again(out: Path, tmp_path: Path) -> None:
    broken = Row(0, "failed 1", "its process died 2 times")
    sweep(sweeptoy.task(tmp_path, 2), lambda task, blocks: iter([[broken, sweeptoy.row(task, 1)]]), out)
    assert b"failed 1" in out.read_bytes()
    again = sweep(sweeptoy.task(tmp_path, 2), solve_here, out)
    assert (again.loaded, again.sheet.failed) == (False, 0)


def test_of_a_finished_table_only_what_broke_is_solved_again(out: Path, tmp_path: Path) -> None:
    task = sweeptoy.task(tmp_path)
    sweep(task, solve_here, out.with_stem("whole"))
    good = [sweeptoy.row(task, point) for point in range(24)]
    for broken in (0, 7, 23):  # point 5 has failed and stays so
        rows = [*good[:broken], Row(broken, "failed 1", "a fault of the program"), *good[broken + 1 :]]
        sweep(task, lambda task, blocks, rows=rows: iter([rows]), out, fresh=True)
        met: list[int] = []
        again = sweep(task, counting(met), out)
        assert (met, again.loaded, again.resumed) == ([broken], False, 23)
        assert out.read_bytes() == out.with_stem("whole").read_bytes()
        assert sweep(task, counting(met), out).loaded


def test_a_table_and_a_journal_of_one_task_count_each_point_once(out: Path, tmp_path: Path) -> None:
    task = sweeptoy.task(tmp_path)
    good = [sweeptoy.row(task, point) for point in range(24)]
    rows = [Row(0, "failed 1", "a fault of the program"), *good[1:]]
    sweep(task, lambda task, blocks: iter([rows]), out)
    met: list[int] = []
    with pytest.raises(KeyboardInterrupt):
        sweep(task, counting(met, stop=10), out, fresh=True)
    told: list[tuple[int, int]] = []
    again = sweep(task, counting(met), out, told=lambda done, failed: told.append((done, failed)))
    assert (len(met), again.resumed, again.sheet.failed, told) == (10, 24, 1, [])


def test_another_task_or_a_changed_table_is_solved_again(out: Path, tmp_path: Path) -> None:
    sweep(sweeptoy.task(tmp_path), solve_here, out)
    assert not sweep(sweeptoy.task(tmp_path, 26), solve_here, out).loaded
    whole = out.read_bytes()
    out.write_bytes(whole[:70] + bytes([whole[70] ^ 1]) + whole[71:])
    assert not sweep(sweeptoy.task(tmp_path, 26), solve_here, out).loaded
    assert out.read_bytes() == whole
    voucher(out).write_text("not toml")
    assert not sweep(sweeptoy.task(tmp_path, 26), solve_here, out).loaded
    voucher(out).unlink()
    assert not sweep(sweeptoy.task(tmp_path, 26), solve_here, out).loaded


def test_a_file_that_the_spec_names_belongs_to_the_task(out: Path, tmp_path: Path) -> None:
    (tmp_path / "q.csv").write_text("phi[deg],Q[N]\n0,0\n180,1500\n")
    text = '[torque]\nspeed = "20 rad/s"\n[torque.table]\nfile = "q.csv"\n'
    task = sweeptoy.task(tmp_path)
    task = Task(text, task.file, task.folder, (), task.axes, solver=task.solver)
    sweep(task, solve_here, out)
    assert sweep(task, solve_here, out).loaded
    (tmp_path / "q.csv").write_text("phi[deg],Q[N]\n0,0\n180,1501\n")
    assert not sweep(task, solve_here, out).loaded


def test_a_journal_of_another_task_is_not_used(out: Path, tmp_path: Path) -> None:
    met: list[int] = []
    with pytest.raises(KeyboardInterrupt):
        sweep(sweeptoy.task(tmp_path), counting(met, stop=10), out)
    swept = sweep(sweeptoy.task(tmp_path, 26), solve_here, out)
    assert swept.resumed == 0


def test_too_many_failures_end_the_sweep_and_keep_what_is_done(out: Path, tmp_path: Path) -> None:
    with pytest.raises(NoSolutionError, match="1 points have failed"):
        sweep(sweeptoy.task(tmp_path), solve_here, out, most_failed=0)
    assert part(out).exists()
    assert sweep(sweeptoy.task(tmp_path), solve_here, out, most_failed=1).resumed == 6


def test_no_valid_variant_at_all_is_one_error_and_leaves_nothing(out: Path, tmp_path: Path) -> None:
    with pytest.raises(SpecError, match=r"flywheel\.delta"):  # toy deltas of 1 and more are no valid ones
        sweep(sweeptoy.task(tmp_path, solver="invalid"), solve_here, out)
    assert list(tmp_path.iterdir()) == []


def test_a_pattern_that_names_nothing_is_told_before_the_work(out: Path, tmp_path: Path) -> None:
    from tmmcalc.batch.reading import task_of

    spec = tmp_path / "t.toml"
    spec.write_text(sweeptoy.TORQUE)
    met: list[int] = []
    with pytest.raises(UsageError, match=r"'flywheel\.J_X'\n.*did you mean .*flywheel\.J_F"):
        sweep(task_of(spec, ["flywheel.delta=0.01:0.1:9"], None, (), ("flywheel.J_X",)), counting(met), out)
    assert (met, list(tmp_path.iterdir())) == ([], [spec])


def test_progress_is_told(tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    sweep(sweeptoy.task(tmp_path, 8), solve_here, told=lambda done, failed: told.append((done, failed)))
    assert told == [(2, 0), (4, 0), (6, 1), (8, 1)]
