"""Mutants of the ready specs and of command lines: every one follows from a seed and its number."""

from __future__ import annotations

import random
import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import tomli_w
from outputs_commands import COMMANDS, FEWER, LENGTHY, UNDRAWN

from fuzz.judge import CONFIGS, SPEC, Case
from fuzz.places import Steps, branches, leaves, numeric, removed, replaced, times, valued
from tmmcalc.core.errors import TmmError
from tmmcalc.core.plan import plan
from tmmcalc.project import parse_spec
from tmmcalc.rooms import STAGES

Document = dict[str, Any]

FACTORS = (-1.0, 0.0, 1e-12, 1e-6, 1e-3, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0, 1e3, 1e6, 1e12)
NUMBERS = (float("nan"), float("inf"), -float("inf"), -0.0, 1e300, 1e-300, 1.0, -1.0, 2**31, 2**63, 10**400)
TYPES: tuple[Any, ...] = (True, "x", "", [], {}, [[]], [1], [{}], {"A": []}, ["a", 1], 0, 1.5, [0, 0], [0, 0, 0])
UNITS = (
    "mm",
    "m",
    "km",
    "deg",
    "rad",
    "rpm",
    "rad/s",
    "N",
    "kN",
    "kg",
    "s",
    "ms",
    "N*m",
    "kW",
    "%",
    "furlong",
    "mm mm",
)
STRINGS = (" ", "-", "É", "漢字", "😀", "a" * 3000, "../x", "[bold]x[/bold]", "%s", "{x}", "a.b", "a,b", "'", '"', "\\")
FLAGS = (
    *("--positions 0", "--positions 0:12:0", "--positions 12:0", "--positions x", "--columns phi", "--columns *"),
    *("--columns [", "--columns ,", "--tolerance 1e-6", "--tolerance 1e-30", "--tolerance nan", "--tolerance -1"),
    *("-f json", "-f csv", "-f toml", "-f xml", "--strict", "--fresh", "--no-csv", "--from x", "--from kinematics"),
    *("--method x", "--depfile d.mk", "--depfile no/d.mk", "-o out", "-o case.toml", "-o ''", "--quiet", "--bogus"),
    *("--set mechanism.grid.positions=36", "--set a=1", "--set =", "--set x", "--set motor.power='1 kW'"),
    *("--set mechanism.input.speed='60 rpm'", "--set project.title=5", "--set @x.csv:1", "--svg a.svg", "--csv"),
)
MUTATIONS = 3  # of one spec, at most


@dataclass(frozen=True)
class Ready:
    """A ready spec: its document, and the commands that it has."""

    name: str
    document: Document
    commands: tuple[tuple[str, ...], ...]


@cache
def ready_specs() -> tuple[Ready, ...]:
    return tuple(
        _ready(file.relative_to(CONFIGS).with_suffix("").as_posix(), file.read_text("utf-8"))
        for file in sorted(CONFIGS.rglob("*.toml"))
    )


def _ready(name: str, text: str) -> Ready:
    document = tomllib.loads(text)
    if name in FEWER:
        document["mechanism"]["grid"]["positions"] = 5000
    short = (("check", SPEC), ("plan", SPEC, "--why"))
    if name in LENGTHY:
        return Ready(name, document, short)
    try:
        stages = plan(parse_spec(text, folder=CONFIGS), None, STAGES).running
    except TmmError:
        stages = ()
    run = ("run", SPEC, "-o", "out")
    own = [(*COMMANDS[stage].split(), SPEC, "--no-store") for stage in stages if stage in COMMANDS]
    drawn = [("plot", SPEC, stage, "-o", "p.svg") for stage in stages if STAGES[stage].picture and stage not in UNDRAWN]
    return Ready(name, document, (*short, *6 * (run,), *own, *drawn[:1]))


def mutant(seed: int, number: int) -> Case:
    """The mutant of this number: of a spec, of a command line, or of the text of a spec."""
    chance = random.Random(f"{seed}:{number}")
    ready = chance.choice(ready_specs())
    args = chance.choice(ready.commands)
    kind = chance.random()
    if kind < 0.1:
        flags = " ".join(chance.sample(FLAGS, chance.randint(1, 2)))
        return Case((*args, *_words(flags)), tomli_w.dumps(ready.document), f"{ready.name}: {flags}")
    # most specs with a wrong word are refused at once: what is computed is found by other numbers
    ways = (_scaled,) if kind < 0.7 else WAYS
    document, told = ready.document, []
    for _ in range(chance.randint(1, MUTATIONS)):
        document, said = chance.choice(ways)(chance, document)
        told.append(said)
    text = tomli_w.dumps(document)
    if kind > 0.95:
        text, said = _torn(chance, text)
        told.append(said)
    return Case(args, text, f"{ready.name}: {'; '.join(told)}"[:300])


def _words(flags: str) -> list[str]:
    import shlex

    return shlex.split(flags)


def _place(chance: random.Random, document: Document, fits: Callable[[Any], bool]) -> tuple[Steps, Any] | None:
    places = [(path, value) for path, value in leaves(document) if fits(value)]
    return chance.choice(places) if places else None


def _scaled(chance: random.Random, document: Document) -> tuple[Document, str]:
    found = _place(chance, document, numeric)
    if found is None:
        return document, "nothing scaled"
    path, value = found
    factor = chance.choice(FACTORS) if chance.random() < 0.3 else 10 ** chance.uniform(-1.5, 1.5)
    return replaced(document, path, times(value, factor)), f"{_shown(path)} times {factor:g}"


def _numbered(chance: random.Random, document: Document) -> tuple[Document, str]:
    found = _place(chance, document, numeric)
    if found is None:
        return document, "nothing numbered"
    path, value = found
    number = chance.choice(NUMBERS)
    other = number if abs(number) >= 1e308 else valued(value, number)
    return replaced(document, path, other), f"{_shown(path)} = {other!r:.40}"


def _typed(chance: random.Random, document: Document) -> tuple[Document, str]:
    path, other = chance.choice(list(branches(document))), chance.choice(TYPES)
    return replaced(document, path, other), f"{_shown(path)} = {other!r}"


def _missing(chance: random.Random, document: Document) -> tuple[Document, str]:
    path = chance.choice(list(branches(document)))
    return removed(document, path), f"without {_shown(path)}"


def _united(chance: random.Random, document: Document) -> tuple[Document, str]:
    found = _place(chance, document, numeric)
    if found is None:
        return document, "no unit"
    path, value = found
    unit = chance.choice(UNITS)
    number = value.split()[0] if isinstance(value, str) else value
    return replaced(document, path, f"{number} {unit}"), f"{_shown(path)} in {unit}"


def _worded(chance: random.Random, document: Document) -> tuple[Document, str]:
    found = _place(chance, document, lambda value: isinstance(value, str) and not numeric(value))
    if found is None:
        return document, "no words"
    path, word = found[0], chance.choice(STRINGS)
    return replaced(document, path, word), f"{_shown(path)} = {word!r:.20}"


def _doubled(chance: random.Random, document: Document) -> tuple[Document, str]:
    """An element of a list twice, or two of them in the other order."""
    lists = [path for path in branches(document) if isinstance(_at(document, path), list) and _at(document, path)]
    if not lists:
        return document, "nothing doubled"
    path = chance.choice(lists)
    held = list(_at(document, path))
    k = chance.randrange(len(held))
    if chance.random() < 0.5:
        held.insert(k, held[k])
        return replaced(document, path, held), f"{_shown(path)}[{k}] twice"
    held.reverse()
    return replaced(document, path, held), f"{_shown(path)} backwards"


def _grafted(chance: random.Random, document: Document) -> tuple[Document, str]:
    """A table of another spec, added or in place of one's own."""
    other = chance.choice(ready_specs())
    key = chance.choice(list(other.document))
    return {**document, key: other.document[key]}, f"[{key}] of {other.name}"


WAYS = (_scaled, _scaled, _scaled, _scaled, _numbered, _typed, _missing, _united, _worded, _doubled, _grafted)


def _torn(chance: random.Random, text: str) -> tuple[str, str]:
    """The text with a line twice, without one, or with a character in place of another."""
    lines = text.splitlines()
    if not lines:
        return text, "empty"
    k = chance.randrange(len(lines))
    way = chance.randrange(3)
    if way == 0:
        return "\n".join((*lines[: k + 1], *lines[k:])), f"line {k + 1} twice"
    if way == 1:
        return "\n".join((*lines[:k], *lines[k + 1 :])), f"without line {k + 1}"
    sign = chance.choice("[]{}=\"'#.,-_ e0é")
    at = chance.randrange(len(text))
    return text[:at] + sign + text[at + 1 :], f"{sign!r} as character {at}"


def _at(document: Document, path: Steps) -> Any:
    held: Any = document
    for step in path:
        held = held[step]
    return held


def _shown(path: Steps) -> str:
    return ".".join(map(str, path))
