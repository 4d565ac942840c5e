"""Full disks, pipes, held folders, escapes and interrupts, through the command line."""

from __future__ import annotations

import fcntl
import os
import subprocess
import sys
from pathlib import Path

import pytest
from sparing import sparing

from tmmcalc.core.printable import hidden

from .conftest import CONFIGS, Cli, environment

pytestmark = pytest.mark.skipif(os.name != "posix", reason="devices, pipes and locks of a Unix")

FULL = [
    ("--help",),
    ("check", "my.toml"),
    ("kinematics", "my.toml", "-q", "-f", "json"),
    ("run", "--help"),
    ("completion",),
    ("--version",),
    ("schema",),
    ("init", "--list"),
    ("init", "shaper"),
    ("plan", "my.toml"),
    ("run", "my.toml", "-q"),
    ("kinematics", "my.toml", "-q"),
    ("kinematics", "my.toml", "-q", "-f", "csv"),
    ("kinematics", "my.toml", "-q", "-f", "toml"),
    ("sweep", "my.toml", "-q", "-o", "-", "--set", "mechanism.grid.positions=12,24"),
]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a disk that is full")
@sparing("args", FULL, every=4)
def test_a_full_disk_is_one_message(folder: Path, args: tuple[str, ...]) -> None:
    told = {} if args != ("completion",) else {"_TMMCALC_COMPLETE": "source_bash"}  # as a shell asks for it
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "tmmcalc", *(() if told else args)],
            cwd=folder,
            env=environment(**told),
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            timeout=60,
        )
    assert done.returncode == 2
    assert done.stderr == (
        "error: standard output cannot be written: No space left on device\n"
        "  -> free the disk, or send the output elsewhere\n"
    )


def test_closed_streams_are_no_fault(folder: Path) -> None:
    command = f"{sys.executable} -m tmmcalc"
    for line, code in ((f"{command} --version >&-", 0), (f"{command} check none.toml 2>&-", 2)):
        done = subprocess.run(line, shell=True, cwd=folder, env=environment(), capture_output=True, timeout=60)
        assert (done.returncode, done.stderr) == (code, b"")


def test_what_is_echoed_steers_no_terminal(cli: Cli, folder: Path) -> None:
    hostile = "a\x1b[31m\u202e\x07[red]"
    (folder / f"{hostile}.toml").write_bytes((folder / "my.toml").read_bytes())
    for args in (
        ("check", f"{hostile}.toml"),
        ("check", f"{hostile}.tom"),
        ("run", f"--{hostile}", "my.toml"),
        (hostile,),
        ("plan", "my.toml", "--to", hostile),
        ("check", "my.toml", "--set", f"{hostile}=1"),
        ("check", "my.toml", "--set", f'project.title="{hostile}"'),
        ("kinematics", "my.toml", "-q", "--columns", hostile),
        ("kinematics", "my.toml", "-q", "--set", f"mechanism.grid.positions={hostile}"),
        ("kinematics", f"{hostile}.toml", "--positions", "0"),
        ("run", f"{hostile}.toml", "my.toml"),
    ):
        answer = cli(*args)
        shown = (answer.out + answer.err).replace("\n", "")
        assert not hidden(shown), args
        assert shown, args
    assert r"a\x1b[31m" in answer.out


@pytest.mark.parametrize("name", ["[" * 20_000, "*a" * 20_000, "max(" + "x)[" * 20_000])
def test_a_name_without_end_is_not_searched_for(cli: Cli, name: str) -> None:
    for args in (("kinematics", "my.toml", "--no-store"), ("run", "my.toml"), ("sweep", "my.toml", "-o", "-")):
        answer = cli(*args, "-q", "--columns", f"phi,{name}", "--set", "mechanism.grid.positions=4")
        assert answer.code == 2
        assert "is longer than 200 characters" in answer.err


@pytest.mark.parametrize("kind", ["pipe", "folder", "device"])
def test_what_is_no_file_is_told_at_once(cli: Cli, folder: Path, kind: str) -> None:
    os.mkfifo(folder / "pipe")
    (folder / "folder").mkdir()
    name = "/dev/zero" if kind == "device" else kind
    read = (("check", name), ("sweep", "my.toml", "--points", name), ("kinematics", "my.toml", "--set", f"@{name}:1"))
    for args in read:
        answer = cli(*args)
        assert answer.code == 2
        assert f"{name} is a {'directory' if kind == 'folder' else f'{kind}, not a file'}" in answer.err
    written = (("init", "shaper", "-o", name), ("kinematics", "my.toml", "--depfile", name), ("schema", "-o", name))
    for args in written:
        answer = cli(*args)
        assert answer.code == 2
        assert f"{name} is a {kind}" in answer.err
    assert cli("kinematics", "my.toml", "-o", name).code == (0 if kind == "folder" else 2)
    assert not Path(name).is_file()


def test_a_held_folder_is_told_and_given_up(cli: Cli, folder: Path) -> None:
    assert cli("structure", "my.toml", "-q").code == 0
    with (folder / "my.out" / ".lock").open("ab") as other:
        fcntl.flock(other, fcntl.LOCK_EX)
        answer = cli("structure", "my.toml", "-q", "--wait", "0.1")
    assert (answer.code, answer.out) == (2, "")
    assert answer.err == (
        "another process works in the output folder; waiting up to 0.1 s\n"
        "error: my.out: another process works in this folder, and has not ended within 0.1 s\n"
        "  -> wait for its end, give it longer by --wait SECONDS, or choose another output folder\n"
    )


@pytest.mark.parametrize("wait", ["nan", "-1", "soon"])
def test_a_wait_that_is_no_time_is_refused(cli: Cli, wait: str) -> None:
    assert cli("structure", "my.toml", "-q", "--wait", wait).code == 2


def test_a_stage_that_has_left_the_spec_leaves_no_files(cli: Cli, folder: Path) -> None:
    text = (CONFIGS / "shaper.toml").read_text()
    (folder / "full.toml").write_text(text)
    assert cli("run", "full.toml", "-o", "out", "-q").code == 0
    assert (folder / "out" / "motion.csv").exists()
    (folder / "full.toml").write_text(text[: text.index("[motor]")])
    answer = cli("run", "full.toml", "-o", "out")
    assert answer.code == 0
    assert "motion: the spec has it no more; removed motion.toml, motion.npz, motion.csv\n" in answer.err
    assert not list((folder / "out").glob("motion.*"))
    assert (folder / "out" / "kinematics.csv").exists()


def test_stored_files_that_break_a_document_are_told(cli: Cli, folder: Path) -> None:
    from pipeline.test_foreign import reseal

    assert cli("kinematics", "my.toml", "-q").code == 0
    reseal(folder / "my.out" / "kinematics.toml", lambda body: body.replace(b"\n[result]", b"\n[else]"))
    answer = cli("kinematics", "my.toml")
    assert answer.code == 2
    assert "does not fit" in answer.err
    assert "compute it again by --fresh" in answer.err
    assert cli("kinematics", "my.toml", "--fresh", "-q").code == 0
    assert cli("kinematics", "my.toml", "-q").code == 0


@pytest.mark.parametrize(("name", "kept"), [("table.csv", "16 of 200 points are kept in table.csv.part"), ("-", "")])
def test_an_interrupted_sweep_says_what_is_kept(
    cli: Cli, folder: Path, monkeypatch: pytest.MonkeyPatch, name: str, kept: str
) -> None:
    from tmmcalc.batch import executors

    def interrupted(task, blocks):
        first, *_ = blocks
        yield executors.solve(task, first)
        raise KeyboardInterrupt

    monkeypatch.setattr("tmmcalc.batch.choice.solver_of", lambda task, *rest: (task, interrupted))
    answer = cli("sweep", "my.toml", "-q", "-o", name, "--set", "mechanism.input.speed=50:60:200", "--to", "structure")
    assert (answer.code, answer.out) == (130, "")
    assert answer.err.startswith(f"stopped: {kept}")
    assert ("the same command goes on from there" in answer.err) == bool(kept)
    assert (folder / "table.csv.part").exists() == bool(kept)


def test_an_interrupted_run_says_what_is_kept(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(*args: object) -> None:
        raise KeyboardInterrupt

    assert cli("structure", "my.toml", "-q").code == 0
    monkeypatch.setattr("tmmcalc.core.plan.plan", interrupt)
    monkeypatch.setattr("tmmcalc.pipeline.runner.plan", interrupt)
    answer = cli("run", "my.toml", "-q")
    assert answer.code == 130
    assert answer.err == "stopped: finished stages are kept in my.out; the same command loads them\n"
