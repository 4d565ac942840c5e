"""Zhukovsky's lever: moments of the given forces about the pole of the turned plan, the drive that balances them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.linkage.forces.results import side_of
from tmmcalc.linkage.freebody import Acting, Couple
from tmmcalc.linkage.lever import LEAST_ARM, Lever, LeverForce, levers, replaced_at, working
from tmmcalc.linkage.notes.group import plain_name
from tmmcalc.linkage.notes.statics.loaded import Loaded, printed_head, said
from tmmcalc.linkage.pictures.lever import draw_lever, lever_scale
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.symbols import canonical
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Paragraph, Table
from tmmcalc.report.telling import WIDE, cell, located, named

HIGH = {0: 105.0, 12: 165.0}  # height of the picture from so many forces on [mm]
KEY = "forces_lever"
DIGITS = 5  # of a number in the table


def lever(loaded: Loaded) -> Iterator[Block]:
    """What is done, the pairs of forces in place of couples, the moments, the drive, the difference."""
    told, row, result = loaded.told, loaded.rows[0], loaded.result
    at = result.theta[[*loaded.rows]], np.array([side_of(result, each) for each in loaded.rows])
    count = len(working(levers(loaded.statics, told.result, *at, 1.0)[0].forces))
    size = WIDE, HIGH[max(least for least in HIGH if least <= count)]
    mu = lever_scale(Box(0.0, 0.0, *size), loaded.statics, told.result, result, row)
    found = levers(loaded.statics, told.result, *at, mu)
    if not any(working(each.forces) for each in found):
        return
    yield Heading(tr("Lever of Zhukovsky"), 2)
    yield Paragraph(
        tr(
            "The force analysis is checked by the lever of Zhukovsky: the plan of velocities is turned by 90° "
            "clockwise (figure {figure}), every given force is applied at the end of the velocity of its point, and "
            "the moments of all forces about the pole sum up to zero with that of the balancing one. Reactions do no "
            "work together and stay away. A couple acts as a pair of forces at two points of its link; in the figure "
            "it is marked as the couple over the distance of the points, $M_k/l_k$.",
            figure=f"{{fig:{KEY}}}",
        )
    )
    yield from _pairs(loaded, found)
    caption = tr("Lever of Zhukovsky {place}", place=told.there(0))
    draw = partial(draw_lever, statics=loaded.statics, kinematics=told.result, result=result, row=row, tabled=False)
    yield Figure(caption, draw, size, KEY)
    tables = [_table(loaded, each, k) for k, each in enumerate(found)]
    said = tr(
        "The forces with their arms and moments about the pole are {where}; those that pass through the pole have "
        "none.",
        where=located(tables),
    )
    yield Paragraph(said)
    yield from tables
    yield from _drive(loaded, found)


def _pairs(loaded: Loaded, found: Sequence[Lever]) -> Iterator[Block]:
    """The forces that stand for the couples, the first by its formula."""
    texts = []
    mechanism = loaded.told.chain.mechanism
    seen = dict.fromkeys((f.link, f.name, f.kind) for each in found for f in working(each.forces) if f.point)
    for link, name, kind in seen:
        (tail, a), (head, b) = replaced_at(mechanism, link)
        points = plain_name(tail) + plain_name(head)
        distance = tr("distance between points {first} and {second}", first=plain_name(tail), second=plain_name(head))
        for lexicon, each, bodies in zip(loaded.told.lexicons, found, loaded.bodies, strict=True):
            couple = next(c for c in bodies[link].couples if (f"{c.letter}{c.index}", c.kind) == (name, kind))
            force = next((f.force for f in each.forces if (f.link, f.name, f.kind) == (link, name, kind)), 0.0)
            key = loaded.key(couple)
            pair = tr("force of the pair that stands for a couple")
            lexicon |= named(
                {
                    key: Given(couple.value, "N*m", said(loaded, couple)),
                    f"l_{{{points}}}": Given(abs(b - a), "m", distance),
                    _pair_name(key): Given(force, "N", pair),
                }
            )
        texts.append(f"{_pair_name(key)} = abs({key})/l_{{{points}}}")
    yield from loaded.lines(texts[:1])
    if texts[1:]:
        yield Paragraph(tr("The forces of the other pairs are found in the same way."))


def _pair_name(key: str) -> str:
    """The force that stands for a couple: ``F_{M4}``."""
    return f"F_{{{''.join(letter for letter in key if letter not in '_{}')}}}"


def _name(loaded: Loaded, force: LeverForce) -> str:
    """The name of a force on the lever in the table, with the point of one of a pair."""
    parts: list[Acting | Couple] = []
    for body in (each[force.link] for each in loaded.bodies):
        parts += body.couples if force.point else body.forces
    key = loaded.key(next(p for p in parts if (f"{p.letter}{p.index}", p.kind) == (force.name, force.kind)))
    return f"${_pair_name(key)}$, {plain_name(force.point)}" if force.point else f"${key}$"


def _table(loaded: Loaded, found: Lever, k: int) -> Table:
    """The forces of a lever that have an arm."""
    forces = [force for force in working(found.forces) if abs(force.arm) > LEAST_ARM]
    columns = {tr("Force"): [_name(loaded, force) for force in forces]}
    for symbol, unit, part in (("F_i", "N", "force"), ("h_i", "mm", "arm"), ("F_i*h_i", "N*mm", "moment")):
        head, factor = printed_head(symbol, unit)
        columns[head] = [cell(factor * _seen(getattr(force, part)), DIGITS) for force in forces]
    caption = tr("Moments on the lever {place}", place=loaded.told.there(k))
    return Table(caption, tuple(columns), tuple(zip(*columns.values(), strict=True)), f"{KEY}_{loaded.rows[k]}")


def _seen(value: float) -> float:
    """An arm, or a moment, without what is rounding."""
    return value if abs(value) > LEAST_ARM else 0.0


def _drive(loaded: Loaded, found: Sequence[Lever]) -> Iterator[Block]:
    """The sum of the moments, the drive that balances it, what it differs by from the force analysis."""
    result, link = loaded.result, loaded.told.result.structure.input_link
    speed = loaded.told.result.speed
    letter, unit, rate = ("M", "N*m", f"omega_{link}") if result.turns else ("F", "N", "v_d")
    what = tr("balancing moment by the lever") if result.turns else tr("balancing force by the lever")
    for lexicon, each in zip(loaded.told.lexicons, found, strict=True):
        moving = [force for force in each.forces if abs(force.arm) > LEAST_ARM]
        forces = {
            "F_i": Given([force.force for force in moving] or [0.0], "N", tr("forces on the lever")),
            "h_i": Given(
                [force.arm for force in moving] or [0.0],
                "mm",
                tr("arms of the forces, positive if they turn counter-clockwise"),
            ),
            "M_p": Given(each.moment if moving else 0.0, "N*mm", tr("sum of the moments about the pole")),
            "mu_v": Given(each.mu, "(m/s)/mm", tr("scale of the plan of velocities")),
            f"{letter}'_d": Given(each.drive if moving else 0.0, unit, what),
        }
        lexicon |= named(forces)
        if not result.turns:
            lexicon[canonical(rate)] = Given(speed, "m/s", tr("velocity of the drive"))
    yield from loaded.lines(["M_p = sum(F_i*h_i, i)", f"{letter}'_d = -M_p*mu_v/{rate}"])
    largest = max(abs(extreme.value) for extreme in result.drive_extremes) or 1.0
    apart = 100 * max(abs(each.difference) for each in found) / largest
    bound = f"$10**(-{math.floor(-math.log10(apart))})$" if apart > 1e-12 else "$10**(-12)$"
    yield Paragraph(
        tr("The difference from the force analysis does not exceed {part} % of the largest value.", part=bound)
    )
