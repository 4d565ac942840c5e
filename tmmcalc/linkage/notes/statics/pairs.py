"""What is told of a pair once its reaction is known: its friction, the arm of a normal reaction, the edges of a slider.

A pair is told as the link that takes the reaction feels it; of a prismatic one the direction of its line is a formula,
``gamma_5`` or ``gamma_5 + delta_5``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.forces.kinetostatics import REST
from tmmcalc.linkage.forces.results import edge_reactions
from tmmcalc.linkage.forces.wrench import Slideway, sliding
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.statics.loaded import Loaded
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Lexicon, Paragraph
from tmmcalc.report.telling import lines, named, number_of, vector

SMALL = 1e-9  # of the largest force: a normal reaction without an arm


class ToldPair(NamedTuple):
    """A pair as a link feels it; ``line`` is the formula of the direction of a prismatic one."""

    joint: Joint
    link: int
    line: str = ""
    point: str = ""  # about which the moment of a normal reaction is told

    @property
    def other(self) -> int:
        """The link that gives the reaction."""
        return self.joint.other(self.link)

    @property
    def ij(self) -> str:
        """The index of its reaction."""
        return f"{self.link}{self.other}"

    def angle(self, lexicon: Lexicon) -> float:
        """The direction of its line [deg]."""
        return sum(number_of(lexicon, part) for part in self.line.split(" + "))


def arms(loaded: Loaded, pairs: Sequence[ToldPair]) -> Iterator[Block]:
    """The arms of the normal reactions about the points of their moments; the reactions at the edges of sliders."""
    for pair in pairs:
        ij, about = pair.ij, f"M_{{{pair.ij}}}^{{{pair.point}}}"
        places = []
        for place in loaded.told.places:
            normal = number_of(place.lexicon, f"N_{{{ij}}}")
            if abs(normal) <= SMALL * loaded.largest[0]:
                continue
            value = 1e3 * number_of(place.lexicon, about) / normal
            meaning = tr("arm of the normal reaction about {point}, along the guide", point=pair.point)
            place.lexicon[canonical(f"h_{{{ij}}}")] = Given(value, "mm", meaning)
            places.append(place)
        if places:
            yield from lines([f"h_{{{ij}}} = 1000*{about}/N_{{{ij}}}"], places)
        yield from _edges(loaded, pair)


def _edges(loaded: Loaded, pair: ToldPair) -> Iterator[Block]:
    """The reactions at both edges of a slider whose length is given (textbook fig. 3.1b)."""
    length, ij, j = loaded.pair(pair.joint.name).length, pair.ij, loaded.row_of(pair.joint.name)
    if length is None:
        return
    sign = 1.0 if pair.link > pair.other else -1.0
    normals = np.array([number_of(lexicon, f"N_{{{ij}}}") for lexicon in loaded.told.lexicons])
    couples = sign * loaded.result.couple[j, [*loaded.rows]]
    edges = np.array(edge_reactions(normals, couples, length))
    for k, lexicon in enumerate(loaded.told.lexicons):
        ahead = tr("reaction at the edge of the slider of link {link} along the positive direction", link=pair.link)
        behind = tr("reaction at the other edge of the slider of link {link}", link=pair.link)
        lexicon |= named(
            {
                f"C_{{{ij}}}": Given(
                    float(couples[k]), "N*m", tr("moment of the normal reaction about the middle of the slider")
                ),
                f"L_{{{ij}}}": Given(length, "m", tr("length of the slider of link {link}", link=pair.link)),
                f"N'_{{{ij}}}": Given(float(edges[0, k]), "N", ahead),
                f"N''_{{{ij}}}": Given(float(edges[1, k]), "N", behind),
            }
        )
    yield from loaded.lines(
        [f"N'_{{{ij}}} = N_{{{ij}}}/2 + C_{{{ij}}}/L_{{{ij}}}", f"N''_{{{ij}}} = N_{{{ij}}}/2 - C_{{{ij}}}/L_{{{ij}}}"]
    )
    if np.any(edges[0] * edges[1] < 0):
        said = tr("Where both have opposite signs, the slider of link {link} tips and bears on both edges.",
                  link=pair.link)  # fmt: skip
        yield Paragraph(said)


def put_friction(loaded: Loaded, pairs: Sequence[ToldPair]) -> None:
    """Enter the friction of pairs: the moment on the link, or the force along the line with its sign."""
    for pair in pairs:
        if not rubs(loaded, pair):
            continue
        own, ij, name = loaded.pair(pair.joint.name), pair.ij, plain_name(pair.joint.name)
        words = {"link": pair.link, "other": pair.other}
        for lexicon, bodies in zip(loaded.told.lexicons, loaded.bodies, strict=True):
            about = tr("coefficient of friction in pair {joint}", joint=pair.joint.name)
            found = {f"f_{{{name}}}": Given(own.friction, "", about)}
            body = bodies[pair.link]
            if pair.joint.kind == "revolute":
                rubbing = [c.value for c in body.couples if c.joint == pair.joint.name and c.kind == "friction"]
                radius = tr("radius of the pin of pair {joint}", joint=pair.joint.name)
                found[f"r_{{{name}}}"] = Given(own.radius, "m", radius)
                meaning = tr("friction moment of link {other} on link {link}", **words)
                found[f"M_{{{ij}}}"] = Given(sum(rubbing), "N*m", meaning)
            else:
                force = sum((f.value for f in body.forces if f.joint == pair.joint.name and f.kind == "friction"), 0j)
                meaning = tr("friction force of link {other} on link {link}", **words)
                along_line = (np.exp(-1j * np.radians(pair.angle(lexicon))) * force).real
                found[f"F_{{{ij}}}"] = Given(float(along_line), "N", meaning)
                found |= vector(f"F_{{{ij}%}}", force, "N", meaning)
            lexicon |= named(found)


def friction(loaded: Loaded, pairs: Sequence[ToldPair]) -> Iterator[Block]:
    """The friction that the reactions give: (3.27) along a line, (3.28) about a pin."""
    texts = [text for pair in pairs if rubs(loaded, pair) for text in _law(loaded, pair)]
    if texts:
        yield Paragraph(
            tr("Friction acts against the relative motion in the pair; with the reactions that were found it is")
        )
        yield from loaded.lines(texts)


def rubs(loaded: Loaded, pair: ToldPair) -> bool:
    """Whether a pair has friction."""
    return pair.joint.name in loaded.statics.scales


def _law(loaded: Loaded, pair: ToldPair) -> list[str]:
    """The formulas of the friction in a pair."""
    ij, name, resting = pair.ij, plain_name(pair.joint.name), _senses(loaded, pair)
    if pair.joint.kind == "revolute":
        law = f"f_{{{name}}}*r_{{{name}}}*R_{{{ij}}}"
        if resting:
            return [f"M_{{{ij}}} = -s_{{{ij}}}*{law}"]
        relative = f"omega_{{{ij}}} = omega_{pair.link} - omega_{pair.other}"
        return [relative, f"M_{{{ij}}} = -sign(omega_{{{ij}}})*{law}"]
    sense = f"s_{{{ij}}}" if resting else f"sign(v_{{{ij}}})"
    edged = loaded.pair(pair.joint.name).length is not None
    size = f"(abs(N'_{{{ij}}}) + abs(N''_{{{ij}}}))" if edged else f"abs(N_{{{ij}}})"
    line = pair.line if " " not in pair.line else f"({pair.line})"
    return [
        f"F_{{{ij}}} = -{sense}*f_{{{name}}}*{size}",
        f"F_{{{ij}x}} = F_{{{ij}}}*cos({line})",
        f"F_{{{ij}y}} = F_{{{ij}}}*sin({line})",
    ]


def _senses(loaded: Loaded, pair: ToldPair) -> bool:
    """Enter the relative velocity; whether the pair stands still in a shown position, so that its sense is told."""
    rate = np.broadcast_to(sliding(pair.joint, loaded.every.place.configuration)[0], loaded.result.theta.shape)
    sense = loaded.statics.sense(pair.joint, loaded.every.place.configuration, loaded.every.place.side)
    sense = np.broadcast_to(sense, rate.shape)
    own = 1.0 if pair.link > pair.other else -1.0
    resting = False
    for lexicon, row in zip(loaded.told.lexicons, loaded.rows, strict=True):
        turned = own * (along(loaded, pair) if pair.joint.kind == "prismatic" else 1.0)
        speed = turned * float(rate[row]) * loaded.statics.scene.travel.speed
        if pair.joint.kind == "revolute":
            meaning = tr("angular velocity of link {link} against link {other}", link=pair.link, other=pair.other)
            lexicon[canonical(f"omega_{{{pair.ij}}}")] = Given(speed, "rad/s", meaning)
        else:
            meaning = tr("velocity of link {block} along link {link}", block=pair.link, link=pair.other)
            lexicon.setdefault(canonical(f"v_{{{pair.ij}}}"), Given(speed, "m/s", meaning))
        resting = resting or abs(rate[row]) <= REST * loaded.statics.scales[pair.joint.name]
        told = tr("sense of the relative motion just after the position, 1 or −1")
        lexicon[canonical(f"s_{{{pair.ij}}}")] = Given(turned * float(sense[row]), "", told)
    return resting


def along(loaded: Loaded, pair: ToldPair) -> float:
    """+1 if the told direction of a line is that of the program, else -1: they turn together."""
    seat, row = loaded.every.state.reactions[pair.joint.name].seat, loaded.rows[0]
    assert isinstance(seat, Slideway)
    e = np.broadcast_to(seat.e, loaded.result.theta.shape)[row]
    told = np.exp(1j * np.radians(pair.angle(loaded.told.lexicons[0])))
    return 1.0 if (np.conj(e) * told).real > 0 else -1.0
