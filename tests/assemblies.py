"""Find the assembly variants of a mechanism from many starts, for the reference solver.

Damped Gauss-Newton (Levenberg-Marquardt) on the closure equations of ``reference.System``, all starts at
once. Points of a sketch, where given, place the starts and choose among the variants found.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from reference import Angle, Array, NoPositionError, Placements, System

from tmmcalc.linkage.model import Link, Mechanism

CLOSED = 1e-13  # scaled closure error of a start that is at a variant
STUCK = 1e6  # damping of a start that no step brings nearer


def initial_guess_from(
    mechanism: Mechanism, coordinate: float, sketch: Mapping[str, complex] | None = None, *, starts: int = 120
) -> Placements:
    """Placement of every moving link at this input coordinate, the variant nearest to the sketch.

    ``sketch`` maps point names to rough places [m]. Between variants that put its points equally near, the
    one whose sliders stand further ahead on their guides is taken. Raises NoPositionError if none is found.
    """
    sketch = sketch or {}
    found = all_assemblies(mechanism, coordinate, sketch, starts=starts)
    if not found:
        raise NoPositionError(coordinate)
    size = System(mechanism).size
    return min(found, key=lambda p: (round(misfit(mechanism, p, sketch) / size, 6), -ahead(mechanism, p)))


def all_assemblies(
    mechanism: Mechanism,
    coordinate: float,
    sketch: Mapping[str, complex] | None = None,
    *,
    starts: int = 120,
    seed: int = 0,
) -> list[Placements]:
    """The different assembly variants that the starts led to, as placements."""
    system = System(mechanism)
    q = start_bodies(system, sketch or {}, starts, np.random.default_rng(seed))
    if isinstance(driver := system.equations[-1], Angle):
        q[:, driver.bodies[0], 2] = coordinate
    q, error = relax(system, q, np.full(starts, coordinate))
    variants: list[Array] = []
    for bodies in q[error < 1e-10]:
        if all(distance(system, bodies, other) > 1e-6 for other in variants):
            variants.append(bodies)
    return [placements(mechanism, bodies) for bodies in variants]


def start_bodies(system: System, sketch: Mapping[str, complex], starts: int, rng: np.random.Generator) -> Array:
    """Random body coordinates (starts, links + 1, 3); links with sketched points lie on them."""
    q = np.zeros((starts, len(system.index), 3))
    for link in system.mechanism.links:
        angle = rng.uniform(-np.pi, np.pi, starts)
        place = system.size * (rng.uniform(-1, 1, starts) + 1j * rng.uniform(-1, 1, starts))
        known = [name for name in link.points if name in sketch]
        if known:
            place, angle = fitted(link, known, sketch, angle)
        q[:, system.index[link.id]] = np.stack([place.real, place.imag, angle], axis=-1)
    return q


def fitted(link: Link, known: list[str], sketch: Mapping[str, complex], angle: Array) -> tuple[Array, Array]:
    """Lay a link on its sketched points; one point leaves the angle free."""
    own = np.array([link.points[name] for name in known])
    drawn = np.array([sketch[name] for name in known])
    moment = np.sum(np.conj(own - own.mean()) * (drawn - drawn.mean()))
    if abs(moment) > 0:
        angle = np.full_like(angle, np.angle(moment))
    return drawn.mean() - own.mean() * np.exp(1j * angle), angle


def relax(system: System, q: Array, coordinate: Array, iterations: int = 80) -> tuple[Array, Array]:
    """Levenberg-Marquardt on every start that still moves; the bodies and their largest scaled closure errors."""
    q, damping = q.copy(), np.full(len(q), 1e-2)
    error = system.residual(q, coordinate) / system.row_scale
    for _ in range(iterations):
        going = np.flatnonzero((np.max(np.abs(error), axis=1) > CLOSED) & (damping < STUCK))
        if not going.size:
            break
        trial = q[going] - damped_step(system, q[going], error[going], damping[going])
        trial_error = system.residual(trial, coordinate[going]) / system.row_scale
        better = np.sum(trial_error**2, axis=1) < np.sum(error[going] ** 2, axis=1)
        q[going[better]], error[going[better]] = trial[better], trial_error[better]
        damping[going] = np.clip(np.where(better, damping[going] / 8, damping[going] * 5), 1e-14, STUCK)
    return q, np.max(np.abs(error), axis=1)


def damped_step(system: System, q: Array, error: Array, damping: Array) -> Array:
    matrix = system.scaled(system.jacobian(q))
    normal = matrix.transpose(0, 2, 1) @ matrix + damping[:, None, None] * np.eye(matrix.shape[2])
    x = np.linalg.solve(normal, matrix.transpose(0, 2, 1) @ error[..., None])[..., 0]
    bodies = x.reshape(len(x), -1, 3) * system.body_scale
    return np.concatenate([bodies, np.zeros((len(x), 1, 3))], axis=1)


def distance(system: System, a: Array, b: Array) -> float:
    """Largest difference of two configurations, angles by their directions."""
    place = np.abs(a[:, :2] - b[:, :2]).max() / system.size
    return float(max(place, np.abs(np.exp(1j * a[:, 2]) - np.exp(1j * b[:, 2])).max()))


def placements(mechanism: Mechanism, bodies: Array) -> Placements:
    rows = zip(mechanism.links, bodies, strict=False)
    return {link.id: (complex(x, y), float(np.angle(np.exp(1j * t)))) for link, (x, y, t) in rows}


def misfit(mechanism: Mechanism, placed: Placements, sketch: Mapping[str, complex]) -> float:
    """Root of the summed squares of the distances to the sketched points [m]."""
    squares = 0.0
    for link in mechanism.links:
        place, angle = placed[link.id]
        for name in link.points.keys() & sketch.keys():
            squares += abs(place + link.points[name] * np.exp(1j * angle) - sketch[name]) ** 2
    return float(np.sqrt(squares))


def ahead(mechanism: Mechanism, placed: Placements) -> int:
    """How many sliders stand ahead of the point of their guide."""
    placed = {0: (0j, 0.0), **placed}
    count = 0
    for joint in mechanism.joints:
        if joint.kind == "prismatic":
            (slider, slider_angle), (guide, guide_angle) = (placed[number] for number in joint.links)
            gap = slider + joint.points[0] * np.exp(1j * slider_angle)
            gap -= guide + joint.points[1] * np.exp(1j * guide_angle)
            count += (np.conj(joint.directions[1] * np.exp(1j * guide_angle)) * gap).real > 0
    return int(count)
