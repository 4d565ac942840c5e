"""What is asked of a six-bar with a dwell beside its sizes: where angles begin, strokes, what is sought."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.linkage.notes.syntheses.dwellsearch import ranges
from tmmcalc.linkage.synthesis.dwell.parameters import USUAL
from tmmcalc.linkage.synthesis.dwell.task import DwellTask, Optimum
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Block, Datum, Paragraph

FRAME = "l_OA/sin(Theta/2)"  # of a rocker, by its swing


def choices(asked: DwellTask) -> Iterator[Block]:
    """Conventions, then the choices by words, and the search where there is one."""
    said = tr(
        "At dwell axis $x$ runs from $O$ to $B$; positions 1, 2, 3 are at its beginning, between, at its end. $psi_0$ "
        "is the angle of $BC$ in position 1, $phi_12$, $psi_12$, $psi_13$ are turns of the crank and of $BC$ from "
        "position 1, $alpha$ is the angle from $CA$ to $CD$, all counter-clockwise."
    )
    if asked.output == "slider":
        said += " " + tr("The slider moves along the direction that the crank has after the part $n$ of the dwell.")
    elif asked.pivot is None:
        said += " " + tr("The pivot $F$ of the rocker lies across the crank after the part $n$ of the dwell.")
    yield Paragraph(said)
    yield Datum(tr("sense of the crank"), text=tr("clockwise") if asked.clockwise else tr("counter-clockwise"))
    towards = asked.working == "towards"
    said = tr("the stroke towards the dwell") if towards else tr("the stroke that begins after the dwell")
    yield Datum(tr("working stroke"), text=said)
    if asked.lengths is not None:
        side = tr("to the left of $AB$") if asked.lengths.left else tr("to the right of $AB$")
        yield Datum(tr("place of $C$ at dwell"), text=side)
    if asked.output == "slider":
        along = tr("against the direction $O*A$ at that part of the dwell")
        yield Datum(
            tr("positive displacement of the slider"),
            text=along if asked.reverse else tr("in the direction $O*A$ at that part of the dwell"),
        )
    elif asked.pivot is None:
        sides = {
            True: tr("to the left of the crank"),
            False: tr("to the right of the crank"),
            None: tr("on the better side"),
        }
        yield Datum(tr("place of $F$"), text=sides[asked.pivot_left])
    yield from _divided(asked)
    if asked.optimum is not None:
        yield from _searched(asked, asked.optimum)


def _divided(asked: DwellTask) -> Iterator[Datum]:
    """By what the part n of the dwell and the frame of a rocker are."""
    if asked.n is None and asked.working_angle is not None:
        yield Datum(tr("part of the dwell"), ("n",), text=_corrected(f"${part_rule(asked)}$", exact=asked.exact))
    elif asked.n is None and asked.pivot is None and asked.optimum is None:
        yield Datum(tr("part of the dwell"), ("n",), (USUAL,))
    if asked.swing is not None and asked.pivot is None:
        yield Datum(tr("frame of the rocker"), ("l_OF",), text=_corrected(f"${FRAME}$", exact=asked.exact))


def part_rule(asked: DwellTask) -> str:
    """The part n of the dwell by the turn of the crank on the stroke towards it."""
    return "1 - (deg(180) - phi_t)/phi_B" if asked.clockwise else "(deg(180) - phi_t)/phi_B"


def _corrected(rule: str, *, exact: bool) -> str:
    return tr("{rule}, then corrected until what is asked is met", rule=rule) if exact else rule


def _searched(asked: DwellTask, optimum: Optimum) -> Iterator[Block]:
    """The criteria with their weights, the parameters that are sought with their ranges."""
    yield Paragraph(
        tr(
            "The parameters that are not given are sought so that the weighted sum of the criteria is least: $f_1$, "
            "the largest deviation over the dwell as a part of the stroke; $f_2 = l_OB/l_OA$; $f_3$, the tangent of "
            "the largest pressure angle; $f_4$ and $f_5$, the sums of the squares of the largest forces of both bars "
            "on the working and on the idle stroke, for a unit resistance and lengths in parts of $l_OB$. The crank "
            "turns fully."
        )
    )
    for k, weight in enumerate(optimum.weights, 1):
        yield Datum(tr("weight of criterion {number}", number=k), (f"w_{k}",), (weight,))
    for name, ends, unit in ranges(asked, optimum):
        yield Datum(tr("range of the parameter {name}", name=name), (), ends, unit)
