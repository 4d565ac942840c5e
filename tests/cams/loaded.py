"""Random loads of random cams: springs of all methods, friction, weight, technological forces, a speed that varies."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from cams.scenes import KINDS, random_cam
from tmmcalc.cams.speed import TURN, Speed
from tmmcalc.cams.task import Force, Guide, Loads, Spring
from tmmcalc.core.numerics.panels import panels


def random_spring(random, stiffness, force):
    """A return spring; stiffness and force are of the order of what inertia asks for."""
    return (
        Spring(safety=random.uniform(1.05, 2.5)),
        Spring(safety=random.uniform(1.05, 2.5)),
        Spring(safety=random.uniform(1.05, 2.5), exact=True),
        Spring("preload", least=force * 10 ** random.uniform(-2, 0)),
        Spring("given", stiffness=stiffness * random.uniform(0.5, 3), preload=force * random.uniform(0, 1)),
        Spring("none"),
    )[random.integers(6)]


def waved(random, omega):
    """A speed of two harmonics as panels, and by its formula with omega domega/dphi."""
    one, two = random.uniform(0, 0.15, 2).tolist()

    def rate(lib, phi):
        a, b = lib.mpf(one), lib.mpf(two)
        found = lib.mpf(omega) * (1 + a * lib.cos(phi) + b * lib.sin(2 * phi))
        return found, found * lib.mpf(omega) * (-a * lib.sin(phi) + 2 * b * lib.cos(2 * phi))

    return rate


def random_loaded(random, kind=None):
    """A task with loads, its follower, and its speed where that varies."""
    from cams.exact_peaks import PLAIN

    task, follower = random_cam(random, kind or str(random.choice(KINDS)))
    turns, h, omega = follower.kind == "oscillating", task.program.stroke, 10 ** random.uniform(0, 2.5)
    mass = 10 ** random.uniform(-3, 1) * (follower.rocker**2 if turns else 1)
    inertia = mass * omega**2 * h
    force = Force(*(inertia * random.uniform(-3, 0.3, 2)).tolist()) if random.random() < 0.5 else Force()
    loads = Loads(
        omega, mass, force,
        gravity=0.0 if turns else float(random.choice([0.0, -9.81, -5.0])),
        spring=random_spring(random, inertia / h, inertia),
        friction=0.0 if turns else float(random.choice([0.0, 0.05, 0.2])),
        pivot_friction=0.1 if turns else 0.0, pivot_radius=0.1 * follower.rocker if turns else 0.0,
    )  # fmt: skip
    roller = 0.0 if follower.kind == "flat" else follower.roller
    gap, length = h * random.uniform(0, 1), (h + follower.start) * 10 ** random.uniform(-0.3, 0.7)
    guide = Guide(length=length, gap=gap)
    if random.random() < 0.5:
        guide = Guide(top=follower.start + h + roller + gap + length, gap=gap)
    asked = replace(task.asked, closure=str(random.choice(["force", "groove"])) if follower.kind != "flat" else "force")
    task, rate = replace(task, asked=asked, loads=loads, guide=Guide() if turns else guide), None
    if random.random() < 0.25:
        rate, on = waved(random, omega), panels(0.0, TURN, widest=np.pi / 12)
        task = replace(task, turning=Speed(on, *rate(PLAIN, on.x)))
    return task, follower, rate
