"""What is told of a time-optimal law and of the extremes of what it moves."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tmmcalc.core.quantity import keyed
from tmmcalc.core.timelaw import TimeLaw
from tmmcalc.core.timerows import TimedExtreme
from tmmcalc.report.document import Fact
from tmmcalc.report.numbers import number

NOTHING = 1e-9  # of the larger extreme: the smaller one is zero


def law_facts(law: TimeLaw, angular: bool, what: str, prefix: str = "", which: str = "the") -> Iterator[Fact]:
    """Travel, phases and largest speed of a law; ``prefix`` begins the names for programs.

    ``which`` says before "acceleration" what the law is of, where there is another one.
    """
    unit = "rad" if angular else "m"
    places = {"prefix": prefix, "unit": unit}
    shown = f"{number(math.degrees(law.travel))} deg" if angular else f"{number(law.travel)} m"
    yield Fact(f"travel of {what}", shown, keyed(law, "travel", **places))
    values = keyed(law, "ramp", "uniform", "duration", "instants", "ramp_travel", "uniform_travel", **places)
    yield Fact("phases", _phases(law, which), values)
    speed = f"{number(law.speed)} {unit}/s, acceleration {number(law.acceleration)} {unit}/s^2"
    yield Fact("largest speed", speed, keyed(law, "speed", "acceleration", **places))


def _phases(law: TimeLaw, which: str) -> str:
    if not law.speed:
        return "no motion"
    ramp, uniform = number(law.ramp), number(law.uniform)
    parts = (
        f"acceleration {ramp} s, uniform motion {uniform} s, deceleration {ramp} s"
        if law.uniform
        else f"acceleration {ramp} s, deceleration {ramp} s: the travel is too short for the largest speed"
    )
    instants = ", ".join(number(t) for t in law.instants)
    return f"{parts}\nT = {number(law.duration)} s; {which} acceleration jumps at t = {instants} s"


def extreme_lines(found: Sequence[TimedExtreme]) -> str:
    """One line a quantity: both extremes with their times, of what begins at zero the largest size; angles in deg."""
    return "\n".join(map(_line, found))


def _line(each: TimedExtreme) -> str:
    factor, written = (180 / math.pi, "deg") if each.unit == "rad" else (1.0, each.unit)
    unit = f" {written}" if written else ""
    value, at = each.size
    if min(abs(each.least), abs(each.largest)) > NOTHING * abs(value):
        low, high = number(factor * each.least, 6), number(factor * each.largest, 6)
        return (
            f"{each.name} from {low}{unit} (t = {number(each.least_at, 5)} s) "
            f"to {high}{unit} (t = {number(each.largest_at, 5)} s)"
        )
    word = "at least" if value < 0 else "at most"
    return f"{each.name} {word} {number(factor * value, 6)}{unit} (t = {number(at, 5)} s)"


def extreme_values(found: Sequence[TimedExtreme]) -> dict[str, float]:
    """The extremes for programs."""
    values: dict[str, float] = {}
    for each in found:
        values |= keyed(each, "least", "least_at", "largest", "largest_at", name=each.name, unit=each.unit)
    return values
