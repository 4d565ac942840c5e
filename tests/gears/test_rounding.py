"""Estimated errors of tooth sets, their strength and their criteria against the same in 50 digits."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from bounding import assert_bounds

from tmmcalc.gears.criteria.efficiency import MeshEfficiency
from tmmcalc.gears.criteria.errors import criteria_error
from tmmcalc.gears.criteria.evaluate import Assumptions, evaluate
from tmmcalc.gears.model import Demands, Interval, ToothSets, TrainTask
from tmmcalc.gears.search.search import _angles, angle_error
from tmmcalc.gears.strength.errors import strength_error
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.task import StageTask, StrengthTask

pytestmark = pytest.mark.slow

SCENES = 200
ROWS = 5  # trains of a scene


def _trains(rng: np.random.Generator) -> ToothSets:
    """Single planets, whose ring has few or many more teeth than the planet."""
    sun = rng.integers(14, 90, ROWS)
    planet = rng.integers(17, 120, ROWS)
    ring = planet + np.where(rng.random(ROWS) < 0.3, rng.integers(7, 12, ROWS), planet + sun)
    teeth = np.stack((sun, planet, ring), axis=1)
    return ToothSets("AIbar", teeth, np.ones((ROWS, 1), np.int64), np.full((ROWS, 2), 0.35), planets=3)


def _worst(told: Any, exact: list[Any]) -> float:
    largest = max(abs(each) for each in exact)
    return float(max(abs(float(one) - each) for one, each in zip(np.ravel(told), exact, strict=True)) / largest)


def _strengths() -> Iterator[tuple[str, float, float]]:
    rng = np.random.default_rng(3)
    for _ in range(SCENES):
        sets, torque = _trains(rng), float(rng.uniform(5, 900))
        sigma_H, sigma_F = float(rng.uniform(400e6, 900e6)), float(rng.uniform(150e6, 300e6))
        psi = float(rng.uniform(0.3, 1.2))
        task = StrengthTask(torque, (StageTask(psi_bd=psi, permissible_contact=sigma_H, permissible_bending=sigma_F),))
        found = solve_strength(sets, task)
        error = strength_error(sets, task, found)
        assert error is not None
        beta = {c.symbol: mp.mpf(c.value) for c in found.coefficients}
        spread = {side: 1 + beta[f"beta_{side}"] * mp.mpf(psi) for side in "HF"}
        required, contact, bending = [], [], []
        for row, teeth in enumerate(sets.teeth.tolist()):
            C_H, C_F = _demands(teeth, mp.mpf(torque) / 3, mp.mpf(sigma_H), mp.mpf(sigma_F))
            required += [mp.cbrt(C_H * spread["H"] / mp.mpf(psi)), mp.cbrt(C_F * spread["F"] / mp.mpf(psi))]
            reference = min(teeth[0], teeth[1])
            module, width = mp.mpf(float(found.module[row, 0])), mp.mpf(float(found.width[row, 0]))
            borne = width / (module * reference) * module**3
            contact.append(mp.mpf(sigma_H) * mp.sqrt(C_H * spread["H"] / borne))
            bending.append(mp.mpf(sigma_F) * C_F * spread["F"] / borne)
        told = np.stack((found.contact_module[:, 0], found.bending_module[:, 0]), axis=1)
        yield "module", error.module, _worst(told, required)
        yield "contact stress", error.contact_stress, _worst(found.contact_stress, contact)
        yield "bending stress", error.bending_stress, _worst(found.bending_stress, bending)


def _demands(teeth: list[int], torque: Any, sigma_H: Any, sigma_F: Any) -> tuple[Any, Any]:
    """Largest C_H and C_F of both meshes, sun and planet, planet and ring (4.38, 4.41)."""
    sun, planet, ring = (mp.mpf(z) for z in teeth)
    reference = min(sun, planet)
    contact, bending = [], []
    for one, other, internal in ((sun, planet, False), (planet, ring, True)):
        small, large = min(one, other), max(one, other)
        u = large / small
        on = torque * small / sun  # the planet is an idler: both of its meshes carry the tangential force of the sun's
        factor = (u - 1 if internal else u + 1) / u
        contact.append(mp.mpf(770) ** 3 * 1000 * on * factor / (reference * small**2 * sigma_H**2))
        form = [mp.mpf("3.568") + (0 if z is ring else mp.mpf("201.95") / z**2) for z in (one, other)]
        bending.append(mp.mpf(14) ** 3 / 1000 * on * max(form) / sigma_F / (reference * small))
    return max(contact), max(bending)


def _criteria() -> Iterator[tuple[str, float, float]]:
    rng = np.random.default_rng(4)
    for _ in range(SCENES):
        sets, basis = _trains(rng), Assumptions(meshes=MeshEfficiency(0.97, float(rng.uniform(0.95, 0.99))))
        module = rng.choice([0.001, 0.0015, 0.002, 0.00275], (ROWS, 1))
        width = rng.integers(8, 60, (ROWS, 1)) / 1000
        found = evaluate(sets, module, width, basis=basis)
        error = criteria_error(sets, module, width, basis, found)
        assert error is not None
        truth: dict[str, list[Any]] = defaultdict(list)
        for row, (sun, planet, ring) in enumerate(sets.teeth.tolist()):
            m, b = mp.mpf(float(module[row, 0])), mp.mpf(float(width[row, 0]))
            r1, r2 = m * sun / 2, m * planet / 2
            solid = [mp.pi * 7820 * b * r**2 for r in (r1, r2)]
            light = mp.mpf(basis.build.webbed_mass) * solid[1]
            truth["mass"].append(solid[0] + 3 * light)
            ratio = 1 + mp.mpf(ring) / sun
            own = 1 - mp.mpf(ring) / planet  # of the planet over the carrier
            stretch = mp.cos(mp.mpf(basis.rack)) / mp.cos(mp.mpf(0.35))
            orbit = (r1 + r2) * stretch
            turned = solid[0] * r1**2 / 2 * ratio**2
            turned += 3 * (mp.mpf(basis.build.webbed_inertia) * light * r2**2 / 2 * own**2 + light * orbit**2)
            truth["inertia"].append(turned)
            truth["size"].append(2 * (orbit + r2))
            truth["envelope"].append(2 * max(orbit + r2, m * ring / 2, r1))
            eta = mp.mpf(basis.meshes.external) * mp.mpf(basis.meshes.internal)
            truth["efficiency"].append(eta + (1 - eta) / ratio)
        for name, exact in truth.items():
            yield name, getattr(error, name), _worst(getattr(found, name), exact)


def _angles_of_sets() -> Iterator[tuple[str, float, float]]:
    rng = np.random.default_rng(5)
    task = TrainTask(
        "AI", nominal=mp.mpf(1), ratio=Interval(1, 2), proportions=((1, 1),), planets=3,
        demands=Demands(largest_angle=0.6), pressure_angle=0.3490658503988659,
    )  # fmt: skip
    for _ in range(SCENES):
        z1, z2, z2b = (rng.integers(17, 90, ROWS) for _ in range(3))
        teeth = np.stack((z1, z2, z2b, z1 + z2 + z2b + rng.integers(-3, 4, ROWS)), axis=1)
        modules = np.ones((ROWS, 2), np.int64)
        sets = ToothSets("AI", teeth, modules, _angles(task, teeth, modules), planets=3)
        exact = []
        for a, b, c, d in teeth.tolist():
            sums = [a + b, d - c]
            exact += [mp.acos(mp.cos(mp.mpf(task.pressure_angle)) * each / max(sums)) for each in sums]
        if np.any(sets.angles != task.pressure_angle):
            yield "angles", angle_error(task, sets), _worst(sets.angles, exact)


@pytest.mark.parametrize("scenes", [_strengths, _criteria, _angles_of_sets])
def test_estimates_of_trains_bound_their_errors(scenes: Any) -> None:
    pairs: dict[str, list[tuple[float, float]]] = defaultdict(list)
    with mp.workdps(50):
        for name, estimate, error in scenes():
            pairs[name].append((estimate, error))
    for name, each in pairs.items():
        assert_bounds(each, name, scenes=SCENES * 3 // 4)


def test_angles_of_the_rack_are_exact() -> None:
    sets = ToothSets("AIbar", np.array([[20, 52, 124]]), np.ones((1, 1), np.int64), np.full((1, 2), 0.35), planets=3)
    task = TrainTask("AIbar", 6, Interval(5, 7), ((1,),), 3, pressure_angle=0.35)
    assert angle_error(task, sets) == 0.0
    assert angle_error(task, replace(sets, teeth=sets.teeth[:0], angles=sets.angles[:0])) == 0.0
