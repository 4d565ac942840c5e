"""The compiled linkage: input link, then one step a dyad in order of assembly.

``Chain.evaluate`` is the whole kinematics: one vectorised pass over an array of input coordinates.
Derivatives are with respect to the input coordinate (transfer functions), exact, from the 2x2 systems
of the dyads; no difference is taken anywhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.linkage import solvers
from tmmcalc.linkage.dyads import Dyad
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.mounts import Motions, Rates, Slide, Slides
from tmmcalc.linkage.plane import LinkMotion, Plane, Real, frame
from tmmcalc.linkage.steps import Step, build, seat
from tmmcalc.linkage.structure import Structure, check_solvable

_STILL = Rates(*(np.zeros(()) for _ in range(4)))


class Configuration(NamedTuple):
    """Motions of all links, sliding coordinates, and the placement and ports of every step."""

    motions: Motions
    slides: Slides
    ports: list[tuple[Any, Any]]
    placed: list[Any]


class Chain(NamedTuple):
    """A mechanism with its structure and one variant sign a dyad, ready to be evaluated."""

    mechanism: Mechanism
    structure: Structure
    steps: tuple[Step, ...]

    @property
    def input_joint(self) -> Joint:
        """The joint of the input link with the frame."""
        return self.mechanism.joint(self.mechanism.input.joint)

    @property
    def turns(self) -> bool:
        """Whether the input link is a crank (revolute) and not a driven slider."""
        return self.input_joint.kind == "revolute"

    def evaluate(
        self, x: Real, *, order: int = 2, method: solvers.Method = solvers.closed, steps: int | None = None
    ) -> Configuration:
        """Positions and, with ``order=2``, both derivatives at the input coordinates ``x`` (n,).

        ``steps`` limits the chain to its first dyads. The coordinates must lie where the mechanism assembles
        (see `assembly`); elsewhere the motions are NaN.
        """
        motions: Motions = {FRAME: frame()}
        slides: Slides = {}
        motions[self.structure.input_link] = self._input_motion(x, slides, order)
        ports_of, placed_of = [], []
        with np.errstate(divide="ignore", invalid="ignore"):
            for step in self.steps[:steps]:
                ports = step.ports(motions)
                placed = step.dyad.place(*ports)
                step.move(motions, slides, ports, placed, rates(step.dyad, ports, placed, method) if order else _STILL)
                ports_of.append(ports)
                placed_of.append(placed)
        return Configuration(motions, slides, ports_of, placed_of)

    def _input_motion(self, x: Real, slides: Slides, order: int) -> LinkMotion:
        joint = self.input_joint
        own, at = seat(joint, self.structure.input_link), seat(joint, FRAME)
        still, zero = np.zeros(()), np.zeros((), np.complex128)
        if joint.kind == "prismatic":
            sense = at.direction if own.slider else -at.direction
            one = np.ones_like(x)
            slides[joint.name] = Slide(x, one, np.zeros_like(x))
            u = np.asarray(at.direction / own.direction)
            velocity: Plane = sense * one if order else zero
            return LinkMotion(own.point, at.point + x * sense, velocity, zero, u, zero, zero, still, still)
        u = np.empty(x.shape, np.result_type(x.dtype, np.complex64))
        np.cos(x, out=u.real)
        np.sin(x, out=u.imag)
        pivot = np.asarray(at.point + 0j)
        if not order:
            return LinkMotion(own.point, pivot, zero, zero, u, zero, zero, still, still)
        return LinkMotion(own.point, pivot, zero, zero, u, 1j * u, -u, np.ones_like(x), np.zeros_like(x))

    def margins(self, x: Real, step: int) -> Real:
        """Assembly margin of one dyad at the coordinates ``x``; the dyads before it must assemble there."""
        ports = self.steps[step].ports(self.evaluate(x, order=0, steps=step).motions)
        return np.broadcast_to(self.steps[step].dyad.margin(*ports), x.shape)


def rates(dyad: Dyad, ports: tuple[Any, Any], placed: Any, method: solvers.Method) -> Rates:
    """Stages 2 and 3 of a dyad: its two rates and their derivatives."""
    solve = method(*dyad.columns(placed))
    x, y = solve(dyad.velocity(*ports, placed))
    return Rates(x, y, *solve(dyad.acceleration(*ports, placed, x, y)))


def compile_chain(mechanism: Mechanism, structure: Structure, variants: Mapping[str, int]) -> Chain:
    """Build the chain of a mechanism of class II; ``variants`` gives the sign by group name, default +1.

    Raises `StructureError` for a group of class III or higher.
    """
    check_solvable(structure)
    steps = tuple(build(mechanism, group, variants.get(group.name, 1)) for group in structure.groups)
    return Chain(mechanism, structure, steps)
