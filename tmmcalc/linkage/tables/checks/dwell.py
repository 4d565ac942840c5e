"""Checks of ``[synthesis.dwell]``: sizes given once, an output with what belongs to it, what is left to find."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable, word
from tmmcalc.spec.phrases import listing, show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.values import amount, amounts

PATH = ("synthesis", "dwell")
POSITIONS = ("phi12", "psi0", "psi12", "psi13", "CB", "CD", "alpha")
ROCKER_ONLY, SLIDER_ONLY = ("swing", "pivot", "pivot_side"), ("stroke", "k")
TOGETHER = (
    ("n", "working_angle", "the one gives the other"),
    ("frame", "stroke", "each gives the scale"),
    ("pivot", "swing", "F gives the swing"),
    ("pivot", "pivot_side", "F is given"),
    ("pivot", "n", "n places F"),
    ("pivot", "working_angle", "F settles it"),
)
# Ranges of what is sought, and the keys that give it.
SOUGHT = {"phi12_part": "phi12", "psi12_part": "psi12"}


def check_output(outline: Outline) -> Iterator[Finding]:
    """What belongs to the output, and nothing else."""
    asked = _asked(outline)
    if asked is None:
        return
    rocks = word(asked, "output", "slider") == "rocker"
    for key in SLIDER_ONLY if rocks else ROCKER_ONLY:
        if key in asked:
            rule = f"{key} belongs to a {'slider' if rocks else 'rocker'}"
            yield Finding((*PATH, key), rule, "remove it" if rocks else 'remove it, or write output = "rocker"')
    if rocks and "swing" not in asked and "pivot" not in asked:
        yield Finding(PATH, "missing key: a rocker needs its swing or its pivot", 'add swing = "40 deg"')
    wanted, found = ("moment" if rocks else "force"), dimension_of(asked.get("resistance"))
    if found in ("force", "moment") and found != wanted:
        rule = (
            f"{show(asked['resistance'])} is not a {wanted}, which is what acts on a {'rocker' if rocks else 'slider'}"
        )
        yield Finding((*PATH, "resistance"), rule, f'write "{"40 N*m" if rocks else "1.5 kN"}", for example')
    weight = amount(subtable(subtable(asked, "optimum"), "weights").get("f2"))
    if rocks and weight:
        yield Finding((*PATH, "optimum", "weights", "f2"), "f2 is the size of a linkage with a slider", "remove it")


def check_once(outline: Outline) -> Iterator[Finding]:
    """Nothing is given twice."""
    asked = _asked(outline)
    if asked is None:
        return
    for first, second, why in TOGETHER:
        if first in asked and second in asked:
            yield Finding((*PATH, second), f"{second} together with {first}: {why}", "keep one of them")
    if "lengths" in asked:
        for key in ("positions", "optimum"):
            if key in asked:
                rule = f"{key} together with lengths: they settle the linkage"
                yield Finding((*PATH, key), rule, "keep one of them")


def check_found(outline: Outline) -> Iterator[Finding]:
    """What is not given is sought."""
    asked = _asked(outline)
    if asked is None or "lengths" in asked:
        return
    given = subtable(asked, "positions")
    missing = [key for key in POSITIONS if key not in given]
    if missing and "optimum" not in asked:
        rule = f"missing {'key' if len(missing) == 1 else 'keys'} of [synthesis.dwell.positions]: {listing(missing)}"
        yield Finding(PATH, rule, "add them, or [synthesis.dwell.optimum], which seeks what is not given")
    elif "psi12" in given and "psi13" not in given:
        rule = "psi12 without psi13: it is sought as a part of psi13"
        yield Finding((*PATH, "positions", "psi12"), rule, "add psi13, or remove psi12")


def check_turns(outline: Outline) -> Iterator[Finding]:
    """Position 2 is within the dwell, and the bar turns one way."""
    asked = _asked(outline)
    if asked is None:
        return
    dwell = amount(asked.get("dwell"), "angle")
    for key in ("positions", "lengths"):
        phi12 = amount(subtable(asked, key).get("phi12"), "angle")
        if dwell is not None and phi12 is not None and phi12 >= dwell:
            rule = f"{show(asked[key]['phi12'])} is not within the dwell of {show(asked['dwell'])}"
            yield Finding((*PATH, key, "phi12"), rule, "write an angle between 0 and the dwell, such as half of it")
    given = subtable(asked, "positions")
    psi12, psi13 = (amount(given.get(key), "angle") for key in ("psi12", "psi13"))
    if psi13 == 0:
        yield Finding((*PATH, "positions", "psi13"), "psi13 is zero: the bar would stand", "write a turn other than 0")
    elif psi12 is not None and psi13 is not None and not 0 < psi12 / psi13 < 1:
        rule = f"psi12 = {show(given['psi12'])} is not between 0 and psi13 = {show(given['psi13'])}"
        yield Finding((*PATH, "positions", "psi12"), rule, "write an angle between them, such as half of psi13")


def check_ranges(outline: Outline) -> Iterator[Finding]:
    """Ranges ascend, and belong to parameters that are sought."""
    asked = _asked(outline)
    if asked is None:
        return
    given = subtable(asked, "positions")
    for key, ends in subtable(subtable(asked, "optimum"), "ranges").items():
        path = (*PATH, "optimum", "ranges", key)
        numbers = amounts(ends, "angle") if key in ("psi0", "psi13", "alpha") else amounts(ends)
        if numbers is not None and len(numbers) == 2 and numbers[0] >= numbers[1]:
            yield Finding(path, f"{show(ends)} does not ascend", "write the smaller end first")
        n_given = key == "n" and ("n" in asked or "working_angle" in asked or "pivot" in asked)
        if n_given or SOUGHT.get(key, key) in given:
            yield Finding(path, f"a range of {key}, which is given", "remove the range or the value")


def _asked(outline: Outline) -> Raw | None:
    """The table, None if it is not there."""
    asked = subtable(outline.document, "synthesis").get("dwell")
    return asked if isinstance(asked, dict) else None


CHECKS = (check_output, check_once, check_found, check_turns, check_ranges)
