"""What acts on the links at the shown positions: names in formulas, sums of forces and moments of what is given.

A force has the letter and index of `linkage.acting`, ``Q_5``, ``R_{21}``; those that share a name are told apart there.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real, cross
from tmmcalc.linkage.acting import Acts, Kind, acting_on, told_apart
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics
from tmmcalc.linkage.forces.results import Forces, side_of
from tmmcalc.linkage.freebody import Acting, Couple, FreeBody, Solved, link_bodies, solved
from tmmcalc.linkage.loading import Load, Loading, Pair
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.told import Told, told_of
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.structure import Structure
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Lexicon
from tmmcalc.report.printing import printed_as
from tmmcalc.report.telling import named, number_of, vector

COLUMNS = 12  # of numbers in a table
NOTHING = 1e-12  # of the largest force, or couple: less is not told

Bodies = Mapping[int, FreeBody]  # every moving link by itself


class Loaded(NamedTuple):
    """A linkage with all that acts on it."""

    told: Told
    loading: Loading
    result: Forces
    rows: Sequence[int]  # the shown positions among those of the result
    statics: Statics
    every: Solved  # all rows of the result
    bodies: Sequence[Bodies]  # of the shown positions
    names: Mapping[tuple[int, str, Kind], str]  # of what acts, by link, name and kind
    largest: tuple[float, float]  # force and couple of the shown positions
    powered: bool  # whether a chapter on works tells the mean power too

    @property
    def labels(self) -> list[str]:
        """The labels of the shown positions."""
        return [self.told.result.labels[row] for row in self.told.rows]

    def lines(self, texts: Sequence[str], words: Mapping[str, str] | None = None) -> Iterator[Block]:
        """The formulas worked out at the shown positions."""
        return self.told.lines([text for text in texts if text], words or {})

    def key(self, acting: Acting | Couple, part: str = "") -> str:
        """The name of a force in formulas, or that of its projection: ``Q_{5}``, ``Q_{5x}``."""
        own = f"{acting.letter}{acting.index}"
        name = self.names.get((acting.link, own, acting.kind), own).replace(",", "")
        return force_key(name, part)

    def pair(self, joint: str) -> Pair:
        """Friction and size of a pair."""
        return next((pair for pair in self.loading.pairs if pair.joint == joint), Pair(joint))

    def clean(self, force: complex) -> complex:
        """A force without the projections that are rounding alone."""
        least = NOTHING * self.largest[0]
        return complex(*(part if abs(part) > least else 0.0 for part in (force.real, force.imag)))

    def row_of(self, joint: str) -> int:
        """The row of a joint in the result."""
        return next(j for j, pair in enumerate(self.result.pairs) if pair.joint == joint)


def force_key(name: str, part: str = "") -> str:
    """The name of a force in formulas: a letter with an index, the primes of its name; no two names have one key.

    >>> force_key("Q5"), force_key("Q5", "x"), force_key("P_z", "y"), force_key("gas", "x")
    ('Q_{5}', 'Q_{5x}', 'P_{zy}', 'Q_{gas,x}')
    >>> force_key("Q5'"), force_key("Q_5"), force_key("Q_gas", "x")  # other loads than Q5 and gas
    ("Q'_{5}", 'Q_{Q-5}', 'Q_{Q-gas,x}')
    """
    plain = name.rstrip("'")
    primes = name[len(plain) :]
    found = re.fullmatch(r"([A-Za-z])(\d*)", plain) or re.fullmatch(r"([A-PR-Za-z])_([A-Za-z]\w*)", plain)
    letter, index = (found[1], name_index(found[2])) if found else ("Q", name_index(plain))
    index += ("," if part and len(index) > 1 and index[-1].isalpha() else "") + part
    return f"{letter}{primes}_{{{index}}}" if index else f"{letter}{primes}"


def names_of(mechanism: Mechanism, structure: Structure, loading: Loading) -> dict[tuple[int, str, Kind], str]:
    """The names of what acts by link, name and kind, told apart; a load that pushes against a link keeps its own."""
    acting = [each for each in acting_on(mechanism, structure, loading) if each.kind not in ("reaction", "friction")]
    names = {(a.link, a.name, a.kind): name for a, name in zip(acting, told_apart(acting), strict=True)}
    return names | {(load.link, load.name, "load"): _own_name(acting, load) for load in loading.loads}


def _own_name(acting: Sequence[Acts], load: Load) -> str:
    """The name of a load; with its kind where something else is called so."""
    shared = any(each.name == load.name and each.kind != "load" for each in acting)
    return f"{load.name}_load" if shared else load.name


def name_index(name: str) -> str:
    """The name of a load or a spring as an index, no two alike.

    >>> name_index("gas"), name_index("Q2'"), name_index("Q_2"), name_index("spring 1")
    ('gas', 'Q2′', 'Q-2', 'spring,1')
    """
    return name.translate({ord("_"): "-", ord("'"): "′", ord(" "): ","})


def own_index(name: str) -> str:
    """The index of the letters of the law of a load, which begins with the letter of the load as no other does.

    >>> own_index("Q5"), own_index("gas"), own_index("Q5'"), own_index("M")
    ('Q,5', 'Q,gas', 'Q′,5', 'Q,M')
    """
    letter, _, index = force_key(name).replace("'", "′").partition("_")
    return f"{letter},{index.strip('{}')}" if index else f"Q,{letter}"


def loaded_of(order: Order) -> Loaded:
    """What is told of the forces of a run."""
    told, loading, result = told_of(order), to_loading(order.spec), order.results["forces"]
    mechanism, structure = told.chain.mechanism, told.result.structure
    statics = compile_statics(compile_scene(mechanism, loading, told.result))
    rows = [result.labels.index(told.result.labels[row]) for row in told.rows]  # more of them where friction jumps
    every = solved(statics, result.theta, np.array([side_of(result, row) for row in range(len(result.labels))]))
    bodies = [{body.links[0]: body for body in link_bodies(every, row)} for row in rows]
    names = names_of(mechanism, structure, loading)
    force = max((abs(f.value) for each in bodies for body in each.values() for f in body.forces), default=0.0)
    couple = max((abs(c.value) for each in bodies for body in each.values() for c in body.couples), default=0.0)
    powered = "power" in order.results
    return Loaded(told, loading, result, rows, statics, every, bodies, names, (force, couple), powered)


def given_forces(body: FreeBody, own: set[str]) -> list[Acting]:
    """Forces on a link but the drive and the reactions of its group's own joints, for which the equations are."""
    return [f for f in body.forces if not (f.kind == "reaction" and f.joint in own) and f.kind != "drive"]


def _given_couples(body: FreeBody, own: set[str]) -> list[Couple]:
    return [c for c in body.couples if not (c.kind == "reaction" and c.joint in own) and c.kind != "drive"]


def sums(loaded: Loaded, link: int, own: set[str]) -> list[str]:
    """The sums of the given forces along both axes; their quantities are put into the lexicons."""
    everything = [f for each in loaded.bodies for f in given_forces(each[link], own)]
    seen = {loaded.key(f): f for f in everything if abs(f.value) > NOTHING * loaded.largest[0]}
    for lexicon, each in zip(loaded.told.lexicons, loaded.bodies, strict=True):
        total = 0j
        acting = {loaded.key(f): f for f in given_forces(each[link], own)}
        for key, like in seen.items():
            value = loaded.clean(acting[key].value) if key in acting else 0j
            total += value
            for axis, part in (("x", value.real), ("y", value.imag)):
                lexicon[canonical(loaded.key(like, axis))] = Given(part, "N", said(loaded, like))
        lexicon |= named(vector(f"T_{{{link}%}}", total, "N", tr("sum of the given forces on link {link}", link=link)))
    return [f"T_{{{link}{axis}}} = {' + '.join(loaded.key(f, axis) for f in seen.values()) or '0'}" for axis in "xy"]


def said(loaded: Loaded, acting: Acting | Couple) -> str:
    """What a force or a couple is."""
    link, couple = acting.link, isinstance(acting, Couple)
    if acting.joint:
        other = loaded.told.chain.mechanism.joint(acting.joint).other(link)
        if acting.kind == "friction":
            return (
                tr("friction moment of link {other} on link {link}", other=other, link=link)
                if couple
                else tr("friction force of link {other} on link {link}", other=other, link=link)
            )
        return tr("reaction of link {other} on link {link}", other=other, link=link)
    words = {
        "load": tr("given load"),
        "weight": tr("weight of link {link}", link=link),
        "inertia": tr("inertia couple of link {link}", link=link)
        if couple
        else tr("inertia force of link {link}", link=link),
        "spring": tr("force of the spring"),
        "damper": tr("force of the damper"),
        "drive": tr("force of the drive"),
    }
    return words[acting.kind]


def moments(loaded: Loaded, links: Sequence[int], point: str, own: set[str]) -> str:
    """The sum of the moments about a point, with arms; its quantities are put into the lexicons."""
    name = f"M_{{{''.join(map(str, links))}}}^{{{point}}}"
    words = {"links": ", ".join(map(str, links)), "point": point}
    said_sum = (
        tr("sum of the given moments on links {links} about {point}", **words)
        if len(links) > 1
        else tr("sum of the given moments on link {links} about {point}", **words)
    )
    terms: dict[str, None] = {}
    force, couple = loaded.largest
    for lexicon, each in zip(loaded.told.lexicons, loaded.bodies, strict=True):
        pole = complex(number_of(lexicon, f"x_{{{point}}}"), number_of(lexicon, f"y_{{{point}}}"))
        total = 0.0
        for link in links:
            for f in given_forces(each[link], own):
                if abs(f.value) <= NOTHING * force:
                    continue
                key = loaded.key(f)
                moment = float(cross(f.at - pole, f.value))
                arm = f"h_{{{key.replace('_', '').replace('{', '').replace('}', '')}}}^{{{point}}}"
                known = lexicon.get(canonical(key)) if f.kind == "friction" else None  # it has a sign along its line
                size = number_of(lexicon, key) if known else abs(f.value)
                lexicon[canonical(key)] = Given(size, "N", said(loaded, f))
                lexicon[canonical(arm)] = Given(
                    moment / size, "m", tr("signed arm of a force about {point}", point=point)
                )
                terms[f"{key}*{arm}"] = None
                total += moment
            for c in _given_couples(each[link], own):
                if abs(c.value) > NOTHING * couple:
                    key = loaded.key(c)
                    lexicon[canonical(key)] = Given(c.value, "N*m", said(loaded, c))
                    terms[key] = None
                    total += c.value
        lexicon[canonical(name)] = Given(total, "N*m", said_sum)
    for lexicon in loaded.told.lexicons:  # what acts in another position alone is nothing here
        for term in terms:
            for part in term.split("*"):
                lexicon.setdefault(canonical(part), Given(0.0, "N", ""))
    return f"{name} = {' + '.join(terms)}" if terms else ""


def put_reaction(loaded: Loaded, joint: Joint, link: int, bodies: Bodies, lexicon: Lexicon) -> complex:
    """Enter the projections and the size of a reaction of a revolute pair on a link; the reaction."""
    other = joint.other(link)
    acting = [f for f in bodies[link].forces if f.joint == joint.name and f.kind == "reaction"]
    value = sum((f.value for f in acting), 0j)
    meaning = tr("reaction of link {other} on link {link}", other=other, link=link)
    lexicon |= named(vector(f"R_{{{link}{other}%}}", value, "N", meaning))
    lexicon[canonical(f"R_{{{link}{other}}}")] = Given(abs(value), "N", meaning)
    return value


def printed_head(name: str, unit: str) -> tuple[str, float]:
    """A quantity with the unit in which it is printed, as the head of a row or a column; the factor of its values."""
    shown, factor = printed_as(unit)
    return f"${name}$, {tr_unit(shown)}", factor


def packed(parts: Sequence[Mapping[str, Real]]) -> list[dict[str, Real]]:
    """Columns of pairs together in tables that are not too wide."""
    found: list[dict[str, Real]] = [{}]
    for part in parts:
        if len(found[-1]) + len(part) > COLUMNS and found[-1]:
            found.append({})
        found[-1] |= part
    return [part for part in found if part]


def point_of(loaded: Loaded, joint: str) -> str:
    """The point of a revolute joint in formulas."""
    pins = find_pins(loaded.told.chain.mechanism)
    return plain_name(next(pin.name for pin in pins if joint in pin.joints))
