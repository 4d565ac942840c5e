"""The chapter on forces: what acts on the links, then the groups from the last to the first, then the input link.

Friction stands among the given forces, as the last pass of the program found it; so the lines hold with it and without.
"""

from __future__ import annotations

import cmath
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmmcalc.core.plane import cross
from tmmcalc.linkage.forces.kinetostatics import compile_statics
from tmmcalc.linkage.forces.results import side_of
from tmmcalc.linkage.freebody import Acting, Couple, FreeBody, link_bodies, solved
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.told import Dyad, Told, told_of
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph
from tmmcalc.report.telling import named, number_of, vector

NOTHING = 1e-12  # of the largest force, or couple: less is not told

Bodies = Mapping[int, FreeBody]


def blocks(order: Order) -> Iterator[Block]:
    """Inertia forces, every dyad from the last, the balancing moment of the input link."""
    told, loading, result = told_of(order), to_loading(order.spec), order.results["forces"]
    mechanism = told.chain.mechanism
    statics = compile_statics(compile_scene(mechanism, loading, told.result))
    rows = [result.labels.index(told.result.labels[row]) for row in told.rows]  # more of them where friction jumps
    sides = np.array([side_of(result, row) for row in rows])
    found = solved(statics, result.theta[rows], sides)
    bodies = [{body.links[0]: body for body in link_bodies(found, k)} for k in range(len(told.rows))]
    yield from told.beyond()
    yield from _inertia(told, loading, bodies)
    for dyad in reversed(told.dyads):
        yield Heading(tr("Group {name}", name=dyad.step.group.name), 2)
        yield from _dyad(told, dyad, bodies)
    if told.chain.structure.driven is None and told.chain.turns:
        yield from _input(told, bodies)


def _inertia(told: Told, loading: Loading, bodies: Sequence[Bodies]) -> Iterator[Block]:
    """Weights, inertia forces and couples of the links that have mass."""
    yield Heading(tr("Weights and loads of inertia"), 2)
    pins = find_pins(told.chain.mechanism)
    for body in loading.heavy:
        link = body.link
        at = next((plain_name(pin.name) for pin in pins if pin.at.get(link) == body.center), None)
        places = {"k": str(link), "S": at or ""}
        for lexicon, each in zip(told.lexicons, bodies, strict=True):
            lexicon |= named(_mass_quantities(loading, body, each[link]))
        texts = []
        if abs(loading.gravity):
            texts.append("G_<k> = m_<k>*g")
        if at is not None:
            texts += ["P_{<k>x} = -m_<k>*a_{<S>x}", "P_{<k>y} = -m_<k>*a_{<S>y}"]
        yield from told.lines([*texts, "M_<k> = -J_<k>*eps_<k>"], places)


def _mass_quantities(loading: Loading, body: Any, found: FreeBody) -> dict[str, Given]:
    link = body.link
    inertia = next((f.value for f in found.forces if f.kind == "inertia"), 0j)
    couple = next((c.value for c in found.couples if c.kind == "inertia"), 0.0)
    force, moment = tr("inertia force of link {link}", link=link), tr("inertia couple of link {link}", link=link)
    return {
        f"m_{link}": Given(body.mass, "kg", tr("mass of link {link}", link=link)),
        f"J_{link}": Given(
            body.inertia, "kg*m^2", tr("moment of inertia of link {link} about its centre of mass", link=link)
        ),
        "g": Given(abs(loading.gravity), "m/s^2", tr("acceleration of gravity")),
        f"G_{link}": Given(body.mass * abs(loading.gravity), "N", tr("weight of link {link}", link=link)),
        **vector(f"P_{{{link}%}}", inertia, "N", force),
        f"M_{link}": Given(couple, "N*m", moment),
    }


def _dyad(told: Told, dyad: Dyad, bodies: Sequence[Bodies]) -> Iterator[Block]:
    """Sums of what is given on its links, then the reactions in the order of their equations."""
    places = dyad.places
    links = [int(places["a"]), int(places["b"])]
    group = dyad.step.group
    own = {*group.inner, *group.outer}
    texts: list[str] = []
    for k in links:
        texts += _sums(told, bodies, k, own)
    pair = f"{places['a']}{places['b']}"
    texts += [f"T_{{{pair}{axis}}} = T_{{{places['a']}{axis}}} + T_{{{places['b']}{axis}}}" for axis in "xy"]
    for key, point in dyad.kind.MOMENTS.items():
        moved = [int(places[letter]) for letter in key]
        texts.append(_moments(told, bodies, moved, places[point], own))
    for lexicon, each in zip(told.lexicons, bodies, strict=True):
        for axis in "xy":
            total = sum(number_of(lexicon, f"T_{{{k}{axis}}}") for k in links)
            lexicon[canonical(f"T_{{{pair}{axis}}}")] = Given(total, "N", tr("sum of the given forces on the group"))
        lexicon |= named(_reactions(told, dyad, each, lexicon))
    yield from told.lines([text for text in texts if text], {})
    yield from told.lines(dyad.kind.REACTIONS, places)


def key_of(acting: Acting | Couple) -> str:
    """The name of a force in formulas: a letter with an index, ``Q_5`` of ``Q5``, ``Q_gas`` of ``gas``."""
    found = re.fullmatch(r"([A-Za-z])_?(\d*)", acting.letter)
    letters, rest = (found[1], found[2]) if found else ("Q", plain_name(acting.letter))
    index = f"{rest}{acting.index}".replace(",", "")
    return f"{letters}_{{{index}}}" if index else letters


def part_of(key: str, axis: str) -> str:
    """The name of a projection: ``Q_{5x}``."""
    return f"{key[:-1]}{axis}}}" if key.endswith("}") else f"{key}_{axis}"


def _given(body: FreeBody, own: set[str]) -> list[Acting]:
    """Forces on a link but the reactions of its group's own joints, for which the equations are."""
    return [f for f in body.forces if not (f.kind == "reaction" and f.joint in own) and f.kind != "drive"]


def _couples(body: FreeBody, own: set[str]) -> list[Couple]:
    return [c for c in body.couples if not (c.kind == "reaction" and c.joint in own) and c.kind != "drive"]


def _largest(bodies: Sequence[Bodies]) -> tuple[float, float]:
    force = max((abs(f.value) for each in bodies for body in each.values() for f in body.forces), default=0.0)
    couple = max((abs(c.value) for each in bodies for body in each.values() for c in body.couples), default=0.0)
    return force, couple


def _acting(bodies: Sequence[Bodies], link: int, own: set[str]) -> tuple[list[str], list[str]]:
    """Names of forces and couples that are something in any position."""
    force, couple = _largest(bodies)
    forces = dict.fromkeys(
        key_of(f) for each in bodies for f in _given(each[link], own) if abs(f.value) > NOTHING * force
    )
    couples = dict.fromkeys(
        key_of(c) for each in bodies for c in _couples(each[link], own) if abs(c.value) > NOTHING * couple
    )
    return [*forces], [*couples]


def _sums(told: Told, bodies: Sequence[Bodies], link: int, own: set[str]) -> list[str]:
    """The sums of the given forces along both axes; their quantities are put into the lexicons."""
    forces, _ = _acting(bodies, link, own)
    for lexicon, each in zip(told.lexicons, bodies, strict=True):
        total = 0j
        acting = {key_of(f): f for f in _given(each[link], own)}
        for key in forces:
            value = acting[key].value if key in acting else 0j
            total += value
            said = _said(acting.get(key), key)
            for axis, part in (("x", value.real), ("y", value.imag)):
                lexicon[canonical(part_of(key, axis))] = Given(part, "N", said)
        sums = tr("sum of the given forces on link {link}", link=link)
        lexicon |= named(vector(f"T_{{{link}%}}", total, "N", sums))
    return [f"T_{{{link}{axis}}} = {' + '.join(part_of(key, axis) for key in forces) or '0'}" for axis in "xy"]


def _said(acting: Acting | Couple | None, key: str) -> str:
    """What a force or a couple is."""
    kind = acting.kind if acting is not None else "load"
    link = acting.link if acting is not None else ""
    words = {
        "load": tr("given load"),
        "weight": tr("weight of link {link}", link=link),
        "inertia": tr("inertia couple of link {link}", link=link)
        if isinstance(acting, Couple)
        else tr("inertia force of link {link}", link=link),
        "spring": tr("force of the spring"),
        "damper": tr("force of the damper"),
        "reaction": tr("reaction found before"),
        "friction": tr("friction of the pair"),
        "drive": tr("force of the drive"),
    }
    return words[kind]


def _moments(told: Told, bodies: Sequence[Bodies], links: Sequence[int], point: str, own: set[str]) -> str:
    """The sum of the moments about a point, with arms; its quantities are put into the lexicons."""
    name = f"M_{{{''.join(map(str, links))}}}^{{{point}}}"
    terms: dict[str, None] = {}
    force, couple = _largest(bodies)
    for lexicon, each in zip(told.lexicons, bodies, strict=True):
        pole = complex(number_of(lexicon, f"x_{{{point}}}"), number_of(lexicon, f"y_{{{point}}}"))
        total = 0.0
        for link in links:
            for f in _given(each[link], own):
                if abs(f.value) <= NOTHING * force:
                    continue
                key = key_of(f)
                moment = float(cross(f.at - pole, f.value))
                arm = f"h_{{{key.replace('_', '').replace('{', '').replace('}', '')}}}^{{{point}}}"
                lexicon[canonical(key)] = Given(abs(f.value), "N", _said(f, key))
                lexicon[canonical(arm)] = Given(
                    moment / abs(f.value), "m", tr("arm of the force about {point}, with its sign", point=point)
                )
                terms[f"{key}*{arm}"] = None
                total += moment
            for c in _couples(each[link], own):
                if abs(c.value) > NOTHING * couple:
                    key = key_of(c)
                    lexicon[canonical(key)] = Given(c.value, "N*m", _said(c, key))
                    terms[key] = None
                    total += c.value
        lexicon[canonical(name)] = Given(total, "N*m", tr("sum of the given moments about {point}", point=point))
    for lexicon in told.lexicons:  # what acts in another position alone is nothing here
        for term in terms:
            for part in term.split("*"):
                lexicon.setdefault(canonical(part), Given(0.0, "N", ""))
    return f"{name} = {' + '.join(terms)}" if terms else ""


def _reactions(told: Told, dyad: Dyad, bodies: Bodies, lexicon: Lexicon) -> dict[str, Given]:
    """The reactions of the dyad by the program."""
    places = dyad.places
    mechanism = told.chain.mechanism
    found: dict[str, Given] = {}
    ends = (
        ("a", "f", dyad.step.group.outer[0]),
        ("b", "g", dyad.step.group.outer[1]),
        ("a", "b", dyad.step.group.inner[0]),
    )
    for on, other, name in ends:
        link = int(places[on])
        joint = mechanism.joint(name)
        index = f"{places[on]}{places[other]}"
        acting = [f for f in bodies[link].forces if f.joint == name and f.kind == "reaction"]
        couple = sum(c.value for c in bodies[link].couples if c.joint == name and c.kind == "reaction")
        pair = tr("reaction of link {other} on link {link}", other=places[other], link=link)
        value = sum((f.value for f in acting), 0j)
        if joint.kind == "revolute":
            found |= vector(f"R_{{{index}%}}", value, "N", pair)
            found[f"R_{{{index}}}"] = Given(abs(value), "N", pair)
            found |= _parts(dyad, index, on, value, lexicon)
            continue
        angle = _line_angle(dyad, name, lexicon)
        normal = (value * np.conj(1j * cmath.exp(1j * np.radians(angle)))).real
        found[f"N_{{{index}}}"] = Given(float(normal), "N", tr("normal reaction of link {other} on link {link}",
                                                               other=places[other], link=link))  # fmt: skip
        for point in {places["B"], places["P"]} & {plain_name(pin.name) for pin in find_pins(mechanism)}:
            pole = complex(number_of(lexicon, f"x_{{{point}}}"), number_of(lexicon, f"y_{{{point}}}"))
            moment = couple + sum(float(cross(f.at - pole, f.value)) for f in acting)
            found[f"M_{{{index}}}^{{{point}}}"] = Given(
                moment, "N*m", tr("moment of the normal reaction about {point}", point=point)
            )
    return found


def _line_angle(dyad: Dyad, joint: str, lexicon: Lexicon) -> float:
    """The direction of a prismatic joint in the equations [deg]."""
    places, group = dyad.places, dyad.step.group
    if group.kind == "RPR":
        return number_of(lexicon, f"phi_{places['b']}")
    if group.kind == "PRP" and joint == group.outer[0]:
        return number_of(lexicon, f"gamma_{places['a']}")
    gamma = number_of(lexicon, f"gamma_{places['b']}")
    if group.kind == "RPP" and joint == group.inner[0]:
        return gamma + number_of(lexicon, f"delta_{places['b']}")
    return gamma


def _parts(dyad: Dyad, index: str, on: str, value: complex, lexicon: Lexicon) -> dict[str, Given]:
    """The parts of an outer reaction along and across the line that its equations take."""
    places, kind = dyad.places, dyad.step.group.kind
    along = tr("parts of the reaction along and across link {link}", link=places[on])
    if kind == "RPP":
        lines = {"I": number_of(lexicon, f"gamma_{places['b']}")}
        lines["II"] = lines["I"] + number_of(lexicon, f"delta_{places['b']}")
        both = tr("projection of the reaction on the lines of link {link}", link=places["b"])
        return {
            f"R_{{{index}}}^{{{mark}}}" if len(mark) > 1 else f"R_{{{index}}}^{mark}": Given(
                float((value * cmath.exp(-1j * np.radians(angle))).real), "N", both
            )
            for mark, angle in lines.items()
        }
    link = places["b"] if kind == "RPR" else places[on]
    if canonical(f"phi_{link}") not in lexicon:
        return {}
    local = value * cmath.exp(-1j * np.radians(number_of(lexicon, f"phi_{link}")))
    first, second = ("e", "n") if kind == "RPR" else ("n", "t")
    return {
        f"R_{{{index}}}^{first}": Given(float(local.real), "N", along),
        f"R_{{{index}}}^{second}": Given(float(local.imag), "N", along),
    }


def _input(told: Told, bodies: Sequence[Bodies]) -> Iterator[Block]:
    """The balancing moment about the pivot, and the reaction there."""
    link, joint = told.result.structure.input_link, told.chain.input_joint
    pivot = next(plain_name(pin.name) for pin in find_pins(told.chain.mechanism) if joint.name in pin.joints)
    own = {joint.name}
    yield Heading(tr("Input link"), 2)
    if any(f.kind == "drive" for each in bodies for f in each[link].forces):
        yield Paragraph(tr("The drive acts through the mesh of a gear."))
        return
    texts = [*_sums(told, bodies, link, own), _moments(told, bodies, [link], pivot, own)]
    for lexicon, each in zip(told.lexicons, bodies, strict=True):
        drive = sum(c.value for c in each[link].couples if c.kind == "drive")
        lexicon["M_d"] = Given(float(drive), "N*m", tr("balancing moment"))
        value = sum((f.value for f in each[link].forces if f.joint == joint.name and f.kind == "reaction"), 0j)
        frame = tr("reaction of link {other} on link {link}", other=0, link=link)
        lexicon |= named(vector(f"R_{{{link}0%}}", value, "N", frame))
        lexicon[canonical(f"R_{{{link}0}}")] = Given(abs(value), "N", frame)
    texts += [
        f"M_d = -M_{{{link}}}^{{{pivot}}}",
        "R_{<k>0x} = -T_{<k>x}",
        "R_{<k>0y} = -T_{<k>y}",
        "R_{<k>0} = sqrt(R_{<k>0x}**2 + R_{<k>0y}**2)",
    ]
    yield from told.lines([text for text in texts if text], {"k": str(link)})
