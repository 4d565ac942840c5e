"""What is worth knowing about a six-bar with a dwell, after the conclusions of Zinchenko, with its figures."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.notes import Phrase, Said, held
from tmmcalc.linkage.synthesis.dwell.criteria import towards_and_away
from tmmcalc.linkage.synthesis.dwell.exact import Figures
from tmmcalc.linkage.synthesis.dwell.task import DwellTask

HIGH = 2.0  # of a bar force on the working stroke, against the resistance
LONG = 0.02  # of max |S| over the dwell, against the stroke
STEEP = math.radians(60)  # pressure angle


def advice(asked: DwellTask, found: Figures, n: float | None) -> Iterator[Said]:
    """Remarks on forces, dwell, division of time and sense."""
    working, idle = (math.sqrt(float(part[0])) for part in (found.criteria.f4, found.criteria.f5))
    unit = "" if asked.output == "slider" else "/l_OB"
    figures = Phrase(
        "sqrt(f4) = {working:.3g}{unit} on the working stroke, sqrt(f5) = {idle:.3g}{unit} on the idle one",
        working=working,
        unit=unit,
        idle=idle,
    )
    if idle < 0.9 * working:
        other = "away" if asked.working == "towards" else "towards"
        yield (
            Phrase(
                "note: the bars carry less on the idle stroke ({figures}): the working stroke should be the one "
                'with the least forces; write working = "{other}", or mount the linkage so that it drives on that '
                "stroke",
                figures=figures,
                other=other,
            )
        )
    elif working > HIGH and asked.output == "slider":
        yield Phrase(
            "note: bar forces above the resistance are acceptable on the idle stroke only: {figures}", figures=figures
        )
    else:
        yield Phrase("note: bar forces for a unit resistance: {figures}", figures=figures)
    ratio = found.dwell[0] / found.stroke
    if ratio > LONG:
        text = (
            "the output leaves its dwell by {value:.3g} % of the stroke; a smaller dwell angle than {dwell:.4g} deg "
            "gives a more exact dwell"
        )
        yield held("note", text, 100 * ratio, 100 * LONG, "%", name="max |S|/stroke", dwell=math.degrees(asked.dwell))
    yield from _division(asked, found, n)
    steepest, at = found.largest["delta"]
    if steepest > STEEP:
        text = "the pressure angle reaches {value:.4g} deg at {at:.4g} deg of the crank from position 1"
        numbers = math.degrees(steepest), math.degrees(STEEP), "deg"
        yield held("warning", text, *numbers, name="delta", at=math.degrees(at))


def _division(asked: DwellTask, found: Figures, n: float | None) -> Iterator[Said]:
    """How the turn divides into the two strokes and the dwell, and what changes it."""
    towards, away = (float((end - begin)[0]) for begin, end in towards_and_away(asked, np.array([found.far])))
    text = Phrase(
        "note: stroke towards the dwell {towards:.5g} deg, dwell {dwell:.5g} deg, stroke away {away:.5g} deg",
        towards=math.degrees(towards),
        dwell=math.degrees(asked.dwell),
        away=math.degrees(away),
    )
    if n is not None:
        text = Phrase(
            "{text}; n moves the division, the sense of the crank exchanges both strokes, k only turns the sign of S "
            "about",
            text=text,
        )
    yield text
