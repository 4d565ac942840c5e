"""Checks of a cam on a shaft of the machine: the shaft is there, the cam loads it, its turns close in the cycle."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from tmmcalc.cams.tables.cam import MOST_TURNS, SHAFTS, closed_ratio
from tmmcalc.cams.tables.checks.written_cam import place, turning_shaft, written_cam
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable, tables, word
from tmmcalc.spec.phrases import show
from tmmcalc.spec.values import amount

TURN = 2 * math.pi
CLOSED = 1e-9  # relative difference of a ratio from the quotient that closes


def check_shaft(outline: Outline) -> Iterator[Finding]:
    """A shaft drives the cam at a ratio, and is loaded by what acts on the follower."""
    cam = written_cam(outline)
    if "ratio" in cam.table and "shaft" not in cam.table:
        rule = "ratio without shaft: of the speed of which shaft it is"
        yield Finding(place("", "ratio"), rule, 'add shaft = "crank", or give the speed of the cam itself')
    if "shaft" not in cam.table:
        return
    if not turning_shaft(outline):
        rule = f"shaft = {show(cam.table['shaft'])}: there is no shaft that turns, neither a crank nor that of [torque]"
        yield Finding(place("", "shaft"), rule, "remove it, or add the [mechanism] whose crank drives the cam")
        return
    if "speed" in cam.table:
        rule = "speed together with shaft: the cam has the speed of its shaft times ratio"
        yield Finding(place("", "speed"), rule, "remove it, or remove shaft")
    if not cam.has("loads"):
        rule = "shaft without [cam.loads]: nothing is known of what the cam asks of the shaft"
        yield Finding(place("", "shaft"), rule, "add [cam.loads] with the mass of the follower, or remove shaft")


def check_closed(outline: Outline) -> Iterator[Finding]:
    """The cam repeats within a few turns of the crank, and within the cycle of a torque diagram."""
    cam = written_cam(outline)
    shaft = word(cam.table, "shaft")
    if shaft not in SHAFTS or not turning_shaft(outline):
        return
    own = _fraction(cam.table.get("ratio", 1))
    gears = _gears(outline) if shaft == "motor" else 1.0
    if gears is None:
        rule = 'shaft = "motor" without the ratio of the gears: how often the cam turns in a cycle is not known'
        yield Finding(place("", "shaft"), rule, 'add ratio = 5, for example, to [transmission], or write "crank"')
    if own is None or gears is None:
        return
    ratio, exact = own * Fraction(gears), closed_ratio(own, gears)
    if not exact or abs(exact / ratio - 1) > CLOSED:
        told = "" if shaft == "crank" else f" and a ratio of {gears:g} of the gears"
        rule = (
            f"with a ratio of {float(own):.10g}{told} the cam turns {float(ratio):.10g} times in a turn of the crank: "
            f"it does not repeat within {MOST_TURNS} turns of it"
        )
        yield Finding(place("", "ratio"), rule, 'write a quotient of small whole numbers: 0.5, "1/3", 2')
        return
    period = amount(subtable(outline.document, "torque").get("period", TURN), "angle")
    if "torque" not in outline.document or not period or period <= 0:
        return
    cycles = period / (TURN * exact.denominator)
    if abs(cycles - round(cycles)) > CLOSED or not round(cycles):
        rule = (
            f"the cam repeats after {360 * exact.denominator:g} deg of the shaft, the cycle of [torque] is "
            f"{math.degrees(period):g} deg"
        )
        remedy = f'write period = "{360 * exact.denominator} deg" in [torque], or a multiple of it'
        yield Finding(place("", "ratio" if "ratio" in cam.table else "shaft"), rule, remedy)


def _fraction(written: Any) -> Fraction | None:
    """A ratio as it is written, None if it is faulty."""
    if isinstance(written, bool) or not isinstance(written, int | float | str):
        return None
    try:
        ratio = Fraction(str(written).replace(" ", ""))
    except (ValueError, ZeroDivisionError):
        return None
    return ratio if ratio > 0 else None


def _gears(outline: Outline) -> float | None:
    """The ratio of the gears, by itself or of all shafts together; None if it is not written."""
    ratio = amount(subtable(outline.document, "transmission").get("ratio"))
    if ratio is not None:
        return ratio if ratio > 0 else None
    ratios = [amount(shaft.get("ratio", 1.0)) for _, shaft in tables(outline.document, "shafts")]
    known = [each for each in ratios if each is not None and each > 0]
    return math.prod(known) if known and len(known) == len(ratios) else None


CHECKS = (check_shaft, check_closed)
