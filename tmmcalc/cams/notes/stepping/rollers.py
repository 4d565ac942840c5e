"""How large the rollers may be, what is taken, and what it leaves of the working profile of each cam."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from tmmcalc.cams.indexing.results import Cam
from tmmcalc.cams.indexing.rollers import USUAL, governing
from tmmcalc.cams.notes.stepping.quantities import MM, Stepping, at_part
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import column_of, lines, named, numeral, plainly
from tmmcalc.report.telling import degrees as turned

NAMES = ("r_A", "r_B", "r_n", "r_t", "r_s")  # of the limits, in the order of the theory


def rollers(of: Stepping, cam: Cam) -> Iterator[Block]:
    """The limits of the radius, the radius, the working profile."""
    place = [Place("", of.lexicon | named(_limited(cam)))]
    yield Heading(tr("Rollers and working profile"), 3)
    yield Paragraph(
        tr(
            "The radius of the rollers has to stay below the limits of table {tab:indexing_rollers}: the least radius "
            "of the convex parts of each flank, half the distance of neighbours in a row, the radius with which the "
            "working lobe would end before the groove can drive, and what the groove leaves of the camshaft."
        )
    )
    yield _table(cam)
    texts = ["r_n = l_k*sin(deg(360)/z_2)", "r_s = a - l_k - r_c"]
    yield from lines(texts, place)
    yield from _taken(of, cam)
    yield from lines(["r_min = a - l_k - r_r"], [Place("", place[0].lexicon | named(_working(of, cam)))])
    yield from _bottom(of, cam)
    yield Paragraph(
        tr(
            "The working profile of flank A ends on the axis of the lobe at $k_w = {part}$, {radius} mm from $O_1$; "
            "there B takes over with a pressure angle of ${angle}$.",
            part=numeral(cam.working_part),
            radius=plainly(MM * cam.working_tip),
            angle=turned(cam.working_angle),
        )
    )
    yield from _second(of)


def _limited(cam: Cam) -> Lexicon:
    """The limits by their letters; without those that allow any roller."""
    return {
        name: Given(MM * limit.radius, "mm", _said(name))
        for name, limit in zip(NAMES, cam.roller_limits, strict=True)
        if limit.radius is not None
    }


def _said(name: str) -> str:
    return {
        "r_A": tr("least convex radius of flank A"),
        "r_B": tr("least convex radius of groove B"),
        "r_n": tr("radius at which neighbours in a row touch"),
        "r_t": tr("radius with which the working lobe ends in the middle of the step"),
        "r_s": tr("radius with which the groove reaches the camshaft"),
    }[name]


def _table(cam: Cam) -> Table:
    """Every limit with its place, and whether the rollers keep it."""
    rows = []
    for name, limit in zip(NAMES, cam.roller_limits, strict=True):
        value = tr("any") if limit.radius is None else column_of([MM * limit.radius])[0]
        part = "" if limit.radius is None or limit.part is None else column_of([limit.part], 4)[0]
        rows.append((_said(name), f"${name}$", value, part))
    head = tr("Limit"), tr("Designation"), f"{tr('Value')}, {tr_unit('mm')}", "$k$"
    return Table(tr("Limits of the radius of the rollers"), head, tuple(rows), "indexing_rollers")


def _taken(of: Stepping, cam: Cam) -> Iterator[Block]:
    """The radius that is given or chosen."""
    limit = governing(cam.roller_limits)
    name = NAMES[cam.roller_limits.index(limit)]
    lexicon = of.lexicon | named(_limited(cam))
    if of.task.roller is not None:
        yield Paragraph(tr("The radius of the rollers is given; the least limit is ${name}$.", name=name))
    elif not of.found.roller:
        yield Paragraph(tr("No roller works beside the point of the groove: the drive is told by its pitch curve."))
    else:
        yield Paragraph(tr("The least limit is ${name}$; a usual part of it is taken:", name=name))
        yield from lines([f"r_r = {USUAL[0]:g}*{name}"], [Place("", lexicon)])
    if of.found.roller and limit.radius is not None:
        yield Result("r_r", lexicon["r_r"], MM * limit.radius, "<=")


def _working(of: Stepping, cam: Cam) -> Lexicon:
    return {
        "r_min": Given(MM * cam.nearest, "mm", tr("least distance of the working profile from the axis of the cams"))
    }


def _bottom(of: Stepping, cam: Cam) -> Iterator[Block]:
    """The radius of curvature in the middle of the groove (4)."""
    lexicon = at_part(of, 0.5)
    lexicon["rho_m"] = Given(MM * cam.bottom, "mm", tr("radius of curvature of the pitch curve at its bottom"))
    yield Paragraph(tr("The groove is symmetric; at its bottom, $k = 1/2$, it is concave:"))
    texts = ["rho_m = l_k*(lambda - 1 - beta')**2/(lambda - (1 + beta')**2)"]
    yield from lines(texts, [Place("", lexicon)])


def _second(of: Stepping) -> Iterator[Block]:
    """The cam of the second row, where it differs."""
    second, drive = of.found.second, of.drive
    if second is None or drive is None:
        return
    yield Heading(tr("Cam of the second row"), 3)
    lexicon = dict(of.lexicon)
    if of.found.dwells is not None:
        gamma = Given(degrees(second.lag), "deg", tr("angle of the lobe of the second cam behind that of the first"))
        lexicon["gamma"] = gamma
        yield Paragraph(tr("The dwells are not equal: the lobe of the second cam stands behind that of the first by"))
        yield from lines(["gamma = phi_p + phi_d1"], [Place("", lexicon)])
    if second.turned_over:
        yield Paragraph(tr("The second cam is the first one turned over."))
        return
    lexicon["r_min2"] = Given(
        MM * second.nearest, "mm", tr("least distance of the second working profile from the axis of the cams")
    )
    yield Paragraph(
        tr(
            "The rollers of the second row have another radius, so the working profile of the second cam is another "
            "offset of the same pitch curve:"
        )
    )
    yield from lines(["r_min2 = a - l_k - r_r2"], [Place("", lexicon)])
    yield Paragraph(
        tr(
            "Its flank A ends at $k_w = {part}$, {radius} mm from $O_1$; there B takes over with a pressure angle of "
            "${angle}$.",
            part=numeral(second.working_part),
            radius=plainly(MM * second.working_tip),
            angle=turned(second.working_angle),
        )
    )
