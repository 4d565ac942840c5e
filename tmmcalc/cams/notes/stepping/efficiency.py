"""Efficiency of the flank that drives, A before the tip of the lobe and B after it (12), (13); the means of a step."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.cams.indexing.results import Cam
from tmmcalc.cams.notes.stepping.quantities import Stepping, at_row
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result
from tmmcalc.report.telling import lines, named, numeral, plainly

RISE = (
    "n_x<f> = R_<f>**2*(1 + beta') - a*beta'*(a - l_k*cos(theta_<f>))",
    "n_y<f> = a*l_k*beta'*sin(theta_<f>)",
    "sigma_<f> = atan(abs(n_y<f>)/abs(n_x<f>))",
)
AGAINST = "eta_1 = (1 - f_1*f_2 - (f_1 + f_2)*tan(abs(vartheta_<f>)))/(1 + f_1/tan(sigma_<f>))"
ALONG = "eta_2 = (1 - f_1/tan(sigma_<f>))/(1 - f_1*f_2 + (f_1 + f_2)*tan(abs(vartheta_<f>)))"
MEANS = "eta_1m = I_1A + I_1B", "eta_2m = I_2A + I_2B", "eta_12 = I_1A + I_2B"
PERCENT = 100


def efficiency(of: Stepping, cam: Cam, rows: Sequence[int]) -> Iterator[Block]:
    """Both efficiencies at rows where their formulas hold, and their means."""
    table = cam.efficiency
    yield Heading(tr("Efficiency"), 3)
    yield Paragraph(
        tr(
            "Up to $k_m = {part}$ flank A drives, after it groove B. The slope of the curve under the roller decides "
            "the efficiency: $eta_1$ with the load against the motion, $eta_2$ with the load along it. Where a formula "
            "leaves the range from 0 to 1, by self-locking or near the ends of the step, it is cut off there.",
            part=numeral(cam.handover.part),
        )
    )
    for flank in ("A", "B"):
        own = [row for row in rows if (of.found.k[row] <= cam.handover.part) == (flank == "A")]
        moving = [row for row in own if of.found.motion[1, row] > 0]
        yield from lines(RISE, _places(of, cam, moving), {"f": flank}) if moving else ()
        for text, cut in ((AGAINST, table.against_cut), (ALONG, table.aiding_cut)):
            held = [row for row in moving if not cut[row]]
            yield from lines([text], _places(of, cam, held), {"f": flank}) if held else ()
    yield from _means(of, cam)


def _places(of: Stepping, cam: Cam, rows: Sequence[int]) -> list[Place]:
    return [
        Place(tr("at k = {part}", part=plainly(float(of.found.k[row]))), at_row(of, row) | named(_found(cam, row)))
        for row in rows
    ]


def _found(cam: Cam, row: int) -> Lexicon:
    against = float(np.asarray(cam.efficiency.against)[row])
    along = float(np.asarray(cam.efficiency.aiding)[row])
    return {
        "eta_1": Given(against, "", tr("efficiency with the load against the motion")),
        "eta_2": Given(along, "", tr("efficiency with the load along the motion")),
    }


def _means(of: Stepping, cam: Cam) -> Iterator[Block]:
    """Sums of the integrals over the parts of the step in which A and B drive."""
    table = cam.efficiency
    lexicon: Lexicon = {
        "I_1A": Given(
            table.against_a,
            "",
            tr("integral of {eta} over the part of the step before the tip, where A drives", eta="η₁"),
        ),
        "I_1B": Given(
            table.against_b,
            "",
            tr("integral of {eta} over the part of the step after the tip, where B drives", eta="η₁"),
        ),
        "I_2A": Given(
            table.aiding_a,
            "",
            tr("integral of {eta} over the part of the step before the tip, where A drives", eta="η₂"),
        ),
        "I_2B": Given(
            table.aiding_b,
            "",
            tr("integral of {eta} over the part of the step after the tip, where B drives", eta="η₂"),
        ),
        "eta_1m": Given(table.mean_against, "", tr("mean efficiency of the step with the load against the motion")),
        "eta_2m": Given(table.mean_aiding, "", tr("mean efficiency of the step with the load along the motion")),
        "eta_12": Given(
            table.mean_paper,
            "",
            tr("mean efficiency of the step with the load against the motion up to the tip, along it after the tip"),
        ),
    }
    yield Paragraph(tr("The mean efficiencies of the whole step, whose parts $k$ run from 0 to 1:"))
    yield from lines(MEANS, [Place("", named(lexicon))])
    shares = ((tr("against the motion"), table.against_share), (tr("along the motion"), table.aiding_share))
    for said, share in shares:
        if share > 0:
            part = plainly(PERCENT * share, 3)
            text = tr("With the load {way} the efficiency is cut off over {part} % of the step.", way=said, part=part)
            yield Paragraph(text)
    yield Result("eta_1m", lexicon["eta_1m"])
