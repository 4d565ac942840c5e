"""The compiled linkage: input link, then one step a group in order of assembly.

``Chain.evaluate`` is the whole kinematics: one vectorised pass over an array of input coordinates.
Derivatives are with respect to the input coordinate (transfer functions), exact, from the linear systems
of the groups; no difference is taken anywhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmmcalc.core.plane import LinkMotion, Plane, Real, frame
from tmmcalc.core.records import record
from tmmcalc.linkage import solvers
from tmmcalc.linkage.dyads import KINDS
from tmmcalc.linkage.dyads.base import Dyad, Element, Elements, Motions, Mount, Rates, Sites, Slide, Slides, element
from tmmcalc.linkage.model import FRAME, Joint, Mechanism
from tmmcalc.linkage.structure import Group, Structure

if TYPE_CHECKING:
    from tmmcalc.linkage.loops.step import LoopStep
    from tmmcalc.linkage.results import Branch, Kinematics, Terms


_STILL = Rates(*(np.zeros(()) for _ in range(4)))


class Step(NamedTuple):
    """One dyad of the chain; ``group`` names it in messages."""

    group: Group
    variant: int  # sign as the spec gives it; 1 for the kinds with one assembly
    dyad: Dyad
    port1: Element
    port2: Element
    mount: Mount
    fixed: tuple[Any, Any]  # states of the ports on the frame, which never change; None of those on other links

    def ports(self, motions: Motions) -> tuple[Any, Any]:
        """States of the two ports on the links solved before."""
        kind, (port1, port2) = self.group.kind, self.fixed
        return port1 or self.port1.port(kind[0], motions), port2 or self.port2.port(kind[2], motions)

    def advance(
        self, motions: Motions, slides: Slides, x: Real, order: int, method: solvers.Method
    ) -> tuple[tuple[Any, Any], Any]:
        """Place the dyad and add the motions of its links; its ports, and its placement."""
        ports = self.ports(motions)
        placed = self.dyad.place(*ports)
        rates = self.dyad.rates(*ports, placed, method) if order else _STILL
        sites = Sites(self.group.links, (self.port1.link, self.port2.link), *ports)
        self.mount.move(sites, motions, slides, placed, rates)
        return ports, placed

    def regularity(self, placed: Any) -> Real:
        """Distance (n,) from a dead point: 1 the best, 0 singular."""
        return self.dyad.regularity(placed)


class Configuration(NamedTuple):
    """Motions of all links, sliding coordinates, and the ports (or loops) and the placement of every step."""

    motions: Motions
    slides: Slides
    ports: list[Any]
    placed: list[Any]


class Layout(NamedTuple):
    """What is stacked, in which order: named points with their owner, links, prismatic joints."""

    points: tuple[tuple[str, int, complex], ...]
    links: tuple[int, ...]
    joints: tuple[str, ...]


@record
class Chain:
    """A mechanism with its structure and one step a group, on its variant or branch, ready to be evaluated."""

    mechanism: Mechanism
    structure: Structure
    steps: tuple[Step | LoopStep, ...]
    terms: Terms | None = None  # None: accelerations have all their terms

    @cached_property
    def input_joint(self) -> Joint:
        """The joint of the input link with the frame."""
        return self.mechanism.joint(self.mechanism.input.joint)

    @cached_property
    def _input_elements(self) -> tuple[Element, Element]:
        return element(self.input_joint, self.structure.input_link), element(self.input_joint, FRAME)

    @property
    def turns(self) -> bool:
        """Whether the input link is a crank (revolute) and not a driven slider."""
        return self.input_joint.kind == "revolute"

    @cached_property
    def layout(self) -> Layout:
        """All named points of moving links that are not pins of the frame, each once; links and joints in order.

        A point belongs to the first of its links, but an outer pin of a dyad to the dyad's, whose base point it is.
        """
        owners: dict[str, tuple[int, complex]] = {}
        links = (self.structure.input_link, *(k for group in self.structure.groups for k in group.links))
        order = tuple(dict.fromkeys(links))
        points, fixed = {link.id: link.points for link in self.mechanism.links}, self.mechanism.frame.points
        for k in order:
            for name, p in points[k].items():
                if name not in fixed:
                    owners.setdefault(name, (k, p))
        for step in self.steps:
            for name, k in zip(step.group.outer, step.group.links, strict=True) if isinstance(step, Step) else ():
                if name in owners and name in points[k]:
                    owners[name] = (k, points[k][name])
        return Layout(
            tuple((name, *owners[name]) for name in sorted(owners, key=_natural)),
            tuple(sorted(order)),
            tuple(joint.name for joint in self.mechanism.joints if joint.kind == "prismatic"),
        )

    @property
    def branches(self) -> dict[str, Branch]:
        """The branches of the higher groups, by name."""
        return {step.group.name: step.branch for step in self.steps if not isinstance(step, Step)}

    @property
    def period(self) -> float | None:
        """After which the motion comes back [rad]: a turn of the crank, or several if a branch does; None: a slider."""
        periods = [branch.period for branch in self.branches.values() if branch.period is not None]
        return max((2 * np.pi, *periods)) if self.turns else None

    def joined(self, step: Step | LoopStep) -> Chain:
        """The chain with one more step."""
        return replace(self, steps=(*self.steps, step))

    def evaluate(
        self, x: Real, *, order: int = 2, method: solvers.Method = solvers.closed, steps: int | None = None
    ) -> Configuration:
        """Positions and, with ``order=2``, both derivatives at the input coordinates ``x`` (n,).

        ``steps`` limits the chain to its first groups. The coordinates must lie where the mechanism assembles
        (see `assembly`); elsewhere the motions are NaN.
        """
        motions: Motions = {FRAME: frame()}
        slides: Slides = {}
        if self.structure.driven is None:
            motions[self.structure.input_link] = self._input_motion(x, slides, order)
        ports_of: list[Any] = []
        placed_of: list[Any] = []
        with np.errstate(divide="ignore", invalid="ignore"):
            for step in self.steps[:steps]:
                ports, placed = step.advance(motions, slides, x, order, method)
                ports_of.append(ports)
                placed_of.append(placed)
        if self.terms is not None and order and steps is None:
            from tmmcalc.linkage.curtailed import curtailed  # only mistakes need it

            motions, slides = curtailed(self.mechanism, self.structure, self.terms, motions, slides, x.shape)
        return Configuration(motions, slides, ports_of, placed_of)

    def _input_motion(self, x: Real, slides: Slides, order: int) -> LinkMotion:
        joint, (own, at) = self.input_joint, self._input_elements
        one, still, zero = np.ones(()), np.zeros(()), np.zeros((), np.complex128)
        if joint.kind == "prismatic":
            sense = at.direction if own.slider else -at.direction
            slides[joint.name] = Slide(x, one, still)
            u = np.asarray(at.direction / own.direction)
            velocity: Plane = np.asarray(sense + 0j) if order else zero
            return LinkMotion(own.point, at.point + x * sense, velocity, zero, u, zero, zero, still, still)
        u = np.empty(x.shape, np.result_type(x.dtype, np.complex64))
        np.cos(x, out=u.real)
        np.sin(x, out=u.imag)
        pivot = np.asarray(at.point + 0j)
        if not order:
            return LinkMotion(own.point, pivot, zero, zero, u, zero, zero, still, still)
        return LinkMotion(own.point, pivot, zero, zero, u, 1j * u, -u, one, still)

    def margins(self, x: Real, step: int) -> Real:
        """Assembly margin of a dyad at the coordinates ``x``; the groups before it must assemble there."""
        dyad = self.dyad(step)
        return np.broadcast_to(dyad.dyad.margin(*dyad.ports(self.evaluate(x, order=0, steps=step).motions)), x.shape)

    def dyad(self, step: int) -> Step:
        """The step of this number, which is a dyad."""
        found = self.steps[step]
        assert isinstance(found, Step)
        return found


def _natural(name: str) -> tuple[str, str]:
    """Centres of mass S1, S2, ... after the joints' points."""
    return ("~" if name[0] == "S" and name[1:].isdigit() else "", name)


def compile_chain(
    mechanism: Mechanism,
    structure: Structure,
    variants: Mapping[str, int],
    branches: Mapping[str, Branch] | None = None,
) -> Chain:
    """Build the chain of a mechanism: ``variants`` gives the sign of dyads by group name, default +1.

    ``branches`` gives the branch of every group of class III or higher, and of one with the drive inside it.
    """
    steps: list[Step | LoopStep] = []
    for group in structure.groups:
        if group.kind:
            steps.append(step_of(mechanism, group, variants.get(group.name, 1)))
        else:
            steps.append(_on_branch(mechanism, group, variants[group.name], (branches or {})[group.name]))
    return Chain(mechanism, structure, tuple(steps))


def step_of(mechanism: Mechanism, group: Group, variant: int) -> Step:
    """The step of a dyad, its constants read from the mechanism."""
    a, b = group.links
    inner, first, second = (mechanism.joint(name) for name in (*group.inner, *group.outer))
    elements = Elements(
        port1=element(first, first.other(a)),
        port2=element(second, second.other(b)),
        outer_a=element(first, a),
        outer_b=element(second, b),
        inner_a=element(inner, a),
        inner_b=element(inner, b),
    )
    dyad, mount = KINDS[group.kind].read(elements, group, variant)
    ports, letters, rest = elements[:2], (group.kind[0], group.kind[2]), {FRAME: frame()}
    fixed = [
        port.port(letter, rest) if port.link == FRAME else None for port, letter in zip(ports, letters, strict=True)
    ]
    return Step(group, variant, dyad, *ports, mount, (fixed[0], fixed[1]))


def _on_branch(mechanism: Mechanism, group: Group, variant: int, branch: Branch) -> LoopStep:
    from tmmcalc.linkage.loops.equations import equations_of  # only groups of class III and higher need them
    from tmmcalc.linkage.loops.step import LoopStep

    return LoopStep(group, variant, equations_of(mechanism, group), branch)


def chain_of(mechanism: Mechanism, kinematics: Kinematics) -> Chain:
    """The chain that a kinematics result was found with."""
    chain = compile_chain(mechanism, kinematics.structure, kinematics.variants, kinematics.branches)
    return chain if kinematics.terms is None else replace(chain, terms=kinematics.terms)
