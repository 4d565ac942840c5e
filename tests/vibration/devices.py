"""Random vibratory devices, and their equations at 50 digits from the motions of points and from springs alone."""

from __future__ import annotations

from typing import Any

import numpy as np
from mpmath import mp, mpf

from tmmcalc.vibration.vibrator.task import Damping, Exciter, Flats, Gripper, Ring, Rods, Unbalance, VibratorTask

COUNT = 7


def random_device(rng: np.random.Generator) -> VibratorTask:
    """Sizes, masses and stiffnesses within decades; damped by parts of critical damping or by coefficients."""
    size, mass = 10 ** rng.uniform(-2, 0), 10 ** rng.uniform(-1, 2)

    def length() -> float:
        return float(size * rng.uniform(0.2, 1.0))

    def inertia() -> float:
        return float(mass * length() ** 2)

    def weight() -> float:
        return float(mass * rng.uniform(0.2, 2))

    stiff = mass * (2 * np.pi * 20) ** 2
    rods = Rods(length(), diameter=size * 0.02, length=size * rng.uniform(0.3, 1))
    if rng.random() < 0.5:
        rods = Rods(length(), float(stiff * 10 ** rng.uniform(-1, 1)))
    flats = Flats(width=size * 0.2, thickness=size * rng.uniform(0.005, 0.02), length=size * 0.4, offset=size * 0.3)
    if rng.random() < 0.5:
        flats = Flats(*(stiff * 10 ** rng.uniform(-1, 2, 2) * [1, size**2]).tolist())
    ratio = float(rng.choice([0.0, 10 ** rng.uniform(-4, -0.5)]))
    direct = (stiff * mass) ** 0.5 * 10 ** rng.uniform(-4, -1) * np.array([1, 1, *[size**2] * 3, 1, size**2])
    return VibratorTask(
        Ring(weight(), inertia()),
        Gripper(weight(), length(), inertia(), inertia(), inertia()),
        Exciter(weight(), length(), length(), float(rng.uniform(-1, 1)), inertia(), inertia()),
        rods,
        flats,
        float(stiff * size**2 * 10 ** rng.uniform(-2, 3)),
        damping=Damping(ratio) if rng.random() < 0.7 else Damping(0.0, tuple(direct.tolist())),
        unbalance=Unbalance(float(mass * size * 1e-4), length(), length(), float(rng.uniform(-1, 1)), inertia()),
    )


def _unit(k: int) -> list[Any]:
    return [mpf(int(k == i)) for i in range(COUNT)]


def _moved(*parts: tuple[Any, list[Any]]) -> list[Any]:
    return [sum((factor * row[i] for factor, row in parts), mpf(0)) for i in range(COUNT)]


X, Y, PHI, TILT_X, TILT_Y, Z, GAMMA = (_unit(k) for k in range(COUNT))


def _of_exciter(radius: Any, arm: Any, angle: Any) -> list[list[Any]]:
    """Displacement along x, y and z of a point over the bisector of x and y."""
    h = mp.sqrt(mpf(1) / 2)
    back, up = -arm * mp.sin(angle) * h, arm * mp.cos(angle)
    return [_moved((1, X), (-radius * h, PHI), (back, GAMMA)), _moved((1, Y), (radius * h, PHI), (back, GAMMA)),
            _moved((up, GAMMA))]  # fmt: skip


def _squares(rows: list[tuple[Any, list[Any]]]) -> Any:
    total = mp.zeros(COUNT, COUNT)
    for factor, row in rows:
        for i in range(COUNT):
            for j in range(COUNT):
                total[i, j] += factor * row[i] * row[j]
    return total


def equations(task: VibratorTask) -> tuple[Any, Any]:
    """M and C."""
    gripper, exciter, rods, flats = task.gripper, task.exciter, task.rods, task.flats
    drop = mpf(gripper.drop)
    mass = [(mpf(task.ring.mass), X), (mpf(task.ring.mass), Y), (mpf(task.ring.inertia), PHI)]
    for row in (_moved((1, X), (-drop, TILT_Y)), _moved((1, Y), (drop, TILT_X)), Z):
        mass.append((mpf(gripper.mass), row))
    mass += [(mpf(gripper.inertia_x), TILT_X), (mpf(gripper.inertia_y), TILT_Y), (mpf(gripper.inertia_z), PHI)]
    for row in _of_exciter(mpf(exciter.radius), mpf(exciter.arm), mpf(exciter.arm_angle)):
        mass.append((mpf(exciter.mass), row))
    mass += [(mpf(exciter.inertia_z), PHI), (mpf(exciter.inertia_hinge), GAMMA)]
    rod = mpf(rods.stiffness or 0)
    if rods.stiffness is None:
        rod = 12 * mpf(rods.young) * mp.pi * mpf(rods.diameter) ** 4 / 64 / mpf(rods.length) ** 3
    r = mpf(rods.radius)
    springs = []
    for x, y in ((r, 0), (0, r), (-r, 0), (0, -r)):
        springs += [(rod, _moved((1, X), (-y, PHI))), (rod, _moved((1, Y), (x, PHI)))]
    vertical, tilt = _of_flats(flats, gripper, task.gravity)
    springs += [(4 * vertical, Z), (tilt, TILT_X), (tilt, TILT_Y), (mpf(task.plate), GAMMA)]
    return _squares(mass), _squares(springs)


def _of_flats(flats: Flats, gripper: Gripper, gravity: float) -> tuple[Any, Any]:
    """Stiffness across one spring; of the tilt, of two bent and two twisted springs and the weight."""
    if flats.vertical is not None and flats.tilt is not None:
        return mpf(flats.vertical), mpf(flats.tilt)
    b, h, l, inner = (mpf(each) for each in (flats.width, flats.thickness, flats.length, flats.offset))
    bending = mpf(flats.young) * b * h**3 / 12
    long, short = max(b, h), min(b, h)
    series = mp.nsum(lambda n: mp.tanh((2 * n + 1) * mp.pi * long / short / 2) / (2 * n + 1) ** 5, [0, mp.inf])
    polar = long * short**3 / 3 * (1 - 192 / mp.pi**5 * short / long * series)
    bent = 12 * bending * (l / 2 + inner) / l**3 * inner + bending * (4 * l + 6 * inner) / l**2
    twisted = mpf(flats.shear) * polar / l
    return 12 * bending / l**3, 2 * bent + 2 * twisted + mpf(gripper.mass) * mpf(gravity) * mpf(gripper.drop)


def natural(mass: Any, stiffness: Any) -> tuple[list[Any], Any]:
    """Frequencies ascending and modes in columns with y'My = 1."""
    inverse = mp.inverse(mp.cholesky(mass))
    squares, vectors = mp.eigsy(inverse * stiffness * inverse.T)
    order = sorted(range(COUNT), key=lambda k: squares[k])
    modes = inverse.T * vectors
    return [mp.sqrt(squares[k]) for k in order], mp.matrix([[modes[i, k] for k in order] for i in range(COUNT)])


def damping_of(task: VibratorTask, mass: Any, stiffness: Any) -> Any:
    """B in the coordinates of the device."""
    if task.damping.direct:
        return mp.diag([mpf(each) for each in task.damping.direct])
    frequencies, modes = natural(mass, stiffness)
    back = mass * modes
    return back * mp.diag([2 * mpf(task.damping.ratio) * w for w in frequencies]) * back.T


def excited(task: VibratorTask) -> Any:
    """Complex force over w^2: of the real part of P e^(i psi)."""
    unbalance = task.unbalance
    assert unbalance is not None
    rows = _of_exciter(mpf(unbalance.radius), mpf(unbalance.arm), mpf(unbalance.arm_angle))
    h = mp.sqrt(mpf(1) / 2)
    to_cosine, to_sine = (h * h, h * h, h), (-h, h, mpf(0))
    parts = [mp.mpc(c, -s) for c, s in zip(to_cosine, to_sine, strict=True)]
    moment = mpf(unbalance.moment)
    return mp.matrix([moment * sum(part * row[i] for part, row in zip(parts, rows, strict=True)) for i in range(COUNT)])


def amplitudes(task: VibratorTask, speed: float) -> tuple[Any, Any]:
    """Complex amplitudes at a speed, and the power that the dampers take."""
    mass, stiffness = equations(task)
    damping, w = damping_of(task, mass, stiffness), mpf(speed)
    x = mp.lu_solve(stiffness - w**2 * mass + mp.mpc(0, 1) * w * damping, w**2 * excited(task))
    return x, w**2 / 2 * (x.H * damping * x)[0].real
