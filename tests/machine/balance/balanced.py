"""Mechanisms with masses for the balancing tests, and inertia loads by ways of their own.

Accelerations here are spectral derivatives of positions over a full turn: nothing of the program's velocities is used.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np
from linkage.scenes import CONFIGS, crank_slider, four_bar, slotted, yoke
from numpy.typing import NDArray

from tmmcalc.linkage.chain import Chain, compile_chain
from tmmcalc.linkage.loading import Body
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.structure import solve_structure
from tmmcalc.linkage.variants import given_variants

Array = NDArray[Any]
TURN = 2 * np.pi
PRESS = (Body(2, 12.0, 0.055, 0.055 + 0j), Body(3, 24.0, 0.0, 0j))


class Scene(NamedTuple):
    """A mechanism whose crank turns fully, with masses."""

    mechanism: Mechanism
    chain: Chain
    bodies: tuple[Body, ...]


def chain_of(mechanism: Mechanism) -> Chain:
    structure = solve_structure(mechanism)
    return compile_chain(mechanism, structure, given_variants(mechanism, structure))


def scene(mechanism: Mechanism, *bodies: Body) -> Scene:
    """The mechanism with these bodies, or with one of drawn masses on every link."""
    return Scene(mechanism, chain_of(mechanism), bodies or drawn(mechanism))


def drawn(mechanism: Mechanism, seed: int = 7) -> tuple[Body, ...]:
    rng = np.random.default_rng(seed)
    size = max(abs(p) for joint in mechanism.joints for p in joint.points)
    return tuple(
        Body(
            link.id,
            float(rng.uniform(0.5, 5)),
            float(rng.uniform(0, 1) * size**2),
            complex(size * rng.uniform(-0.5, 0.5), size * rng.uniform(-0.5, 0.5)),
        )
        for link in mechanism.links
    )


def config(name: str) -> Mechanism:
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.project import load_spec

    return to_linkage(load_spec(CONFIGS / f"{name}.toml").mechanism)


def _named(name: str) -> Scene:
    by_hand = {
        "crank-slider": crank_slider(0.1, 0.35, 0.04),
        "four-bar": four_bar(0.1, 0.3, 0.25, 0.3 + 0.12j),
        "crossed four-bar": four_bar(0.1, 0.3, 0.25, 0.3 + 0.12j, -1),
        "slotted": slotted(0.3, 0.1, 0.02),
        "rotating slot": slotted(0.1, 0.3, 0.02),
        "yoke": yoke(0.1, 1.2),
    }
    return scene(by_hand[name] if name in by_hand else config(name))


NAMES = ("crank-slider", "four-bar", "crossed four-bar", "slotted", "rotating slot", "yoke")
CONFIGS_USED = ("shaper", "four-dyads", "engine-compressor", "v-engine", "slotter")
SCENES: dict[str, Callable[[], Scene]] = {name: cache(partial(_named, name)) for name in (*NAMES, *CONFIGS_USED)}


def derivative(values: Array) -> Array:
    """Derivative of periodic samples (..., n) by the transform; harmonics at rounding level are left out."""
    n = values.shape[-1]
    c = np.fft.fft(values, axis=-1)
    k = np.fft.fftfreq(n, 1 / n)
    keep = np.abs(c) > 1e-15 * np.max(np.abs(c), axis=-1, keepdims=True)
    return np.fft.ifft(np.where(keep & (np.abs(k) < n // 2), 1j * k * c, 0), axis=-1)


def momenta(case: Scene, x: Array, about: complex) -> tuple[Array, Array]:
    """Momentum and moment of momentum about a fixed point, per unit speed, from positions on a full turn ``x``."""
    motions = case.chain.evaluate(x, order=0).motions
    p, k = np.zeros(len(x), complex), np.zeros(len(x))
    for body in case.bodies:
        u = np.broadcast_to(motions[body.link].u, x.shape)
        S = np.broadcast_to(motions[body.link].point(body.center).r, x.shape)
        v, turning = derivative(S), (derivative(u) / u).imag
        p += body.mass * v
        k += body.inertia * turning + body.mass * (np.conj(S - about) * v).imag
    return p, k
