"""Warnings as data: of every ready and extreme spec, what compares a quantity with a limit has both as numbers."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import tmmcalc
from naming.solved import solved
from tmmcalc.core.errors import TmmError
from tmmcalc.core.notes import SHOWN, Note, finding, held, restored
from tmmcalc.project import load_spec
from tmmcalc.report.document import Document
from tmmcalc.report.render import _payload
from tmmcalc.rooms import STAGES

CONFIGS = Path(__file__).parents[2] / "configs"
SPECS = [*sorted(CONFIGS.glob("*.toml")), *sorted((CONFIGS / "extreme").glob("*.toml"))]
QUICK = ("shaper", "pair-blocking", "cam-translating", "extra-contact", "manipulator", "inertia-ratio", "dyad-flips")
NUMBER = re.compile(r"(?<![\w.*'])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w*']|\.\d)")
COMPARES = re.compile(
    r"\b(?:(?:not )?(?:above|below|beyond)|(?:more|less|fewer) than|exceeds?|outside|out of|of at least|of at most"
    r"|too (?:light|heavy) ?:)"
    r" (?:(?:the|its|asked|allowed|usual|recommended|required|rated|limit|of|least|possible) )*"
    r"(?:[\w*_]+ = )?[-+]?\d"
)
# texts that name the end of a range or a part where the number of the limit would stand
IN_WORDS = {
    "amplification",
    "multiplier",
    "nu_p",
    "nu_x",
    "delta",
    "lambda",
    "imbalance",
    "thickness/diameter",
    "safety",
}


def documents(document: Document) -> Iterator[Document]:
    yield document
    for part in document.parts:
        yield from documents(part)


def shows(text: str, value: float) -> bool:
    """Whether a number in the text is the value in as many digits as are written."""
    for word in NUMBER.findall(text):
        digits = len(word.partition("e")[0].replace(".", "").lstrip("+-0")) or 1
        if float(f"{value:.{digits}g}") == float(word):
            return True
    return False


def told(spec: Path) -> list[tuple[str, Note | str]]:
    """Every note of every stage that a spec has results of."""
    try:
        found = solved(spec)
    except TmmError:
        return []
    results = {} if found.failures else found.results
    shown = [(stage, STAGES[stage].summary(result, stage)) for stage, result in results.items() if stage in STAGES]
    return [(stage, note) for stage, whole in shown for each in documents(whole) for note in each.notes]


@pytest.mark.parametrize(
    "spec",
    [
        pytest.param(path, marks=() if path.stem in QUICK else pytest.mark.slow, id=f"{path.parent.name}-{path.stem}")
        for path in SPECS
    ],
)
def test_what_is_compared_with_a_limit_is_data(spec: Path) -> None:
    for stage, note in told(spec):
        if note.startswith("warning") and COMPARES.search(note):
            assert isinstance(note, Note), f"{stage}: {note}"
            assert note.value is not None, f"{stage}: {note}"
            assert note.limit is not None, f"{stage}: {note}"
            assert note.name, f"{stage}: {note}"
            factors = [1.0, *(factor for (unit, _), factor in SHOWN.items() if unit == note.unit)]
            value, limit = (any(shows(note, each * factor) for factor in factors) for each in (note.value, note.limit))
            assert value, f"{stage}: {note.value} is not in {note}"
            assert limit or note.limit == 0 or note.name in IN_WORDS, f"{stage}: {note.limit} is not in {note}"


def test_the_walk_meets_comparisons() -> None:
    """The pattern finds what it should: of a press, a pair, a vibrator."""
    for text in (
        "b/m = 4 is narrow, below 6",
        "|theta| reaches 45 deg, beyond the limit of 30 deg",
        "transverse contact ratio 1.1 below 1.2",
        "a stress of 250 MPa is above the allowed 200 MPa",
        "a radius of 1 mm at phi = 3 deg, less than r_m = 2 mm",
    ):
        assert COMPARES.search(text), text
    assert not COMPARES.search("the follower leaves the cam for phi from 30 to 40 deg")
    assert shows("a radius of 1.235 mm", 1.23456)
    assert not shows("a radius of 1.235 mm", 1.24)


def test_a_note_survives_its_files() -> None:
    note = held("warning", "{value:.3g} is above {limit:g} in {part}", 0.12345, 0.1, "m", name="h", part="{the} ring")
    assert note == "warning: 0.123 is above 0.1 in {the} ring"
    for each in (note, note.within("pair 1"), Note("note", "a word"), Note("note", "a word", "somewhere")):
        again = restored(Note, json.loads(json.dumps(each.stored())))
        assert isinstance(again, Note)
        assert again == each
        assert again.__getnewargs__() == each.__getnewargs__()
    assert finding(note.within("pair 1")) == {
        "level": "warning",
        "place": "pair 1",
        "name": "h",
        "value[m]": 0.12345,
        "limit[m]": 0.1,
        "text": "0.123 is above 0.1 in {the} ring",
    }


@pytest.mark.parametrize("name", ["wheel", "pair-blocking", "cam-oscillating", "vibratory-device", "extra-transloader"])
def test_a_resumed_run_tells_the_same(name: str, tmp_path: Path) -> None:
    spec = load_spec(CONFIGS / f"{name}.toml")
    first, again = (
        {
            stage: _payload(STAGES[stage].summary(result, stage)).get("findings")
            for stage, result in tmmcalc.run(spec, out=tmp_path).results.items()
            if stage in STAGES
        }
        for _ in range(2)
    )
    assert first == again
