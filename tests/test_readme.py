"""The documents: their console blocks print what they show, their Python runs, their links lead somewhere."""

from __future__ import annotations

import doctest
import re
import shlex
import sys
from pathlib import Path

import pytest

import tmmcalc
from tmmcalc.cli import main
from tmmcalc.core.errors import Fault

ROOT = Path(__file__).parent.parent
BLOCK = re.compile(r"```console\n(.*?)```", re.DOTALL)
TOML = re.compile(r"```toml\n(.*?)```", re.DOTALL)
PYTHON = re.compile(r"```python\n(.*?)```", re.DOTALL)
LINK = re.compile(r"\]\(([^)#:]+)(?:#([^)]*))?\)")
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
# pages whose commands take long
LONG = {"batch", "cams", "class", "constraints", "design", "linkages", "machine", "note", "page", "sheets", "vibration"}


def name_of(document: Path) -> str:
    return document.relative_to(ROOT).as_posix()


def sessions(document: Path) -> list[list[tuple[str, str]]]:
    """The console blocks of a document, each as pairs of a command and what it prints."""
    blocks = []
    for block in BLOCK.findall(document.read_text()):
        parts = re.split(r"^\$ (.*)\n", block, flags=re.MULTILINE)[1:]
        blocks.append(list(zip(parts[::2], parts[1::2], strict=True)))
    return blocks


@pytest.mark.usefixtures("known_schema")
@pytest.mark.parametrize(
    "document",
    [pytest.param(d, marks=pytest.mark.slow if d.stem in LONG else (), id=name_of(d)) for d in DOCUMENTS],
)
def test_console_blocks(
    document: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Commands of a document run in one folder, one after the other; ``...`` stands for anything."""
    for folder in ("configs", "examples"):
        (tmp_path / folder).symlink_to(ROOT / folder)
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


@pytest.mark.parametrize("document", DOCUMENTS, ids=name_of)
def test_specs_in_documents(document: Path) -> None:
    """A TOML block that is a whole spec is one."""
    for text in TOML.findall(document.read_text()):
        if "[mechanism.input]" in text and "[[mechanism.joints]]" in text:
            tmmcalc.solve_structure(tmmcalc.parse_spec(text))


@pytest.mark.parametrize("document", DOCUMENTS, ids=name_of)
def test_keys_in_documents(document: Path) -> None:
    """A TOML block that is a part of a spec may lack keys, but has none that a spec has not."""
    for text in TOML.findall(document.read_text()):
        assert [fault for fault in faults_in(text) if fault.message.startswith("unknown key")] == [], text


def faults_in(text: str) -> list[Fault]:
    try:
        tmmcalc.parse_spec(text)
    except tmmcalc.SpecError as error:
        return error.faults
    return []


@pytest.mark.parametrize("document", [each for each in DOCUMENTS if "```python" in each.read_text()], ids=name_of)
def test_python_in_documents(document: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The Python of a document gives what it shows, from top to bottom, beside the shaper as ``my.toml``."""
    (tmp_path / "my.toml").write_text((ROOT / "configs" / "shaper.toml").read_text())
    monkeypatch.chdir(tmp_path)
    text = "".join(PYTHON.findall(document.read_text()))
    examples = doctest.DocTestParser().get_doctest(text, {}, document.name, str(document), 0)
    assert len(examples.examples) == text.count(">>> ")
    told: list[str] = []
    doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(examples, out=told.append)
    assert told == [], "".join(told)


def anchors(document: Path) -> set[str]:
    """The headings of a document, as links name them."""
    headings = re.findall(r"^#+ (.*)$", document.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading).lower().replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("document", DOCUMENTS, ids=name_of)
def test_links_lead_somewhere(document: Path) -> None:
    for target, anchor in LINK.findall(re.sub(r"```.*?```", "", document.read_text(), flags=re.DOTALL)):
        place = document.parent / target
        assert place.exists(), target
        assert not anchor or anchor in anchors(place), f"{target}#{anchor}"


def test_the_readme_is_short_and_names_every_page_of_the_guide() -> None:
    readme, index = ((ROOT / name).read_text() for name in ("README.md", "docs/guide/README.md"))
    assert len(readme.splitlines()) <= 180
    for page in (ROOT / "docs" / "guide").glob("*.md"):
        assert f"](docs/guide/{page.name})" in readme
        assert page.name == "README.md" or f"]({page.name})" in index
