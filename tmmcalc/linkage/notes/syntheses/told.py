"""What the chapter on the synthesis is told from: what is asked, the linkage taken, its sizes by their letters."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.results import SAME, Check, Design, SearchStep, Synthesis
from tmmcalc.linkage.synthesis.task import SynthesisTask
from tmmcalc.linkage.tables.tasks.synthesis import to_synthesis
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Line, Paragraph, Place, Table
from tmmcalc.report.telling import cell, lines, named, spaced

LETTERS = {  # of sizes whose symbols are no letters of formulas
    "two_phi": "Theta",
    "eps_lambda": "kappa",
    "phi_zero": "phi_I",
    "phi_second": "phi_{II}",
    "phi_start": "phi_s",
    "psi_start": "psi_s",
    "s_start": "s_s",
    "body": "beta",
}
NOISE = 1e-12  # in SI: of an error that is rounding alone


class Told(NamedTuple):
    """A synthesis with the linkage that is taken, and the quantities by their letters."""

    order: Order
    task: SynthesisTask
    found: Synthesis
    listed: tuple[Design, ...]  # all linkages that were found
    design: Design  # that which is taken
    lexicon: dict[str, Given]

    @property
    def asked(self) -> Any:
        """What the kind asks."""
        return self.task.asked

    @property
    def number(self) -> int:
        """Number of the linkage among those that were found, from 1."""
        return 1 + next(k for k, each in enumerate(self.listed) if each is self.design)

    def sizes(self) -> dict[str, Given]:
        """The sizes of the linkage by their letters."""
        return {letter_of(size.symbol): self.lexicon[letter_of(size.symbol)] for size in self.design.sizes}

    def meaning(self, letter: str) -> str:
        """What a letter stands for."""
        return self.lexicon[letter].meaning

    def give(self, quantities: Mapping[str, Given]) -> None:
        """Put quantities into the lexicon."""
        self.lexicon.update(named(dict(quantities)))

    def lines(self, *texts: str, words: Mapping[str, str] | None = None) -> Iterator[Line]:
        """The formulas worked out with what is known by now."""
        place = Place("", dict(self.lexicon))
        yield from lines(texts, [place], words)
        self.lexicon.update(place.lexicon)

    def achieved(self, name: str) -> float:
        """What the simulated linkage has."""
        return self.design.check(name).achieved


def told_of(order: Order) -> Told:
    """The synthesis of a run with the linkage that the spec takes, its sizes in the lexicon."""
    found: Synthesis = order.results["synthesis"]
    listed = found.among or found.designs
    design = found.designs[0]
    if not found.among:
        chosen = order.spec.synthesis.choose
        if not chosen and order.spec.constraints and len(listed) > 1:
            chosen = order.solved("feasibility").chosen
        design = listed[min(chosen or 1, len(listed)) - 1]
    told = Told(order, to_synthesis(order.spec), found, listed, design, {})
    meaning, own = "", meanings()
    for size in design.sizes:
        if size.meaning != SAME:
            meaning = own.get(letter_of(size.symbol)) or tr_name(size.meaning).replace("->", "→")
        told.give({letter_of(size.symbol): quantity_of(size.value, size.unit, meaning)})
    return told


def letter_of(symbol: str) -> str:
    """A size as it is called in formulas.

    >>> letter_of("two_phi"), letter_of("l_OA")
    ('Theta', 'l_OA')
    """
    return LETTERS.get(symbol, symbol)


def quantity_of(value: float, unit: str, meaning: str) -> Given:
    """A value in SI as it is printed: angles in degrees; ``-`` is a number."""
    if unit == "rad":
        return Given(math.degrees(value), "deg", meaning)
    return Given(float(value), "" if unit == "-" else unit, meaning)


def angle(value: float, meaning: str) -> Given:
    """An angle [rad]."""
    return Given(math.degrees(value), "deg", meaning)


def length(value: float, meaning: str) -> Given:
    """A length [m]."""
    return Given(float(value), "m", meaning)


def ratio(value: float, meaning: str) -> Given:
    """A number."""
    return Given(float(value), "", meaning)


def turned(value: float, digits: int = 5) -> str:
    """An angle [deg] in a sentence or a cell.

    >>> turned(-12.5)
    '−12.5°'
    """
    return f"{cell(value, digits)}°"


def sound(errors: Real) -> Real:
    """Errors without those that are rounding alone."""
    return np.where(np.abs(errors) < NOISE, 0.0, errors)


CHECKS = {  # names of checks that are letters
    "S": "S",
    "K": "K",
    "nu_p": "nu_p",
    "nu_x": "nu_x",
    "nu_max": "nu_m",
    "r": "r",
    "l": "l",
    "e": "e",
    "R": "R",
    "L": "L",
    "lambda": "lambda",
    "eps": "eps",
    "e/S": "e/S",
}


def called(check: Check) -> str:
    """A check in words or by its letter."""
    letter = CHECKS.get(check.name)
    return f"${letter}$" if letter else tr_name(check.name)


def meanings() -> dict[str, str]:
    """What letters mean that several kinds share."""
    return {
        "S": tr("stroke of the slider"),
        "K": tr("time ratio, working stroke over idle stroke"),
        "nu_p": tr("pressure angle on the working stroke where the crank stands across the guide"),
        "nu_x": tr("pressure angle on the idle stroke where the crank stands across the guide"),
        "nu_m": tr("largest pressure angle of the rod"),
        "v_p": tr("mean speed on the working stroke"),
        "n_1": tr("speed of the crank"),
        "psi": tr_name("overlap angle"),
        "lambda": tr("crank over rod"),
        "eps": tr("offset over crank"),
        "kappa": tr("offset over rod"),
        "phi_I": tr("angle of the crank at the far end of the stroke"),
        "phi_{II}": tr("angle of the crank at the near end of the stroke"),
    }


def course_of(told: Told, best: str, *, of: str = "", run: str = "", called: Sequence[str] = ()) -> Iterator[Block]:
    """What the steps of the search did, of each round its first, some and its last; ``best`` heads the least value.

    ``of`` heads how many linkages there are, where that is told, ``run`` the rounds, which have numbers or names.
    """
    rounds: dict[int, list[SearchStep]] = {}
    for step in told.found.course:
        rounds.setdefault(step.run, []).append(step)
    if not rounds:
        return
    several = len(rounds) > 1
    rows = []
    for k, steps in rounds.items():
        for step in spaced(steps):
            name = called[k - 1] if called else str(k)
            counted = [str(step.linkages)] if of else []
            rows.append((*[name] * several, str(step.number), *counted, cell(step.best, 4)))
    head = (*[run or tr("Round")] * several, tr("Step"), *([of] if of else []), best)
    yield Paragraph(tr("Table {tab:synthesis_course} has steps of the search."))
    yield Table(tr("Course of the search"), head, tuple(rows), "synthesis_course")
