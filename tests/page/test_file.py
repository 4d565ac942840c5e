"""The file itself: its size, the same bytes each time, one that a command writes; its modules are all there."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from page.scenes import CONFIGS
from tmmcalc.page.document import MODULES, WEB

MEGABYTE = 1_000_000


def command(name: str, file: Path, seed: str) -> bytes:
    """What ``tmmcalc page`` writes."""
    argv = [sys.executable, "-m", "tmmcalc", "page", str(CONFIGS / f"{name}.toml"), "-o", str(file), "-q", "--no-store"]
    root = str(CONFIGS.parent)
    subprocess.run(argv, check=True, env={"PYTHONPATH": root, "PYTHONHASHSEED": seed, "PATH": ""}, timeout=120)
    return file.read_bytes()


@pytest.mark.parametrize(
    ("name", "most"),
    [
        ("shaper", 1),
        pytest.param("class-four", 1, marks=pytest.mark.slow),
        pytest.param("four-dyads", 1, marks=pytest.mark.slow),
        pytest.param("course-project", 3, marks=pytest.mark.slow),
    ],
)
def test_it_is_small_and_the_same_each_time(name: str, most: float, tmp_path: Path) -> None:
    first, second = (command(name, tmp_path / f"{seed}.html", seed) for seed in ("1", "2"))
    assert first == second
    assert len(first) < most * MEGABYTE


def test_all_modules_are_joined() -> None:
    assert {file.stem for file in WEB.glob("*.js")} == set(MODULES)


def test_scripts_make_no_elements_of_texts() -> None:
    """What a spec says reaches the page as text alone, and nothing is styled by an attribute."""
    for file in WEB.glob("*.js"):
        text = file.read_text(encoding="utf-8")
        assert not re.search(r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\b|new Function", text), (
            file
        )
        assert not re.search(r'style: ["`]|setAttribute\("style"', text), file
    assert "style=" not in (WEB / "page.html").read_text(encoding="utf-8")
