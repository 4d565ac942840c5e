"""The least size of a cam under a stem with a roller: lines that bound the places of its axis, the textbook's rule.

A line for each sign of the pressure angle on each phase whose angle is limited: S_0 >= b + or - e/tan(theta_P), where b
is the largest value of the phase. In the user's sense the sign of e is that of the line times that of the cam.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isclose, tan
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.notes.lexicon import Told, degrees_of, mm, of_motion
from tmmcalc.cams.pressure.angle import limited_phases
from tmmcalc.cams.synthesis import translatingsizes
from tmmcalc.cams.synthesis.completion import ANGLE
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Display, Lexicon, Paragraph, Place
from tmmcalc.report.telling import lines, named, number_of

ANGLES = {"rise": "theta_P", "return": "theta_{Pc}"}
ON = 1e-9  # of S0: a point this near to a line lies on it
SAME = 1e-9  # displacements at the largest velocities that are the same
BASE = "R_0 = sqrt(S_0**2 + e**2)"
SHAFT, SHAFT_AND_ROLLER = "R_0 = r_1/(1 - 0.4)", "R_0 = r_1 + r_2"  # a roller that is to be found may have 0.4 R0
REST = 1e-15  # [m] a line through the axis of the cam, that of rest


class Bound(NamedTuple):
    """One of the lines."""

    number: int
    kind: str  # rise or return
    line: translatingsizes.Line

    @property
    def rests(self) -> bool:
        """Whether it is that of rest, without a height."""
        return abs(self.line.height) <= REST

    @property
    def slope(self) -> str:
        """Its slope in the canonical frame as a formula, with its sign."""
        return f"1/tan({ANGLES[self.kind]})"


def told_stem(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """The condition, its lines, the textbook's sizes, the sizes taken."""
    words = told.words
    yield Paragraph(tr("The pressure angle follows from the position and the analogue of velocity:"))
    yield Display(read(f"tan(theta) = (S' {words['+']} e)/(S_0 + DeltaS)"))
    yield Paragraph(
        tr(
            "It keeps its limit where $abs(S' {sign} e) <= (S_0 + DeltaS)*tan(theta_P)$, so that each phase asks for "
            "a least distance $S_0$, which depends on the offset $e$:",
            sign=words["+"],
        )
    )
    every = _bounds(told)
    e = result.follower.offset
    start = translatingsizes.least_start(tuple(each.line for each in every), e)
    lexicon["S_0P"] = mm(start, tr("least distance by the pressure angle"))
    shown = [each._replace(number=k) for k, each in enumerate((b for b in every if _shown(b, (e, start))), 1)]
    for each in shown:
        yield from _height(told, each, lexicon)
    yield from _textbook(told, lexicon)
    yield from _taken(told, result, shown, lexicon)


def stem_base(told: Told, result: Synthesis, lexicon: Lexicon) -> Iterator[Block]:
    """The base circle, and where the shaft decides it the start distance."""
    asked, place = told.task.asked, [Place("", lexicon)]
    if result.governs == "shaft":
        yield from lines((SHAFT if asked.roller is None else SHAFT_AND_ROLLER, "S_0 = sqrt(R_0**2 - e**2)"), place)
    elif asked.base is None:
        yield from lines((BASE if result.follower.offset else "R_0 = S_0",), place)


def _bounds(told: Told) -> list[Bound]:
    """The lines with the phases that they belong to."""
    kinds = [kind for kind, *_ in limited_phases(told.task) for _ in (1, -1)]
    found = translatingsizes.lines_of(told.task)
    return [Bound(k, kind, line) for k, (kind, line) in enumerate(zip(kinds, found, strict=True), 1)]


def _shown(each: Bound, point: translatingsizes.Point) -> bool:
    """Whether a line is told: that of the velocity of its phase, and each through the point taken."""
    e, start = point
    along = each.line.side > 0 if each.kind == "rise" else each.line.side < 0
    return along or abs(each.line.at(e) - start) <= ON * abs(start)


def _height(told: Told, each: Bound, lexicon: Lexicon) -> Iterator[Block]:
    """What a line asks of S0 without an offset, at its place, and the line itself."""
    sign = "" if each.line.side > 0 else "-"
    phi = each.line.phi
    y, first = _at(told, each)
    own = of_motion(told, 0)
    name = f"b_{each.number}"
    at = {"<dy>": mm(y, own["<dy>"].meaning), "<y>'": mm(first, own["<y>'"].meaning)}
    said = tr("bound {number} of the start distance without offset", number=each.number)
    lexicon |= named({name: mm(each.line.height, said)})
    place = Place(tr("at φ = {angle}°", angle=degrees_of(phi)), lexicon | told.named(at))
    if each.rests:
        yield Paragraph(tr("Where the follower is at rest:"))
    else:
        yield Paragraph(tr("On the rise:") if each.kind == "rise" else tr("On the return:"))
    if not each.rests:
        yield from lines((f"{name} = {sign}S'/tan({ANGLES[each.kind]}) - DeltaS",), [place])
    yield Display(read(f"S_0 >= {_bound(told, each)}"))


def _bound(told: Told, each: Bound) -> str:
    """What a line asks of S0; at rest it passes the axis of the cam."""
    sign, asked = _sign(told, each), f"e/tan({ANGLES[each.kind]})"
    if each.rests:
        return asked if sign == "+" else f"-{asked}"
    return f"b_{each.number} {sign} {asked}"


def _sign(told: Told, each: Bound) -> str:
    """The sign of the offset in a line, in the user's sense."""
    return "+" if each.line.side * told.follower.sense > 0 else "-"


def _at(told: Told, each: Bound) -> tuple[float, float]:
    """Displacement and analogue of velocity where the line is highest, on the side of a jump that has it."""
    program, phi = told.task.program, each.line.phi
    near = np.flatnonzero((program.edges[:-1] <= phi + 1e-9) & (phi - 1e-9 <= program.edges[1:]))
    every = program.at(np.full(near.size, phi), near)
    limit = told.task.limits.rise if each.kind == "rise" else told.task.limits.back
    assert limit is not None
    heights = each.line.side * every[1] / tan(limit) - every[0]
    best = int(np.argmin(np.abs(heights - each.line.height)))
    return float(every[0, best]), float(every[1, best])


def _textbook(told: Told, lexicon: Lexicon) -> Iterator[Block]:
    """The textbook's sizes, as if the limits were reached where the velocity is largest."""
    tops = translatingsizes.velocity_tops(told.task)
    e, start = translatingsizes.textbook(told.task, None)
    yield Paragraph(
        tr(
            "If the limits were reached where the velocity is largest, the sizes would be, by the textbook’s "
            "approximate formulas:"
        )
    )
    lexicon |= named(
        {
            "S_0^{*}": mm(start, tr("approximate least distance")),
            "e^{*}": mm(told.follower.sense * e + 0.0, tr("approximate best offset")),
        }
    )
    for k, (_, y, speed) in zip("yc", tops, strict=False):
        sign = 1 if k == "y" else -1
        word = tr("on the rise") if k == "y" else tr("on the return")
        lexicon[f"S'_{k}"] = mm(sign * speed, tr("analogue of velocity of largest size {phase}", phase=word))
        lexicon[f"DeltaS_{k}"] = mm(y, tr("displacement there {phase}", phase=word))
    place, plus = [Place("", lexicon)], told.words["+"]
    if len(tops) == 1:
        texts = ["S_0^{*} = S'_y/tan(theta_P) - DeltaS_y"]
    elif told.task.limits.rise == told.task.limits.back and isclose(tops[0][1], tops[1][1], rel_tol=SAME):
        texts = [
            f"e^{{*}} = {'-' if plus == '+' else ''}(S'_y + S'_c)/2",
            "S_0^{*} = (S'_y - S'_c)/(2*tan(theta_P)) - DeltaS_y",
        ]
    else:
        texts = [
            f"e^{{*}} = {'' if plus == '+' else '-'}(DeltaS_y - DeltaS_c - S'_c/tan(theta_{{Pc}}) - S'_y/tan(theta_P))"
            "/(1/tan(theta_P) + 1/tan(theta_{Pc}))",
            f"S_0^{{*}} = (S'_y {plus} e^{{*}})/tan(theta_P) - DeltaS_y",
        ]
    yield from lines(texts, place)


def _taken(told: Told, result: Synthesis, shown: list[Bound], lexicon: Lexicon) -> Iterator[Block]:
    """The exact sizes, in the order in which what is given settles them."""
    asked, e, place = told.task.asked, result.follower.offset, [Place("", lexicon)]
    free = asked.start is None and asked.base is None
    if asked.offset is None and not free:
        yield from lines((f"e = {'-' * (told.follower.sense * e < 0)}sqrt(R_0**2 - S_0**2)",), place)
    if asked.start is None and asked.base is not None:
        yield from lines(("S_0 = sqrt(R_0**2 - e**2)",), place)
    start = number_of(lexicon, "S_{0P}") / 1e3
    on = [each for each in shown if abs(each.line.at(e) - start) <= ON * abs(start)]
    first = on[0]
    if asked.offset is None and free:
        yield Paragraph(tr("The base circle is least at this place of the region:"))
        yield from _corner(told, on, lexicon)
    else:
        yield Paragraph(tr("With this offset the larger of the bounds counts:"))
    yield from lines((f"S_{{0P}} = {_bound(told, first)}",), place)
    if not free:
        if told.follower.start >= start * (1 - ON):
            yield Paragraph(tr("$S_0$ is not less: the pressure angle keeps its limits."))
        else:
            yield Paragraph(tr("$S_0$ is less: the pressure angle exceeds its limit."))
    elif result.governs == ANGLE:
        yield Paragraph(tr("This distance is taken: $S_0 = S_{0P}$."))


def _corner(told: Told, on: list[Bound], lexicon: Lexicon) -> Iterator[Block]:
    """The best offset: where two lines cross, or at the foot of one."""
    place = [Place("", lexicon)]
    if len({each.line.slope for each in on}) == 1:
        only = on[0]
        limit = ANGLES[only.kind]
        sign = "-" if _sign(told, only) == "+" else ""
        yield from lines((f"e = {sign}b_{only.number}*sin({limit})*cos({limit})",), place)
        return
    on = sorted(on, key=lambda each: _sign(told, each) != "+")
    first, second = on[0], next(each for each in on if each.line.slope != on[0].line.slope)
    sign = "+" if _sign(told, second) == "-" else "-"
    slopes = f"{'' if _sign(told, first) == '+' else '-'}{first.slope} {sign} {second.slope}"
    yield from lines((f"e = ({_difference(second, first)})/({slopes})",), place)


def _difference(first: Bound, second: Bound) -> str:
    """What two lines ask for without offset, one less the other."""
    own = "" if first.rests else f"b_{first.number}"
    return own if second.rests else f"{own} - b_{second.number}".strip()
