"""Pictures in Ukrainian: no English word is left on them but those that the spec gives, and nothing is cut off."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from paper import on_sheet, written
from sparing import sparing

from tmmcalc.core.plan import plan
from tmmcalc.pipeline.picturing import figure_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.language import speaking

CONFIGS = Path(__file__).parents[2] / "configs"
SIGNS = {"max", "min"}
FORMULA, WORD = re.compile(r"\$[^$]*\$"), re.compile("[A-Za-z]{3,}")
QUICK = [
    ("extra-ball", "falling_ball"),
    ("extra-contact", "contact"),
    ("extra-liner", "liner"),
    ("extra-reliability", "reliability"),
    ("extra-tie-down", "tie_down"),
    ("extra-transloader", "transloader"),
    ("rules", "feasibility"),
    ("feasibility", "feasibility"),
    ("manipulator", "manipulator"),
    ("manipulator-direct", "manipulator"),
    ("in-line-engine", "balance"),
    ("press", "balance"),
    ("press", "flywheel"),
    ("press", "motion"),
    ("shaper", "reduction"),
    ("hydraulic-lift", "reduction"),
    ("electric-braking", "transient"),
    ("pendulum-rotor", "pendulum"),
    ("vibratory-device", "vibrator"),
]


def names_of(file: Path) -> set[str]:
    """The words of a spec, without its comments."""
    lines = (line.partition("#")[0] for line in file.read_text(encoding="utf-8").splitlines())
    return set(WORD.findall("\n".join(lines)))


@sparing(("name", "stage"), QUICK, every=4)
def test_no_english_word_is_left(name: str, stage: str) -> None:
    file = CONFIGS / f"{name}.toml"
    spec = load_spec(file)
    assert stage in plan(spec).running
    found = run(spec, target=stage)
    with speaking("uk"):
        drawing = figure_of(stage, found.spec, found.results)()
    said = {word for text in written(drawing) for word in WORD.findall(FORMULA.sub("", text))}
    assert said <= names_of(file) | SIGNS, sorted(said - names_of(file))
    assert any(re.search("[а-яіїє]{3}", text) for text in written(drawing))
    assert on_sheet(drawing) == []


@pytest.mark.parametrize(("name", "stage"), QUICK[:1])
def test_a_word_that_is_left_is_found(name: str, stage: str) -> None:
    """In English the same picture has words that the spec has not."""
    file = CONFIGS / f"{name}.toml"
    found = run(load_spec(file), target=stage)
    said = written(figure_of(stage, found.spec, found.results)())
    assert {word for text in said for word in WORD.findall(FORMULA.sub("", text))} - names_of(file)
