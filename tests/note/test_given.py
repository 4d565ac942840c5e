"""What is given of the subjects whose data stand in their chapters: all that a solution by hand needs, nothing found.

Every number of a spec is changed by itself, see `note.given`.
"""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from functools import cache
from math import pi
from pathlib import Path
from tempfile import gettempdir

import pytest
from classroom.leaking import beginning, numbers_in
from sparing import sparing

from note import test_dyad, test_extras, test_manipulators, test_synthesis, test_vibration
from note.given import data_of, numbers_of, untold
from note.scenes import CONFIGS, written
from note.scenes import SPECS as EVERY
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.told import Told, listed
from tmmcalc.note.plaintext import text
from tmmcalc.note.task import row_of
from tmmcalc.pipeline.chapters import given_in
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.project import Spec
from tmmcalc.project.loader import Variants
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Block, Datum, Figure, Paragraph

READY = sorted(
    path.stem
    for path in CONFIGS.glob("*.toml")
    if re.search(
        r"^\[(bearing|contact|falling_ball|liner|reliability|tie_down|transloader|manipulator|vibrator|pendulum|dyad"
        r"|synthesis)\b",
        path.read_text(encoding="utf-8"),
        re.MULTILINE,
    )
)
DEAR = {"dyad", "synth-dwell", "synth-dwell-optimum", "synth-dwell-rocker", "synth-motion", "synth-path"}
DEAR |= {"synth-trailing-rod", "vibratory-device"}
SPECS = [pytest.param(name, marks=[pytest.mark.slow] * (name in DEAR)) for name in READY]
HEAD = '[project]\ntitle = "t"\n\n'
OF_ALL = [*SPECS, *(pytest.param(name, marks=pytest.mark.slow) for name in EVERY if name not in READY)]
OTHERS = {  # specs whose tables have other keys than those of the ready ones
    **{f"extras, {kind}": HEAD + body for kind, body in test_extras.KINDS.items()},
    **{f"manipulator, {kind}": test_manipulators.HEAD + body for kind, body in test_manipulators.KINDS.items()},
    **{f"vibration, {kind}": HEAD + body for kind, body in test_vibration.KINDS.items()},
    **{f"synthesis, {kind}": HEAD + test_synthesis.body_of(kind) for kind in test_synthesis.CLOSED},
    **{f"dyad, {kind}": f'{HEAD}[dyad]\nkind = "{kind.split()[0]}"\n{body}' for kind, body in test_dyad.KINDS.items()},
}
SOUGHT = {f"synthesis, {kind}": HEAD + test_synthesis.body_of(kind) for kind in test_synthesis.SOUGHT}
UNTOLD = {  # ends of keys of numbers that are none of the given data
    ".at_least": "a limit of a constraint, which another stage judges",
    ".at_most": "a limit of a constraint, which another stage judges",
    ".rows": "rows of a table",
    "synthesis.solutions": "how many of the linkages that were found are listed",
    "synthesis.seed": "where a search begins",
    "synthesis.positions": "positions of the ready spec of the linkage",
    "optimum.population": "how long a search goes on",
    "optimum.generations": "how long a search goes on",
    "optimum.polish": "how long a search goes on",
}
FIXED = {  # ends of keys of numbers that nothing but their own value may be
    "swing.carrier.time[0]": "times begin at nothing",
    "pendulum.rod.width": "a rod that spins is square",
    "pendulum.rod.thickness": "a rod that spins is square",
}


def scene(words: str, folder: Path = CONFIGS) -> tuple[Variants, RunResult]:
    """A spec whose numbers can be changed, and what is found of it."""
    variants = Variants(words, str(folder / "spec.toml"), folder)
    return variants, run(variants.spec())


@cache
def ready(name: str) -> tuple[Variants, RunResult]:
    return scene((CONFIGS / f"{name}.toml").read_text(encoding="utf-8"))


def check_told(words: str, variants: Variants, done: RunResult) -> None:
    """Every number of a spec is told but those of the settings, and each can be changed.

    What is given is told by the spec alone, so it is not solved again; a dyad that does not assemble is refused.
    """

    def told(spec: Spec) -> list[Datum]:
        return data_of(given_in(spec, done.results))

    found = untold(words, variants, told(done.spec), told)
    paths = [path for path, _, _ in numbers_of(tomllib.loads(words))]
    assert found.same == [path for path in paths if path.endswith(tuple(UNTOLD))]
    assert [path for path in found.refused if not path.endswith(tuple(FIXED))] == []


@pytest.mark.parametrize("name", SPECS)
def test_every_number_of_a_ready_spec_is_told(name: str) -> None:
    variants, done = ready(name)
    assert data_of(given_in(done.spec, done.results))
    check_told((CONFIGS / f"{name}.toml").read_text(encoding="utf-8"), variants, done)


@sparing("name", OTHERS, every=12)
def test_every_number_of_other_keys_is_told(name: str) -> None:
    variants, done = scene(OTHERS[name], Path(gettempdir()))
    check_told(OTHERS[name], variants, done)


@pytest.mark.slow
@pytest.mark.parametrize("name", SOUGHT)
def test_every_number_of_a_search_is_told(name: str) -> None:
    variants, done = scene(SOUGHT[name], Path(gettempdir()))
    check_told(SOUGHT[name], variants, done)


def said(blocks: list[Block]) -> str:
    """What is read of what is given."""
    rows = [" ".join(row_of(block)) for block in blocks if isinstance(block, Datum)]
    return "\n".join([*rows, *(block.text for block in blocks if isinstance(block, Paragraph))])


def found_in(done: RunResult) -> dict[str, str]:
    """Beginnings of the facts that are found, none of them a number of the spec in some unit, with their names."""
    own = [value for _, value, _ in numbers_of(done.spec.model_dump(mode="json"))]
    known = {beginning(value * factor) for value in own for factor in (1.0, 180 / pi, 30 / pi, 60.0)}
    told = [fact for name, result in done.results.items() if STAGES[name].tells_data for fact in listed(name, result)]
    facts = {beginning(fact.value): fact.key for fact in told if isinstance(fact, Told) and fact.value == fact.value}
    return {
        digits: key for digits, key in facts.items() if digits and digits not in known and not digits.endswith("00")
    }


@pytest.mark.parametrize("name", SPECS)
def test_nothing_that_is_found_is_given(name: str) -> None:
    """To four digits, as what students get is searched for answers; the note tells some of it."""
    _, done = ready(name)
    found = found_in(done)
    assert found
    assert {found[digits] for digits in {*numbers_in(said(given_in(done.spec, done.results)))} & {*found}} == set()
    assert {*numbers_in(text(written(name)))} & {*found}


@pytest.mark.parametrize("kind", ["UNTOLD", "FIXED"])
def test_every_exception_is_of_some_spec(kind: str) -> None:
    texts = [(CONFIGS / f"{name}.toml").read_text(encoding="utf-8") for name in READY]
    documents = map(tomllib.loads, (*texts, *OTHERS.values(), *SOUGHT.values()))
    paths = [path for document in documents for path, _, _ in numbers_of(document)]
    assert [end for end in globals()[kind] if not any(path.endswith(end) for path in paths)] == []


@pytest.mark.parametrize("name", OF_ALL)
def test_a_datum_is_known_by_what_it_is_and_speaks_of_no_table(name: str) -> None:
    """Sheets know it by these; places in the note are none of theirs."""
    _, done = ready(name)
    for language in ("en", "uk"):
        with speaking(language):
            blocks = given_in(done.spec, done.results)
        assert all(isinstance(block, Datum | Paragraph | Figure) for block in blocks)
        marks = [(each.what, each.keys) for each in data_of(blocks)]
        assert [mark for mark, times in Counter(marks).items() if times > 1] == []
        assert not re.search(r"\{(tab|fig|eq):", said(blocks))
