"""Estimated errors of blocking contours: areas against a rule of 64 points, corners against roots in 50 digits."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import radians
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds

from tmmcalc.gears.involute.contour.contour import Contour, contour, contours
from tmmcalc.gears.involute.contour.errors import contour_error
from tmmcalc.gears.involute.contour.task import Task
from tmmcalc.gears.involute.wheel import Wheel

pytestmark = pytest.mark.slow

TASKS = 130
PLAIN = ("undercut", "interference", "contact_ratio", "thickness", "tip")  # lines that need no fillet


def _tasks() -> Iterator[Task]:
    rng = np.random.default_rng(11)
    for _ in range(TASKS):
        z1 = int(rng.integers(9, 40))
        z2, helix = int(rng.integers(z1, 120)), float(rng.choice([0.0, radians(rng.uniform(3, 30))]))
        thin = float(rng.choice([0.0, 0.25]))
        yield Task(Wheel(z1, 0.0, helix), Wheel(z2, 0.0, helix), float(rng.uniform(1, 1.2)), (thin, thin))


def _conditions(task: Task) -> dict[str, Callable[[Any, Any], Any]]:
    """The conditions in high precision as functions of the shifts, by the textbook's formulas."""
    z, rack = (task.first.teeth, task.second.teeth), task.first.rack
    alpha, beta = mp.mpf(rack.angle), mp.mpf(task.first.helix)
    a_t = mp.atan(mp.tan(alpha) / mp.cos(beta))
    r = [n / (2 * mp.cos(beta)) for n in z]
    b = [each * mp.cos(a_t) for each in r]
    pitch = mp.pi / mp.cos(beta) * mp.cos(a_t)

    def inv(a: Any) -> Any:
        return mp.tan(a) - a

    def mesh(x1: Any, x2: Any) -> tuple[Any, list[Any], list[Any]]:
        target = inv(a_t) + 2 * (x1 + x2) * mp.tan(alpha) / sum(z)
        w = mp.findroot(lambda a: inv(a) - target, float(mp.cbrt(3 * target)) * 0.9, tol=1e-80)
        a_w = sum(b) / mp.cos(w)
        tips = [a_w - r[1] - x2 + rack.addendum, a_w - r[0] - x1 + rack.addendum]
        rho = [mp.sqrt(tip**2 - base**2) for tip, base in zip(tips, b, strict=True)]
        return a_w * mp.sin(w), tips, rho

    def limit(i: int, x: Any) -> Any:
        return r[i] * mp.sin(a_t) - (mp.mpf(rack.straight) - x) / mp.sin(a_t)

    def interference(i: int) -> Callable[[Any, Any], Any]:
        def value(x1: Any, x2: Any) -> Any:
            g, _, rho = mesh(x1, x2)
            return g - rho[1 - i] - limit(i, (x1, x2)[i])

        return value

    def thickness(i: int) -> Callable[[Any, Any], Any]:
        def value(x1: Any, x2: Any) -> Any:
            _, tips, rho = mesh(x1, x2)
            psi = (mp.pi / 2 + 2 * (x1, x2)[i] * mp.tan(alpha)) / z[i]
            half = psi + inv(a_t) - inv(mp.atan(rho[i] / b[i]))
            return 2 * tips[i] * half * mp.cos(mp.atan(mp.tan(beta) * tips[i] / r[i])) - task.thickness[i]

        return value

    def contact(x1: Any, x2: Any) -> Any:
        g, _, rho = mesh(x1, x2)
        return (rho[0] + rho[1] - g) / pitch - task.contact_ratio

    return {
        "contact_ratio": contact,
        **{f"interference{i + 1}": interference(i) for i in (0, 1)},
        **{f"thickness{i + 1}": thickness(i) for i in (0, 1)},
        **{f"undercut{i + 1}": lambda x1, x2, i=i: limit(i, (x1, x2)[i]) for i in (0, 1)},
        **{f"tip{i + 1}": lambda x1, x2, i=i: mesh(x1, x2)[1][i] - r[i] for i in (0, 1)},
    }


def _corner_error(found: Contour) -> float | None:
    """True error of the corners, relative to the largest shift of any; None if none is of plain lines."""
    assert found.main is not None
    conditions, missed = _conditions(found.task), []
    corners = found.main.corners
    for corner in corners:
        one, two = corner.lines
        if one == two or not (one.startswith(PLAIN) and two.startswith(PLAIN)):
            continue
        f, g = conditions[one], conditions[two]
        root = mp.findroot(lambda x1, x2, f=f, g=g: [f(x1, x2), g(x1, x2)], (corner.x1, corner.x2), tol=1e-50)
        missed.append(max(abs(root[0] - corner.x1), abs(root[1] - corner.x2)))
    scale = max(max(abs(corner.x1), abs(corner.x2)) for corner in corners) if corners else 1.0
    return float(max(missed)) / scale if missed else None


@pytest.fixture(scope="module")
def scenes() -> list[tuple[Contour, Contour]]:
    """Contours as they are, and with finer edges."""
    found = []
    for task in _tasks():
        for plain in contours(task):
            if plain.main is not None:
                found.append((plain, contour(task, plain.strict, points=64)))
    return found


def test_estimates_of_areas_are_bounds(scenes: list[tuple[Contour, Contour]]) -> None:
    pairs = []
    for plain, fine in scenes:
        assert plain.main is not None
        assert fine.main is not None
        error = contour_error(plain)
        assert error is not None
        pairs.append((error.area, abs(plain.main.area / fine.main.area - 1)))
    assert_bounds(pairs, "area")


def test_estimates_of_corners_are_bounds(scenes: list[tuple[Contour, Contour]]) -> None:
    pairs = []
    with mp.workdps(50):
        for plain, _ in scenes:
            true, error = _corner_error(plain), contour_error(plain)
            assert error is not None
            if true is not None:
                pairs.append((error.corners, true))
    assert_bounds(pairs, "corners")
