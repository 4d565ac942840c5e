"""The Makefile rule, read by the real make where there is one."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.pipeline import depfile

NAMES = [
    "plain",
    "two words",
    "a#b",
    "a$b",
    "a:b",
    "k=1",
    "x[1]",
    "st*r",
    "q?",
    "back\\slash",
    "e\\ f",
    "e\\#g",
]
NAMES += ["report (1)", "~home", "a'b", "трасса"]
needs_make = pytest.mark.skipif(shutil.which("make") is None, reason="there is no make here")


def test_rule_and_phony_sources(tmp_path: Path):
    depfile.write(tmp_path / "d", ["out/path.toml", "out/path.npz"], ["my spec.toml", "loads$.csv"])
    assert (tmp_path / "d").read_text() == (
        "out/path.toml out/path.npz: my\\ spec.toml loads$$.csv\n\nmy\\ spec.toml:\n\nloads$$.csv:\n"
    )


def make(folder: Path) -> str:
    rule = '\t@touch "$$T"; echo made\n'
    first = (folder / "d").read_text().split("\n", 1)[0].split(": ")[0]
    (folder / "Makefile").write_text(f"all: {first}\n\ninclude d\n\n{first}:\n{rule}")
    done = subprocess.run(
        ["make", "-s"], cwd=folder, capture_output=True, text=True, env={**os.environ, "T": target_of(folder)}
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def target_of(folder: Path) -> str:
    return (folder / "target-name").read_text()


@needs_make
@sparing("name", NAMES, every=4)
def test_make_reads_the_names(tmp_path: Path, name: str):
    target, source = f"{name}.t", f"{name}.s"
    (tmp_path / "target-name").write_text(target)
    (tmp_path / source).touch()
    depfile.write(tmp_path / "d", [target], [source])
    assert make(tmp_path) == "made\n"
    assert (tmp_path / target).exists()
    assert make(tmp_path) == ""
    later = (tmp_path / target).stat().st_mtime + 10
    os.utime(tmp_path / source, (later, later))
    assert make(tmp_path) == "made\n"
    (tmp_path / source).unlink()
    assert make(tmp_path) == "made\n"


@pytest.mark.parametrize("name", ["a;b", "a|b", "a%b", "a\nb"])
def test_names_that_make_cannot_hold(tmp_path: Path, name: str):
    with pytest.raises(UsageError, match="Makefile"):
        depfile.write(tmp_path / "d", ["t"], [name])
    assert not (tmp_path / "d").exists()


def test_folder_that_is_not_there(tmp_path: Path):
    with pytest.raises(UsageError, match="d: cannot be written"):
        depfile.write(tmp_path / "none" / "d", ["t"], ["s"])
