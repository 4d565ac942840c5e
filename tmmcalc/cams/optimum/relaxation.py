"""What a looser limit would buy: the least H2 again, with the limit of one active constraint 1 % looser, or at the next
preferred number (R20).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import floor, log10
from typing import Any

from tmmcalc.cams.optimum.leastheight import QUICK, least_heights
from tmmcalc.cams.optimum.results import Choice, Relaxation
from tmmcalc.cams.optimum.scene import Scene

R20 = (1.0, 1.12, 1.25, 1.4, 1.6, 1.8, 2.0, 2.24, 2.5, 2.8, 3.15, 3.55, 4.0, 4.5, 5.0, 5.6, 6.3, 7.1, 8.0, 9.0, 10.0)
PART = 0.01
REGION = 0.05  # of S0: how far the optimum may go in a step


def relaxations(scene: Scene, least: Choice) -> Iterator[Relaxation]:
    """Every active constraint of the lowest mechanism, relaxed in both ways."""
    sizes = (least.start, least.roller, least.height)

    def heights(others: list[Scene]) -> list[float]:
        return [each.height for each in least_heights(others, sizes, REGION, QUICK)]

    return bought(scene, least, heights)


def bought(scene: Scene, least: Choice, heights: Callable[[list[Scene]], list[float]]) -> Iterator[Relaxation]:
    """The same with the least H2 of scenes as a function."""
    asked = []
    for number in least.active:
        limit = limit_of(scene, number)
        if limit is not None:
            _, before, way, _ = limit
            asked += [(number, limit, preferred, loosened(before, way, preferred)) for preferred in (False, True)]
    found = heights([relaxed(scene, limit[0], after) for _, limit, _, after in asked]) if asked else []
    for (number, (key, before, _, unit), preferred, after), height in zip(asked, found, strict=True):
        yield Relaxation(number, key, unit, before, after, preferred, height, least.height - height)


def limit_of(scene: Scene, number: int) -> tuple[str, float, int, str] | None:
    """The limit behind a constraint: its key in the spec, its value, and which way is looser."""
    need, limits = scene.requirements, scene.limits
    by_stress: tuple[str, float | None, int, str] = ("bending", need.bending, 1, "Pa")
    table: dict[int, tuple[str, float | None, int, str]] = {
        2: ("roller_friction", need.roller_friction, 1, "-"),
        3: ("convex_radius", limits.convex, -1, "m"),
        4: ("concave_radius", limits.concave if limits.allow_concave else None, -1, "m"),
        5: ("pin_pressure", need.pin_pressure, 1, "Pa")
        if need.pin is None
        else ("roller_ratio", need.roller_ratio, -1, "-"),
        6: by_stress if need.deflection is None else ("deflection", need.deflection, 1, "m"),
        7: by_stress,
        8: ("guide_pressure", need.guide_pressure, 1, "Pa"),
        9: ("contact", need.contact, 1, "Pa"),
    }
    key, value, way, unit = table.get(number, ("", None, 0, ""))
    return None if not value else (key, value, way, unit)


def relaxed(scene: Scene, key: str, value: float) -> Scene:
    """The scene with another limit."""
    limits, need = scene.limits, scene.requirements
    if key == "convex_radius":
        limits = replace(limits, convex=value)
    elif key == "concave_radius":
        limits = replace(limits, concave=value)
    else:
        change: dict[str, Any] = {key: value}
        need = replace(need, **change)
    return replace(scene, limits=limits, requirements=need)


def loosened(value: float, way: int, preferred: bool) -> float:
    """A limit 1 % looser, or the next preferred number."""
    return next_preferred(value, way) if preferred else value * (1 + way * PART)


def next_preferred(value: float, way: int) -> float:
    """The next number of the series R20 above (way 1) or below it.

    >>> next_preferred(5e6, 1), next_preferred(0.075, -1)
    (5600000.0, 0.071)
    """
    decade = 10.0 ** floor(log10(value) + 1e-12)
    if way > 0:
        return float(f"{next(n for n in R20 if n * decade > value * (1 + 1e-9)) * decade:.12g}")
    below = [n for n in (0.9, *R20) if n * decade < value * (1 - 1e-9)]
    return float(f"{below[-1] * decade:.12g}")
