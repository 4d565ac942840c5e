"""Velocities and accelerations of a group as vector equations, textbook (2.31) to (2.35), and what is known of each.

Both ways of a loop lead to its point: with the point of the source chain, about it with the links, along the guides.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tmmcalc.linkage.notes.told import Told
from tmmcalc.linkage.notes.ways import Arm, Loop, Slid, Way
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Display, Paragraph


class Term(NamedTuple):
    """A vector of an equation, and what is known of its direction; nothing if it is known in size, too."""

    name: str
    known: str = ""


def velocities(told: Told, loops: Sequence[Loop], marks: str = "e") -> Iterator[Block]:
    """The equations of the velocities; ``marks`` names what is carried along by guides of the source chain."""
    return _equations(told, loops, "v", marks)


def accelerations(told: Told, loops: Sequence[Loop], marks: str = "e") -> Iterator[Block]:
    """The equations of the accelerations, with normal, tangential and Coriolis parts."""
    return _equations(told, loops, "a", marks)


def _equations(told: Told, loops: Sequence[Loop], letter: str, marks: str) -> Iterator[Block]:
    terms: dict[str, Term] = {}
    for loop in loops:
        sides = []
        for way in (loop.first, loop.second):
            found = [*_terms(told, way, letter, marks)]
            terms |= {canonical(term.name): term for term in found}
            sides.append(" + ".join(f"vec({term.name})" for term in found))
        point = f"{letter}_{{{loop.point}}}"
        own = [] if f"vec({point})" in sides else [f"vec({point})"]
        yield Display(read(" = ".join([*own, *(side for side in sides if side)])))
    known = ", ".join(f"${key}$" for key, term in terms.items() if not term.known)
    others = ", ".join(term.known for term in terms.values() if term.known)
    if known and others:
        yield Paragraph(
            tr("Known in size and direction: {known}; in direction alone: {others}.", known=known, others=others)
        )
    elif others:
        yield Paragraph(tr("Known in direction alone: {others}.", others=others))


def _terms(told: Told, way: Way, letter: str, marks: str) -> Iterator[Term]:
    arms: Sequence[Arm] = way.arms
    still = told.nothing(f"{letter}_{{{way.start}x}}", f"{letter}_{{{way.start}y}}")
    if arms and arms[0].spin.known:
        first, *arms = arms
        if not still or not told.nothing(f"omega_{first.spin.link}"):
            yield Term(f"{letter}_{{{first.end}}}^{{{marks.format(first.spin.line[0])}}}")
        yield from _slides(told, first, letter)
    elif not still:
        yield Term(f"{letter}_{{{way.start}}}")
    for arm in arms:
        yield from _turning(arm, letter)
        yield from _slides(told, arm, letter)


def _turning(arm: Arm, letter: str) -> Iterator[Term]:
    """The motion about the start: of a slider's pin, of the point of the guide that coincides with it."""
    end = f"{arm.end}{arm.spin.line[0]}" if arm.slid else arm.end
    line = f"{arm.start}{arm.end}"
    name = f"{letter}_{{{end}{arm.start}}}"
    if letter == "v":
        yield Term(name, tr("{vector} perpendicular to {line}", vector=f"${name}$", line=line))
    else:
        yield Term(f"{name}^n")
        yield Term(f"{name}^t", tr("{vector} perpendicular to {line}", vector=f"${name}^t$", line=line))


def _slides(told: Told, arm: Arm, letter: str) -> Iterator[Term]:
    for slid in arm.slid:
        name = f"{letter}_{{{slid.pair}}}"
        yield Term(name, "" if _driven(told, slid) else _along(slid, name))
        if letter == "a" and not told.nothing(f"omega_{arm.spin.link}"):
            yield Term(f"{name}^K")


def _driven(told: Told, slid: Slid) -> bool:
    return slid.joint.name == told.result.input_joint


def _along(slid: Slid, name: str) -> str:
    guide = slid.joint.links[1]
    if guide == 0:
        return tr("{vector} along the guide", vector=f"${name}$")
    return tr("{vector} along the guide of link {link}", vector=f"${name}$", link=guide)
