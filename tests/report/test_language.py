"""Translations: every text that is said has one, every one is said, and the font has its letters."""

from __future__ import annotations

import ast
import csv
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from inspect import getmodule
from pathlib import Path

import pytest

import tmmcalc
import tmmcalc.rooms  # they register their stages
from report.sentences import key_of, of_ring
from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import given_out, standing_in
from tmmcalc.core.stage import STAGES
from tmmcalc.report.drawing.lettering import pieces
from tmmcalc.report.language import (
    LANGUAGES,
    PLACE,
    catalogue,
    files_of,
    possessive,
    speaking,
    spoken,
    tr,
    tr_count,
    tr_name,
    tr_unit,
)

ROOT = Path(tmmcalc.__file__).parent
CONFIGS = Path(__file__).parents[2] / "configs"
OTHERS = [language for language in LANGUAGES if language != "en"]
APOSTROPHE = re.compile(r"[А-Яа-яЄІЇҐєіїґ]['`][А-Яа-яЄІЇҐєіїґ]")
POINT = re.compile(r"\d\.\d")
FORMULA_NUMBER = re.compile(r"\(\d+\.\d+[^)]*\)|Д\.\d\.\d")  # and of a table
NAME = re.compile(r'^name = "(.+)"', re.MULTILINE)
PARTS = re.compile("координати |складові |проєкції ")  # what is said of several things already
SHORT = 5  # letters of an f-string that could be of any text
RUSSIAN = re.compile("[ыэъё]", re.IGNORECASE)


@cache
def said() -> dict[str, dict[str, str]]:
    """The first arguments of ``tr`` and ``tr_count`` in the program, with the file of each."""
    found: dict[str, dict[str, str]] = {"tr": {}, "tr_count": {}}
    for file in ROOT.rglob("*.py"):
        text = file.read_text(encoding="utf-8")
        if ("tr(" not in text and "tr_count(" not in text) or file.name == "language.py":
            continue
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in found:
                argument = node.args[1 if node.func.id == "tr_count" else 0]
                assert isinstance(argument, ast.Constant), f"{file}: {ast.unparse(node)} is no literal"
                found[node.func.id][str(argument.value)] = str(file.relative_to(ROOT))
    return found


@pytest.mark.parametrize("language", OTHERS)
def test_every_text_has_its_translation(language: str) -> None:
    words = catalogue(language)
    assert {text: file for text, file in said()["tr"].items() if text not in words.texts} == {}
    assert {text: file for text, file in said()["tr_count"].items() if text not in words.counts} == {}


def meant() -> dict[str, str]:
    """What the results mean, as their fields and the modules of their columns declare it, each with its first stage."""
    found: dict[str, str] = {}
    for name, stage in STAGES.items():
        every = [each for kind in stage.kinds for each in given_out(kind)]
        if columns := stage.part("columns"):
            every += standing_in(getmodule(columns))
        for each in every:
            found.setdefault(each.meaning, name)
    return found


@pytest.mark.parametrize("language", OTHERS)
def test_every_meaning_has_its_translation(language: str) -> None:
    words = catalogue(language)
    assert {text: stage for text, stage in meant().items() if text not in words.names and text not in words.texts} == {}


def texts_in(node: ast.AST) -> list[str]:
    """The texts that it says."""
    calls = (each for each in ast.walk(node) if isinstance(each, ast.Call) and ast.unparse(each.func) == "tr")
    return [str(call.args[0].value) for call in calls if isinstance(call.args[0], ast.Constant)]


def meanings_of(node: ast.expr, within: ast.FunctionDef, functions: dict[str, ast.FunctionDef]) -> list[str]:
    """What an expression of a function may mean: its texts, those that its name stands for, those of what it calls."""
    if isinstance(node, ast.Call) and ast.unparse(node.func) in functions:
        return texts_in(functions[ast.unparse(node.func)])
    if not isinstance(node, ast.Name):
        return texts_in(node) or [
            text
            for name in ast.walk(node)
            if isinstance(name, ast.Name)
            for text in meanings_of(name, within, functions)
        ]
    before: dict[int, ast.expr] = {}
    for each in ast.walk(within):
        if isinstance(each, ast.For) and node.id in names_in(each.target):
            before[each.lineno] = each.iter
        elif isinstance(each, ast.Assign) and each.lineno < node.lineno and node.id in names_in(each.targets[0]):
            target, value = each.targets[0], each.value
            if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
                value = value.elts[names_in(target).index(node.id)]
            before[each.lineno] = value
    return meanings_of(before[max(before)], within, functions) if before else []


def names_in(node: ast.AST) -> list[str]:
    return [each.id for each in ast.walk(node) if isinstance(each, ast.Name)]


def vectors_of(within: ast.FunctionDef) -> Iterator[ast.expr]:
    """The meanings that a function of a note gives to vectors: to both projections the same."""
    for node in ast.walk(within):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "vector":
            yield node.args[-1]
        elif isinstance(node, ast.For) and "axis" in names_in(node.target):
            calls = (each for each in ast.walk(node) if isinstance(each, ast.Call))
            yield from (call.args[-1] for call in calls if ast.unparse(call.func) == "Given")
        elif isinstance(node, ast.Dict):
            seen = set()
            for key, value in zip(node.keys, node.values, strict=True):
                if isinstance(key, ast.Constant | ast.JoinedStr) and isinstance(value, ast.Call) and value.args:
                    said = re.sub("[xy]", "x", ast.unparse(key)), ast.unparse(value.args[-1])
                    if said in seen and not isinstance(value.args[-1], ast.Constant):
                        yield value.args[-1]
                    seen.add(said)


@pytest.mark.slow
@pytest.mark.parametrize("language", OTHERS)
def test_every_vector_of_the_notes_has_projections(language: str) -> None:
    """In English there are projections of any noun; in another language of those whose genitive is known."""
    found: dict[str, str] = {}
    for file in ROOT.rglob("notes/**/*.py"):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        functions = {each.name: each for each in ast.walk(tree) if isinstance(each, ast.FunctionDef)}
        for function in functions.values():
            for node in vectors_of(function):
                told = meanings_of(node, function, functions)
                assert told, f"{file}: what does {ast.unparse(node)} mean?"
                found |= dict.fromkeys(told, file.name)
    assert len(found) > 30
    vectors = [text for text in found if possessive(text)]
    assert len(vectors) > 10
    with speaking(language):
        said = {text: tr(text) for text in vectors}
        assert {text: each for text, each in said.items() if not (possessive(each) or PARTS.match(each))} == {}


@pytest.mark.parametrize("language", OTHERS)
def test_every_translation_is_of_a_text_that_is_said(language: str) -> None:
    assert not set(catalogue(language).texts) - set(said()["tr"])


@pytest.mark.parametrize("language", OTHERS)
def test_a_text_is_translated_once(language: str) -> None:
    seen: dict[str, Path] = {}
    for file in files_of(language):
        words = tomllib.loads(file.read_text(encoding="utf-8"))
        names = words.pop("names", {})
        for text in [*(text for text, found in words.items() if isinstance(found, str)), *names]:
            assert text not in seen, f"{text!r} stands in {seen[text]} and {file}"
            seen[text] = file


@cache
def given() -> tuple[frozenset[str], re.Pattern[str]]:
    """What theory, manifests and ready specs may say: constants, names of results in words; and forms of f-strings."""
    forms: set[str] = set()
    constants = {name for file in CONFIGS.glob("*.toml") for name in NAME.findall(file.read_text(encoding="utf-8"))}
    for file in ROOT.rglob("*.csv"):
        with file.open(encoding="utf-8", newline="") as rows:
            constants |= {cell for row in csv.reader(rows) for cell in row}
    for file in ROOT.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                key = node.value.partition("[")[0].replace("_", " ")
                constants |= {node.value, node.value.partition(":")[0], key, f"{key} max", f"{key} rms"}
                constants |= {key_of(node.value), of_ring(key_of(node.value))}
            elif isinstance(node, ast.JoinedStr):
                parts = [str(part.value) if isinstance(part, ast.Constant) else "" for part in node.values]
                if len("".join(parts)) > SHORT:
                    forms.add("".join(re.escape(part) or ".+" for part in parts))
    return frozenset(constants), re.compile("|".join(sorted(forms)))


@pytest.mark.slow
@pytest.mark.parametrize("language", OTHERS)
def test_every_name_is_one_that_the_program_gives(language: str) -> None:
    constants, forms = given()
    names = catalogue(language).names
    assert [name for name in names if name not in constants and not forms.fullmatch(name)] == []


def test_no_text_is_said_twice_for_its_translation() -> None:
    """No text stands beside itself as in ``{"crank": tr("crank")}``: what the theory says goes through `tr_name`."""
    for text, file in ((file.read_text(encoding="utf-8"), file) for file in ROOT.rglob("*.py")):
        for node in ast.walk(ast.parse(text)) if "tr(" in text else ():
            if isinstance(node, ast.Dict):
                for key, value in zip(node.keys, node.values, strict=True):
                    twice = isinstance(key, ast.Constant) and ast.unparse(value) == f"tr({key.value!r})"
                    assert not twice, f"{file}: {ast.unparse(value)}"


@pytest.mark.parametrize("language", OTHERS)
def test_translations_hold_the_same_values_and_letters_of_the_font(language: str) -> None:
    words = catalogue(language)
    for text, found in {**words.texts, **words.names}.items():
        assert sorted(PLACE.findall(text)) == sorted(PLACE.findall(found)), text
        for line in found.split("\n"):
            pieces(line)
        assert not POINT.search(FORMULA_NUMBER.sub("", found)), f"{found!r} has a decimal point"


def test_ukrainian_is_spelt_as_it_should_be() -> None:
    words = catalogue("uk")
    for found in (*words.texts.values(), *words.names.values()):
        assert not APOSTROPHE.search(found), f"{found!r}: the apostrophe is ’"
        assert not RUSSIAN.search(found), f"{found!r} has a letter of another language"
        assert '"' not in found, f"{found!r}: quotes are «»"


def test_a_language_holds_within_its_block() -> None:
    assert spoken() == "en"
    with speaking("uk"):
        assert (spoken(), tr_unit("N*m"), tr_count(22, "link", "links")) == ("uk", "Н·м", "22 ланки")
        with speaking("en"):
            assert tr_unit("N*m") == "N·m"
        assert tr("a text that nobody translates") == "a text that nobody translates"
    assert spoken() == "en"


def test_a_phrase_is_translated_with_its_values() -> None:
    reason = Phrase("no shifts of z = {teeth} give a mesh {kind}", teeth="14/17", kind="without undercut")
    outside = Phrase("equal specific sliding at the contact ratio {ratio}", ratio="1.25")
    assert tr_name(reason) == "no shifts of z = 14/17 give a mesh without undercut"
    with speaking("uk"):
        assert tr_name(reason) == "жодні зміщення коліс z = 14/17 не дають зачеплення без підрізання"
        assert tr_name(outside).endswith("за коефіцієнта перекриття 1,25")


def test_an_unknown_language_is_refused() -> None:
    with pytest.raises(UsageError, match="there is no language 'de'"), speaking("de"):
        pass
