"""Killed runs, full disks, two runs at once: in real processes, with real signals."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.pipeline.lock import locked

from . import toy
from .toy import Spec, contents, go, shown

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals and fork of POSIX")

OLD = Spec()
NEW = replace(OLD, radius=0.25, positions=31)
BIG = (replace(OLD, positions=60_000), replace(NEW, positions=60_001))


def forked(body: Callable[[], None]) -> int:
    """Run `body` in a child process; return its wait status (0: it ended well)."""
    child = os.fork()
    if child == 0:
        code = 1
        try:
            body()
            code = 0
        finally:
            os._exit(code)
    return os.waitpid(child, 0)[1]


def kill_at(call: str, count: int, after: bool) -> None:
    """Make the `count`-th call of an os function from now on the last thing that this process does."""
    original, left = getattr(os, call), [count]

    def deadly(*args, **kwargs):
        left[0] -= 1
        if left[0] == 0 and not after:
            os.kill(os.getpid(), signal.SIGKILL)
        result = original(*args, **kwargs)
        if left[0] == 0:
            os.kill(os.getpid(), signal.SIGKILL)
        return result

    setattr(os, call, deadly)


def killed_run(spec: Spec, out: Path, call: str, count: int, after: bool, **more) -> bool:
    """Run until the kill point; return False if the run ended before it."""

    def body() -> None:
        kill_at(call, count, after)
        go(spec, out, **more)

    status = forked(body)
    assert status in (0, signal.SIGKILL)
    return status != 0


def reference(folder: Path, spec: Spec, **more) -> dict[str, bytes]:
    go(spec, folder, **more)
    return contents(folder)


def check_whole(out: Path, *versions: dict[str, bytes]) -> None:
    """Each visible file is whole, of one version or the other."""
    for name, data in contents(out).items():
        if not name.startswith("."):
            assert data in [version.get(name) for version in versions], f"{name} is neither old nor new"


@sparing("after", [False, True], every=2)
@sparing("call", ["replace", "getpid"], every=2)
def test_killed_at_every_step_of_the_writes(tmp_path: Path, call: str, after: bool):
    old, new = reference(tmp_path / "old", OLD), reference(tmp_path / "new", NEW)
    count, killed = 0, True
    while killed:
        count += 1
        for then, expected in ((NEW, new), (OLD, old)):
            out = tmp_path / f"{count} {then.radius}"
            go(OLD, out)
            killed = killed_run(NEW, out, call, count, after)
            check_whole(out, old, new)
            result = go(then, out)
            assert contents(out) == expected
            assert result.results["energy"].total == go(then).results["energy"].total
    assert count > 6  # files written: one of geometry, three of path, two of energy


@sparing("after", [False, True], every=2)
def test_killed_while_a_csv_is_removed(tmp_path: Path, after: bool):
    old, new = reference(tmp_path / "old", OLD), reference(tmp_path / "new", OLD, csv=False)
    count, killed = 0, True
    while killed:
        count += 1
        out = tmp_path / str(count)
        go(OLD, out)
        killed = killed_run(OLD, out, "unlink", count, after, csv=False)
        check_whole(out, old, new)
        result = go(OLD, out, csv=False)
        assert contents(out) == new
        assert "damaged" not in [kind for _, kind in shown(result)]


@sparing("limit", [0, 1, 100, 700, 1500, 2500], every=3, first=2)
@pytest.mark.parametrize("deadly", [True, False])
def test_disk_that_ends_in_the_middle_of_a_file(tmp_path: Path, limit: int, deadly: bool):
    """The kernel stops the write at the limit, by a signal that kills or by an error as of a full disk."""
    import resource

    old, new = reference(tmp_path / "old", OLD), reference(tmp_path / "new", NEW)
    out = tmp_path / "out"
    go(OLD, out)

    def body() -> None:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL if deadly else signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        with pytest.raises(UsageError, match=f"{out}.*cannot be written: File too large"):
            go(NEW, out)

    status = forked(body)
    assert (os.WTERMSIG(status) == signal.SIGXFSZ) if deadly else (status == 0)
    leftovers = [name for name in contents(out) if name.endswith(".tmp")]
    assert bool(leftovers) == deadly
    check_whole(out, old, new)
    go(NEW, out)
    assert contents(out) == new


@pytest.mark.slow
def test_killed_at_random_while_large_files_are_written(tmp_path: Path):
    versions = [reference(tmp_path / str(at), spec, csv=False) for at, spec in enumerate(BIG)]
    out, dice = tmp_path / "out", random.Random(7)
    for at in range(10):
        child = os.fork()
        if child == 0:
            while True:
                for spec in BIG:
                    go(spec, out, csv=False)
        time.sleep(dice.uniform(0.005, 0.25))
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        if out.exists():
            check_whole(out, *versions)
        go(BIG[at % 2], out, csv=False)
        assert contents(out) == versions[at % 2]


CHILD = """
import sys
from importlib import import_module
from pathlib import Path
toy = import_module(sys.argv[1])
out, positions, rounds = Path(sys.argv[2]), [int(n) for n in sys.argv[3].split(",")], int(sys.argv[4])
for _ in range(rounds):
    for n in positions:
        result = toy.go(toy.Spec(positions=n), out)
        assert "damaged" not in [kind for _, kind in toy.shown(result)], result.events
        assert result.results["energy"].by_position.shape == (n,)
        assert result.results["energy"].total == toy.go(toy.Spec(positions=n)).results["energy"].total
print("done", flush=True)
"""


def start(out: Path, positions: str, rounds: int) -> subprocess.Popen[str]:
    env = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", CHILD, toy.__name__, str(out), positions, str(rounds)]
    return subprocess.Popen(command, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


@pytest.mark.slow
def test_two_runs_at_once_do_not_spoil_the_folder(tmp_path: Path):
    out = tmp_path / "out"
    children = [start(out, "1500,25", 25), start(out, "25,1501", 25)]
    for child in children:
        output, errors = child.communicate(timeout=120)
        assert (output, errors) == ("done\n", "")
    assert not [name for name in contents(out) if name.endswith(".tmp")]
    go(OLD, out)
    assert contents(out) == reference(tmp_path / "alone", OLD)


def test_two_equal_runs_at_once_agree(tmp_path: Path):
    children = [start(tmp_path / "out", "1999", 1) for _ in range(2)]
    for child in children:
        assert child.communicate(timeout=60) == ("done\n", "")
    assert contents(tmp_path / "out") == reference(tmp_path / "alone", replace(OLD, positions=1999))


def test_a_run_waits_for_the_lock_and_a_killed_holder_frees_it(tmp_path: Path):
    go(OLD, tmp_path)
    with locked(tmp_path):
        child = start(tmp_path, "25", 1)
        with pytest.raises(subprocess.TimeoutExpired):
            child.communicate(timeout=1.5)
    assert child.communicate(timeout=30) == ("done\n", "")

    def die_with_the_lock() -> None:
        with locked(tmp_path):
            os.kill(os.getpid(), signal.SIGKILL)

    assert forked(die_with_the_lock) == signal.SIGKILL
    assert shown(go(OLD, tmp_path)) == [(stage, "loaded") for stage in toy.TOY]
