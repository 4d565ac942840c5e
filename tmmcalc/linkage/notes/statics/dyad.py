"""The reactions of a dyad: sums of what is given on its links, then the equations of its kind in their order."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.plane import cross
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.statics.loaded import Bodies, Loaded, moments, put_reaction, sums
from tmmcalc.linkage.notes.statics.pairs import ToldPair, arms, friction
from tmmcalc.linkage.notes.told import Dyad
from tmmcalc.linkage.pins import find_pins
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Lexicon, Paragraph
from tmmcalc.report.telling import named, number_of


def dyad_reactions(loaded: Loaded, dyad: Dyad, pairs: Sequence[ToldPair]) -> Iterator[Block]:
    """The given forces, the reactions, the arms of those of guides, the friction that they give."""
    places = dyad.places
    links = [int(places["a"]), int(places["b"])]
    group = dyad.step.group
    own = {*group.inner, *group.outer}
    texts: list[str] = []
    for k in links:
        texts += sums(loaded, k, own)
    pair = f"{places['a']}{places['b']}"
    texts += [f"T_{{{pair}{axis}}} = T_{{{places['a']}{axis}}} + T_{{{places['b']}{axis}}}" for axis in "xy"]
    for key, point in dyad.kind.MOMENTS.items():
        texts.append(moments(loaded, [int(places[letter]) for letter in key], places[point], own))
    for lexicon, each in zip(loaded.told.lexicons, loaded.bodies, strict=True):
        for axis in "xy":
            total = sum(number_of(lexicon, f"T_{{{k}{axis}}}") for k in links)
            lexicon[canonical(f"T_{{{pair}{axis}}}")] = Given(total, "N", tr("sum of the given forces on the group"))
        for told in pairs:
            _put(loaded, dyad, told, each, lexicon)
    yield Paragraph(tr("The forces that are known, those found before among them, and their moments:"))
    yield from loaded.lines(texts)
    yield Paragraph(_way(dyad))
    yield from loaded.lines(dyad.kind.REACTIONS, places)
    yield from arms(loaded, [told for told in pairs if told.point])
    yield from friction(loaded, pairs)


def dyad_pairs(loaded: Loaded, dyad: Dyad) -> list[ToldPair]:
    """The outer pair of a, the inner one as a feels it, the outer pair of b."""
    places, group = dyad.places, dyad.step.group
    mechanism = loaded.told.chain.mechanism
    points = {"RRP": "B", "PRP": "B", "RPR": "P", "RPP": "P"}
    found = []
    for letter, name in (("a", group.outer[0]), ("a", group.inner[0]), ("b", group.outer[1])):
        joint, link = mechanism.joint(name), int(places[letter])
        if joint.kind == "revolute":
            found.append(ToldPair(joint, link))
        else:
            moment = "" if group.kind == "RPP" and letter == "b" else places[points[group.kind]]
            found.append(ToldPair(joint, link, _line(dyad, name), moment))
    return found


def _line(dyad: Dyad, joint: str) -> str:
    """The direction of a prismatic joint in the equations, as a formula."""
    places, group = dyad.places, dyad.step.group
    if group.kind == "RPR":
        return f"phi_{places['b']}"
    if group.kind == "PRP" and joint == group.outer[0]:
        return f"gamma_{places['a']}"
    along = f"gamma_{places['b']}"
    return f"{along} + delta_{places['b']}" if group.kind == "RPP" and joint == group.inner[0] else along


def _way(dyad: Dyad) -> str:
    """How the equations of the kind follow each other."""
    a, b, group = dyad.places["a"], dyad.places["b"], dyad.places["a"] + "," + dyad.places["b"]
    point, first, second = dyad.places["B"], dyad.places["P"], dyad.places["Q"]
    return {
        "RRR": lambda: tr(
            "From the moments of each link about {point} follow the tangential parts of the outer reactions, from the "
            "projections of all forces of group ({group}) across link {b} the normal part of that of link {a}; then "
            "the sums of forces of the group and of link {a} give the other reactions. The normal part is positive "
            "towards {point}, the tangential one a quarter turn counter-clockwise of it.",
            point=point, group=group, a=a, b=b,
        ),
        "RRP": lambda: tr(
            "From the moments of link {a} about {point} follows the tangential part of the reaction in {first}, from "
            "the projections of all forces of group ({group}) on the guide the normal part, from those across the "
            "guide its normal reaction; the forces of link {a} give the inner reaction. The normal part is positive "
            "towards {point}, the tangential one a quarter turn counter-clockwise of it.",
            point=point, first=first, group=group, a=a,
        ),
        "RPR": lambda: tr(
            "From the projections of the forces of link {a} along link {b} follows the part of the reaction in "
            "{first} along it, from the moments of group ({group}) about {second} the part across it; the forces of "
            "link {a} across the slot give the inner reaction, all forces of the group the reaction in {second}.",
            first=first, second=second, group=group, a=a, b=b,
        ),
        "PRP": lambda: tr(
            "From the projections of all forces of group ({group}) along each guide follows the normal reaction of "
            "the other; the forces of link {a} give the inner reaction, the moments about {point} those of the normal "
            "reactions.",
            point=point, group=group, a=a,
        ),
        "RPP": lambda: tr(
            "From the projections of all forces of group ({group}) along the guide, and of those of link {a} along "
            "its line on link {b}, follows the reaction in {first}; the projections across both lines give the normal "
            "reactions.",
            first=first, group=group, a=a, b=b,
        ),
    }[dyad.step.group.kind]()  # fmt: skip


def _put(loaded: Loaded, dyad: Dyad, pair: ToldPair, bodies: Bodies, lexicon: Lexicon) -> None:
    """Enter a reaction of the dyad by the program."""
    joint, link, places = pair.joint, pair.link, dyad.places
    if joint.kind == "revolute":
        value = put_reaction(loaded, joint, link, bodies, lexicon)
        lexicon |= named(_parts(dyad, pair, value, lexicon))
        return
    acting = [f for f in bodies[link].forces if f.joint == joint.name and f.kind == "reaction"]
    couple = sum(c.value for c in bodies[link].couples if c.joint == joint.name and c.kind == "reaction")
    value = sum((f.value for f in acting), 0j)
    normal = (value * np.conj(1j * cmath.exp(1j * np.radians(pair.angle(lexicon))))).real
    meaning = tr("normal reaction of link {other} on link {link}", other=pair.other, link=link)
    lexicon[canonical(f"N_{{{pair.ij}}}")] = Given(float(normal), "N", meaning)
    points = {plain_name(pin.name) for pin in find_pins(loaded.told.chain.mechanism)}
    for point in {places["B"], places["P"]} & points:
        pole = complex(number_of(lexicon, f"x_{{{point}}}"), number_of(lexicon, f"y_{{{point}}}"))
        moment = couple + sum(float(cross(f.at - pole, f.value)) for f in acting)
        about = tr("moment of the normal reaction about {point}", point=point)
        lexicon[canonical(f"M_{{{pair.ij}}}^{{{point}}}")] = Given(moment, "N*m", about)


def _parts(dyad: Dyad, pair: ToldPair, value: complex, lexicon: Lexicon) -> dict[str, Given]:
    """The parts of an outer reaction along and across the line that its equations take."""
    places, kind, index = dyad.places, dyad.step.group.kind, pair.ij
    if kind == "RPP":
        lines = {"I": number_of(lexicon, f"gamma_{places['b']}")}
        lines["{II}"] = lines["I"] + number_of(lexicon, f"delta_{places['b']}")
        both = tr("projection of the reaction on the lines of link {link}", link=places["b"])
        return {
            f"R_{{{index}}}^{mark}": Given(float((value * cmath.exp(-1j * np.radians(angle))).real), "N", both)
            for mark, angle in lines.items()
        }
    link = places["b"] if kind == "RPR" else pair.link
    along = tr("part of the reaction along link {link}", link=link)
    across = tr("part of the reaction across link {link}", link=link)
    if canonical(f"phi_{link}") not in lexicon:
        return {}
    local = value * cmath.exp(-1j * np.radians(number_of(lexicon, f"phi_{link}")))
    first, second = ("e", "n") if kind == "RPR" else ("n", "t")
    return {
        f"R_{{{index}}}^{first}": Given(float(local.real), "N", along),
        f"R_{{{index}}}^{second}": Given(float(local.imag), "N", across),
    }
