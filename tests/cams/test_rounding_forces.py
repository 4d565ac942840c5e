"""Estimates of forces, strength and vibration on random cams, against all rows in extended precision."""

from __future__ import annotations

import numpy as np
import pytest

from tests.cams.exact import SCENES, judge, random_program
from tests.cams.test_rounding_motion import LIMITS, random_follower
from tmmcalc.cams.elasticerrors import vibration_errors
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.response import kicks_of, steady
from tmmcalc.cams.speed import constant_speed
from tmmcalc.cams.strength.solve import solve_strength
from tmmcalc.cams.task import Asked, CamTask, Guide, Loads, Requirements, Spring
from tmmcalc.cams.wide import wide
from tmmcalc.errors import NoSolutionError, SingularityError
from tmmcalc.numerics.panels import Panels

pytestmark = pytest.mark.slow

NEEDS = Requirements(width=0.008, contact=4e8, rolling_arm=5e-5, roller_friction=0.1, pin_friction=0.1,
                     pin_pressure=5e6, span=0.1, bending=1e8, deflection=1e-5, guide_pressure=5e6)  # fmt: skip


def loaded(random, kind):
    turns = kind == "oscillating"
    stroke = random.uniform(0.1, 0.5) if turns else 10 ** random.uniform(-2.5, -1.7)
    loads = Loads(
        random.uniform(5, 200), random.uniform(1e-4, 1e-3) if turns else random.uniform(0.05, 1.0),
        friction=0.0 if turns else random.uniform(0, 0.08), spring=Spring(safety=random.uniform(1.1, 2.0)),
        pivot_friction=0.1 if turns else 0.0, pivot_radius=0.005 if turns else 0.0,
    )  # fmt: skip
    task = CamTask(
        random_program(random, stroke), Asked(kind), LIMITS, int(random.integers(5, 40)), loads=loads,
        guide=Guide(length=random.uniform(0.05, 0.1), stem=0.005, land=0.005), requirements=NEEDS,
    )  # fmt: skip
    return task, random_follower(random, kind)


def forces_by_hand(task, follower, spring, guide):
    """P_c, R and the driving torque (n,) at the rows in extended precision, from the equations of equilibrium."""
    rows, loads = task.positions, wide(task.loads)
    y, y1, y2, _ = task.program.wider.at(wide(rows.phi), rows.piece)
    kinds = np.array([each.kind for each in task.program.phases])[task.program.places[0][rows.piece]]
    sense = np.where(kinds == "rise", 1, np.where(kinds == "return", -1, 0))
    load = -loads.mass * loads.speed**2 * y2 - wide(spring.preload) - wide(spring.stiffness) * y
    f = wide(follower)
    arm = f.rocker if follower.kind == "oscillating" else np.longdouble(1)
    if follower.kind == "oscillating":
        theta = np.arctan2(f.rocker * (1 - y1) - f.centres * np.cos(f.start + y), f.centres * np.sin(f.start + y))
        ratio = loads.pivot_friction * loads.pivot_radius / f.rocker
    elif follower.kind == "flat":
        theta, ratio = np.zeros_like(y), 2 * loads.friction * np.abs(y1) / wide(guide.length)
    else:
        theta = np.arctan((y1 + f.offset) / (f.start + y))
        above = wide(task.program.highest) + f.roller - y
        ratio = loads.friction * np.abs(np.sin(theta)) * (1 + 2 * above / wide(guide.length))
    contact = -load / (arm * (np.cos(theta) - np.where(load > 0, -sense, sense) * ratio))
    return load, contact, arm * contact * np.cos(theta) * y1


def off(found, exact):
    size = float(np.max(np.abs(exact)))
    return float(np.max(np.abs(found - exact))) / size if size else 0.0


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["translating", "oscillating", "flat"])
def test_estimates_of_forces_and_strength(kind):
    random, pairs = np.random.default_rng(7), {}
    last = "stress" if kind == "flat" else "load"
    while len(pairs.get(last, ())) < SCENES:
        task, follower = loaded(random, kind)
        try:
            found = solve_forces(task, follower)
        except (SingularityError, NoSolutionError):
            continue
        exact = forces_by_hand(task, follower, found.spring, found.guide)
        for name, true in zip(("load", "contact", "driving"), exact, strict=True):
            pairs.setdefault(name, []).append((found.error[name], off(getattr(found, name), true)))
        strength = solve_strength(task, follower, found)
        span, torsion = np.longdouble(NEEDS.span), np.longdouble(NEEDS.torsion)
        motion = task.program.wider.at(wide(task.positions.phi), task.positions.piece)
        reduced = np.sqrt((exact[1] * span / 4) ** 2 + torsion * (exact[0] * motion[1]) ** 2)
        pairs.setdefault("reduced", []).append((strength.error["reduced"], off(strength.reduced, reduced)))
        if "stress" in strength.error and kind == "flat":
            radius = wide(follower.start) + motion[0] + motion[2]
            stress = np.longdouble(0.418) * np.sqrt(np.longdouble(NEEDS.modulus) / NEEDS.width * exact[1] / radius)
            pairs.setdefault("stress", []).append((strength.error["stress"], off(strength.stress, stress)))
    judge(pairs)


def test_estimates_of_the_vibration():
    """Against panels cut in half, in extended precision."""
    random, pairs = np.random.default_rng(11), {}
    for _ in range(SCENES):
        program = random_program(random, 0.02)
        omega, damping = random.uniform(5, 200), random.choice([0.01, 0.05, 0.2])
        frequency = omega * random.uniform(3, 40)
        speed = constant_speed(omega)
        course = steady(program, speed, frequency, damping)
        error = vibration_errors(program, speed, course, frequency, damping)
        w, zeta = np.longdouble(frequency), np.longdouble(damping)
        rate = -zeta * w + 1j * w * np.sqrt(1 - zeta**2)
        edges = wide(course.panels.edges)
        on = Panels(np.sort(np.concatenate((edges, (edges[1:] + edges[:-1]) / 2))), course.panels.order)
        ratio, kicks = kicks_of(program.wider, speed, on, rate)
        q = [np.clongdouble(0)]
        for turn in range(2):
            for factor, kick in zip(ratio, kicks, strict=True):
                q.append(factor * q[-1] + kick)
            if turn == 0:
                q = [q[-1] / (1 - np.exp(rate * 2 * np.longdouble(np.pi) / np.longdouble(omega)))]
        exact = np.array(q[::2])
        pairs.setdefault("residual", []).append((error["residual"], off(course.edges, exact)))
        z, true = course.edges.imag / rate.imag, exact.imag / rate.imag
        pairs.setdefault("stretch", []).append((error["stretch"], off(z, true)))
    judge(pairs)
