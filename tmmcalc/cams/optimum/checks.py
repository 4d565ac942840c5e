"""The constraints at one choice of sizes, with their values and limits."""

from __future__ import annotations

from math import hypot

import numpy as np

from tmmcalc.cams.optimum.margins import NUMBERS, Judged, judge
from tmmcalc.cams.optimum.results import NAMES, Check, Choice
from tmmcalc.cams.optimum.scene import Scene


def choice_of(scene: Scene, start: float, roller: float, height: float) -> Choice:
    """The sizes with all constraints."""
    found = judge(scene, np.array([start]), np.array([roller]), np.array([height]))
    length = height - start - scene.stroke - roller - scene.guide.gap
    return Choice(start, roller, height, length, (closure(scene), *checks(scene, found, 0, start, roller)))


def closure(scene: Scene) -> Check:
    """The first constraint: the spring over what lifts the follower off."""
    found = scene.spring
    asked = 1.0 if found.asked is None else found.asked
    margin = 1.0 if found.reached is None else 1 - asked / found.reached if found.reached > 0 else -1.0
    return Check(1, NAMES[1], "|Q|/P", found.reached, ">=", asked, "-", margin)


def checks(scene: Scene, found: Judged, k: int, start: float, roller: float) -> tuple[Check, ...]:
    """The constraints NUMBERS at point k of what was judged."""
    need, limits = scene.requirements, scene.limits
    least, most = found.curvature[:, k].tolist()
    base = hypot(start, scene.follower.offset)
    shaft = float(found.shaft[2, k])
    convex = 1 / most - limits.convex if most > 0 else None
    concave = limits.concave + 1 / least if least < 0 else 0.0
    rows: tuple[tuple[str, float, str, float | None, str], ...] = (
        ("D", float(found.slip[k]), "<=", 1.0, "-"),
        ("r2", roller, "<=", convex, "m"),
        ("r2", roller, ">=", concave if concave > 0 and limits.allow_concave else None, "m"),
        ("r2", roller, ">=", float(found.roller[k]), "m"),
        ("r2", roller, "<=", base - shaft, "m"),
        ("sigma_F", float(found.stem[k]), "<=", need.bending, "Pa"),
        ("p", float(found.pressure[k]), "<=", need.guide_pressure, "Pa"),
        ("sigma_H", float(found.stress[k]), "<=", need.contact, "Pa"),
    )
    return tuple(
        Check(number, NAMES[number], symbol, value if known else None, relation, limit, unit, float(margin))
        for number, known, (symbol, value, relation, limit, unit), margin in zip(
            NUMBERS, judged(scene), rows, found.margin[:, k], strict=True
        )
    )


def judged(scene: Scene) -> tuple[bool, ...]:
    """Which of the constraints NUMBERS have data."""
    need, guide = scene.requirements, scene.guide
    pin = need.pin is not None or need.pin_pressure is not None
    rolls = need.rolling_arm is not None and need.roller_friction is not None
    return (
        rolls and (need.roller_inertia is not None or (need.width is not None and pin)),
        True,
        True,
        pin,
        True,
        guide.stem is not None and need.bending is not None,
        guide.stem is not None and guide.land is not None and need.guide_pressure is not None,
        need.width is not None and need.contact is not None,
    )
