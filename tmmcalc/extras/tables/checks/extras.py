"""Checks of the small calculators: what is given once, what belongs together, what fits."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable
from tmmcalc.spec.phrases import Path, either
from tmmcalc.spec.values import amount, amounts, check_bare_speed, first_disorder

_GAPS = ("radii", "gap", "table")
_LIFE = ("items", "least_life", "mean_life")
_WHEEL = ("wheel_speed", "wheel_diameter")
_LATEST = 80.0  # lambda t of a ball


def check_contact(outline: Outline) -> Iterator[Finding]:
    """The gap is given in one way, and so is the modulus; a formula has its grid."""
    table = outline.document.get("contact")
    if not isinstance(table, dict):
        return
    yield from _one_of(("contact",), table, _GAPS, 'add radii = "20 mm", for example')
    if "modulus" in table and {"young", "poisson"} & {*table}:
        key = "young" if "young" in table else "poisson"
        yield Finding(("contact", key), f"{key} together with modulus: it is that of both bodies", "remove one of them")
    if "gap" in table and "size" not in table:
        rule = "missing key: a formula does not tell how far the contact reaches"
        yield Finding(("contact",), rule, 'add size = "2 mm"')
    radii = table.get("radii")
    if isinstance(radii, list) and len(radii) > 2:
        yield Finding(("contact", "radii"), f"{len(radii)} radii: there are two planes", "write one, or two")
    if isinstance(table.get("gap"), str):
        from tmmcalc.core.expression import parse_field  # late: only formulas need it

        try:
            parse_field(table["gap"], ("x", "y"), "contact.gap")
        except UsageError as fault:
            yield Finding(("contact", "gap"), fault.message, fault.remedy)
    if isinstance(table.get("table"), dict):
        yield from _check_gap_table(table["table"])


def _check_gap_table(table: Raw) -> Iterator[Finding]:
    path: Path = ("contact", "table")
    axes = {key: amounts(table.get(key), "length") for key in ("x", "y")}
    for key, places in axes.items():
        if places is not None and len(places) < 2:
            yield Finding((*path, key), "one place is no table", "write two or more")
        disorder = None if places is None else first_disorder(places)
        if disorder is not None:
            yield Finding((*path, key, disorder), "places ascend", "put them in order")
    x, y, h = axes["x"], axes["y"], table.get("h")
    if x is None or y is None or not isinstance(h, list):
        return
    if len(h) != len(y):
        yield Finding((*path, "h"), f"{len(h)} rows for {len(y)} places along y", "write one for each")
    for k, row in enumerate(h):
        if isinstance(row, list) and len(row) != len(x):
            yield Finding((*path, "h", k), f"{len(row)} values for {len(x)} places along x", "write one for each")


def check_reliability(outline: Outline) -> Iterator[Finding]:
    """The loads differ; the strength is given, or a test that it is estimated from."""
    table = outline.document.get("reliability")
    if not isinstance(table, dict):
        return
    path: Path = ("reliability",)
    yield from _one_of(path, table, ("load", "readings"), "add load = [2, 2.5]")
    given = [key for key in _LIFE if key in table]
    known = [key for key in ("strength", "decay") if key in table]
    if given and known:
        rule = f"{known[0]} together with {given[0]}: the test gives it"
        yield Finding((*path, known[0]), rule, "remove one of them")
    elif not given and len(known) < 2:
        rule = "missing key: the strength is known by strength and decay, or by a test"
        yield Finding(path, rule, "add strength = 2.56 and decay = 2.6e-4; or items, least_life and mean_life")
    elif given and len(given) < len(_LIFE):
        absent = next(key for key in _LIFE if key not in table)
        yield Finding(path, f"missing key: {given[0]} without {absent}", f"add {absent} = 150")
    least, mean = amount(table.get("least_life")), amount(table.get("mean_life"))
    if least is not None and mean is not None and least >= mean > 0:
        yield Finding((*path, "mean_life"), f"a mean life of {mean:g} is not above the shortest", "write a longer one")
    loads = amounts(table.get("load"))
    if loads is not None and len(loads) == 2 and loads[0] >= loads[1]:
        yield Finding((*path, "load"), f"loads from {loads[0]:g} to {loads[1]:g}", "write the smaller one first")
    readings = amounts(table.get("readings"))
    if readings and len({*readings}) < 2:
        yield Finding((*path, "readings"), "equal readings tell no range of loads", "write two different ones or more")


def check_tie_down(outline: Outline) -> Iterator[Finding]:
    """The preload is given once."""
    table = subtable(outline.document, "tie_down")
    if "preload" in table and "thread" in table:
        yield Finding(
            ("tie_down", "preload"), "preload together with thread: it gives the preload", "remove one of them"
        )


def check_ball(outline: Outline) -> Iterator[Finding]:
    """Gravity moves a ball whose separated mass has no speed of its own; times are within reach."""
    table = subtable(outline.document, "falling_ball")
    if table.get("relative_speed") == "own" and amount(table.get("gravity", 9.81), "acceleration") == 0:
        yield Finding(("falling_ball", "gravity"), 'without gravity "own" has no solution here', "write a gravity")
    decay = amount(table.get("decay"))
    listed = table.get("times")
    places: dict[Path, object] = {("duration",): table.get("duration")}
    if isinstance(listed, list):
        places |= {("times", k): value for k, value in enumerate(listed)}
    for place, value in places.items():
        time = amount(value, "time")
        if time is not None and decay is not None and time * decay > _LATEST:
            rule = f"at lambda t = {time * decay:.4g} nothing of the ball is left"
            yield Finding(("falling_ball", *place), rule, f"write a time up to {_LATEST / decay:.4g} s")


def check_bearing(outline: Outline) -> Iterator[Finding]:
    """The speed is that of the shaft or of a wheel; the rings hold the rolling bodies."""
    table = outline.document.get("bearing")
    if not isinstance(table, dict):
        return
    path: Path = ("bearing",)
    yield from check_bare_speed(table.get("speed"), (*path, "speed"))
    wheel = [key for key in _WHEEL if key in table]
    if "speed" in table and wheel:
        yield Finding((*path, wheel[0]), f"{wheel[0]} together with speed", "remove one of them")
    elif "speed" not in table and len(wheel) < 2:
        rule = "missing key: the bearing turns by speed, or with a wheel"
        yield Finding(path, rule, 'add speed = "45 rpm", or wheel_speed and wheel_diameter')
    inner, outer, roller = (amount(table.get(key), "length") for key in ("inner", "outer", "roller"))
    if inner is not None and outer is not None and inner >= outer:
        yield Finding((*path, "outer"), "the outer ring is not larger than the inner one", "write a larger one")
    elif inner is not None and outer is not None and roller is not None and roller >= (outer - inner) / 2:
        yield Finding((*path, "roller"), "rolling bodies do not fit between the rings", "write a smaller one")
    else:
        yield from _check_count(path, table.get("count"), inner, outer, roller)
    peak, rms = (amounts(table.get(key)) for key in ("peak", "rms"))
    for key, other in (("peak", "rms"), ("rms", "peak")):
        if key in table and other not in table:
            yield Finding(path, f"missing key: {key} without {other}", f"add {other} = [4.2, 5.6]")
    if peak is not None and rms is not None and len(peak) != len(rms):
        yield Finding((*path, "rms"), f"{len(rms)} values for {len(peak)} peaks", "write one for each")


def _check_count(
    path: Path, count: object, inner: float | None, outer: float | None, roller: float | None
) -> Iterator[Finding]:
    """So many rolling bodies lie beside each other on the mean circle."""
    if inner is None or outer is None or not roller or not isinstance(count, int) or roller <= 0 or inner <= 0:
        return
    most = int(math.pi / math.asin(2 * roller / (inner + outer)))
    if count > most:
        rule = f"{count} rolling bodies do not fit on the mean circle: there is room for {most}"
        yield Finding((*path, "count"), rule, f"write {most} at most, or a smaller roller")


def _one_of(path: Path, table: Raw, keys: tuple[str, ...], remedy: str) -> Iterator[Finding]:
    there = [key for key in keys if key in table]
    if not there:
        yield Finding(path, f"missing key: there is none of {either(keys)}", remedy)
    elif len(there) > 1:
        yield Finding((*path, there[1]), f"{' and '.join(there)} together: one is enough", "keep one of them")


CHECKS = (check_contact, check_reliability, check_tie_down, check_ball, check_bearing)
