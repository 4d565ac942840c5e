"""Runs of the real entry point: in this process for the many, as a process of its own for the few that need one."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from tmmcalc.cli import main

ROOT = Path(__file__).parents[2]
CONFIGS = ROOT / "configs"


class Answer(NamedTuple):
    code: int
    out: str
    err: str


Cli = Callable[..., Answer]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty working folder with the linkage of the shaper as ``my.toml``."""
    shutil.copy(ROOT / "tests" / "shaper.toml", tmp_path / "my.toml")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def cli(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], known_schema: None) -> Cli:
    """Run a command in this process; an exception of the program is one of the test."""

    monkeypatch.setattr("tmmcalc.cli.patience.FIRST", 1e6)  # a busy machine is no part of what is said

    def run(*args: str) -> Answer:
        monkeypatch.setattr(sys, "argv", ["tmmcalc", *args])
        with pytest.raises(SystemExit) as ended:
            main()
        return Answer(int(ended.value.code or 0), *capsys.readouterr())

    return run


def environment(**more: str) -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(ROOT), "COLUMNS": "80", **more}


@pytest.fixture
def process(folder: Path) -> Cli:
    """Run a command as a process of its own."""

    def run(*args: str, **more: str) -> Answer:
        done = subprocess.run(
            [sys.executable, "-m", "tmmcalc", *args],
            cwd=folder,
            env=environment(**more),
            capture_output=True,
            text=True,
            timeout=60,
        )
        return Answer(done.returncode, done.stdout, done.stderr)

    return run


Once = Callable[[Path, Callable[[], None]], None]


@pytest.fixture(scope="module")
def once(tmp_path_factory: pytest.TempPathFactory) -> Once:
    """A folder as something makes it: made for the first test of a module that wants it, copied for the others."""
    kept = tmp_path_factory.mktemp("kept")

    def give(folder: Path, make: Callable[[], None]) -> None:
        place = kept / "-".join(folder.parts)
        if place.exists():
            shutil.copytree(place, folder)
        else:
            make()
            shutil.copytree(folder, place)

    return give
