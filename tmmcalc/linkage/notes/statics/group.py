"""A group of higher class, or one that holds the drive: three equations a link, all solved at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tmmcalc.core.plane import cross
from tmmcalc.linkage.forces.wrench import Plan
from tmmcalc.linkage.model import Joint
from tmmcalc.linkage.notes.statics.loaded import (
    NOTHING,
    Loaded,
    moments,
    point_of,
    printed_head,
    put_reaction,
    sums,
)
from tmmcalc.linkage.notes.statics.pairs import ToldPair, arms, friction
from tmmcalc.linkage.notes.statics.slides import put_slide
from tmmcalc.report.formula.digits import Given, value_of
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Paragraph, Table
from tmmcalc.report.telling import cell, located, named, number_of

DIGITS = 5  # of the unknowns and right sides in tables
COEFFICIENTS = 4  # digits of coefficients
STILL = 1e-12  # of a coefficient: less is rounding
SUMS = ("x", "y", "M")  # the equations of a link


class Term(NamedTuple):
    """What an unknown brings into an equation: the coefficient as a formula with its sign."""

    unknown: str
    sign: int
    factor: str  # "1", or a formula

    @property
    def text(self) -> str:
        """The term with its sign before it."""
        factor = "" if self.factor == "1" else f"*{self.factor}"
        return f"{'+' if self.sign > 0 else '-'} {self.unknown}{factor}"


class Equations(NamedTuple):
    """The equations of a link: the point of its moments, the terms of each by the names in SUMS."""

    link: int
    pole: str
    terms: dict[str, list[Term]]
    given: bool  # whether moments are given on it

    def left(self, which: str) -> str:
        """The name of a sum."""
        return f"Sigma_{self.link}^{{{self.pole}}}" if which == "M" else f"Sigma_{{{self.link}{which}}}"

    def known(self, which: str) -> str:
        """The name of the sum of what is given; none where no moment is."""
        if which != "M":
            return f"T_{{{self.link}{which}}}"
        return f"M_{self.link}^{{{self.pole}}}" if self.given else ""


def group_pairs(loaded: Loaded, plan: Plan) -> list[ToldPair]:
    """The pairs of a group as their receivers feel them, their quantities entered."""
    return [_told(loaded, post.joint, post.receiver) for post in plan.posts]


def group_reactions(loaded: Loaded, plan: Plan, pairs: Sequence[ToldPair]) -> Iterator[Block]:
    """What is given, the system of equations, its solution, and the equations with it."""
    joints = [post.joint.name for post in plan.posts]
    unknowns = [name for pair in pairs for name in _unknowns(pair)]
    texts: list[str] = []
    equations = []
    for link in plan.group.links:
        own = [pair for pair in pairs if link in (pair.link, pair.other)]
        pole = next((pair.point for pair in own if pair.joint.kind == "revolute"), own[0].point)
        texts += sums(loaded, link, set(joints))
        given = moments(loaded, [link], pole, set(joints))
        texts.append(given)
        equations.append(Equations(link, pole, _terms(loaded, link, pole, own), bool(given)))
    if plan.driven is not None:
        unknowns.append("F_d")
        for lexicon, row in zip(loaded.told.lexicons, loaded.rows, strict=True):
            lexicon["F_d"] = Given(float(loaded.result.drive[row]), "N", tr("force of the drive"))
        _push(equations, pairs[plan.driven])
    yield Paragraph(tr("The forces that are known, those found before among them, and their moments:"))
    yield from loaded.lines(texts)
    yield from _system(loaded, plan.group.name, equations, unknowns)
    yield from _checks(loaded, equations)
    yield from loaded.lines(
        [
            f"R_{{{pair.ij}}} = sqrt(R_{{{pair.ij}x}}**2 + R_{{{pair.ij}y}}**2)"
            for pair in pairs
            if pair.joint.kind == "revolute"
        ]
    )
    yield from arms(loaded, [pair for pair in pairs if pair.joint.kind == "prismatic"])
    yield from friction(loaded, pairs)


def _told(loaded: Loaded, joint: Joint, link: int) -> ToldPair:
    """A pair of the group, its quantities entered."""
    if joint.kind == "revolute":
        for lexicon, each in zip(loaded.told.lexicons, loaded.bodies, strict=True):
            put_reaction(loaded, joint, link, each, lexicon)
        return ToldPair(joint, link, "", point_of(loaded, joint.name))
    pair = ToldPair(joint, link)
    pair = pair._replace(line=f"gamma_{{{pair.ij}}}")
    return pair._replace(point=put_slide(loaded, pair))


def _unknowns(pair: ToldPair) -> tuple[str, str]:
    ij = pair.ij
    if pair.joint.kind == "revolute":
        return f"R_{{{ij}x}}", f"R_{{{ij}y}}"
    return f"N_{{{ij}}}", f"M_{{{ij}}}^{{{pair.point}}}"


def _terms(loaded: Loaded, link: int, pole: str, own: list[ToldPair]) -> dict[str, list[Term]]:
    """What the pairs of a link bring into its equations."""
    found: dict[str, list[Term]] = {which: [] for which in SUMS}
    for pair in own:
        sign = 1 if link == pair.link else -1
        first, second = _unknowns(pair)
        over, up = f"(x_{{{pair.point}}} - x_{{{pole}}})", f"(y_{{{pair.point}}} - y_{{{pole}}})"
        away = pair.point != pole
        if pair.joint.kind == "revolute":
            found["x"].append(Term(first, sign, "1"))
            found["y"].append(Term(second, sign, "1"))
            found["M"] += [Term(first, -sign, up), Term(second, sign, over)] if away else []
        else:
            found["x"].append(Term(first, -sign, f"sin({pair.line})"))
            found["y"].append(Term(first, sign, f"cos({pair.line})"))
            found["M"] += [Term(first, sign, f"({over}*cos({pair.line}) + {up}*sin({pair.line}))")] if away else []
            found["M"].append(Term(second, sign, "1"))
    return found


def _push(equations: list[Equations], pair: ToldPair) -> None:
    """Add the force of the drive, which pushes the slider ahead and its guide back."""
    for each in equations:
        if each.link not in pair.joint.links:
            continue
        sign = 1 if each.link == pair.joint.links[0] else -1
        each.terms["x"].append(Term("F_d", sign, f"cos({pair.line})"))
        each.terms["y"].append(Term("F_d", sign, f"sin({pair.line})"))
        if pair.point != each.pole:
            over, up = f"(x_{{{pair.point}}} - x_{{{each.pole}}})", f"(y_{{{pair.point}}} - y_{{{each.pole}}})"
            each.terms["M"].append(Term("F_d", sign, f"({over}*sin({pair.line}) - {up}*cos({pair.line}))"))


def _system(loaded: Loaded, name: str, equations: list[Equations], unknowns: list[str]) -> Iterator[Block]:
    """The coefficients of the equations, link by link, and the unknowns that solve them."""
    tables = [_coefficients(loaded, each, [u for u in unknowns if _in(each, u)]) for each in equations]
    solution = f"forces_solution_{equations[0].link}"
    yield Paragraph(
        tr(
            "Each link of group {name} is in equilibrium: its projections on both axes and its moments make three "
            "equations, together {count} equations with {count} unknowns. Their coefficients, those of moments in m, "
            "and their right sides $b$ are {where}, with the positions in brackets; the unknowns that solve them are "
            "in table {solution}.",
            name=name,
            count=len(unknowns),
            where=located(tables),
            solution=f"{{tab:{solution}}}",
        )
    )
    yield from tables
    rows = []
    for unknown in unknowns:
        head, factor = printed_head(unknown, "N*m" if unknown.startswith("M_") else "N")
        found = (_clean(loaded, number_of(lexicon, unknown)) for lexicon in loaded.told.lexicons)
        rows.append((head, *(cell(factor * each, DIGITS) for each in found)))
    yield Table(
        tr("Reactions of group {name} at the positions", name=name),
        (tr("Unknown"), *loaded.labels),
        tuple(rows),
        solution,
    )


def _in(each: Equations, unknown: str) -> bool:
    return any(term.unknown == unknown for terms in each.terms.values() for term in terms)


def _coefficients(loaded: Loaded, each: Equations, unknowns: list[str]) -> Table:
    """The coefficients of the equations of a link at the shown positions."""
    rows = []
    for place, label in zip(loaded.told.places, loaded.labels, strict=True):
        for which in SUMS:
            known = each.known(which)
            right = -number_of(place.lexicon, known) if known else 0.0
            cells = []
            for unknown in unknowns:
                own = [term for term in each.terms[which] if term.unknown == unknown]
                found = sum(term.sign * value_of(read(term.factor).sides[0], place.lexicon, "") for term in own)
                cells.append(cell(found if abs(found) > STILL else 0.0, COEFFICIENTS))
            rows.append((f"${each.left(which)}$ ({label})", *cells, cell(_clean(loaded, right), DIGITS)))
    head = (tr("Equation"), *(f"${unknown}$" for unknown in unknowns), "$b$")
    caption = tr("Coefficients of the equations of link {link}", link=each.link)
    return Table(caption, head, tuple(rows), f"forces_system_{each.link}")


def _clean(loaded: Loaded, value: float) -> float:
    """A force or a moment without what is rounding."""
    return value if abs(value) > NOTHING * max(loaded.largest) else 0.0


def _checks(loaded: Loaded, equations: list[Equations]) -> Iterator[Block]:
    """The equations with the unknowns that were found."""
    texts = []
    for each in equations:
        for lexicon, bodies in zip(loaded.told.lexicons, loaded.bodies, strict=True):
            body = bodies[each.link]
            left = complex(body.vertices[-1])
            pole = complex(number_of(lexicon, f"x_{{{each.pole}}}"), number_of(lexicon, f"y_{{{each.pole}}}"))
            moment = sum(float(cross(f.at - pole, f.value)) for f in body.forces) + sum(c.value for c in body.couples)
            about = tr("sum of the moments on link {link} about {point}", link=each.link, point=each.pole)
            along = tr("sums of the projections of the forces on link {link}", link=each.link)
            lexicon |= named(
                {
                    each.left("x"): Given(left.real, "N", along),
                    each.left("y"): Given(left.imag, "N", along),
                    each.left("M"): Given(moment, "N*m", about),
                }
            )
        for which in SUMS:
            terms = " ".join(term.text for term in each.terms[which]).removeprefix("+ ")
            known = each.known(which)
            texts.append(f"{each.left(which)} = {terms}{known and f' + {known}'}")
    yield Paragraph(tr("With the unknowns that were found every equation holds:"))
    yield from loaded.lines(texts)
