"""What results mean, those by choice too: every meaning is there, and every text of it has its translation."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tmmcalc.core.notes import Phrase
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import listed, offered, one
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.language import LANGUAGES, catalogue, speaking, tr_name
from tmmcalc.rooms import STAGES

CONFIGS = Path(__file__).parents[2] / "configs"
OTHERS = [language for language in LANGUAGES if language != "en"]
SPECS = sorted(each.stem for each in CONFIGS.glob("*.toml") if not each.stem.startswith("assignment"))
QUICK = ("shaper", "press", "gears-double-planets", "cam-oscillating", "pair-spur", "synth-crank-rocker")
APART = re.compile(r"\{\w+\}|\$[^$]*\$")  # places of values, and what is typeset
LATIN = re.compile(r"[A-Za-z]{3,}")
NAMES = {
    "name",
    "formula",
    "word",
    "way",
    "group",
    "symbol",
    "note",
    "unit",
}  # places of names that are said as they are


def meanings(name: str) -> dict[str, str]:
    """Of a ready spec all meanings of what is listed and offered, by the names of these."""
    found = run(load_spec(CONFIGS / f"{name}.toml"), by_name=True)
    scene = Scene(found.spec, found.results)
    return {
        f"{stage}.{each.quantity}": each.meaning
        for stage, result in found.results.items()
        if stage in STAGES
        for each in (*listed(stage, result), *offered(stage, scene))
    }


def texts_of(meaning: str, named: str) -> Iterator[str]:
    """Its texts as catalogues have them: its own, and the words in its places that the spec has not named."""
    if not isinstance(meaning, Phrase):
        yield meaning
        return
    yield meaning.template
    for place, value in meaning.values.items():
        for each in (value,) if isinstance(value, str) else value:
            if isinstance(each, Phrase) or (place not in NAMES and each not in named):
                yield from texts_of(each, named)


def check(name: str, language: str) -> None:
    words, named, found = catalogue(language), (CONFIGS / f"{name}.toml").read_text(encoding="utf-8"), meanings(name)
    assert len(found) > 4
    assert [each for each, meaning in found.items() if not meaning] == []
    said = {text: each for each, meaning in found.items() for text in texts_of(meaning, named)}
    english = {text for text in said if LATIN.search(APART.sub("", text))}
    assert {text: said[text] for text in english if text not in words.names and text not in words.texts} == {}


@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("name", QUICK)
def test_every_meaning_has_its_translation_in_some_specs(name: str, language: str) -> None:
    check(name, language)


@pytest.mark.slow
@pytest.mark.parametrize("language", OTHERS)
@pytest.mark.parametrize("name", [name for name in SPECS if name not in QUICK])
def test_every_meaning_has_its_translation_in_all_specs(name: str, language: str) -> None:
    check(name, language)


@pytest.mark.parametrize(
    ("spec", "asked", "said"),
    [
        (
            "shaper",
            "kinematics.max(aS_D_differences)",
            "прискорення вихідної координати D за центральними різницями: найбільше значення",
        ),
        ("shaper", "forces.lever_M_G3@2", "сила ваги G3: момент відносно полюса важеля Жуковського"),
        (
            "shaper",
            "forces.eq_3_F_F32@2",
            "сила тертя F32 у парі A3: модуль на ланці 3",
        ),
        ("pair-spur", "pair.1.wheels.0.rho_a", "радіус кривизни профілю на вершині зубця, колесо 1"),
        ("cam-oscillating", "cam_profile.rho_w@3", "радіус кривизни (робочий профіль)"),
        (
            "gears-double-planets",
            "strength.factors.wheel 2'.S_H.value",
            "коефіцієнт запасу за контактними напруженнями, колесо 2'",
        ),
    ],
)
def test_what_is_asked_is_said_in_ukrainian(spec: str, asked: str, said: str) -> None:
    name = parse(asked)
    found = run(load_spec(CONFIGS / f"{spec}.toml"), target=name.stage, by_name=True)
    with speaking("uk"):
        assert tr_name(one(name, found.results, Scene(found.spec, found.results)).meaning) == said


def test_no_meaning_of_a_factor_holds_its_number() -> None:
    """The source of a factor may be the number itself in other words, as b/d_1 with both numbers; a sheet has none."""
    found = meanings("gears-double-planets")
    factors = {name: each for name, each in found.items() if name.startswith("strength.factors.")}
    assert len(factors) > 20
    assert not [each for each in factors.values() if re.search(r"textbook|\d mm", each)]
