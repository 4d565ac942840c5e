"""What is known of mistakes: each is told in both languages, and says one thing that comes of it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import tmmcalc
from tmmcalc.classroom.keying import told_of
from tmmcalc.classroom.known import HOMES, known
from tmmcalc.core.errors import UsageError
from tmmcalc.core.mistake import OFTEN, SELDOM
from tmmcalc.core.stage import STAGES
from tmmcalc.report.language import LANGUAGES, catalogue

DIGIT = re.compile(r"\d")


def test_every_file_of_a_folder_is_one() -> None:
    """Nothing else lists them."""
    root = Path(tmmcalc.__file__).parent
    files = {f"{home}.{file.stem}" for home in HOMES for file in (root / home / "mistakes").glob("[!_]*.py")}
    assert files == {*known()}
    assert len(files) > 80


@pytest.mark.parametrize("name", sorted(known()))
def test_a_mistake_says_what_it_is_and_where_to_look(name: str) -> None:
    mistake = known()[name]
    ways = [mistake.tables is not None, bool(mistake.stages), mistake.reads is not None]
    assert sum(ways) == 1
    assert {*mistake.stages} <= {*STAGES}
    assert OFTEN <= mistake.common <= SELDOM
    assert mistake.hint.endswith((".", "?"))
    assert mistake.title[0].islower() or mistake.title.startswith(("m ", "Coriolis"))
    assert len(mistake.title) < 130 > len(mistake.hint)
    assert not DIGIT.search(mistake.hint.replace("2 pi", "")), "a hint has no number"
    for language in LANGUAGES:
        if language != "en":
            words = catalogue(language)
            assert {mistake.title, mistake.hint} <= {*words.names, *words.texts}


def test_the_commoner_ones_come_first() -> None:
    order = [mistake.common for mistake in known().values()]
    assert order == sorted(order)


def test_titles_tell_mistakes_apart() -> None:
    titles = [mistake.title for mistake in known().values()]
    twice = {title for title in titles if titles.count(title) > 1}
    assert twice == set()


def test_a_mistake_of_another_version_is_refused() -> None:
    with pytest.raises(UsageError, match=r"no mistake is called 'linkage\.no_such'"):
        told_of("linkage.no_such")
