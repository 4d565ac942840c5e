"""A long command says on standard error that it goes on; one that is quiet, or short, says nothing."""

from __future__ import annotations

import time

import pytest

from cli.conftest import Cli
from tmmcalc.cli import patience
from tmmcalc.core.progress import tell


def test_it_speaks_ever_more_rarely(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(patience, "FIRST", 0.1)
    with patience.patience():
        tell(0.25, "round 3")
        time.sleep(0.55)
    time.sleep(0.1)
    said = capsys.readouterr().err.splitlines()
    assert said[:2] == [f"still at it after {after:g} s: 25 %, round 3" for after in (0.1, 0.2)]
    assert len(said) == 3


def test_quiet_is_quiet(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(patience, "FIRST", 0.05)
    with patience.patience(quiet=True):
        time.sleep(0.15)
    assert capsys.readouterr().err == ""


def test_the_running_stage_is_named(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(patience, "FIRST", 0.02)
    assert "still at it after 0.02 s" in cli("run", "my.toml", "--no-store").err
    assert "still at it" not in cli("run", "my.toml", "--no-store", "-q").err


def test_too_little_memory_is_told(cli: Cli, monkeypatch: pytest.MonkeyPatch) -> None:
    def solve(*args: object, **more: object) -> None:
        raise MemoryError("Unable to allocate 44 TiB")

    monkeypatch.setattr("tmmcalc.pipeline.runner.run", solve)
    answer = cli("kinematics", "my.toml")
    assert answer.code == 4
    assert "more memory than there is: Unable to allocate 44 TiB" in answer.err
    assert "fewer positions" in answer.err
