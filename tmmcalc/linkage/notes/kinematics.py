"""The chapter on motion: the input link, then every group in the order of the formula, at the chosen positions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from importlib import import_module
from typing import Any, NamedTuple

from tmmcalc.linkage.chain import Chain, Step, chain_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.notes import points
from tmmcalc.linkage.notes.group import GroupAt, filled, group_at, pin_quantities, plain_name, turned
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.formula.digits import Given, value_of
from tmmcalc.report.formula.simplify import ZERO, simplified
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.formula.tree import Name
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Line, Place

DYADS = "tmmcalc.linkage.notes.dyads"
STILL = 1e-12  # a value this small in every shown position is nothing


class Told(NamedTuple):
    """What the chapter knows while it is told: the positions with the quantities found so far."""

    chain: Chain
    result: Kinematics
    rows: Sequence[int]
    lexicons: Sequence[dict[str, Given]]
    known: set[str]  # points

    def lines(self, texts: Sequence[str], places: dict[str, str]) -> Iterator[Block]:
        """The formulas with their links and points, without what is nothing here."""
        for text in texts:
            formula = simplified(read(filled(text, places)), self._zeros())
            left, right = formula.sides
            assert isinstance(left, Name)
            if right in (ZERO, left):
                continue
            for lexicon in self.lexicons:
                if lexicon[left.key].unit == "deg":
                    lexicon[left.key] = turned(lexicon[left.key], value_of(right, lexicon, "deg"))
            names = [tr("in position {label}", label=self.result.labels[row]) for row in self.rows]
            yield Line(formula, tuple(map(Place, names, self.lexicons)))

    def _zeros(self) -> set[str]:
        """Names that are nothing in every shown position."""
        common = set.intersection(*(set(lexicon) for lexicon in self.lexicons))
        return {key for key in common if all(abs(_size(lexicon[key])) <= STILL for lexicon in self.lexicons)}


def _size(given: Given) -> float:
    return given.value if isinstance(given.value, float) else math.inf


def kinematics_blocks(mechanism: Mechanism, result: Kinematics, rows: Sequence[int]) -> Iterator[Block]:
    """The input link and every dyad, with their formulas worked out at these positions."""
    chain = chain_of(mechanism, result)
    lexicons = [
        {**pin_quantities(chain, result, row), **_input_quantities(chain, result, row)} for row in rows
    ]
    fixed = {plain_name(pin.name) for pin in find_pins(mechanism) if pin.fixed}
    told = Told(chain, result, rows, lexicons, fixed)
    yield Heading(tr("Kinematic analysis"), 1)
    yield from _input(told)
    for step in chain.steps:
        if isinstance(step, Step):
            yield from _dyad(told, step)


def _input_quantities(chain: Chain, result: Kinematics, row: int) -> dict[str, Given]:
    """The input crank: its angle, angular velocity and acceleration."""
    link = result.structure.input_link
    first = float(result.x[0])
    return {
        f"phi_{link}": Given(math.degrees(float(result.x[row])), "deg", tr("angle of link {link}", link=link)),
        "phi_0": Given(math.degrees(first), "deg", tr("angle of the crank in the first position")),
        "phi": Given(math.degrees(float(result.phi[row])), "deg", tr("angle of the crank from the first position")),
        f"n_{link}": Given(abs(result.speed) * 30 / math.pi, "rpm", tr("speed of the crank")),
        f"omega_{link}": Given(result.speed, "rad/s", tr("angular velocity of link {link}", link=link)),
        f"eps_{link}": Given(result.acceleration, "rad/s^2", tr("angular acceleration of link {link}", link=link)),
    }


def _input(told: Told) -> Iterator[Block]:
    carrier = points.crank_carrier(told.chain)
    if carrier is None:
        return
    yield Heading(tr("Input link"), 2)
    sense = "" if told.result.speed > 0 else "-"
    texts = ("omega_<k> = <sense>pi*n_<k>/30", "phi_<k> = phi_0 + phi")
    yield from told.lines(texts, {"k": str(carrier.link), "sense": sense})
    yield from _points(told, carrier)


def _points(told: Told, carrier: points.Carrier) -> Iterator[Block]:
    """The points of a link that are not known yet."""
    for found in points.carried(told.chain, carrier, told.known):
        for lexicon in told.lexicons:
            lexicon |= found.quantities
        for texts in (points.POSITION, points.VELOCITY, points.ACCELERATION):
            yield from told.lines(texts, dict(found.places))


def _dyad(told: Told, step: Step) -> Iterator[Block]:
    kind = import_module(f"{DYADS}.{step.group.kind.lower()}")
    states = [group_at(told.chain, step, told.result, row) for row in told.rows]
    places = states[0].places
    for at, lexicon in zip(states, told.lexicons, strict=True):
        for key, given in _quantities(kind, at).items():
            lexicon.setdefault(filled(key, places), given)
    yield Heading(tr("Group {name}", name=step.group.name), 2)
    for title, texts in (
        (tr("Positions"), kind.POSITION),
        (tr("Velocities"), kind.VELOCITY),
        (tr("Accelerations"), kind.ACCELERATION),
    ):
        yield Heading(title, 3)
        yield from told.lines(texts, dict(places))
    told.known.add(places["B"])
    for carrier in points.carriers(told.chain, states[0]):
        yield from _points(told, carrier)


def _quantities(kind: Any, at: GroupAt) -> dict[str, Given]:
    """What the kind says, and the rotation of its links."""
    found: dict[str, Given] = kind.quantities(at)
    for letter, (omega, eps) in kind.turning(at).items():
        link = at.places[letter]
        found[f"omega_<{letter}>"] = Given(omega, "rad/s", tr("angular velocity of link {link}", link=link))
        found[f"eps_<{letter}>"] = Given(eps, "rad/s^2", tr("angular acceleration of link {link}", link=link))
    return found


