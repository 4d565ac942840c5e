"""What the chapters on a linkage are told from: its groups at the chosen positions, all quantities by their names."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from typing import Any, NamedTuple

from tmmcalc.linkage.chain import Chain, Step, chain_of
from tmmcalc.linkage.loops.step import LoopStep
from tmmcalc.linkage.notes import driven, loops, points
from tmmcalc.linkage.notes.group import GroupAt, group_at, pin_quantities, plain_name
from tmmcalc.linkage.notes.shown import rows_shown
from tmmcalc.linkage.notes.ways import Arm, Loop, loops_of
from tmmcalc.linkage.pictures.cycle import LinkageMotion, whole_cycle
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Place
from tmmcalc.report.telling import STILL, filled, lines, named

NOISE = 1e-15  # of quantities in SI
DYADS = "tmmcalc.linkage.notes.dyads"


class Dyad(NamedTuple):
    """A dyad at the positions, the formulas of its kind, and its links with the points that they carry."""

    step: Step
    kind: Any  # module of `tmmcalc.linkage.notes.dyads`
    states: Sequence[GroupAt]
    loops: tuple[Loop, ...]
    carried: Sequence[points.Carried]

    @property
    def places(self) -> Mapping[str, str]:
        """The links and points that stand in its formulas."""
        return self.states[0].places


class Told(NamedTuple):
    """A linkage at positions ``rows`` of the result, with the quantities of each."""

    cycle: LinkageMotion
    result: Kinematics
    rows: Sequence[int]
    lexicons: Sequence[dict[str, Given]]
    slider: Arm | None  # the vector to a pin of a driven slider
    crank: Sequence[points.Carried]  # points of the input link
    groups: Sequence[Dyad | loops.Looped]  # in the order of assembly

    @property
    def chain(self) -> Chain:
        """The linkage with its groups."""
        return self.cycle.chain

    @property
    def dyads(self) -> list[Dyad]:
        """The groups that are dyads."""
        return [group for group in self.groups if isinstance(group, Dyad)]

    @property
    def places(self) -> list[Place]:
        """The positions as places of lines."""
        names = [tr("pos. {label}", label=self.result.labels[row]) for row in self.rows]
        return [*map(Place, names, self.lexicons)]

    def there(self, k: int) -> str:
        """The shown position ``k`` in a sentence."""
        return tr("in position {label}", label=self.result.labels[self.rows[k]])

    def lines(self, texts: Sequence[str], words: Mapping[str, str]) -> Iterator[Block]:
        """The formulas with their links and points, worked out at the positions."""
        return lines(texts, self.places, words)

    @property
    def turning(self) -> list[int]:
        """Links that turn, but the crank and blocks that turn with a link on which they slide."""
        joints = self.chain.mechanism.joints
        blocks = {joint.links[0] for joint in joints if joint.kind == "prismatic" and joint.links[1]}
        crank = {self.result.structure.input_link} if self.chain.turns else set()
        links = self.result.trace.link_ids
        moves = (link for link, rates in zip(links, self.result.trace.dangle, strict=True) if rates.any())
        return [link for link in moves if link not in blocks | crank]

    def nothing(self, *names: str) -> bool:
        """Whether these quantities are zero in all shown positions."""
        values = (lexicon[canonical(name)].value for lexicon in self.lexicons for name in names)
        return all(isinstance(value, float) and abs(value) <= STILL for value in values)


def told_of(order: Order) -> Told:
    """What is told of the linkage of a run, at the positions that are asked for, or one of each stroke."""
    mechanism, result = to_linkage(order.spec.linkage), order.results["kinematics"]
    cycle = whole_cycle(chain_of(mechanism, result), result)
    return _gathered(cycle, result, rows_shown(order, cycle.chain, result))


def _gathered(cycle: LinkageMotion, result: Kinematics, rows: Sequence[int]) -> Told:
    """All quantities of the motion at these positions."""
    chain = cycle.chain
    lexicons = [named({**pin_quantities(chain, result, row), **_input_quantities(chain, result, row)}) for row in rows]
    for lexicon, row in zip(lexicons, rows, strict=True):
        lexicon |= _rotations(result, row)
    known = {plain_name(pin.name) for pin in find_pins(chain.mechanism) if pin.fixed}
    slider = driven.driven_slider(chain)
    if slider is not None:
        known.add(slider.end)
        for lexicon, row in zip(lexicons, rows, strict=True):
            lexicon |= named(loops.vector_quantities(chain, result, row, [slider]))
    carrier = points.input_carrier(chain)
    crank = [] if carrier is None else points.gathered(chain, carrier, known, lexicons)
    groups: list[Dyad | loops.Looped] = []
    for step in chain.steps:
        if isinstance(step, LoopStep):
            groups.append(loops.looped_of(chain, step, result, rows, known, lexicons))
        else:
            groups.append(_dyad(chain, step, result, rows, known, lexicons))
    for lexicon in lexicons:
        lexicon |= {key: given._replace(value=0.0) for key, given in lexicon.items() if _noise(given)}
    told = Told(cycle, result, rows, lexicons, slider, crank, groups)
    _turn_angles(told)
    return told


def _turn_angles(told: Told) -> None:
    """Give angles as many whole turns as the formulas of the positions give, as `lines` does in the lexicons.

    They have them from here on, in every chapter and in whatever order chapters are told.
    """
    for dyad in told.dyads:
        for _ in told.lines(dyad.kind.POSITION, dyad.places):
            pass


def _noise(given: Given) -> bool:
    """Whether a quantity in SI is rounding alone."""
    return isinstance(given.value, float) and 0.0 < abs(given.value) < NOISE


def _rotations(result: Kinematics, row: int) -> dict[str, Given]:
    """Angular velocities and accelerations of all links."""
    trace = result.trace
    found = {"omega_0": Given(0.0, "rad/s", tr("frame")), "eps_0": Given(0.0, "rad/s^2", tr("frame"))}
    for k, link in enumerate(trace.link_ids):
        omega, eps = result.in_time(trace.dangle[k, row], trace.ddangle[k, row])
        found[f"omega_{link}"] = Given(float(omega), "rad/s", tr("angular velocity of link {link}", link=link))
        found[f"eps_{link}"] = Given(float(eps), "rad/s^2", tr("angular acceleration of link {link}", link=link))
    return found


def _input_quantities(chain: Chain, result: Kinematics, row: int) -> dict[str, Given]:
    """The input coordinate: the angle of a crank, or the coordinate of a drive, with its law."""
    first = float(result.x[0])
    if not chain.turns:
        return driven.law_quantities(first, float(result.phi[row]))
    link = result.structure.input_link
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
        carried += points.gathered(chain, carrier, known, lexicons)
    return Dyad(step, kind, states, loops_of(chain, step.group), carried)
