"""A linkage reduced to its input at the chosen positions: the moments of loads, weights and friction, the inertia.

    M = sum (F_x v_x + F_y v_y + M omega)/omega_1        J = sum (m v^2 + J_S omega^2)/omega_1^2

The derivative of J follows from velocities and accelerations in time: J' omega_1^3 = 2 sum (m v.a + J_S omega eps) less
2 J eps_1 omega_1, which is what the acceleration of the input gives to them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.forces.friction import size_of
from tmmcalc.linkage.forces.further import FRICTION_REDUCED
from tmmcalc.linkage.forces.kinetostatics import Reaction
from tmmcalc.linkage.forces.wrench import Slideway, sliding
from tmmcalc.linkage.loading import Body, Load, Loading, Pair
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.loads.sources import Place, same_place
from tmmcalc.linkage.model import FRAME, Joint
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.shown import rows_shown
from tmmcalc.linkage.notes.statics.loaded import force_key, name_index, names_of
from tmmcalc.linkage.results import Kinematics
from tmmcalc.machine.attached import Attached
from tmmcalc.machine.notes.moving import Mass, Moving, masses_of, moving, point_name
from tmmcalc.machine.pictures.words import cause_name
from tmmcalc.machine.reduction.causes import Causes, causes_of
from tmmcalc.machine.reduction.inertia import lumped
from tmmcalc.machine.reduction.results import Contribution, Reduction
from tmmcalc.machine.stages.reduction import further, inputs
from tmmcalc.report.drawing.order import POSITIONS, Order
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Heading, Line
from tmmcalc.report.telling import lines

ATTACHED = {"cam": "c"}  # indices of what goes round beside the linkage
OWN = {  # indices of the causes that the program names
    "weight": "G",
    "friction": "F",
    "balancing moment": "b",
    "cam force": "cQ",
    "cam weight": "cG",
    "cam spring": "cs",
    "cam friction": "cF",
}


class Names(NamedTuple):
    """What reduced quantities are called in formulas."""

    moment: str  # ``M``
    total: str  # ``M_red``
    inertia: str  # ``J_red``
    letter: str  # of the inertia in columns
    unit: str  # of the moment
    mass_unit: str
    slope_unit: str
    coordinate: str  # ``phi``

    @classmethod
    def of(cls, result: Reduction) -> Names:
        """By the kind of the input."""
        if result.turns:
            return cls("M", tr("M_red"), tr("J_red"), "J", "N*m", "kg*m^2", "kg*m^2/rad", "phi")
        return cls("F", tr("F_red"), tr("m_red"), "m", "N", "kg", "kg/m", "s")

    def cause(self, contribution: Contribution) -> str:
        """The reduced moment of a cause: ``M_Q5``, ``M_G``."""
        return f"{self.moment}_{{{index_of(contribution)}}}"

    def part(self, of: object) -> str:
        """What a link, or what is attached, adds to the inertia: ``J_{red,3}``."""
        letter, _, index = self.inertia.partition("_")
        return f"{letter}_{{{index},{ATTACHED.get(str(of), of)}}}"

    def slope(self, of: object = "") -> str:
        """Its derivative: ``J'_red``."""
        letter, _, index = self.inertia.partition("_")
        return f"{letter}'_{{{index},{of}}}" if of else f"{letter}'_{{{index}}}"


def index_of(contribution: Contribution) -> str:
    """The index of a cause in formulas; a damper beside its spring has one more."""
    name = contribution.name
    found = OWN.get(name) or name_index(name)
    return f"{found},d" if contribution.kind == "damper" else found


class Reducing(NamedTuple):
    """A linkage at the chosen positions with everything that is reduced there."""

    result: Reduction
    names: Names
    moving: Moving
    rows: Sequence[int]  # of the reduction
    causes: Causes
    place: Place
    columns: Mapping[str, Real]  # by choice, of all rows
    attached: Sequence[str]  # names of what goes round beside the linkage

    @property
    def loading(self) -> Loading:
        """What acts, rods lumped where they are so reduced."""
        return self.causes.scene.loading

    def give(self, key: str, values: Real, unit: str, meaning: str = "") -> None:
        """Put a quantity of all rows of the result into the lexicons."""
        self.moving.give(key, values[self.rows], unit, meaning)

    def lines(self, *texts: str) -> Iterator[Line]:
        """The formulas worked out at the positions; ``<w>`` is the speed of the input."""
        return lines(texts, self.moving.places, {"w": self.moving.rate, "eps": self.moving.acceleration})


def reducing(order: Order) -> Reducing:
    """What is told of the reduction of a linkage, its results put into the lexicons."""
    result, kinematics = order.results["reduction"], order.results["kinematics"]
    mechanism, loading, _ = inputs(order.spec)  # type: ignore[misc]  # of a scene with a linkage
    rows: Sequence[int] = rows_shown(order, chain_of(mechanism, kinematics), kinematics)
    if order.flags[POSITIONS] is None:
        rows = _with_loads(rows, result, kinematics)
    if result.rods == "lumped":
        loading = replace(loading, bodies=lumped(mechanism, loading, result.rod_links))
    attached = [each for each in order.results.values() if isinstance(each, Attached)]
    scene = compile_scene(mechanism, loading, kinematics, math.lcm(1, *(each.turns for each in attached)))
    theta, labels = scene.travel.rows(kinematics)
    own = [labels.index(kinematics.labels[row]) for row in rows]
    place = scene.place(theta[own], scene.travel.sides(theta[own]))
    columns = {each.name: each.make() for each in further(order.spec, order.results)}
    names = [each.name for each in attached]
    found = moving(scene, kinematics, rows, place.configuration)
    return _with_results(Reducing(result, Names.of(result), found, own, causes_of(scene), place, columns, names))


def _with_loads(rows: Sequence[int], result: Reduction, kinematics: Kinematics) -> Sequence[int]:
    """The rows, and where a load does nothing in all of them that at which it does most."""
    found = list(rows)
    for contribution, moment in zip(result.contributions, result.moment[:, : len(kinematics.labels)], strict=True):
        if contribution.kind == "load" and not np.any(moment[found]):
            found.append(int(np.argmax(np.abs(moment))))
    return found


def _with_results(told: Reducing) -> Reducing:
    """The results of the stage in the lexicons."""
    result, names = told.result, told.names
    for contribution, moment in zip(result.contributions, result.moment, strict=True):
        told.give(names.cause(contribution), moment, names.unit, said(result, contribution))
    whole = tr("reduced moment of all forces") if result.turns else tr("reduced force of all forces")
    told.give(names.total, result.total, names.unit, whole)
    mass, slope = mass_words(result)
    told.give(names.inertia, result.inertia, names.mass_unit, mass)
    told.give(names.slope(), result.slope, names.slope_unit, slope)
    return told


def said(result: Reduction, contribution: Contribution) -> str:
    """What the reduced moment of a cause is."""
    cause = cause_name(contribution.name)
    if contribution.kind == "damper":
        cause = tr("{name} (damping)", name=cause)
    return tr("reduced moment ({cause})", cause=cause) if result.turns else tr("reduced force ({cause})", cause=cause)


def mass_words(result: Reduction) -> tuple[str, str]:
    """What reduced inertia and its derivative are."""
    if result.turns:
        return tr("reduced moment of inertia"), tr("derivative of the reduced moment of inertia")
    return tr("reduced mass"), tr("derivative of the reduced mass")


def moment_lines(told: Reducing) -> Iterator[Block]:
    """The reduced moments of the loads, of the weights, of friction by pairs, and the sum of all."""
    names, causes = told.names, [*map(told.names.cause, told.result.contributions)]
    for heading, texts in (
        (tr("Given loads"), [_load_line(told, load) for load in told.loading.loads if load.factor]),
        (tr("Weights"), [_weight_line(told)] if told.loading.gravity and _heavy(told) else []),
        (tr("Friction"), _friction_lines(told)),
        (tr("Sum of all forces"), [f"{names.total} = {' + '.join(causes)}"] if len(causes) > 1 else []),
    ):
        if blocks := [*told.lines(*texts)]:
            yield Heading(heading, 3)
            yield from blocks


def _load_line(told: Reducing, load: Load) -> str:
    """A load by its projections and the velocity of its point, a moment by the angular velocity of its link."""
    moving = told.moving
    name = names_of(moving.mechanism, moving.kinematics.structure, told.loading)[load.link, load.name, "load"]
    motions, value = moving.configuration.motions, told.columns[f"load_{load.name}"][told.rows]
    left = f"{told.names.moment}_{{{name_index(load.name)}}}"
    if load.kind == "moment":
        moving.give(force_key(name), value, "N*m", tr("given load"))
        moving.turning(load.link)
        moving.turning(load.against)
        return f"{left} = {force_key(name)}*(omega_{load.link} - omega_{load.against})/<w>"
    at = motions[load.link].point(load.point)
    point = point_name(moving.mechanism, load.link, load.point, name_index(load.name))
    moving.point(point, at)
    force = value * load.direction * motions[load.follows].u
    moving.give(force_key(name, "x"), force.real, "N", tr("given load"))
    moving.give(force_key(name, "y"), force.imag, "N", tr("given load"))
    rates = {axis: f"v_{{{point}{axis}}}" for axis in "xy"}
    if load.against != FRAME:
        other = f"{point}{load.against}"
        moving.point(other, same_place(motions[load.against], at))
        rates = {axis: f"({rate} - v_{{{other}{axis}}})" for axis, rate in rates.items()}
    return f"{left} = ({' + '.join(f'{force_key(name, axis)}*{rate}' for axis, rate in rates.items())})/<w>"


def _weight_line(told: Reducing) -> str:
    """All weights in one sum."""
    terms = []
    for mass in masses_of(told.moving, _heavy(told)):
        weight, said = mass.body.mass * told.loading.gravity, tr("weight of link {link}", link=mass.body.link)
        for axis, part in (("x", weight.real), ("y", weight.imag)):
            key = f"G_{{{mass.index}{axis}}}"
            told.moving.give(key, np.asarray(part), "N", said)
            terms.append(f"{key}*v_{{{mass.centre}{axis}}}")
    return f"{told.names.moment}_G = ({' + '.join(terms)})/<w>"


def _heavy(told: Reducing) -> list[Body]:
    """The bodies that have a mass."""
    return [body for body in told.loading.bodies if body.mass]


def _friction_lines(told: Reducing) -> list[str]:
    """Friction of every pair by its reaction and its relative velocity, and their sum."""
    statics, place = told.causes.statics._replace(cases=None), told.place
    state, texts, lefts = statics.solve(place, place.side), [], []
    for joint in statics.rubbing:
        name, pair = plain_name(joint.name), statics.pairs[joint.name]
        left = f"{told.names.moment}_{{F,{name}}}"
        said = tr("reduced friction in pair {pair}", pair=joint.name)
        told.give(left, _friction_of(told, joint), told.names.unit, said)
        friction = tr("coefficient of friction in pair {pair}", pair=joint.name)
        told.moving.give(f"f_{name}", np.asarray(pair.friction), "", friction)
        lefts.append(left)
        rubs = _sliding if joint.kind == "prismatic" else _turning
        texts.append(f"{left} = -f_{name}*{rubs(told, joint, pair, state.reactions[joint.name])}/<w>")
    return [*texts, f"{told.names.moment}_F = {' + '.join(lefts)}"] if lefts else []


def _friction_of(told: Reducing, joint: Joint) -> Real:
    """The reduced friction of a pair at all positions."""
    key = FRICTION_REDUCED.of(joint=joint.name, letter=told.names.moment, unit=told.names.unit).name
    return told.columns[key]


def friction_by_pairs(told: Reducing) -> dict[str, Real]:
    """The reduced friction of every pair at all positions, by the heads of columns."""
    first, unit = told.names.moment, told.names.unit
    rubbing = told.causes.statics.rubbing
    return {f"${first}_{{F,{plain_name(joint.name)}}}$, {unit}": _friction_of(told, joint) for joint in rubbing}


def _sliding(told: Reducing, joint: Joint, pair: Pair, reaction: Reaction) -> str:
    """The normal force in a prismatic pair, of a slider that bears on its edges the sum of both, times its velocity."""
    slider, guide = joint.links
    across, along = f"N_{{{slider}{guide}}}", f"v_{{{slider}{guide}}}"
    sign = 1.0 if slider > guide else -1.0
    rate = sign * sliding(joint, told.place.configuration)[0]
    said = tr("velocity of link {link} along its guide", link=slider)
    if guide != FRAME:
        said = tr("velocity of link {block} along link {link}", block=slider, link=guide)
    told.moving.give(along, rate * told.result.speed, "m/s", said)
    if pair.length is None:
        assert isinstance(reaction.seat, Slideway)
        normal = sign * (np.conj(1j * reaction.seat.e) * reaction.wrench.force).real
        told.moving.give(
            across, normal, "N", tr("normal reaction of link {other} on link {link}", other=guide, link=slider)
        )
        return f"abs({across})*abs({along})"
    pressed = size_of(reaction.seat, reaction.wrench, pair.length / 2)
    edges = f"{across}^e"
    told.moving.give(edges, pressed, "N", tr("sum of the pressures of link {block} on its guide", block=slider))
    return f"{edges}*abs({along})"


def _turning(told: Reducing, joint: Joint, pair: Pair, reaction: Reaction) -> str:
    """The radius of a pin, the reaction in it, the angular velocity between its links."""
    low, high = sorted(joint.links)
    name, force = plain_name(joint.name), f"R_{{{high}{low}}}"
    told.moving.give(f"r_{name}", np.asarray(pair.radius), "m", tr("radius of the pin of pair {pair}", pair=joint.name))
    said = tr("reaction of link {other} on link {link}", other=low, link=high)
    told.moving.give(force, np.abs(reaction.wrench.force), "N", said)
    told.moving.turning(low)
    told.moving.turning(high)
    return f"r_{name}*{force}*abs(omega_{high} - omega_{low})"


def inertia_lines(told: Reducing) -> Iterator[Block]:
    """What every link adds to the reduced inertia and to its derivative, and the sums of both."""
    names, moving = told.names, told.moving
    links: dict[int, list[Mass]] = {}
    for mass in masses_of(moving, told.loading.heavy):
        links.setdefault(mass.body.link, []).append(mass)
    parts = [*map(str, links), *(each for each in told.attached)]
    for part in parts:
        inertia, slope = (told.columns[f"{d}{names.letter}_red_{part}"] for d in ("", "d"))
        told.give(names.part(part), inertia, names.mass_unit, _part_words(told.result, part))
        told.give(names.slope(part), slope, names.slope_unit, tr("its derivative"))
    texts = [_inertia_line(names, link, masses) for link, masses in links.items()]
    yield from told.lines(*texts, f"{names.inertia} = {' + '.join(map(names.part, parts))}")
    texts = [_slope_line(told, link, masses) for link, masses in links.items()]
    yield from told.lines(*texts, f"{names.slope()} = {' + '.join(map(names.slope, parts))}")


def _part_words(result: Reduction, part: str) -> str:
    """What the reduced inertia of a link is, or of what is attached."""
    if not part.isdigit():
        return tr("reduced moment of inertia ({name})", name=tr_name(part))
    if result.turns:
        return tr("reduced moment of inertia of link {link}", link=part)
    return tr("reduced mass of link {link}", link=part)


def _inertia_line(names: Names, link: int, masses: Sequence[Mass]) -> str:
    """m v^2 of every mass of a link, and J_S omega^2."""
    terms = [f"{each.mass}*(v_{{{each.centre}x}}**2 + v_{{{each.centre}y}}**2)" for each in masses]
    return f"{names.part(link)} = ({' + '.join(terms)} + {masses[0].inertia}*omega_{link}**2)/<w>**2"


def _slope_line(told: Reducing, link: int, masses: Sequence[Mass]) -> str:
    """The same of the derivative, without what the acceleration of the input gives to velocities."""
    names = told.names
    terms = [
        f"{each.mass}*(v_{{{each.centre}x}}*a_{{{each.centre}x}} + v_{{{each.centre}y}}*a_{{{each.centre}y}})"
        for each in masses
    ]
    whole = f"2*({' + '.join(terms)} + {masses[0].inertia}*omega_{link}*eps_{link})/<w>**3"
    return f"{names.slope(link)} = {whole} - 2*{names.part(link)}*<eps>/<w>**2"
