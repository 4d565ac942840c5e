"""Sentences of the rooms: every template of a warning or a note is a literal, and every one has its translation."""

from __future__ import annotations

import ast
import pickle
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import tmmcalc
from report.sentences import WORD, sentences
from report.sentences import said as said_by_file
from tmmcalc.core.errors import TmmError
from tmmcalc.core.notes import Note, Phrase, graded, held, listed
from tmmcalc.core.sentences import KEY, parted, rejoined
from tmmcalc.core.stored import Record
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.project import load_spec
from tmmcalc.report.document import Document
from tmmcalc.report.language import LANGUAGES, catalogue, speaking, tr_name
from tmmcalc.rooms import STAGES

OTHERS = [language for language in LANGUAGES if language != "en"]
CONFIGS = Path(__file__).parents[2] / "configs"
SPECS = [*sorted(CONFIGS.glob("*.toml")), *sorted((CONFIGS / "extreme").glob("*.toml"))]
LATIN = re.compile(r"[A-Za-z]{3,}")
SHARED = {"RRR", "RRP", "RPR", "PRP", "RPP", "III", "sin", *LAYOUTS}  # kinds of dyads, numerals, functions, layouts


@pytest.mark.parametrize("language", OTHERS)
def test_every_sentence_has_its_translation(language: str) -> None:
    words = catalogue(language)
    missing = {key: file for key, file in sentences().items() if key not in words.names and key not in words.texts}
    assert missing == {}


def test_sentences_are_literals_with_their_values_apart() -> None:
    """An f-string keeps neither template nor values; what names a thing for `tr_name` may be one."""
    for file, rows in said_by_file().items():
        for maker, text in rows:
            if isinstance(text, ast.JoinedStr) and (maker in ("held", "Note", "Grade", "Verdict") or maker == "Phrase"):
                parts = "".join(str(part.value) for part in text.values if isinstance(part, ast.Constant))
                assert file == "core/notes.py" or not WORD.search(parts), f"{file}:{text.lineno}"


def test_a_phrase_holds_its_numbers_as_they_are_written() -> None:
    said = Phrase("{value:.3g} mm of {part} at {places}", value=12.345, part=Phrase("link {k}", k=3), places=[1.5, 2.5])
    assert said == "12.3 mm of link 3 at 1.5, 2.5"
    assert said.template == "{value} mm of {part} at {places}"
    again = pickle.loads(pickle.dumps(said))
    assert (again, again.template, again.values) == (said, said.template, said.values)


def test_values_of_a_phrase_are_said_in_the_language() -> None:
    places = [Phrase("{low:g} to {high:g} deg", low=1.5, high=30), Phrase("{low:g} to {high:g} deg", low=40, high=50)]
    note = held(
        "warning",
        "on the {phase} |theta| reaches {value:.6g} deg, beyond the limit of {limit:.6g} deg, for phi from {where}",
        *(35.25, 30.0, "deg"),
        name="theta",
        place=Phrase("group {group}", group="RRR(2,3)"),
        phase="rise",
        where=places,
    )
    assert note.text.endswith("for phi from 1.5 to 30 deg, 40 to 50 deg")
    with speaking("uk"):
        assert tr_name(graded(note)[1]) == (
            "група RRR(2,3): віддалення: кут тиску за модулем сягає 35,25°, перевищуючи границю 30°, "
            "за φ у межах 1,5…30°; 40…50°"
        )
        assert tr_name(
            graded(
                Phrase(
                    "warning: the circle r = {radius} does not cut the flanks, from {low} to {high}",
                    radius="12.5 mm",
                    low="1 mm",
                    high="2 mm",
                )
            )[1]
        ) == ("коло r = 12,5 мм не перетинає профілів, що лежать від 1 мм до 2 мм")


def test_a_stored_result_has_its_sentences_and_what_they_are_made_of() -> None:
    said = listed([Phrase("stage {k}", k=1), Phrase("stage {k}", k=2)], " and ")
    note = Note("warning", said, "train")
    record = Record({"message": said, "notes": [note.stored(), "note: as it was"], "count": 2})
    stored = parted(record)
    assert stored.scalars["message"] == "stage 1 and stage 2"
    assert type(stored.scalars["message"]) is str
    assert [each["template"] for each in stored.scalars[KEY]] == ["{one} and {other}"]
    again = rejoined(stored).scalars
    assert again == record.scalars
    assert again["message"].template == said.template
    assert again["notes"][0]["text"].values == said.values
    old = {name: value for name, value in stored.scalars.items() if name != KEY}
    assert rejoined(Record(old)).scalars == old


@pytest.mark.slow
@pytest.mark.parametrize("spec", SPECS, ids=lambda path: f"{path.parent.name}-{path.stem}")
@pytest.mark.parametrize("language", OTHERS)
def test_no_english_is_left_in_notes(spec: Path, language: str, tmp_path: Path) -> None:
    """Neither in those of a run nor in those of its files; Latin words are names and keys of the spec."""
    try:
        scene = load_spec(spec)
        runs = [tmmcalc.run(scene, out=tmp_path) for _ in range(2)]
    except TmmError:
        return
    own = set(LATIN.findall(spec.read_text(encoding="utf-8"))) | SHARED
    told = []
    with speaking(language):
        for run in runs:
            shown = [STAGES[stage].summary(result, stage) for stage, result in run.results.items() if stage in STAGES]
            told.append([tr_name(graded(note)[1]) for document in shown for note in notes_of(document)])
    assert told[0] == told[1]
    assert {text for text in told[0] if set(LATIN.findall(text)) - own} == set()


def notes_of(document: Document) -> Iterator[str]:
    """The notes of a document and of its parts."""
    yield from document.notes
    for part in document.parts:
        yield from notes_of(part)
