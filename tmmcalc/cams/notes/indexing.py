"""The indexing drive: what is given, limits, profiles, pressure angles, rollers, efficiency, its pictures."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial

from tmmcalc.cams.indexing.laws import CODE
from tmmcalc.cams.indexing.results import Indexing
from tmmcalc.cams.notes.laws import named_title
from tmmcalc.cams.notes.lexicon import quantities_table
from tmmcalc.cams.notes.stepping.efficiency import efficiency
from tmmcalc.cams.notes.stepping.flanks import flanks, shown_rows
from tmmcalc.cams.notes.stepping.limits import limits
from tmmcalc.cams.notes.stepping.quantities import Stepping, stepping_of
from tmmcalc.cams.notes.stepping.rollers import rollers
from tmmcalc.cams.pictures.indexing import draw_drive
from tmmcalc.cams.pictures.indexingstep import draw_step
from tmmcalc.cams.tables.tasks.indexing import to_indexing
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.formula.digits import digits_given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Figure, Heading, Paragraph
from tmmcalc.report.telling import WIDE, as_given, numeral

GIVEN = ("z_2", "phi_p", "phi_d1", "l_k", "theta_d", "f_1", "f_2", "r_c")
ENDS = re.compile(r"constant ends of (\S+) %")
NAMES = (1.0, 3.0, 2.0, 0.0)  # room that names of axes take beside diagrams, all around [mm]
SCHEME, STEP = 85.0, 140.0  # heights of the pictures [mm]


def blocks(order: Order) -> Iterator[Block]:
    """The drive of the spec; of a law that is known by its B alone the limits."""
    of = stepping_of(to_indexing(order.spec), order.results["indexing"])
    yield Heading(tr("Cam-lantern indexing drive"))
    yield from _data(of)
    yield from limits(of)
    cam = of.found.cam
    if cam is None:
        yield Paragraph(tr("The law is known by $B$ alone, so the drive has no profiles here."))
        return
    rows = shown_rows(of, order)
    yield from flanks(of, cam, rows)
    yield from rollers(of, cam)
    yield from _pictures(of)
    yield from efficiency(of, cam, rows)


def _data(of: Stepping) -> Iterator[Block]:
    """What is given, and the law."""
    yield Paragraph(
        tr(
            "Two cams on the axis $O_1$ turn the wheel on the axis $O_2$ by one pitch of its rollers in every "
            "step, two steps in a turn. The given data are in table {tab:indexing_data}."
        )
    )
    yield quantities_table(tr("Given data of the indexing drive"), given_names(of), of.lexicon, "indexing_data")
    yield from _law(of.found)


def given_names(of: Stepping) -> list[str]:
    """The names of what is given."""
    task = of.task
    names = [name for name in GIVEN if name != "r_c" or task.shaft]
    names += [*["a"] * (task.ratio is not None), *["r_r"] * (task.roller is not None)]
    return names + ["r_r2"] * (task.second_roller is not None)


def _law(found: Indexing) -> Iterator[Block]:
    """The law of the step by its name and its largest velocity."""
    peak = numeral(found.peak)
    if found.cam is None:
        yield Paragraph(tr("Of the law of the step its largest derivative $B = {peak}$ is given.", peak=peak))
    else:
        yield Paragraph(tr("Law of the step: {law}; $B = {peak}$.", law=_law_name(found.law), peak=peak))


def law_name(found: Indexing) -> str:
    """The law of the step; of one that is known by its B alone that."""
    return _law_name(found.law) if found.cam is not None else f"$B = {numeral(found.peak, digits_given(found.peak))}$"


def _law_name(name: str) -> str:
    """A law of the catalogue, one with constant ends by its code or its part, or one of one's own."""
    ends = CODE.fullmatch(name) or ENDS.fullmatch(name)
    if ends is None:
        return named_title(name)
    return tr("acceleration that is constant over {part} % of the step at each end", part=as_given(float(ends[1])))


def _pictures(of: Stepping) -> Iterator[Block]:
    """The drive to scale at the start of a step, and the diagrams over the step."""
    found, cam, drive = of.found, of.found.cam, of.drive
    assert drive is not None
    assert cam is not None

    def step(drawing: Drawing, box: Box) -> None:
        draw_step(drawing, box.inset(*NAMES), drive, found, cam)

    yield Paragraph(
        tr(
            "Figure {fig:indexing_scheme} shows the drive at the start of a step, figure {fig:indexing_step} its "
            "motion, pressure angles, the polar angles whose curves meet at the tip, and the efficiency."
        )
    )
    scheme = partial(draw_drive, task=of.task, result=found, phase=0.0)
    yield Figure(tr("Indexing drive at the start of a step"), scheme, (WIDE, SCHEME), "indexing_scheme")
    yield Figure(tr("Diagrams over one step of the wheel"), step, (WIDE, STEP), "indexing_step")
