"""Estimated errors of pairs against sizes in 50 digits."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from math import radians
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.function import inverse_extended, involute_extended
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask

pytestmark = pytest.mark.slow

SCENES = 220


def _inv(a: Any) -> Any:
    return mp.tan(a) - a


def _inverse(q: Any) -> Any:
    start = mp.cbrt(3 * q) if q < 1 else mp.atan(q + mp.pi / 2)
    return mp.findroot(lambda a: _inv(a) - q, min(start, mp.atan(q + mp.pi / 2)), tol=1e-90)


def _exact(found: MeshPair) -> dict[str, list[tuple[float, Any]]]:
    """What was told and the truth, by the textbook's formulas of two external wheels, of a ring and of a rack."""
    task, (x1, x2) = found.task, (mp.mpf(x) for x in found.shifts)
    z1, z2 = task.teeth
    m, alpha, beta = mp.mpf(task.module), mp.mpf(task.rack.angle), mp.mpf(task.helix)
    a_t = mp.atan(mp.tan(alpha) / mp.cos(beta))
    r1, r2 = z1 / (2 * mp.cos(beta)), z2 / (2 * mp.cos(beta))
    b1, b2 = r1 * mp.cos(a_t), r2 * mp.cos(a_t)
    pitch = mp.pi / mp.cos(beta) * mp.cos(a_t)
    ha, c = mp.mpf(task.rack.addendum), mp.mpf(task.rack.clearance)
    if task.kind == "external":
        if task.strategy == "given_aw":
            a_w = mp.mpf(task.distance) / m
            w = mp.acos((b1 + b2) / a_w)
        else:
            w = _inverse(_inv(a_t) + 2 * (x1 + x2) * mp.tan(alpha) / (z1 + z2))
            a_w = (b1 + b2) / mp.cos(w)
        tips = a_w - (r2 - ha - c + x2) - c, a_w - (r1 - ha - c + x1) - c
        rho = [mp.sqrt(t**2 - b**2) for t, b in zip(tips, (b1, b2), strict=True)]
        ratio = (rho[0] + rho[1] - a_w * mp.sin(w)) / pitch
    elif task.kind == "internal":
        w = _inverse(_inv(a_t) - 2 * (x1 + x2) * mp.tan(alpha) / (z2 - z1))
        a_w = (b2 - b1) / mp.cos(w)
        tips = r1 + ha + x1, r2 - ha - x2
        if abs(tips[1] - found.sizes[1].tip / m) > 1e-6:
            tips = tips[0], mp.mpf(found.sizes[1].tip) / m
        rho = [mp.sqrt(t**2 - b**2) for t, b in zip(tips, (b1, b2), strict=True)]
        ratio = (rho[0] - rho[1] + a_w * mp.sin(w)) / pitch
    else:
        w, a_w, tips = a_t, r1 + x1, (r1 + ha + x1,)
        rho = [mp.sqrt(tips[0] ** 2 - b1**2)]
        ratio = (rho[0] - r1 * mp.sin(a_t) + (ha - x1) / mp.sin(a_t)) / pitch
    truth: dict[str, list[tuple[float, Any]]] = defaultdict(list)
    truth["angle"] = [(found.angle_w, w)]
    truth["distance"] = [(found.distance, m * a_w)]
    truth["contact_ratio"] = [(found.contact_ratio, ratio)]
    for k, size in enumerate(found.sizes):
        x, r, b, z = ((x1, x2)[k], (r1, r2)[k], (b1, b2)[k], (z1, z2)[k])
        side = -1 if size.kind == "ring" else 1
        psi = (mp.pi / 2 + side * 0 + 2 * x * mp.tan(alpha)) / z
        turned = side * (_inv(a_t) - _inv(mp.acos(b / tips[k])))
        tilt = mp.cos(mp.atan(mp.tan(beta) * tips[k] / r))
        truth["thickness"] += [
            (size.thickness, m * 2 * r * psi * mp.cos(beta)),
            (size.tip_thickness, m * 2 * tips[k] * (psi + turned) * tilt),
        ]
        measured = found.measures[k]
        if measured.span is not None:
            inner = mp.pi * (measured.span.teeth - mp.mpf(1) / 2) + 2 * x * mp.tan(alpha) + z * _inv(a_t)
            truth["span"].append((measured.span.length, m * mp.cos(alpha) * inner))
        if measured.balls is not None:
            size_ = mp.mpf(measured.balls.diameter) / m
            space = (mp.pi / 2 - 2 * x * mp.tan(alpha)) / z
            at = (
                _inverse(_inv(a_t) + side * (size_ / (z * mp.cos(alpha)) - space))
                if side > 0
                else _inverse(_inv(a_t) - size_ / (z * mp.cos(alpha)) + (mp.pi / 2 - 2 * x * mp.tan(alpha)) / z)
            )
            across = 2 * b / mp.cos(at) * (mp.cos(mp.pi / (2 * z)) if z % 2 else 1)
            truth["balls"].append((measured.balls.size, m * (across + side * size_)))
    return truth


def _random(kind: str) -> Iterator[MeshPair]:
    rng = np.random.default_rng(len(kind))
    found = 0
    while found < SCENES:
        z1 = int(rng.integers(8, 60))
        z2 = {"external": int(rng.integers(z1, 200)), "internal": z1 + int(rng.integers(12, 150)), "rack": 0}[kind]
        helix = float(rng.choice([0.0, radians(rng.uniform(2, 35))]))
        given = {"shifts": (float(rng.uniform(-0.3, 0.9)), float(rng.uniform(-0.4, 0.8)) if z2 else None)}
        more: dict[str, Any] = {"strategy": "given"}
        if kind == "external" and rng.random() < 0.3:
            more = {"strategy": "given_aw", "distance": (z1 + z2) / 2 * rng.uniform(0.995, 1.03) * 0.004}
            given = {"shifts": (given["shifts"][0], None)}
            helix = 0.0
        task = PairTask((z1, z2), 0.004, kind=kind, helix=helix, refuse=False, **given, **more)
        try:
            pair = solve_pair(task)
        except NoSolutionError:
            continue
        if min(size.tip - size.base for size in pair.sizes) > 0:
            found += 1
            yield pair


@pytest.mark.parametrize("kind", ["external", "internal", "rack"])
def test_estimates_of_pairs_bound_their_errors(kind: str) -> None:
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)
    with mp.workdps(50):
        for found in _random(kind):
            for name, values in _exact(found).items():
                largest = max(abs(truth) for _, truth in values)
                error = float(max(abs(told - truth) for told, truth in values) / largest)
                pairs[name].append((getattr(found.error, name), error))
    assert {"angle", "distance", "contact_ratio", "thickness", "span", "balls"} == {*pairs}
    for name, each in pairs.items():
        assert_bounds(each, f"{name} of {kind}", scenes=SCENES * 9 // 10)


def test_the_involute_in_extended_precision() -> None:
    angles = np.concatenate((np.geomspace(1e-6, 1.0, 60), np.linspace(1.0, 1.55, 40)))
    with mp.workdps(50):
        for a in angles:
            found = mp.mpf(str(involute_extended(a)))
            assert abs(found / _inv(mp.mpf(float(a))) - 1) < 3e-17
            angle = mp.mpf(str(inverse_extended(float(found))))
            assert abs(angle / _inverse(mp.mpf(float(found))) - 1) < 3e-17
