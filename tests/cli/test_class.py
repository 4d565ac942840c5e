"""``tmmcalc class make`` as a teacher meets it."""

from __future__ import annotations

import json
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import pytest

from cli.conftest import Cli, Once, environment

CONFIGS = Path(__file__).parents[2] / "configs"


@pytest.fixture
def shaper(folder: Path) -> Path:
    return Path(shutil.copy(CONFIGS / "assignment-shaper.toml", folder / "shaper.toml"))


@pytest.mark.slow
def test_a_class_is_made_and_told(cli: Cli, shaper: Path) -> None:
    code, out, err = cli("class", "make", "shaper.toml", "-n", "5", "--seed", "7", "-o", "own", "-f", "json")
    assert code == 0
    told = json.loads(out)
    assert (told["variants"], told["seed"]) == (5, 7)
    refused = told["refused"]["columns"]
    assert told["tried"] == 5 + sum(refused["candidates"])
    assert refused["refused by"][0] == "constraint transmits"
    assert told["columns"]["asked"][:2] == ["H", "K"]
    assert sorted(path.name for path in Path("own").iterdir()) == [
        "answers",
        "class.csv",
        "class.toml",
        "sheets",
        "variants",
    ]
    assert "wrote own/class.toml" in err
    data = tomllib.loads(Path("own/class.toml").read_text(encoding="utf-8"))
    assert data["class"]["assignment"] == "../shaper.toml"
    assert len(data["variants"]) == 5
    assert cli("check", "own/variants/03.toml").code == 0


@pytest.fixture(scope="module")
def said() -> list[str]:
    """What is printed as a class of three is made."""
    return []


@pytest.fixture
def three(cli: Cli, shaper: Path, once: Once, said: list[str]) -> str:
    """A class of three, and what was printed as it was made."""
    once(Path("class"), lambda: said.append(cli("class", "make", "shaper.toml", "-n", "3", "-q").out))
    return said[0]


@pytest.mark.slow
def test_a_table_for_people(three: str) -> None:
    assert "least distance" in three
    assert "asked    unit" in three
    assert "candidates  refused by" in three


@pytest.mark.slow
@pytest.mark.usefixtures("three")
def test_later_more(cli: Cli) -> None:
    assert "4, 1 of them now" in cli("class", "make", "shaper.toml", "-n", "4", "-q").out


@pytest.mark.parametrize(
    ("words", "message", "remedy"),
    [
        (("my.toml", "-n", "3"), "my.toml: the spec has no [class]", "add [class]"),
        (("shaper.toml",), "how many variants?", "add -n 40, or roster to [class]"),
        (("shaper.toml", "-n", "3", "-o", "my.toml"), "my.toml is a file", "name a folder"),
        (("none.toml", "-n", "3"), "there is no file none.toml", "check the name"),
    ],
)
def test_what_cannot_be_made(cli: Cli, shaper: Path, words: tuple[str, ...], message: str, remedy: str) -> None:
    code, _, err = cli("class", "make", *words)
    assert code == 2
    assert message in err
    assert remedy in err
    assert not Path("class").exists()


def test_an_asked_result_that_there_is_not(cli: Cli, shaper: Path) -> None:
    shaper.write_text(shaper.read_text(encoding="utf-8").replace("kinematics.K_D", "kinematics.K_E"), encoding="utf-8")
    code, _, err = cli("class", "make", "shaper.toml", "-n", "3")
    assert code == 2
    assert "class.asked[1].result: kinematics tells no 'K_E'" in err
    assert "did you mean K_D" in err


def test_a_unit_of_another_kind(cli: Cli, shaper: Path) -> None:
    text = shaper.read_text(encoding="utf-8").replace('unit = "mm"', 'unit = "kg"')
    shaper.write_text(text, encoding="utf-8")
    code, _, err = cli("class", "make", "shaper.toml", "-n", "3")
    assert code == 2
    assert "kinematics.stroke_D is in m, which is no kg" in err


def test_the_group_tells_its_commands(cli: Cli) -> None:
    out = cli("class", "-h").out
    assert "\n  make " in out


@pytest.mark.slow
def test_a_killed_command_goes_on_where_it_was(shaper: Path, folder: Path) -> None:
    """Killed as soon as its journal has variants, then run again: the same class as in one go."""
    words = [
        sys.executable,
        "-m",
        "tmmcalc",
        "class",
        "make",
        "--no-sheets",
        "shaper.toml",
        "-n",
        "12",
        "--seed",
        "3",
        "-q",
        "-j",
        "1",
    ]
    journal = folder / "killed" / ".class.toml.part"
    killed = subprocess.Popen([*words, "-o", "killed"], env=environment(), stdout=subprocess.DEVNULL)
    until = time.monotonic() + 120
    while (not journal.exists() or journal.stat().st_size < 2000) and time.monotonic() < until:
        time.sleep(0.005)
    killed.send_signal(signal.SIGKILL)
    assert killed.wait() == -signal.SIGKILL
    assert not (folder / "killed" / "class.toml").exists()
    for out in ("killed", "whole"):
        done = subprocess.run([*words, "-o", out], env=environment(), capture_output=True, text=True, check=True)
        assert "12" in done.stdout
    found = [
        {path.relative_to(folder / out): path.read_bytes() for path in (folder / out).rglob("*.*") if path.is_file()}
        for out in ("killed", "whole")
    ]
    assert found[0] == found[1]
    assert len(found[0]) == 14
