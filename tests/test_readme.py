"""The console blocks of the README and of the documents are run, and must print what they show."""

from __future__ import annotations

import doctest
import re
import shlex
import sys
from pathlib import Path

import pytest

import tmmcalc
from tmmcalc.cli import main

ROOT = Path(__file__).parent.parent
BLOCK = re.compile(r"```console\n(.*?)```", re.DOTALL)
TOML = re.compile(r"```toml\n(.*?)```", re.DOTALL)
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def sessions(document: Path) -> list[list[tuple[str, str]]]:
    """The console blocks of a document, each as pairs of a command and what it prints."""
    blocks = []
    for block in BLOCK.findall(document.read_text()):
        parts = re.split(r"^\$ (.*)\n", block, flags=re.MULTILINE)[1:]
        blocks.append(list(zip(parts[::2], parts[1::2], strict=True)))
    return blocks


@pytest.mark.usefixtures("known_schema")
@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_console_blocks(
    document: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Commands of a document run in one folder, one after the other; ``...`` stands for anything."""
    (tmp_path / "configs").symlink_to(ROOT / "configs")
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.chdir(tmp_path)
    for command, shown in (pair for session in sessions(document) for pair in session):
        argv = shlex.split(command)
        if argv[0] != "tmmcalc":
            continue
        monkeypatch.setattr(sys, "argv", argv)
        with pytest.raises(SystemExit) as ended:
            main()
        out, err = capsys.readouterr()
        wrong = "error:" in shown
        assert bool(ended.value.code) == wrong, f"$ {command}: exit code {ended.value.code}\n{err}"
        printed = out + err if wrong else out
        same = doctest.OutputChecker().check_output(shown, printed, doctest.ELLIPSIS)
        assert same, f"$ {command}\nshown:\n{shown}\nprinted:\n{printed}"


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_specs_in_documents(document: Path) -> None:
    """A TOML block that is a whole spec is one."""
    for text in TOML.findall(document.read_text()):
        if "[mechanism.input]" in text and "[[mechanism.joints]]" in text:
            tmmcalc.solve_structure(tmmcalc.parse_spec(text))
