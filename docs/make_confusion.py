"""Write docs/confusion.md: which mistakes of the press are told apart in the answers of a class.

A class is drawn from configs/class-press.toml; each known mistake is made in each variant, and the answers are written
to three digits and marked, exact and with the noise of plans. Numbers that come of nothing are marked too. It takes
some minutes: ``python docs/make_confusion.py``.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from tmmcalc.batch.executors import solve_here
from tmmcalc.classroom.answers.handed import Answer, HandIn
from tmmcalc.classroom.items import items_of
from tmmcalc.classroom.keymaking import make_keys
from tmmcalc.classroom.making import make_class
from tmmcalc.classroom.marking import Marked, Rules, mark_one
from tmmcalc.classroom.model import Key, Keybook
from tmmcalc.classroom.verdicts import Standing
from tmmcalc.project import load_spec

PAGE = Path(__file__).parent / "confusion.md"
ASSIGNMENT = Path(__file__).parents[1] / "configs" / "class-press.toml"
VARIANTS, SEED = 12, 7
DIGITS = 3
PLANS = 0.02  # noise of plans, relative
RANDOM = 2000  # tables of numbers that come of nothing
REPEATS = 10  # of each mistake and variant with noise
HEAD = """# Which mistakes are told apart

A class of {variants} was drawn from `configs/class-press.toml` with {items} asked results. Each of {mistakes} known
mistakes was made in each variant, in all answers that it changes; a misreading of a single answer, marked *, in one of
them. The answers were written to {digits} digits and marked by `class mark`. *Named* is how often the explanation that
stands first names the mistake, alone or among those whose numbers are equal within tolerance; *also* the others that
stand first instead or beside it. `python docs/make_confusion.py` writes this page.

|  | Exact, to {digits} digits | Noise of {noise:.0%}, as by plans |
|-|-|-|
"""


def keys() -> Keybook:
    """The keys of the class."""
    with TemporaryDirectory() as folder:
        made = make_class(ASSIGNMENT, Path(folder) / "class", VARIANTS, SEED)
        return make_keys(ASSIGNMENT, made.own.variants, items_of(load_spec(ASSIGNMENT)), solve_here)


def answered(book: Keybook, key: Key, values: Sequence[float]) -> Marked:
    """The marks of these answers."""
    answers = []
    for value in values:
        text = f"{value:.{DIGITS - 1}e}"
        size = math.floor(math.log10(abs(float(text)))) if float(text) else 0
        answers.append(Answer(text, float(text), 10.0 ** (size - DIGITS + 1), DIGITS))
    return mark_one(book, key, HandIn(key.number, "", tuple(answers)), Rules())


def planted(book: Keybook, noise: float) -> Iterator[tuple[int, Marked]]:
    """Every mistake in every variant, as far as an answer is wrong by it."""
    rng = np.random.default_rng(SEED)
    for key in book.keys:
        right = np.array(key.values)
        for m, told in enumerate(book.mistakes):
            given = np.array(key.mistaken[m])
            changed = np.flatnonzero(np.isfinite(given))
            for _ in range(REPEATS if noise else 1):
                made = rng.choice(changed, 1) if told.single and changed.size else changed
                values = right.copy()
                values[made] = given[made]
                found = answered(book, key, values * (1 + noise * rng.normal(size=len(right))))
                off = [k for k in made if found.standings[k] in (Standing.wrong, Standing.carried)]
                if off:
                    yield m, found


def by_chance(book: Keybook, noise: float) -> float:
    """The share of tables of numbers that come of nothing which are explained."""
    rng = np.random.default_rng(SEED)
    explained = 0
    for n in range(RANDOM):
        key = book.keys[n % len(book.keys)]
        right = np.array(key.values)
        spread = np.exp(rng.normal(0, 0.5, len(right))) * rng.choice([1, -1], len(right), p=[0.85, 0.15])
        wrong = rng.permutation(len(right)) < rng.integers(1, len(right) + 1)
        values = np.where(wrong, right * spread, right * (1 + noise * rng.normal(size=len(right))))
        explained += bool(answered(book, key, values).explanations)
    return explained / RANDOM


class Told:
    """What was named where a mistake was planted."""

    def __init__(self, book: Keybook) -> None:
        self.named: list[list[bool]] = [[] for _ in book.mistakes]
        self.others: list[Counter[int]] = [Counter() for _ in book.mistakes]
        self.enough = list[bool]()  # of those with at least two wrong answers

    def add(self, m: int, found: Marked) -> None:
        """Count what is said of one table."""
        first = found.explanations[0].mistakes if found.explanations else ()
        self.named[m].append(m in first)
        self.others[m].update(other for other in first if other != m)
        if sum(each in (Standing.wrong, Standing.carried) for each in found.standings) > 1:
            self.enough.append(m in first)

    @property
    def share(self) -> float:
        """How many of all are named first."""
        return float(np.mean([each for row in self.named for each in row]))


def page(book: Keybook) -> str:
    """The whole page."""
    settings = {"variants": len(book.keys), "items": len(book.items), "mistakes": len(book.mistakes)}
    told = {noise: Told(book) for noise in (0.0, PLANS)}
    for noise, each in told.items():
        for m, found in planted(book, noise):
            each.add(m, found)
    exact, plans = told.values()
    lines = [
        f"| Mistakes named first | {exact.share:.1%} | {plans.share:.1%} |",
        f"| of these where two answers or more are wrong | {np.mean(exact.enough):.1%} | {np.mean(plans.enough):.1%} |",
        f"| Tables of random wrong numbers explained | {by_chance(book, 0.0):.2%} | {by_chance(book, PLANS):.2%} |",
        "",
        "| Mistake | Named, exact | Named, plans | Also |",
        "|-|-|-|-|",
    ]
    lines += [_row(book, m, exact, plans) for m in range(len(book.mistakes)) if exact.named[m]]
    unseen = [each.name for each, named in zip(book.mistakes, exact.named, strict=True) if not named]
    if unseen:
        lines += ["", f"Within tolerance in all variants: {', '.join(f'`{name}`' for name in unseen)}."]
    return HEAD.format(**settings, digits=DIGITS, noise=PLANS) + "\n".join(lines) + "\n"


def _row(book: Keybook, m: int, *told: Any) -> str:
    shares = (f"{np.mean(each.named[m]):.0%}" if each.named[m] else "" for each in told)
    others = ", ".join(f"`{book.mistakes[k].name}`" for k, _ in told[0].others[m].most_common(3))
    mark = " *" if book.mistakes[m].single else ""
    return f"| `{book.mistakes[m].name}`{mark} | {' | '.join(shares)} | {others} |"


if __name__ == "__main__":
    PAGE.write_text(page(keys()), encoding="utf-8")
