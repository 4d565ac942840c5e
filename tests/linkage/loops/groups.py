"""Random mechanisms with one group of class III or higher, made from a placement of their links."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np
from reference import Placements

from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loops.closure import Loops
from tmmcalc.linkage.loops.equations import equations_of
from tmmcalc.linkage.model import Assembly, Grid, Input, Joint, Link, Mechanism
from tmmcalc.linkage.placing import loops_at
from tmmcalc.linkage.structure import solve_structure

CLASS_IV = ("01", "12", "23", "24", "35", "45", "05")  # joints by the numbers of their links
CLASS_III = ("01", "12", "23", "34", "35", "40", "50")
CLASS_VI = ("01", "12", "23", "34", "45", "56", "67", "27", "04", "06")  # a closed contour of six links
MARK = 0.3 + 0.1j


class Scene(NamedTuple):
    """A mechanism, and where its links stand at its start."""

    mechanism: Mechanism
    placements: Placements


def scene(seed: int, graph: tuple[str, ...] = CLASS_IV, prismatic: Collection[str] = (), crank: float = 0.3) -> Scene:
    """Joints and links are thrown on the plane; the metric is read off, so an assembly exists there."""
    rng = np.random.default_rng(seed)
    links = range(1, max(int(k) for name in graph for k in name) + 1)
    start = rng.uniform(-3, 3)
    places = {name: complex(*rng.uniform(-1, 1, 2)) for name in graph}
    places |= {"01": 0j, "12": crank * complex(np.exp(1j * start))}
    origins = {0: 0j, **{k: complex(*rng.uniform(-1, 1, 2)) for k in links}, 1: 0j}
    angles = {0: 0.0, **{k: rng.uniform(-3, 3) for k in links}, 1: start}

    def own(k: int, place: complex) -> complex:
        return complex((place - origins[k]) * np.exp(-1j * angles[k]))

    joints = []
    for name in graph:
        a, b = int(name[0]), int(name[1])
        if name in prismatic:
            along, s = np.exp(1j * rng.uniform(-3, 3)), rng.uniform(-0.5, 0.5)
            lines = (complex(along * np.exp(-1j * angles[a])), complex(along * np.exp(-1j * angles[b])))
            points = (own(a, places[name] + s * along), own(b, places[name]))
            joints.append(Joint(name, "prismatic", (a, b), points, lines))
        else:
            joints.append(Joint(name, "revolute", (a, b), (own(a, places[name]), own(b, places[name]))))
    bodies = tuple(Link(k, {f"P{k}": MARK, f"Q{k}": 0j}) for k in links)
    sketch = {f"P{k}": complex(origins[k] + MARK * np.exp(1j * angles[k])) for k in links if k > 1}
    mechanism = Mechanism(
        Link(0),
        bodies,
        tuple(joints),
        Input("01", 2.0, start=start),
        grid=Grid(positions=12),
        assembly=Assembly(sketch=sketch),
    )
    return Scene(mechanism, {k: (origins[k], angles[k]) for k in links})


def drawn(
    rng: np.random.Generator, graph: tuple[str, ...], count: int, outer: Collection[str] = ("01", "12")
) -> set[str]:
    """Names of so many joints that are to be prismatic."""
    return {str(name) for name in rng.choice([name for name in graph if name not in outer], count, replace=False)}


def loops_of(mechanism: Mechanism) -> Loops:
    """The loops of the first group at the start."""
    structure = solve_structure(mechanism)
    chain = Chain(mechanism, structure, ())
    return loops_at(chain, equations_of(mechanism, structure.groups[0]), np.array([mechanism.input.start]))
