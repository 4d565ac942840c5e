"""The pendulum-rotor at 40 digits and more by the differential equation of its rod: power series from the joint down.

E I f'''' - ((N + C) f')' = rho w^2 f,   C = -w^2 rho i^2 + w Omega rho (i_y^2 + i_z^2),   N = g (rho (l - a) + m)
joint    f = 0 and E I f'' = k f', or f' = 0
end      E I f'' = (w^2 J - w Omega J_p) f',   -E I f''' + (g m + C) f' = w^2 m f + force
"""

from __future__ import annotations

from typing import Any

import numpy as np
from mpmath import mp, mpf

from tmmcalc.vibration.pendulum.task import Disc, PendulumTask, Rod, Speeds

SETTLED = 1e-22  # step of the secant method: it leaves far less than that of an error


def thickness(task: PendulumTask) -> float:
    """Of the layer in which bending counts, as a part of the length: its inverse is how far solutions grow."""
    rod = task.rod
    pull = task.gravity * (rod.density * rod.length + task.disc.mass)
    return float((min(rod.bending) / pull) ** 0.5 / rod.length) if pull else 1.0


def digits(task: PendulumTask, w: float) -> int:
    """That are computed with: solutions grow over the layers, over waves, and by the turning of the sections."""
    rod = task.rod
    bending, radius = min(rod.bending), max(rod.radius)
    waves = (rod.density * w**2 / bending) ** 0.25 + w * radius * (2 * rod.density / bending) ** 0.5
    return 40 + int(1 / thickness(task) + rod.length * waves)


def _solution(task: PendulumTask, plane: int, w: Any, spin: Any, start: list[Any]) -> list[Any]:
    """f, f', f'', f''' over a/l at the lower end, of Taylor coefficients at the joint."""
    rod, l, g = task.rod, mpf(task.rod.length), mpf(task.gravity)
    bending, rho = mpf(rod.bending[plane]) / l**4, mpf(rod.density)
    polar = mpf(rod.radius[0]) ** 2 + mpf(rod.radius[1]) ** 2
    turning = rho * (w * spin * polar - w**2 * mpf(rod.radius[plane]) ** 2)
    first, slope, load = (g * (rho * l + mpf(task.disc.mass)) + turning) / l**2, g * rho / l, rho * w**2
    c, sums, n = list(start), [mpf(0)] * 4, 0
    small = mpf(10) ** -(mp.dps + 5)
    while True:
        for k in range(4):
            factor = 1
            for j in range(k):
                factor *= n - j
            sums[k] += factor * c[n]
        pulled = first * (n + 2) * (n + 1) * c[n + 2] - slope * (n + 1) ** 2 * c[n + 1] + load * c[n]
        c.append(pulled / (bending * (n + 4) * (n + 3) * (n + 2) * (n + 1)))
        n += 1
        if n > 12 and max(map(abs, c[n : n + 4])) * n**3 < small * (abs(sums[0]) + abs(sums[3])):
            return sums


def _ends(task: PendulumTask, plane: int, w: Any, spin: Any) -> list[list[Any]]:
    """What the two solutions of the joint leave of the moment and the force at the lower end, and their ends."""
    rod, disc, l = task.rod, task.disc, mpf(task.rod.length)
    bending, m = mpf(rod.bending[plane]), mpf(disc.mass)
    if task.pivot is None:
        starts = [[mpf(0), mpf(0), mpf(1), mpf(0)], [mpf(0), mpf(0), mpf(0), mpf(1)]]
    else:
        starts = [[mpf(0), mpf(1), mpf(task.pivot) * l / (2 * bending), mpf(0)], [mpf(0), mpf(0), mpf(0), mpf(1)]]
    polar = mpf(rod.radius[0]) ** 2 + mpf(rod.radius[1]) ** 2
    turning = mpf(rod.density) * (w * spin * polar - w**2 * mpf(rod.radius[plane]) ** 2)
    found = []
    for start in starts:
        f, f1, f2, f3 = _solution(task, plane, w, spin, start)
        f1, f2, f3 = f1 / l, f2 / l**2, f3 / l**3
        moment = bending * f2 + (w * spin * mpf(disc.polar) - w**2 * mpf(disc.diametral[plane])) * f1
        force = -bending * f3 + (mpf(task.gravity) * m + turning) * f1 - w**2 * m * f
        found.append([moment, force, f])
    return found


def frequency(task: PendulumTask, plane: int, told: float, spin: float | None = None) -> Any:
    """The root of the frequency equation next to a number; a critical speed without a ``spin``."""

    def open_(w: Any) -> Any:
        one, two = _ends(task, plane, w, abs(w) if spin is None else mpf(spin))
        return one[0] * two[1] - one[1] * two[0]

    with mp.workdps(digits(task, abs(told) + abs(spin or 0.0))):
        return mp.findroot(open_, (mpf(told), mpf(told) * (1 + mpf(10) ** -9)), tol=SETTLED, verify=False)


def whirl(task: PendulumTask) -> Any:
    """Displacement of the lower end that turns with the rotor by its eccentricity."""
    w = mpf(task.spin)
    with mp.workdps(digits(task, abs(task.spin))):
        one, two = _ends(task, 0, w, w)
        force = mpf(task.disc.mass) * mpf(task.disc.eccentricity) * w**2
        system = mp.matrix([[one[0], two[0]], [one[1], two[1]]])
        shares = mp.lu_solve(system, mp.matrix([0, force]))
        return shares[0] * one[2] + shares[1] * two[2]


def torsion(task: PendulumTask, told: float) -> Any:
    """The root of G I_p k cos(k l) = w^2 J_p sin(k l) with k = w sqrt(inertia/G I_p)."""
    rod = task.rod
    section = mpf(rod.density) * (mpf(rod.radius[0]) ** 2 + mpf(rod.radius[1]) ** 2)
    stiffness, l, polar = mpf(rod.torsion), mpf(rod.length), mpf(task.disc.polar)

    def open_(w: Any) -> Any:
        k = w * mp.sqrt(section / stiffness)
        return stiffness * k * mp.cos(k * l) - w**2 * polar * mp.sin(k * l)

    return mp.findroot(open_, mpf(told), tol=SETTLED, verify=False)


def random_pendulum(rng: np.random.Generator, soft: float = 2e-2) -> PendulumTask:
    """Stiff rods and such with layers of ``soft`` of their length; hung, sprung or clamped; slender and stout."""
    length, density = 10 ** rng.uniform(-2, 1), 10 ** rng.uniform(-2, 2)
    mass = float(rng.choice([0.0, density * length * 10 ** rng.uniform(-1, 2)]))
    gravity = float(rng.choice([9.81, 9.81, 0.0]))
    weight = 9.81 * (density * length + mass)
    bending = weight * length**2 * 10 ** rng.uniform(2 * np.log10(soft), 4)
    radius = length * 10 ** rng.uniform(-3, -0.7)
    round_ = rng.random() < 0.8
    pair = (bending, bending if round_ else bending * rng.uniform(1.01, 2))
    radii = (radius, radius if round_ else radius * rng.uniform(1.01, 2))
    turned = mass * (length * rng.uniform(0.05, 0.5)) ** 2
    disc = Disc(mass, (turned, turned), 2 * turned * float(rng.choice([0.0, 1.0])), 1e-3 * length)
    pivot = [0.0, None, weight * length * 10 ** rng.uniform(-2, 2)][rng.integers(0 if gravity else 1, 3)]
    spin = (weight / (density * length + mass) / length) ** 0.5 * 10 ** rng.uniform(-1, 2) if round_ else 0.0
    spin = spin if rng.random() < 0.8 else 0.0
    rod = Rod(length, density, pair, radii, torsion=bending * 0.8)
    speeds = Speeds(0.0, 2 * spin, 3) if spin and rng.random() < 0.5 else None
    return PendulumTask(rod, disc, pivot, gravity, spin, int(rng.integers(1, 6)), speeds)
