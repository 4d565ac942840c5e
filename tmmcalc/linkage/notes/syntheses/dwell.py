"""The six-bar with a dwell: three positions in closed form, its output, the search, criteria and motion."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.linkage.notes.syntheses.dwellchoices import FRAME, choices, part_rule
from tmmcalc.linkage.notes.syntheses.dwellsearch import criteria, searched
from tmmcalc.linkage.notes.syntheses.positions import by_lengths, by_positions
from tmmcalc.linkage.notes.syntheses.told import Told, angle, length, quantity_of, ratio, turned
from tmmcalc.linkage.pictures.dwell import draw_dwelling, draw_forces, draw_motion
from tmmcalc.linkage.synthesis.dwell.columns import USUAL, columns_of
from tmmcalc.linkage.synthesis.dwell.parameters import by_rule
from tmmcalc.linkage.synthesis.dwell.results import Dwell
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.manuscript import Block, Display, Figure, Heading, Paragraph, Result, Table
from tmmcalc.report.telling import WIDE, cell, column_of, numeral, tabulated

SCHEME, DIAGRAMS = 105.0, 122.0  # heights of the pictures [mm]
MAXIMA = {"S'": "S'", "S''": "S''", "f3": "R_35", "f4": "R_45", "R21": "R_21", "N": "N", "delta": "delta"}
COLUMNS = {
    "phi": "phi",
    "S": "S",
    "dS": "S'",
    "d2S": "S''",
    "x_B": "x_B",
    "y_B": "y_B",
    "R35": "R_35",
    "R45": "R_45",
    "R21": "R_21",
    "N": "N",
    "delta": "delta",
    "M_1": "M_1",
}


def task(told: Told) -> str:
    """What is sought."""
    asked: DwellTask = told.asked
    output = (
        tr("a slider (link 5) that stands while the crank turns by $phi_B$")
        if asked.output == "slider"
        else tr("a rocker (link 5) that stands while the crank turns by $phi_B$")
    )
    return tr(
        "A six-bar linkage of class IV is sought with {output}: crank $OA$ (1), coupler $ACD$ (2), bars $CB$ (3) and "
        "$DE$ (4), whose pins $B$ and $E$ are on link 5. While link 5 stands, $OACB$ is a four-bar linkage, and $D$ "
        "is to pass three times through a circle about $E$.",
        output=output,
    )


def given(told: Told) -> dict[str, Given]:
    """What is asked."""
    asked: DwellTask = told.asked
    p, rocks = asked.positions, asked.output == "rocker"
    part = tr("part of the distance OB")
    words = {letter: each.meaning for letter, each in told.lexicon.items()}
    found = {"phi_B": angle(asked.dwell, words["phi_B"])}
    for name, value in (
        ("phi_12", p.phi12),
        ("psi_0", p.psi0),
        ("psi_12", p.psi12),
        ("psi_13", p.psi13),
        ("alpha", p.alpha),
    ):
        if value is not None:
            found[name] = angle(value, words[name])
    for name, value, said in (("CB", p.bar, words["l_CB"]), ("CD", p.side, words["l_CD"])):
        if value is not None:
            found[f"lambda_{name}"] = ratio(value, f"{said}, {part}")
    if asked.lengths is not None:
        for name, value in (
            ("OA", asked.lengths.crank),
            ("AC", asked.lengths.coupler),
            ("CB", asked.lengths.bar),
            ("CD", asked.lengths.side),
        ):
            found[f"lambda_{name}"] = ratio(value, f"{words[f'l_{name}']}, {part}")
        found["alpha"] = angle(asked.lengths.alpha, words["alpha"])
        found["phi_0"] = angle(asked.lengths.phi0, words["phi_0"])
        found["phi_12"] = angle(asked.lengths.phi12, words["phi_12"])
    if asked.n is not None:
        found["n"] = ratio(asked.n, words.get("n", ""))
    if asked.working_angle is not None:
        found["phi_t"] = angle(asked.working_angle, tr("turn of the crank on the stroke towards the dwell"))
    if asked.swing is not None:
        found["Theta"] = angle(asked.swing, tr("swing of the rocker, asked"))
    if asked.pivot is not None:
        found["xi_F"] = ratio(asked.pivot.real, f"{words['x_F']}, {part}")
        found["eta_F"] = ratio(asked.pivot.imag, f"{words['y_F']}, {part}")
    if asked.stroke is not None:
        found["h"] = length(asked.stroke, tr("stroke of the slider"))
    if asked.frame is not None:
        found["l_OB"] = length(asked.frame, words["l_OB"])
    found["F_u"] = Given(asked.resistance, "N*m" if rocks else "N", tr("resistance on the output"))
    return found


def further(told: Told) -> Iterator[Block]:
    """Choices of output and strokes, what is sought by a search."""
    yield from choices(told.asked)


def blocks(told: Told) -> Iterator[Block]:
    """The search where there is one, the scale, the three positions, the output."""
    asked: DwellTask = told.asked
    if asked.optimum is not None:
        yield from searched(told, asked)
    yield from _scale(told, asked)
    yield Heading(tr("Three positions at dwell"), 3)
    yield from by_positions(told, asked) if asked.lengths is None else by_lengths(told, asked)
    yield Heading(tr("Output link"), 3)
    yield from _rocker(told, asked) if asked.output == "rocker" else _slider(told, asked)


def _scale(told: Told, asked: DwellTask) -> Iterator[Block]:
    """The distance of O from B at dwell."""
    dwell = _dwell(told)
    if asked.stroke is not None:
        scale = told.design.size("l_OB")
        said = tr("stroke over the distance OB, by the motion of the linkage")
        told.give({"h_1": ratio(dwell.stroke / scale, said)})
        yield Paragraph(tr("The stroke gives the scale; with $l_OB = 1$ m it is $h_1$ times 1 m:"))
        yield from told.lines("l_OB = h/h_1")
    elif asked.frame is None:
        yield Paragraph(tr("Nothing gives the scale: the distance of the pivot $O$ from $B$ at dwell is taken as 1 m."))


def _dwell(told: Told) -> Dwell:
    assert told.design.dwell is not None
    return told.design.dwell


def _division(told: Told, asked: DwellTask) -> Iterator[Block]:
    """The part of the dwell at which the output moves along the crank, by the rule and corrected."""
    if asked.working_angle is None or asked.n is not None:
        return
    rule = by_rule(asked)
    assert rule is not None
    said = tr("part of the dwell after which the output moves along the crank, by the rule")
    told.give({"n^{(0)}": ratio(rule, said)})
    yield Paragraph(tr("The turn of the crank on the stroke towards the dwell gives the part $n$ nearly:"))
    yield from told.lines(f"n^{{(0)}} = {part_rule(asked)}")
    if asked.exact:
        yield Paragraph(
            tr(
                "From there $n$ is corrected by secants, a whole turn of the linkage each time, until the stroke "
                "takes this angle: $n = {value}$.",
                value=numeral(told.design.size("n"), 7),
            )
        )


def _slider(told: Told, asked: DwellTask) -> Iterator[Block]:
    """The direction of the guide."""
    yield Paragraph(
        tr("The slider moves along the crank at the part $n$ of the dwell, which divides the turn into the strokes.")
    )
    yield from _division(told, asked)
    yield Paragraph(tr("The guide of the slider and the sense in which $S$ grows:"))
    yield from told.lines("q = phi_0 + n*phi_B" + " + deg(180)" * asked.reverse)


def _rocker(told: Told, asked: DwellTask) -> Iterator[Block]:
    """The pivot of the rocker, its sides."""
    if asked.pivot is not None:
        yield Paragraph(tr("The pivot $F$ of the rocker is given:"))
        if told.design.size("l_OB") != 1.0:
            yield from told.lines("x_F = xi_F*l_OB", "y_F = eta_F*l_OB")
    else:
        yield Paragraph(
            tr(
                "The pivot $F$ of the rocker stands across the crank at the part $n$ of the dwell; its swing gives "
                "the frame nearly:"
            )
        )
        yield from _division(told, asked)
        rule = told.design.size("l_OA") / math.sin((asked.swing or math.nan) / 2)
        told.give({"l_OF^{(0)}": length(rule, tr("frame by the rule of the swing"))})
        yield from told.lines(f"l_OF^{{(0)}} = {FRAME}")
        if asked.exact:
            yield Paragraph(
                tr(
                    "From there $l_OF$ is corrected by secants, a whole turn of the linkage each time, until the "
                    "swing is met: $l_OF = {value}$ m.",
                    value=numeral(told.design.size("l_OF"), 7),
                )
            )
        across = np.exp(1j * (told.design.size("phi_0") + told.design.size("n") * asked.dwell))
        left = (complex(told.design.size("x_F"), told.design.size("y_F")) * np.conj(across)).imag > 0
        sign = "+" if left else "-"
        yield from told.lines(
            f"x_F = l_OF*cos(phi_0 + n*phi_B {sign} deg(90))", f"y_F = l_OF*sin(phi_0 + n*phi_B {sign} deg(90))"
        )
    if asked.pivot is not None:
        yield from told.lines("l_OF = sqrt(x_F**2 + y_F**2)")
    yield from told.lines("l_BF = sqrt((l_OB - x_F)**2 + y_F**2)", "l_EF = sqrt((x_E - x_F)**2 + (y_E - y_F)**2)")


def conditions(told: Told) -> Iterator[Block]:
    """The motion over a turn, dwell and strokes, largest values, criteria, the other methods, the pictures."""
    asked, dwell = told.asked, _dwell(told)
    yield from _moving(told, dwell)
    yield from _strokes(told, dwell)
    yield Paragraph(tr("The largest values over the turn are in table {tab:synthesis_maxima}."))
    yield _maxima(dwell)
    yield from criteria(told, asked, dwell)
    yield from _agreement(dwell)
    yield from _table(dwell)
    yield from _pictures(told, dwell)


def _moving(told: Told, dwell: Dwell) -> Iterator[Block]:
    """How the motion is followed."""
    yield Paragraph(
        tr(
            "The position has two unknown, the angle $theta$ of $AC$ and the coordinate $S$ of link 5, zero at dwell. "
            "The lengths of both bars close it:"
        )
    )
    yield Display(read("(x_C - x_B)**2 + (y_C - y_B)**2 = l_CB**2"))
    yield Display(read("(x_D - x_E)**2 + (y_D - y_E)**2 = l_DE**2"))
    yield Paragraph(
        tr(
            "From position 1 on the turn of the crank is followed by Newton’s method; the determinant of its system "
            "keeps its sign, so the crank turns fully without a singular position, and after a turn the linkage is "
            "where it was. In positions 1, 2 and 3, at $phi$ of {positions}, $S = 0$.",
            positions=", ".join(_degrees(at) for at in dwell.positions),
        )
    )


def _degrees(value: float) -> str:
    return turned(math.degrees(value))


def _strokes(told: Told, dwell: Dwell) -> Iterator[Block]:
    """The extremes, the deviation over the dwell, the strokes by the crank."""
    rocks = dwell.output == "rocker"
    unit = "rad" if rocks else "m"
    stroke, rest = ("Theta", "S_B") if rocks else ("h", "S_B")
    ends = sorted(dwell.extremes, key=lambda each: each.value)
    told.give(
        {
            stroke: quantity_of(
                dwell.stroke, unit, tr_name("swing of the rocker") if rocks else tr("stroke of the slider")
            ),
            "S_g": quantity_of(ends[-1].value, unit, tr("largest coordinate of link 5")),
            "S_k": quantity_of(ends[0].value, unit, tr("least coordinate of link 5")),
            rest: quantity_of(dwell.dwell_error, unit, tr("largest deviation over the dwell")),
            "f_1": ratio(dwell.dwell_ratio, tr("deviation over the dwell as a part of the stroke")),
        }
    )
    rows = [
        (_degrees(each.at), column_of([math.degrees(each.value) if rocks else each.value])[0])
        for each in dwell.extremes
    ]
    head = "$phi$", f"$S$, {tr_unit('deg' if rocks else 'm')}"
    yield Paragraph(tr("Table {tab:synthesis_extremes} has the positions in which link 5 turns back."))
    yield Table(tr("Positions in which link 5 turns back"), head, tuple(rows), "synthesis_extremes")
    yield from told.lines(f"{stroke} = S_g - S_k", f"f_1 = {rest}/{stroke}")
    (begin, end), (back, over) = dwell.working, dwell.idle
    yield Paragraph(
        tr(
            "The working stroke takes the crank from $phi$ = {begin} to {end}, the idle one from {back} to {over}.",
            begin=_degrees(begin),
            end=_degrees(end),
            back=_degrees(back),
            over=_degrees(over),
        )
    )
    yield Result(stroke, told.lexicon[stroke])
    yield Result("f_1", told.lexicon["f_1"])


def _maxima(dwell: Dwell) -> Block:
    """Largest values of the motion and of the forces."""
    rows = []
    for each in dwell.maxima:
        found = quantity_of(each.value, each.unit, "")
        assert isinstance(found.value, float)
        rows.append(
            (
                f"${MAXIMA[each.name]}$",
                "°" if found.unit == "deg" else tr_unit(found.unit),
                cell(found.value),
                _degrees(each.at),
            )
        )
    head = tr("Quantity"), tr("Unit"), tr("largest size"), "$phi$"
    return Table(tr("Largest values over the turn"), head, tuple(rows), "synthesis_maxima")


def _agreement(dwell: Dwell) -> Iterator[Block]:
    """The other methods."""
    found = dwell.agreement
    yield Paragraph(
        tr(
            "The kinematic and the force analysis of the whole mechanism give the same: differences of {motion} and "
            "{forces} of the largest values.",
            motion=cell(found.motion, 1),
            forces=cell(found.forces, 1),
        )
    )
    cross = dwell.cross_check
    if cross is not None:
        yield Paragraph(
            tr(
                "The method of the relative trajectory (link 5 held, the crank pin moved along its slot $Gamma$) with "
                "{steps} steps of the arc deviates by {uniform} of the stroke, with the steps closer at the ends by "
                "{cosine}.",
                steps=cross.steps,
                uniform=cell(cross.uniform, 3),
                cosine=cell(cross.cosine, 3),
            )
        )


def _table(dwell: Dwell) -> Iterator[Block]:
    """All positions, in two tables."""
    every = {column.name: column for column in columns_of(dwell.motion, dwell.output)}
    shown = [every[name] for name in USUAL if name in every]
    halves = shown[:6], [shown[0], *shown[6:]]
    yield Paragraph(tr("Tables {tab:synthesis_motion} and {tab:synthesis_forces} have all positions."))
    captions = tr("Motion of the linkage"), tr("Forces of the linkage against the resistance")
    for columns, caption, key in zip(halves, captions, ("synthesis_motion", "synthesis_forces"), strict=True):
        found = {
            f"${COLUMNS[each.name]}$" + (f", {each.unit}" if each.unit not in ("", "-") else ""): each.make()
            for each in columns
        }
        yield tabulated(caption, found, dwell.motion.labels, head=tr("Position"), key=key)


def _pictures(told: Told, dwell: Dwell) -> Iterator[Block]:
    """The linkage at dwell, diagrams of motion and forces."""
    mechanism = to_linkage(told.order.read(told.design.spec).linkage)
    yield Paragraph(
        tr(
            "Figure {fig:synthesis} shows the linkage in position 1 with both branches of $Gamma$, figures "
            "{fig:synthesis_motion} and {fig:synthesis_forces} motion and forces over the turn of the crank, the "
            "dwell shaded."
        )
    )
    yield Figure(
        tr("The linkage that was found"),
        partial(draw_dwelling, mechanism=mechanism, dwell=dwell),
        (WIDE, SCHEME),
        "synthesis",
    )
    yield Figure(tr("Motion of the output"), partial(draw_motion, dwell=dwell), (WIDE, DIAGRAMS), "synthesis_motion")
    yield Figure(
        tr("Forces and driving moment"), partial(draw_forces, dwell=dwell), (WIDE, DIAGRAMS), "synthesis_forces"
    )
