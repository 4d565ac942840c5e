"""The program as a process: pipes, terminals, signals, two at once, and what it imports."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from sparing import sparing

from .conftest import Cli, environment

posix = pytest.mark.skipif(os.name != "posix", reason="needs pipes, terminals and signals of a Unix")


@pytest.mark.slow
def test_results_alone_go_to_standard_output(process: Cli) -> None:
    code, out, err = process("kinematics", "my.toml", "--format", "json", "--set", "mechanism.grid.positions=4")
    assert code == 0
    assert len(json.loads(out)["columns"]["phi[deg]"]) == 5
    assert re.fullmatch(
        r"2 stages computed in \d+ ms\n"
        r"files in my.out: kinematics.csv, 3 files of the stages\n",
        err,
    )
    assert process("kinematics", "my.toml", "-q", "-f", "csv").err == ""


@pytest.mark.parametrize(
    ("args", "code"),
    [
        (("kinematics", "none.toml"), 2),
        (("kinematics", "my.toml", "--set", 'mechanism.links[id=1].points.A=["700 mm", 0]'), 3),
    ],
)
def test_a_fault_of_the_user_shows_no_traceback(process: Cli, args: tuple[str, ...], code: int) -> None:
    answer = process(*args)
    assert (answer.code, answer.out) == (code, "")
    assert "error: " in answer.err
    assert "\n  -> " in answer.err
    assert "Traceback" not in answer.err
    assert "\033" not in answer.err


@posix
@sparing("args", [("kinematics", "my.toml", "-f", "csv", "-q"), ("schema",), ("check", "none.toml")], every=3)
def test_a_reader_that_has_gone_is_no_fault(folder: Path, args: tuple[str, ...]) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "tmmcalc", *args],
        cwd=folder,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    assert process.stdout is not None
    process.stdout.close()
    _, err = process.communicate(timeout=60)
    assert process.returncode == (2 if args[0] == "check" else 0)
    assert b"Broken" not in err
    assert b"Traceback" not in err


@pytest.mark.slow
@posix
def test_interrupt(folder: Path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "tmmcalc", "run", "my.toml", "-v", "--set", "mechanism.grid.positions=200000", "--csv"],
        cwd=folder,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # a background job inherits it as ignored
    )
    assert process.stderr is not None
    assert any(line.startswith("structure: computed") for line in process.stderr)
    time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    status = process.returncode if process.returncode >= 0 else 128 - process.returncode  # as a shell tells it
    assert (status, out) == (130, ""), err
    assert "Traceback" not in err
    assert not list((folder / "my.out").glob("*.tmp"))
    assert not (folder / "my.out" / "kinematics.csv").exists()


@pytest.mark.slow
def test_two_runs_at_once(folder: Path) -> None:
    runs = [
        subprocess.Popen(
            [sys.executable, "-m", "tmmcalc", "run", "my.toml", "-q"],
            cwd=folder,
            env=environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        for _ in range(2)
    ]
    answers = [run.communicate(timeout=60) for run in runs]
    assert [run.returncode for run in runs] == [0, 0]
    assert answers[0] == answers[1]
    assert answers[0][1] == b""


def on_terminal(folder: Path, width: int, *args: str, **more: str) -> str:
    """What a command shows on a terminal of this width."""
    import fcntl
    import pty
    import struct
    import termios

    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, width, 0, 0))
    env = environment(TERM="xterm-256color", **more)
    del env["COLUMNS"]
    process = subprocess.Popen(
        [sys.executable, "-m", "tmmcalc", *args], cwd=folder, env=env, stdin=theirs, stdout=theirs, stderr=theirs
    )
    os.close(theirs)
    shown = b""
    try:
        while piece := os.read(ours, 65536):
            shown += piece
    except OSError:  # how Linux says that the other end is closed
        pass
    process.wait(timeout=60)
    os.close(ours)
    return shown.decode().replace("\r\n", "\n")


@pytest.mark.slow
@posix
def test_a_terminal_shows_whole_numbers_in_its_width(folder: Path) -> None:
    """Columns that do not fit are left out; no digit of those that are shown is lost."""
    shown = re.sub(r"\x1b\[[0-9;]*m", "", on_terminal(folder, 70, "kinematics", "my.toml", "--positions", "0:3"))
    assert max(map(len, shown.splitlines())) <= 70
    row = next(line.split() for line in shown.splitlines() if line.startswith("1 "))
    assert row[:6] == ["1", "15", "-3.8191", "-0.009927", "-0.41888", "-8.0972"]
    assert "…" not in shown


@pytest.mark.slow
@posix
def test_colour_on_a_terminal_only_and_not_against_the_will(folder: Path) -> None:
    fault = ("check", "none.toml")
    assert "\033[31m" in on_terminal(folder, 80, *fault)
    assert "\033" not in on_terminal(folder, 80, *fault, NO_COLOR="1")


@pytest.mark.slow
@posix
def test_a_long_stage_shows_that_it_runs_and_a_short_one_does_not(folder: Path) -> None:
    show = ("--columns", "phi", "--positions", "0")
    long = on_terminal(folder, 80, "kinematics", "my.toml", "--set", "mechanism.grid.positions=600000", *show)
    assert "kinematics: running" in long
    assert long.index("kinematics: running") < long.index("2 stages computed in")
    short = on_terminal(folder, 80, "kinematics", "my.toml", *show)
    assert "running" not in short


def imported(folder: Path, *args: str) -> set[str]:
    """Modules that a command imports beyond those of typer itself."""
    code = (
        "import sys, typer; before = set(sys.modules); from tmmcalc.cli import main\n"
        f"sys.argv = ['tmmcalc', *{args!r}]\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "print(*(set(sys.modules) - before), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=folder, env=environment(), capture_output=True, text=True)
    return set(done.stderr.splitlines()[-1].split())


def test_help_imports_no_work(folder: Path) -> None:
    modules = imported(folder, "--help")
    assert not modules & {"numpy", "scipy", "pydantic", "rich", "tmmcalc.project", "tmmcalc.cli.kinematics"}


def test_check_imports_no_numbers(folder: Path) -> None:
    modules = imported(folder, "check", "my.toml")
    assert "tmmcalc.project" in modules
    assert not modules & {"numpy", "scipy", "rich", "tmmcalc.pipeline.runner", "tmmcalc.linkage.kinematics"}


@pytest.mark.slow
def test_kinematics_to_a_pipe_imports_what_it_needs(folder: Path) -> None:
    spared = {"scipy", "reportlab", "rich", "difflib"}
    first = imported(folder, "kinematics", "my.toml", "-q")
    assert "numpy" in first
    assert not first & spared
    again = imported(folder, "kinematics", "my.toml", "-q")
    assert not again & {*spared, "tomli_w"}  # nothing to write
