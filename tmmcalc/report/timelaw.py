"""What is told of a time-optimal law and of the extremes of what it moves."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

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
    shown = f"{number(math.degrees(law.travel))} deg" if angular else f"{number(law.travel)} m"
    yield Fact(f"travel of {what}", shown, {f"{prefix}S_m[{unit}]": law.travel})
    ways = {f"{prefix}S_1[{unit}]": law.ramp_travel, f"{prefix}S_2[{unit}]": law.uniform_travel}
    yield Fact("phases", _phases(law, which), _times(law, prefix) | ways)
    speed = f"{number(law.speed)} {unit}/s, acceleration {number(law.acceleration)} {unit}/s^2"
    values = {f"{prefix}v_peak[{unit}/s]": law.speed, f"{prefix}a[{unit}/s^2]": law.acceleration}
    yield Fact("largest speed", speed, values)


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


def _times(law: TimeLaw, prefix: str) -> dict[str, object]:
    return {
        f"{prefix}t_1[s]": law.ramp,
        f"{prefix}t_2[s]": law.uniform,
        f"{prefix}T[s]": law.duration,
        f"{prefix}jumps[s]": list(law.instants),
    }


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
        unit = f"[{each.unit}]" if each.unit else ""
        values |= {
            f"{each.name}_min{unit}": each.least,
            f"{each.name}_min_at[s]": each.least_at,
            f"{each.name}_max{unit}": each.largest,
            f"{each.name}_max_at[s]": each.largest_at,
        }
    return values
