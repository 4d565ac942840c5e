"""What facts are called: each otherwise than the others of its stage, and in Ukrainian without English words."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from naming.solved import solved
from tmmcalc.core.facts import Labelled, labelled
from tmmcalc.naming.told import meant
from tmmcalc.page.said import name_of
from tmmcalc.report.formula.symbols import with_letters

CONFIGS = Path(__file__).parents[2] / "configs"
SPECS = sorted(CONFIGS.glob("*.toml"))
QUICK = ("cam-flat", "gears-circulating", "manipulator-direct", "rotor", "shaper")
ENGLISH = re.compile(r"[A-Za-z]{3,}")
CYRILLIC = re.compile(r"[А-ЯІЇЄҐа-яіїєґ]")
OF_ALL = ("min", "max", "sin", "cos", "AIbar")  # words that are signs in every language
SIGN = re.compile(r"[A-Za-z]\w*|[a-z]/[a-z]|(?:(?:I|II|III|IV|V|VI) )?[DPR]+\([\d,]+\)")  # a letter with its index


def facts(file: Path) -> Iterator[tuple[str, Labelled, str]]:
    """By stage all facts of a spec, and what they mean."""
    for stage, result in solved(file).results.items():
        for each in labelled(stage, result):
            yield stage, each, meant(stage, each)[0]


@pytest.mark.parametrize(
    "file", [pytest.param(f, id=f.stem, marks=() if f.stem in QUICK else pytest.mark.slow) for f in SPECS]
)
def test_facts_are_told_apart_and_in_ukrainian(file: Path) -> None:
    source, known, wrong = file.read_text(encoding="utf-8"), dict[tuple[str, str, str], str](), []
    for stage, each, meaning in facts(file):
        other = known.setdefault((stage, each.part, meaning), each.name)
        if other != each.name:
            wrong.append(f"{stage}: {other} and {each.name} are both called {meaning!r}")
        said = name_of(meaning)
        ukrainian = said if isinstance(said, str) else said[1]
        words = [word for word in ENGLISH.findall(ukrainian) if word not in source and word not in OF_ALL]
        if (words and not _signs(words, each)) or not (CYRILLIC.search(ukrainian) or SIGN.fullmatch(ukrainian)):
            wrong.append(f"{stage}.{each.name}: {ukrainian!r}")
    assert not wrong, "\n".join(wrong)


def _signs(words: list[str], fact: Labelled) -> bool:
    """Whether words are parts of names that the fact itself has: of groups, of layouts."""
    return all(word in fact.name and word.isupper() for word in words)


def test_greek_letters() -> None:
    assert name_of("angle at phi_2, beta and thetas") == "angle at φ_2, β and thetas"
    assert with_letters("alphabet") == "alphabet"
