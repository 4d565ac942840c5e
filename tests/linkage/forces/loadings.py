"""Random loadings: masses, loads of every law that needs no stroke, springs, friction, drives."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from random_mechanisms import RandomMechanism

from tmmcalc.linkage.loading import Body, Coupling, GearDrive, Load, Loading, Pair, Spring
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.model import Mechanism

LAWS = (
    Constant(30.0),
    Polynomial((-10.0, 40.0, -300.0)),
    Viscous(12.0),
    Quadratic(7.0),
)


def place(rng: np.random.Generator) -> complex:
    return complex(*rng.uniform(-0.7, 0.7, 2))


def unit(rng: np.random.Generator) -> complex:
    return complex(np.exp(1j * rng.uniform(-np.pi, np.pi)))


def random_loading(rng: np.random.Generator, mechanism: Mechanism, friction: float = 0.0) -> Loading:
    """Every link has mass; every law, spring and kind of drive occurs; ``friction`` is the largest coefficient."""
    links = [link.id for link in mechanism.links]
    return Loading(
        bodies=tuple(Body(k, float(rng.uniform(0, 3)), float(rng.uniform(0, 0.5)), place(rng)) for k in links),
        gravity=complex(9.81 * unit(rng)),
        loads=tuple(random_load(rng, f"Q{i}", links) for i in range(rng.integers(1, 5))),
        springs=tuple(random_spring(rng, f"spring {i}", links) for i in range(rng.integers(0, 3))),
        pairs=random_pairs(rng, mechanism, friction) if friction else (),
        drive=random_drive(rng),
    )


def random_load(rng: np.random.Generator, name: str, links: list[int]) -> Load:
    link = int(rng.choice(links))
    others = [0, *(k for k in links if k != link)]
    return Load(
        name,
        link,
        "force" if rng.random() < 0.6 else "moment",
        LAWS[rng.integers(len(LAWS))],
        place(rng),
        unit(rng),
        follows=int(rng.choice([0, *links])),
        factor=float(rng.uniform(0.2, 2)),
        against=int(rng.choice(others)) if rng.random() < 0.4 else 0,
    )


def random_spring(rng: np.random.Generator, name: str, links: list[int]) -> Spring:
    a, b = (int(k) for k in rng.choice([0, *links], size=2, replace=False))
    stiffness, damping = float(rng.uniform(0, 60)), float(rng.uniform(0, 5))
    if rng.random() < 0.5:
        return Spring(name, "torsion", (a, b), stiffness=stiffness, free=float(rng.uniform(-1, 1)), damping=damping)
    return Spring(name, "linear", (a, b), (place(rng), place(rng)), stiffness, float(rng.uniform(0, 1)), damping)


def random_pairs(rng: np.random.Generator, mechanism: Mechanism, friction: float) -> tuple[Pair, ...]:
    """Friction in most pairs, sliders with and without a length."""
    pairs = []
    for joint in mechanism.joints:
        if rng.random() < 0.2:
            continue
        f = float(rng.uniform(0.2, 1) * friction)
        if joint.kind == "revolute":
            pairs.append(Pair(joint.name, f, radius=float(rng.uniform(0.02, 0.1))))
        else:
            pairs.append(Pair(joint.name, f, length=float(rng.uniform(0.2, 0.8)) if rng.random() < 0.5 else None))
    return tuple(pairs)


def random_drive(rng: np.random.Generator) -> Coupling | GearDrive:
    if rng.random() < 0.5:
        return Coupling()
    angle = float(np.radians(rng.uniform(15, 30)))
    return GearDrive(float(rng.uniform(0.2, 0.6)), angle, float(rng.uniform(-3, 3)), internal=bool(rng.random() < 0.3))


def reversed_input(scene: RandomMechanism) -> RandomMechanism:
    """The same scene with the input running the other way from its start."""
    given = scene.mechanism.input
    return replace(scene, mechanism=replace(scene.mechanism, input=replace(given, speed=-given.speed)))
