"""What the chapters on a linkage are told from: its dyads at the chosen positions, all quantities by their names."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from typing import Any, NamedTuple

from tmmcalc.linkage.chain import Chain, Step, chain_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.notes import points
from tmmcalc.linkage.notes.group import GroupAt, group_at, pin_quantities, plain_name
from tmmcalc.linkage.notes.positions import by_default
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.drawing.order import POSITIONS, Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Paragraph, Place
from tmmcalc.report.telling import filled, lines, named

DYADS = "tmmcalc.linkage.notes.dyads"


class Dyad(NamedTuple):
    """A dyad at the positions, the formulas of its kind, and its links with the points that they carry."""

    step: Step
    kind: Any  # module of `tmmcalc.linkage.notes.dyads`
    states: Sequence[GroupAt]
    carried: Sequence[points.Carried]

    @property
    def places(self) -> Mapping[str, str]:
        """The links and points that stand in its formulas."""
        return self.states[0].places


class Told(NamedTuple):
    """A linkage at positions ``rows`` of the result, with the quantities of each."""

    chain: Chain
    result: Kinematics
    rows: Sequence[int]
    lexicons: Sequence[dict[str, Given]]
    crank: Sequence[points.Carried]  # points of the input crank
    dyads: Sequence[Dyad]

    @property
    def places(self) -> list[Place]:
        """The positions as places of lines."""
        names = [tr("in position {label}", label=self.result.labels[row]) for row in self.rows]
        return [*map(Place, names, self.lexicons)]

    def lines(self, texts: Sequence[str], words: Mapping[str, str]) -> Iterator[Block]:
        """The formulas with their links and points, worked out at the positions."""
        return lines(texts, self.places, words)

    def beyond(self) -> Iterator[Block]:
        """A sentence on the groups that are no dyads, where there are some."""
        names = ", ".join(step.group.name for step in self.chain.steps if not isinstance(step, Step))
        if names:
            said = tr(
                "The program solves these groups, and their lines are not written out here: {groups}.", groups=names
            )
            yield Paragraph(said)


def told_of(order: Order) -> Told:
    """What is told of the linkage of a run, at the positions that are asked for, or one of each stroke."""
    mechanism, result = to_linkage(order.spec.linkage), order.results["kinematics"]
    return _gathered(mechanism, result, order.rows(POSITIONS, result.labels) or by_default(mechanism, result))


def _gathered(mechanism: Mechanism, result: Kinematics, rows: Sequence[int]) -> Told:
    """All quantities of the motion at these positions."""
    chain = chain_of(mechanism, result)
    lexicons = [named({**pin_quantities(chain, result, row), **_input_quantities(result, row)}) for row in rows]
    for lexicon, row in zip(lexicons, rows, strict=True):
        lexicon |= _rotations(result, row)
    known = {plain_name(pin.name) for pin in find_pins(mechanism) if pin.fixed}
    crank = []
    if (carrier := points.crank_carrier(chain)) is not None:
        crank = _carried(chain, carrier, known, lexicons)
    dyads = []
    for step in chain.steps:
        if isinstance(step, Step):
            dyads.append(_dyad(chain, step, result, rows, known, lexicons))
    return Told(chain, result, rows, lexicons, crank, dyads)


def _rotations(result: Kinematics, row: int) -> dict[str, Given]:
    """Angular velocities and accelerations of all links."""
    trace = result.trace
    found = {"omega_0": Given(0.0, "rad/s", tr("frame")), "eps_0": Given(0.0, "rad/s^2", tr("frame"))}
    for k, link in enumerate(trace.link_ids):
        omega, eps = result.in_time(trace.dangle[k, row], trace.ddangle[k, row])
        found[f"omega_{link}"] = Given(float(omega), "rad/s", tr("angular velocity of link {link}", link=link))
        found[f"eps_{link}"] = Given(float(eps), "rad/s^2", tr("angular acceleration of link {link}", link=link))
    return found


def _input_quantities(result: Kinematics, row: int) -> dict[str, Given]:
    """The input crank: its angle, angular velocity and acceleration."""
    link = result.structure.input_link
    first = float(result.x[0])
    return {
        f"phi_{link}": Given(math.degrees(float(result.x[row])), "deg", tr("angle of link {link}", link=link)),
        "phi_0": Given(math.degrees(first), "deg", tr("angle of the crank in the first position")),
        "phi": Given(math.degrees(float(result.phi[row])), "deg", tr("angle of the crank from the first position")),
        f"n_{link}": Given(abs(result.speed) * 30 / math.pi, "rpm", tr("speed of the crank")),
    }


def _dyad(
    chain: Chain,
    step: Step,
    result: Kinematics,
    rows: Sequence[int],
    known: set[str],
    lexicons: Sequence[dict[str, Given]],
) -> Dyad:
    kind = import_module(f"{DYADS}.{step.group.kind.lower()}")
    states = [group_at(chain, step, result, row) for row in rows]
    for at, lexicon in zip(states, lexicons, strict=True):
        for key, given in kind.quantities(at).items():
            lexicon.setdefault(canonical(filled(key, at.places)), given)
    known.add(states[0].places["B"])
    carried = []
    for carrier in points.carriers(chain, step.group, states[0]):
        carried += _carried(chain, carrier, known, lexicons)
    return Dyad(step, kind, states, carried)


def _carried(
    chain: Chain, carrier: points.Carrier, known: set[str], lexicons: Sequence[dict[str, Given]]
) -> list[points.Carried]:
    """The points of a link that are not known yet."""
    found = [*points.carried(chain, carrier, known)]
    for lexicon in lexicons:
        for each in found:
            lexicon |= named(each.quantities)
    return found
