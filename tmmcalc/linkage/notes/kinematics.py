"""The chapter on motion: the input link, then every group in the order of the formula, at the chosen positions."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from importlib import import_module
from typing import Any

from tmmcalc.linkage.chain import Chain, Step, chain_of
from tmmcalc.linkage.notes.group import (
    GroupAt,
    angle,
    filled,
    group_at,
    pin_quantities,
    turned,
)
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.formula.digits import Given, value_of
from tmmcalc.report.formula.simplify import ZERO, simplified
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Statement
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Line, Place

DYADS = "tmmcalc.linkage.notes.dyads"
STILL = 1e-12  # a value this small in every shown position is nothing


def groups(mechanism: Any, result: Kinematics, rows: Sequence[int]) -> Iterator[Block]:
    """Every dyad, with its formulas worked out at these positions."""
    chain = chain_of(mechanism, result)
    lexicons: list[dict[str, Given]] = [{} for _ in rows]
    for lexicon, row in zip(lexicons, rows, strict=True):
        lexicon |= {**pin_quantities(chain, result, row), **crank_quantities(chain, result, row)}
    for step in chain.steps:
        if isinstance(step, Step):
            yield from _dyad(chain, step, result, rows, lexicons)


def crank_quantities(chain: Chain, result: Kinematics, row: int) -> dict[str, Given]:
    """The input link: its angle and angular velocity."""
    link = result.structure.input_link
    return {
        f"phi_{link}": angle(cmath.exp(1j * float(result.x[row])), tr("angle of link {link}", link=link)),
        f"omega_{link}": Given(result.speed, "rad/s", tr("angular velocity of link {link}", link=link)),
    }


def _dyad(
    chain: Chain, step: Step, result: Kinematics, rows: Sequence[int], lexicons: Sequence[dict[str, Given]]
) -> Iterator[Block]:
    kind = import_module(f"{DYADS}.{step.group.kind.lower()}")
    states = [group_at(chain, step, result, row) for row in rows]
    places = states[0].places
    for at, lexicon in zip(states, lexicons, strict=True):
        for key, given in _quantities(kind, at).items():
            lexicon.setdefault(filled(key, places), given)
    yield Heading(tr("Group {name}", name=step.group.name), 2)
    for title, texts in (
        (tr("Positions"), kind.POSITION),
        (tr("Velocities"), kind.VELOCITY),
        (tr("Accelerations"), kind.ACCELERATION),
    ):
        yield Heading(title, 3)
        for text in texts:
            formula = simplified(read(filled(text, places)), _zeros(lexicons))
            yield from _line(formula, result, rows, lexicons)


def _quantities(kind: Any, at: GroupAt) -> dict[str, Given]:
    """What the kind says, and the rotation of its links."""
    found: dict[str, Given] = kind.quantities(at)
    for letter, (omega, eps) in kind.turning(at).items():
        link = at.places[letter]
        found[f"omega_<{letter}>"] = Given(omega, "rad/s", tr("angular velocity of link {link}", link=link))
        found[f"eps_<{letter}>"] = Given(eps, "rad/s^2", tr("angular acceleration of link {link}", link=link))
    return found


def _zeros(lexicons: Sequence[dict[str, Given]]) -> set[str]:
    """Names that are nothing in every shown position."""
    common = set.intersection(*(set(lexicon) for lexicon in lexicons))
    return {key for key in common if all(abs(float(lexicon[key].value)) <= STILL for lexicon in lexicons)}


def _line(
    formula: Statement, result: Kinematics, rows: Sequence[int], lexicons: Sequence[dict[str, Given]]
) -> Iterator[Block]:
    left, right = formula.sides
    if right == ZERO:
        return
    for lexicon in lexicons:
        if lexicon[left.key].unit == "deg":
            lexicon[left.key] = turned(lexicon[left.key], value_of(right, lexicon, "deg"))
    names = [tr("in position {label}", label=result.labels[row]) for row in rows]
    yield Line(formula, tuple(map(Place, names, lexicons)))
