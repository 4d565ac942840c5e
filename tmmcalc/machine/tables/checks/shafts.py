"""Checks of ``[[shafts]]``: the chain begins at the rotor of a motor, its masses have inertia, its ratios agree."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.linkage.tables.checks import places
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, tables
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.values import amount

AGREE = 1e-9  # relative difference of two ratios that are one


def check_names(outline: Outline) -> Iterator[Finding]:
    """Every shaft has a name of its own."""
    yield from places.check_names(outline, tables(outline.document, "shafts"), "shafts", "shaft")


def check_rotor(outline: Outline) -> Iterator[Finding]:
    """The first mass is the rotor of the motor, which has a moment of inertia where motions in time are asked for."""
    motor = subtable(outline.document, "motor")
    if "motor" not in outline.document:
        rule = "[[shafts]] without [motor]: the first mass of the drive is its rotor"
        yield Finding(("shafts",), rule, 'add [motor] with inertia = "0.03 kg*m^2"')
        return
    given = [key for key in ("inertia", "flywheel_moment") if key in motor]
    if not given and "name" not in motor and _swings(outline):  # a catalogue may tell it
        rule = "missing key: the rotor is the first mass of [[shafts]]"
        yield Finding(("motor",), rule, 'add inertia = "0.03 kg*m^2"')
    for key in given:
        if amount(motor[key], "inertia", "flywheel moment") == 0:
            rule = f"{show(motor[key])} is no inertia of a rotor that [[shafts]] begin with"
            yield Finding(("motor", key), rule, 'write "0.03 kg*m^2", for example')


def check_shafts(outline: Outline) -> Iterator[Finding]:
    """A shaft carries a moment, and a mass between two shafts has inertia, which motions in time need."""
    listed = outline.document["shafts"]
    last = len(listed) - 1 if isinstance(listed, list) else 0
    for index, shaft in tables(outline.document, "shafts"):
        path: Path = ("shafts", index)
        yield from _check_moment(shaft, path)
        if index == last:
            continue
        if "inertia" not in shaft:
            if not _swings(outline):
                continue
            rule = "missing key: the mass between this shaft and the next has its moment of inertia"
            yield Finding(path, rule, 'add inertia = "0.5 kg*m^2"; join two shafts in series into one')
        elif amount(shaft["inertia"], "inertia") == 0:
            rule = f"{show(shaft['inertia'])} is no inertia of a mass between two shafts"
            yield Finding((*path, "inertia"), rule, 'write "0.5 kg*m^2", for example; join shafts in series into one')


def _swings(outline: Outline) -> bool:
    """Whether the masses of the drive move each by itself, as in motions in time alone."""
    return "transients" in outline.document


def _check_moment(shaft: Raw, path: Path) -> Iterator[Finding]:
    damped = (amount(shaft.get("damping"), "torsional damping") or 0.0) > 0
    if "stiffness" not in shaft and damped:
        rule = "damping without stiffness: a rigid shaft is not twisted"
        remedy = 'add stiffness = "5000 N*m/rad"; stiffness = 0 is a fluid coupling'
        yield Finding((*path, "damping"), rule, remedy)
    if amount(shaft.get("stiffness"), "torsional stiffness") == 0 and not shaft.get("damping"):
        rule = f"{show(shaft['stiffness'])} without damping: the shaft carries no moment"
        remedy = 'write "5000 N*m/rad", for example; add damping for a fluid coupling; remove it for a rigid shaft'
        yield Finding((*path, "stiffness"), rule, remedy)


def check_ratio(outline: Outline) -> Iterator[Finding]:
    """The ratio of the gears, if it is given, is the product of those of the shafts, over that of an open pair."""
    shafts = tables(outline.document, "shafts")
    written = subtable(outline.document, "transmission").get("ratio")
    ratios = [amount(shaft.get("ratio", 1.0)) for _, shaft in shafts]
    numbers = [ratio for ratio in ratios if ratio is not None and ratio > 0]
    ratio = amount(written)
    if ratio is None or ratio <= 0 or not numbers or len(numbers) < len(ratios):
        return
    teeth = subtable(outline.document, "open_pair").get("teeth")
    both = isinstance(teeth, list) and len(teeth) == 2 and all(is_integer(z) and z > 0 for z in teeth)
    product, over = math.prod(numbers), teeth[1] / teeth[0] if isinstance(teeth, list) and both else 1.0
    if abs(product / over - ratio) > AGREE * ratio:
        of_pair = f", over {over:.6g} of [open_pair]" if both else ""
        yield Finding(
            ("transmission", "ratio"),
            f"{show(written)} is not the product of the ratios of [[shafts]]{of_pair}, which is {product / over:.10g}",
            "remove it, or give the shafts their ratios: speed of the mass before over that of the mass behind",
        )


CHECKS = (check_names, check_rotor, check_shafts, check_ratio)
