"""Write docs/confusion.md: which mistakes are told apart in the answers of a class.

A class of forty is drawn from each of the ready assignments, as a teacher does it: ``class make``, ``class keys``. For
each known mistake every student hands in a file with the answers that come of it, to three digits, and the files are
marked as ``class mark`` does; then the same with the noise of plans, and numbers that come of nothing. It takes some
half an hour, most of it the keys: ``python docs/make_confusion.py [DIR]``; what stands in DIR already is taken.
"""

from __future__ import annotations

import math
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray

from tmmcalc.classroom.answers.handed import Answer, HandIn
from tmmcalc.classroom.grading import graded
from tmmcalc.classroom.keybook import read_keybook
from tmmcalc.classroom.known import known
from tmmcalc.classroom.marking import Marked, Rules, mark_one
from tmmcalc.classroom.model import Key, Keybook
from tmmcalc.classroom.verdicts import Standing

DOCS = Path(__file__).parent
CONFIGS = DOCS.parent / "configs"
ASSIGNMENTS = ("course-project", "press", "shaper", "cam", "gears", "train")
VARIANTS, SEED = 40, 7
DIGITS = 3
PLANS = 0.02  # noise of plans, relative
RANDOM = 2000  # tables of numbers that come of nothing
REPEATS = 3  # of each mistake and variant with noise
NOISES = (0.0, PLANS)
HEAD = """# Which mistakes are told apart

A class of {variants} was drawn from each of the ready assignments, `configs/assignment-*.toml`. Each known mistake was
made in each variant, in all answers that it changes; a misreading of a single answer, marked *, in one of them. The
answers were written to {digits} digits into a file for each student, and the files marked by `class mark`.
`python docs/make_confusion.py` writes this page.

| | {names} |
|-|{rules}
"""
TABLE = """
*Named* is how often the explanation that stands first names the mistake, alone or among those whose numbers are equal
within tolerance: of exact answers, then after / of those with a noise of {noise:.0%}, as by plans. *Also* are the
others that stand first instead or beside it. Where nothing stands the mistake cannot be made, or changes no answer by
more than the tolerance.

| Mistake | {names} | Also |
|-|{rules}-|
"""

Array = NDArray[np.float64]


def made(name: str, folder: Path) -> Keybook:
    """The keys of a class, which is drawn if it is not there yet."""
    spec = CONFIGS / f"assignment-{name}.toml"
    for order in (["make", spec, "-n", VARIANTS, "--seed", SEED, "--no-sheets", "-o", folder], ["keys", folder]):
        done = [*map(str, order)]
        if "keys" in done or not (folder / "class.toml").is_file():
            subprocess.run([sys.executable, "-m", "tmmcalc", "class", *done], check=True, stdout=subprocess.DEVNULL)
    return read_keybook(folder / "keys")


def planted(book: Keybook, at: int, noise: float, rng: np.random.Generator) -> Iterator[tuple[Key, Array, list[int]]]:
    """The answers of every variant with a mistake, and which of them come of it."""
    for key in book.keys:
        right, given = np.array(key.values), np.array(key.mistaken[at])
        changed = np.flatnonzero(np.isfinite(given))
        if not changed.size:
            continue
        touched = rng.choice(changed, 1) if book.mistakes[at].single else changed
        values = right.copy()
        values[touched] = given[touched]
        yield key, values * (1 + noise * rng.normal(size=len(right))), touched.tolist()


def written(value: float) -> str:
    """A value as a student writes it."""
    return f"{value:.{DIGITS - 1}e}"


def in_memory(book: Keybook, key: Key, values: Sequence[float]) -> Marked:
    """The marks of these answers."""
    answers = []
    for value in values:
        text = written(value)
        size = math.floor(math.log10(abs(float(text)))) if float(text) else 0
        answers.append(Answer(text, float(text), 10.0 ** (size - DIGITS + 1), DIGITS))
    return mark_one(book, key, HandIn(key.number, "", tuple(answers)), Rules())


def by_files(book: Keybook, folder: Path, at: int, rng: np.random.Generator) -> Iterator[tuple[Marked, list[int]]]:
    """The marks of a class in which everybody makes a mistake, and hands in a file."""
    touched = {}
    with TemporaryDirectory() as answers:
        for key, values, made_in in planted(book, at, 0.0, rng):
            touched[key.number] = made_in
            rows = (f"{item.name};{item.unit};{written(value)}" for item, value in zip(book.items, values, strict=True))
            text = "\n".join(("name;unit;value", *rows))
            Path(answers, f"{key.number:02d}.csv").write_text(text, encoding="utf-8")
        if not touched:
            return
        marks, *_ = graded(folder, Path(answers), None)
    assert len(marks.marked) == len(touched), marks.refused
    for each in marks.marked:
        yield each, touched[each.number]


class Told:
    """What was named in a class where a mistake was planted, by its noise."""

    def __init__(self, name: str, folder: Path) -> None:
        self.book = made(name, folder)
        count = len(self.book.mistakes)
        self.named: dict[float, list[list[bool]]] = {noise: [[] for _ in range(count)] for noise in NOISES}
        self.several: dict[float, list[bool]] = {noise: [] for noise in NOISES}  # where two answers or more are wrong
        self.others: list[Counter[str]] = [Counter() for _ in range(count)]
        rng = np.random.default_rng(SEED)
        for at in range(count):
            for marked, touched in by_files(self.book, folder, at, rng):
                self._add(at, 0.0, marked, touched)
            for _ in range(REPEATS):
                for key, values, touched in planted(self.book, at, PLANS, rng):
                    self._add(at, PLANS, in_memory(self.book, key, values.tolist()), touched)
        self.chance = {noise: self._by_chance(noise) for noise in NOISES}

    def _add(self, at: int, noise: float, marked: Marked, touched: list[int]) -> None:
        """Count what is said of one table; none of whose answers is wrong by the mistake says nothing."""
        off = (Standing.wrong, Standing.carried)
        if all(marked.standings[k] not in off for k in touched):
            return
        first = marked.explanations[0].mistakes if marked.explanations else ()
        self.named[noise][at].append(at in first)
        if not noise:
            self.others[at].update(self.book.mistakes[other].name for other in first if other != at)
        if sum(each in off for each in marked.standings) > 1:
            self.several[noise].append(at in first)

    def _by_chance(self, noise: float) -> float:
        """The share of tables of numbers that come of nothing which are explained."""
        rng = np.random.default_rng(SEED)
        explained = 0
        for n in range(RANDOM):
            key = self.book.keys[n % len(self.book.keys)]
            right = np.array(key.values)
            spread = np.exp(rng.normal(0, 0.5, len(right))) * rng.choice([1, -1], len(right), p=[0.85, 0.15])
            wrong = rng.permutation(len(right)) < rng.integers(1, len(right) + 1)
            values = np.where(wrong, right * spread, right * (1 + noise * rng.normal(size=len(right))))
            explained += bool(in_memory(self.book, key, values.tolist()).explanations)
        return explained / RANDOM

    def share(self, noise: float) -> str:
        """How many of all are named first."""
        return f"{np.mean([each for row in self.named[noise] for each in row]):.1%}"

    def with_several(self, noise: float) -> str:
        """The same where two answers or more are wrong, if there are such tables."""
        return f"{np.mean(self.several[noise]):.1%}" if self.several[noise] else ""

    def cell(self, mistake: str) -> str:
        """How often a mistake is named, exact / by plans."""
        if mistake not in (names := [each.name for each in self.book.mistakes]):
            return ""
        shares = [self.named[noise][names.index(mistake)] for noise in NOISES]
        return " / ".join(f"{np.mean(each):.0%}" for each in shares) if all(shares) else ""


def page(classes: dict[str, Told]) -> str:
    """The whole page."""
    every = list(classes.values())
    named = {each.name: each.single for told in every for each in told.book.mistakes}
    rows = [
        ("Asked results", [str(len(each.book.items)) for each in every]),
        ("Mistakes that change an answer", [str(sum(map(bool, each.named[0.0]))) for each in every]),
        ("Named first, exact", [each.share(0.0) for each in every]),
        ("of these where two answers or more are wrong", [each.with_several(0.0) for each in every]),
        ("Random wrong numbers explained", [f"{each.chance[0.0]:.2%}" for each in every]),
        ("Named first, plans", [each.share(PLANS) for each in every]),
        ("of these where two answers or more are wrong", [each.with_several(PLANS) for each in every]),
        ("Random wrong numbers explained, plans", [f"{each.chance[PLANS]:.2%}" for each in every]),
    ]
    settings = {"names": " | ".join(classes), "rules": "-|" * len(classes)}
    lines = [HEAD.format(variants=VARIANTS, digits=DIGITS, **settings).rstrip()]
    lines += [f"| {title} | {' | '.join(cells)} |" for title, cells in rows]
    lines += [TABLE.format(noise=PLANS, **settings).rstrip()]
    met = {name: [told.cell(name) for told in every] for name in sorted(named)}
    for name in (name for name, cells in met.items() if any(cells)):
        others: Counter[str] = sum(
            (told.others[k] for told in every for k, each in enumerate(told.book.mistakes) if each.name == name),
            Counter(),
        )
        also = ", ".join(f"`{other}`" for other, _ in others.most_common(3))
        lines.append(f"| `{name}`{' *' if named[name] else ''} | {' | '.join(met[name])} | {also} |")
    own = {name.partition(":")[0] for name, cells in met.items() if any(cells)}
    if unseen := [name for name in sorted(known()) if name not in own]:
        names = ", ".join(f"`{name}`" for name in unseen)
        lines += ["", f"Of the {len(known())} known mistakes none of these classes shows {names}."]
    return "\n".join(lines) + "\n"


def main(folder: Path) -> None:
    """Write the page."""
    classes = {name: Told(name, folder / name) for name in ASSIGNMENTS}
    (DOCS / "confusion.md").write_text(page(classes), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        with TemporaryDirectory() as place:
            main(Path(place))
