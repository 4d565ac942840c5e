"""Every line of the notes of the ready specs: exact against the program, and right as it is printed.

A formula with a mistake in it is caught: its mutants do not give what the program found.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

import pytest

from note.scenes import SPECS, blocks, chapters, lines, linkage, told, written
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.report.formula.digits import EXACT, off_by, result_of
from tmmcalc.report.formula.tree import Call, Name, Node, Product, Quotient, Statement, Sum, mapped, names, parts
from tmmcalc.report.manuscript import Lexicon, Line

QUICK = ("shaper", "press", "scotch-yoke")
MUTATED: dict[str, list[str]] = {  # keys that are changed, so that no factor is 1 and no term 0 in all scenes
    "shaper": [],
    "press": ["flywheel.delta=0.03"],
    "class-three-slider": [],
    "class-four": [],
    "tipper": [],
    "course-project": ['mechanism.joints[name=D0].guide={through="C", angle="80 deg"}', "train.addendum=0.9"],
    "four-stroke-engine": ['mechanism.joints[name=B0].guide={through="O", angle="75 deg"}'],
    "pair-helical": [],
    "pair-internal": [],
    "pair-rack": [],
    "wheel": [],
    "gears-pairs": [],
    "crank-slider": [],
    "cam-translating": [],
    "cam-rocker-synthesis": [],
    "cam-rocker-optimum": [],
    "cam-lantern": [],
    "synth-slider-crank": [],
    "synth-path": [],
    "synth-motion": [],
    "dyad": [],
    "pair": ['pair.strategy="given_aw"', 'pair.centre_distance="115 mm"'],
    "manipulator": [],
    "manipulator-angular": [],
    "vibratory-device": [],
    "pendulum-rotor": [],
}
SWAPPED = {"sin": "cos", "cos": "sin"}


@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n in QUICK else pytest.mark.slow) for n in SPECS])
def test_every_line_is_exact_and_works_out_as_printed(name: str) -> None:
    if not chapters(name):
        pytest.skip("nothing of it is told")
    for line in lines(name):
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)


def test_there_are_linkages_of_every_kind_of_dyad() -> None:
    assert {"shaper", "press", "four-bar", "trammel", "scotch-yoke", "four-dyads"} <= set(filter(linkage, SPECS))


@pytest.mark.slow
def test_the_shaper_moves_as_in_the_textbook() -> None:
    """Positions 6 and 18 of table D.2.1, recomputed: angles, and rates against l_1 omega_1 and its like."""
    assembler = Assembler()
    assembler.written(told("shaper", "6,18"))
    found = {(line.formula.sides[0], line.place): float(line.found.result) for line in assembler.lines}
    omega = 55 * math.pi / 30
    for name, unit, first, second in (
        ("phi_3", 1.0, 85.442, 98.519),
        ("phi_4", 1.0, -3.316, -1.728),
        ("omega_3", omega, 0.2388, -0.4080),
        ("omega_4", omega, -0.067, -0.213),
        ("v_Dx", 0.2 * omega, -1.219, 2.048),
        ("a_Dx", 0.2 * omega**2, -0.175, 2.008),
        ("eps_3", omega**2, 0.032, -0.383),
    ):
        assert found[Name(name), "pos. 6"] / unit == pytest.approx(first, abs=6e-4)
        assert found[Name(name), "pos. 18"] / unit == pytest.approx(second, abs=6e-4)


def mutants(formula: Statement) -> Iterator[Statement]:
    """The formula with one sign, function or operator changed in its right side."""
    left, right = formula.sides
    for changed in _changed(right):
        yield Statement((left, changed), formula.relations)


def _changed(node: Node) -> Iterator[Node]:
    match node:
        case Sum(terms):
            for k, (sign, term) in enumerate(terms):
                yield Sum((*terms[:k], (-sign, term), *terms[k + 1 :]))
        case Product(factors):
            yield Quotient(Product(factors[:-1]) if len(factors) > 2 else factors[0], factors[-1])
        case Quotient(over, under):
            yield Product((over, under))
        case Call(function, arguments) if function in ("sin", "cos"):
            yield Call(SWAPPED[function], arguments)
    for k, part in enumerate(parts(node)):
        for changed in _changed(part):
            yield _with_part(node, k, changed)


def _with_part(node: Node, k: int, part: Node) -> Node:
    count = iter(range(len(parts(node))))
    return mapped(node, lambda old: part if next(count) == k else old)


@pytest.mark.slow
def test_mutants_are_caught() -> None:
    """A formula with a mistake gives the same number in every shown position of every scene in less than 1 of 100."""
    caught: dict[Statement, bool] = {}
    for name, changed in MUTATED.items():
        for mutant, found in judged(name, changed).items():
            caught[mutant] = caught.get(mutant, False) or found
    missed = [mutant for mutant, found in caught.items() if not found]
    assert len(caught) > 2500
    assert len(missed) <= 0.01 * len(caught), missed


@pytest.mark.parametrize("name", ["shaper", "press"])
def test_most_mutants_are_caught_in_one_scene(name: str) -> None:
    """A factor of 1 or a term of 0 hides some."""
    caught = judged(name)
    assert len(caught) > 300
    assert sum(caught.values()) >= 0.97 * len(caught)


def judged(name: str, changed: Sequence[str] = ()) -> dict[Statement, bool]:
    """By the mutants of the formulas of a scene beside these, names in their order, whether they are caught."""
    caught: dict[Statement, bool] = {}
    for block in blocks(told(name, "2,7", changed=changed)):
        if isinstance(block, Line):
            for mutant in mutants(block.formula):
                seen = any(wrong(mutant, place.lexicon) for place in block.places)
                both = in_order(Statement((*block.formula.sides, mutant.sides[1]), ("=", "=")))
                caught[both] = caught.get(both, False) or seen
    return caught


def in_order(formula: Statement) -> Statement:
    """The formula with its names replaced by their numbers: what two scenes name apart is one text."""
    numbers = {key: f"n_{k}" for k, key in enumerate(names(formula))}

    def renamed(node: Node) -> Node:
        return Name(numbers.get(node.key, node.key)) if isinstance(node, Name) else mapped(node, renamed)

    return Statement(tuple(map(renamed, formula.sides)), formula.relations)


def wrong(mutant: Statement, lexicon: Lexicon) -> bool:
    """Whether a mutant gives another value than the program, or none."""
    given = result_of(mutant.sides[0], lexicon)
    assert isinstance(given.value, float)
    try:
        return off_by(mutant.sides[1], lexicon, given.value, given.unit) > EXACT
    except (ValueError, ArithmeticError):
        return True


def test_couples_are_not_called_forces() -> None:
    said = text(written("shaper"))
    assert "M_3 – inertia couple of link 3, N·m" in said
    assert not re.search(r"force of link \d, N·m", said)


@pytest.mark.slow
def test_a_number_that_is_the_result_stands_once() -> None:
    """``R_10y = −T_1y`` of a positive sum is a sign before a number, and that is the result."""
    twice = re.compile(r"= (\S+) = \1(?= |$)", re.MULTILINE)
    assert "R_10x = −9537.8 N" in text(written("shaper"))
    assert not twice.findall(text(written("shaper")))
