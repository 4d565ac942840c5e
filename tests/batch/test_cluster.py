"""A sweep on a real Dask cluster: a scheduler and two workers on the loopback, one of which is killed."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

import pytest
import sweeptoy

from tmmcalc.batch.cluster import solve_on
from tmmcalc.batch.task import Row, Task
from tmmcalc.core.errors import UsageError

pytestmark = pytest.mark.skipif(os.name != "posix" or not find_spec("distributed"), reason="kills processes of Dask")
ROOT = Path(__file__).parents[2]


class Cluster(NamedTuple):
    address: str
    scheduler: subprocess.Popen[str]
    workers: list[subprocess.Popen[str]]


def start(folder: Path, *args: str) -> subprocess.Popen[str]:
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{ROOT / 'tests'}"}
    command = [sys.executable, "-m", "distributed.cli." + args[0], *args[1:], "--no-dashboard"]
    return subprocess.Popen(command, cwd=folder, env=environment, stderr=subprocess.PIPE, text=True)


def line_of(process: subprocess.Popen[str], pattern: str) -> str:
    """What a line of its log says."""
    assert process.stderr is not None
    for line in process.stderr:
        if match := re.search(pattern, line):
            return match[1]
    raise AssertionError(f"the process ended with code {process.wait()}")


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    scheduler = start(tmp_path, "dask_scheduler", "--host", "127.0.0.1", "--port", "0")
    workers = []
    try:
        address = line_of(scheduler, r"Scheduler at:\s*(tcp://\S+)")
        for _ in range(2):
            workers.append(
                start(tmp_path, "dask_worker", address, "--nthreads", "1", "--no-nanny", "--host", "127.0.0.1")
            )
        for worker in workers:
            line_of(worker, r"(Registered to)")
        yield Cluster(address, scheduler, workers)
    finally:
        for process in (*workers, scheduler):
            process.kill()
            process.wait()
            assert process.stderr is not None
            process.stderr.close()


def solved(cluster: Cluster, task: Task, told: list[str]) -> Iterator[list[Row]]:
    blocks = [range(at, min(at + task.block, task.count)) for at in range(0, task.count, task.block)]
    return solve_on(cluster.address, task, blocks, told.append)


@pytest.mark.slow
def test_a_worker_that_is_killed_in_the_middle_loses_no_point(cluster: Cluster, tmp_path: Path) -> None:
    task, rows, told = sweeptoy.task(tmp_path, 40, solver="slow"), list[Row](), list[str]()
    for some in solved(cluster, task, told):
        rows += some
        if len(rows) == 8:
            cluster.workers[0].send_signal(signal.SIGKILL)
    assert cluster.workers[0].wait(10) == -signal.SIGKILL
    assert sorted(rows, key=lambda row: row.point) == sweeptoy.square(task, range(40))
    assert told == []  # the scheduler gives the work to the other worker


@pytest.mark.slow
def test_a_worker_that_comes_later_is_waited_for(cluster: Cluster, tmp_path: Path) -> None:
    for worker in cluster.workers:
        worker.kill()
        worker.wait()
    late = start(tmp_path, "dask_worker", cluster.address, "--nthreads", "1", "--no-nanny", "--host", "127.0.0.1")
    cluster.workers.append(late)
    task = sweeptoy.task(tmp_path, 6)
    rows = [row for some in solved(cluster, task, []) for row in some]
    assert sorted(rows, key=lambda row: row.point) == sweeptoy.square(task, range(6))


@pytest.mark.slow
def test_a_scheduler_that_goes(cluster: Cluster, tmp_path: Path) -> None:
    rows = solved(cluster, sweeptoy.task(tmp_path, 40, solver="slow"), [])
    next(rows)
    cluster.scheduler.kill()
    with pytest.raises(UsageError, match="is gone"):
        list(rows)


@pytest.mark.slow
def test_a_connection_that_is_given_up_while_work_goes_out(
    cluster: Cluster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from distributed.client import Client, ClosedClientError

    def given_up(client: Client, **_: object) -> None:
        client.close()
        raise ClosedClientError("Client is closed. Can't send cancel-keys message.")

    monkeypatch.setattr(Client, "get_executor", given_up)
    with pytest.raises(UsageError, match="is gone"):
        next(solved(cluster, sweeptoy.task(tmp_path, 4), []))


def test_nobody_at_the_address(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tmmcalc.batch.cluster.REACH", 0.5)
    began = time.monotonic()
    with pytest.raises(UsageError, match="no Dask scheduler answers"):
        next(solve_on("tcp://127.0.0.1:9", sweeptoy.task(tmp_path), [range(2)], print))
    assert time.monotonic() - began < 10


@pytest.mark.slow
def test_workers_without_the_program(cluster: Cluster, tmp_path: Path) -> None:
    task = sweeptoy.task(tmp_path, 4)
    task = Task(task.text, task.file, task.folder, (), task.axes, solver="no_such_module:solve")
    with pytest.raises(UsageError, match="cannot run tmmcalc: ModuleNotFoundError"):
        list(solved(cluster, task, []))


@pytest.mark.slow
def test_the_command_gives_the_same_table(
    cluster: Cluster, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from tmmcalc.cli import main

    crank = "mechanism.links[id=1].points.A[0]=*0.9:1.5:6"
    spec = str(ROOT / "configs" / "shaper.toml")
    sweep = ["tmmcalc", "sweep", spec, "--set", crank, "--set", "mechanism.grid.positions=12", "--to", "kinematics"]
    monkeypatch.chdir(tmp_path)
    for more in (["-o", "here.csv"], ["-o", "there.csv", "--scheduler", cluster.address]):
        monkeypatch.setattr(sys, "argv", [*sweep, *more])
        with pytest.raises(SystemExit) as ended:
            main()
        assert not ended.value.code
    assert Path("there.csv").read_bytes() == Path("here.csv").read_bytes()
    assert "wrote there.csv" in capsys.readouterr().err


@pytest.mark.slow
def test_a_search_there_finds_the_same_though_a_worker_is_killed(cluster: Cluster, tmp_path: Path) -> None:
    from tmmcalc.design.optimize.scene import optimize

    asked = """
[optimize]
least = "kinematics.size(omega_3)"
evaluations = 100
variables = [{ of = "mechanism.links[id=1].points.A[0]", at_least = "50 mm", at_most = "200 mm" }]
[[constraints]]
name = "swing"
value = "kinematics.range(angle_3)"
at_least = "42 deg"
"""
    file = tmp_path / "four.toml"
    file.write_text((ROOT / "configs" / "four-bar.toml").read_text() + asked)
    told: list[str] = []

    def killed(solved: int, words: str) -> None:
        if solved > 50 and cluster.workers[0].poll() is None:
            cluster.workers[0].send_signal(signal.SIGKILL)

    there = optimize(file, scheduler=cluster.address, tell=told.append, told=killed)
    assert cluster.workers[0].wait(10) == -signal.SIGKILL
    assert there == optimize(file)
