"""The check that the shifts of a pair are settled once: by numbers, by a centre distance, or by a strategy."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.gears.tables.checks.written_pair import Written
from tmmcalc.gears.tables.shifting import STRATEGIES
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import listing

_BOTH = ("x1", "x2")


def check_shifts(pair: Written) -> Iterator[Finding]:
    """Shifts and centre distance agree with the strategy; nothing is missing, nothing is said twice."""
    if pair.strategy not in STRATEGIES or not pair.kinds:
        return
    shifts = [key for key in _BOTH if key in pair.keys and (key == "x1" or pair.kind != "rack")]
    distance = "centre_distance" in pair.keys and pair.kind != "rack"
    if len(shifts) == 2 and distance:
        rule = "centre_distance together with x1 and x2: two of the three give the third"
        yield Finding(pair.at("centre_distance"), rule, "remove one of them")
    elif pair.strategy == "given":
        yield from _check_given(pair, shifts, distance)
    elif pair.strategy == "given_aw":
        yield from _check_distance(pair, shifts, distance)
    else:
        yield from _check_chosen(pair, shifts, distance)


def _check_given(pair: Written, shifts: list[str], distance: bool) -> Iterator[Finding]:
    needed = _BOTH[:1] if pair.kind == "rack" else _BOTH
    absent = [key for key in needed if key not in shifts]
    if absent and distance:
        rule = 'strategy = "given" together with centre_distance: it gives the sum of the shifts'
        yield Finding(pair.at("strategy"), rule, 'remove strategy, or write "given_aw"')
    elif absent:
        rule = f'strategy = "given" without {" and ".join(absent)}'
        yield Finding(pair.at("strategy"), rule, f"add {listing(f'{key} = 0.5' for key in absent)}")


def _check_distance(pair: Written, shifts: list[str], distance: bool) -> Iterator[Finding]:
    if len(shifts) == 2:  # without a centre distance of its own
        rule = 'x1 and x2 together with strategy = "given_aw": the centre distance gives their sum'
        yield Finding(pair.at("x2"), rule, 'remove one of them, or write strategy = "given"')
    elif not distance and not pair.of_train:
        rule = 'strategy = "given_aw" without centre_distance'
        yield Finding(pair.at("strategy"), rule, 'add centre_distance = "85 mm"')


def _check_chosen(pair: Written, shifts: list[str], distance: bool) -> Iterator[Finding]:
    """A strategy that finds the shifts itself."""
    if "strategy" not in pair.keys:
        for key in shifts:
            other = _BOTH[1 - _BOTH.index(key)]
            yield Finding(pair.at(key), f"{key} without {other}", f"add {other}, or centre_distance")
        return
    given = f'strategy = "{pair.strategy}"'
    if pair.strategy == "equal_shift":
        if len(shifts) == 2:
            yield Finding(pair.at("x2"), f"x2 together with x1 and {given}: it is -x1", "remove it, or strategy")
    elif shifts:
        rule = f"{' and '.join(shifts)} together with {given}, which chooses the shifts"
        yield Finding(pair.at(shifts[0]), rule, "remove one of them")
    if distance:
        rule = f"centre_distance together with {given}, from which it follows"
        yield Finding(pair.at("centre_distance"), rule, 'remove it, or write strategy = "given_aw"')
