"""Conditions on a four-bar or a slider-crank that was found: whether the crank turns fully, the transmission angle."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from tmmcalc.linkage.notes.syntheses.told import Told, angle, turned
from tmmcalc.linkage.synthesis.planar import grashof as type_of
from tmmcalc.linkage.synthesis.posed import POOR
from tmmcalc.linkage.synthesis.results import TRANSMISSION
from tmmcalc.linkage.synthesis.rockerfamily import Family, cosines
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Block, Paragraph, Result
from tmmcalc.report.telling import held

TURNING = ("crank-rocker", "double crank")  # four-bars whose crank turns fully


def grashof(sizes: Mapping[str, float]) -> Iterator[Block]:
    """The condition of Grashof on crank, coupler, rocker and frame, by their letters, and what it makes of them."""
    short, long = min(sizes, key=lambda key: sizes[key]), max(sizes, key=lambda key: sizes[key])
    one, two = (key for key in sizes if key not in (short, long))
    sides = sizes[short] + sizes[long], sizes[one] + sizes[two]
    yield Paragraph(tr("The condition of Grashof for the shortest and the longest link and the two others:"))
    yield held(f"{short} + {long} < {one} + {two}", sides, "m", holds=sides[0] < sides[1])
    name = type_of(np.array([[each] for each in sizes.values()]))[0]
    if name in TURNING:
        yield Paragraph(tr("The crank turns fully: {name}.", name=tr_name(f"four-bar, {name}")))
    else:
        yield Paragraph(tr("The crank does not turn fully: {name}.", name=tr_name(f"four-bar, {name}")))


def transmission(told: Told, sizes: Mapping[str, float]) -> Iterator[Block]:
    """The transmission angles of a four-bar whose crank turns fully, with the crank on the frame; the least of both."""
    a, b, c, d = sizes
    crank, coupler, frame = (np.array([sizes[key] / sizes[c]]) for key in (a, b, d))
    found = Family(crank, coupler, frame, np.empty(0, complex), np.empty(0))
    far, near = (math.acos(float(each)) for each in cosines(found)[:, 0])
    told.give(
        {
            "mu_1": angle(near, tr("transmission angle with the crank on the frame, towards the pivot of the rocker")),
            "mu_2": angle(far, tr("transmission angle with the crank on the frame, away from the pivot of the rocker")),
        }
    )
    yield Paragraph(tr("The transmission angle is extreme where the crank lies on the line of the frame:"))
    yield from told.lines(
        "mu_1 = acos((<b>**2 + <c>**2 - (<d> - <a>)**2)/(2*<b>*<c>))",
        "mu_2 = acos((<b>**2 + <c>**2 - (<d> + <a>)**2)/(2*<b>*<c>))",
        "mu_m = asin(min(sin(mu_1), sin(mu_2)))",
        words={"a": a, "b": b, "c": c, "d": d},
    )


def turning(told: Told, *, whole: bool = False) -> Iterator[Block]:
    """Both conditions on a linkage of a search; ``whole`` where it was computed over a turn if its crank turns."""
    least = Given(told.design.merits[TRANSMISSION.key], "deg", tr_name("least transmission angle"))
    told.give({"mu_m": least})
    symbols = {size.symbol for size in told.design.sizes}
    turns = False
    if "c" in symbols:
        sizes = {letter: told.design.size(letter) for letter in "abc"}
        frame = told.lexicon["d"].value
        assert isinstance(frame, float)
        sizes["d"] = frame
        yield from grashof(sizes)
        turns = type_of(np.array([[each] for each in sizes.values()]))[0] in TURNING
        if turns and whole:
            yield from transmission(told, sizes)
    elif "r" in symbols:
        r, l, e = (told.design.size(letter) for letter in "rle")
        yield Paragraph(tr("The crank turns fully where it is shorter than the rod with the offset taken off:"))
        yield held("r + abs(e) < l", (r + abs(e), l), "m", holds=r + abs(e) < l)
    if not (turns and whole):
        yield Paragraph(
            tr(
                "On the way through the positions the least transmission angle, an extreme of the kinematic analysis, "
                "is $mu_m$ = {value}.",
                value=turned(told.design.merits[TRANSMISSION.key]),
            )
        )
    limit = math.degrees(told.task.transmission or POOR)
    yield Result("mu_m", least, limit, ">=")
