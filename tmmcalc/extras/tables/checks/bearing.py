"""``[bearing]``: what turns it, and what fits into it."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.phrases import Path
from tmmcalc.spec.values import amount, amounts, check_bare_speed

_WHEEL = ("wheel_speed", "wheel_diameter")


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


CHECKS = (check_bearing,)
