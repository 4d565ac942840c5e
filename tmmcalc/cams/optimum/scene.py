"""What the search for the best sizes starts from: motion, load and data of one mechanism at the nodes of its phases.

None of it depends on S0, r2 or H2. A node stands in a panel of smooth motion, at a Gauss point or at an end; an end
has the limit from inside its panel. The first nodes of all panels come first, then the second ones and so on: what is
largest in every panel is then found across the panels, in one pass along the memory.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields, replace
from typing import Any, Literal

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.formulas import GuidedForces, driving_torque, guided_forces
from tmmcalc.cams.forces.results import SpringFound
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.turn import WIDEST, Points, at_rows, loads_of
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.nodes import nodes, pressing
from tmmcalc.cams.optimum.peaks import ended
from tmmcalc.cams.program import Positions
from tmmcalc.cams.task import AngleLimits, CamTask, Guide, Loads, Requirements
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.records import record

Phases = Literal["turn", "rise"]
WHERE = "cam_optimum"
SHARPER = 4  # panels of a flat face to one of a roller: 1/rho has a sharper peak than kappa


@record
class Rows:
    """What the formulas of `extremes` take from the nodes (M,); with T = S' + e and P = -P_c."""

    drag: Values  # sense f |T|
    force: Values  # P
    inverse: Values  # 1/P
    couple: Values  # P |T|
    twist: Values  # square of the torque in M_E
    square: Values  # (3, M) T^2 + (S0 + y)^2 by powers of S0
    bend: Values  # (3, M) numerator of kappa by powers of S0
    growth: Values  # (2, M) numerator of A over P, of S0 and 1, times the square of omega over its mean
    spin: Values | None  # eps over P and the square of the mean speed; None: the cam turns evenly
    useful: Values  # (4, M) of S0, 1, -(1 + 2 (q + y)/l), 2/l: what friction leaves of S0 + y


@record
class Scene:
    """M = (N + 2) K nodes in K panels."""

    follower: Follower  # its kind and offset alone are read
    phi: Values  # (M,) [rad]
    motion: Values  # (4, M)
    load: Values  # P_c (M,) [N]
    sense: Values  # (M,) +1 rise, -1 return, 0 dwell
    torque: Values  # -P_c S' (M,) [N*m], of all sizes alike
    rows: Rows
    panels: int  # K
    stroke: float  # h [m], of laws that overshoot the highest position
    speed: float  # omega [rad/s]
    friction: float  # f
    spring: SpringFound
    guide: Guide
    limits: AngleLimits
    requirements: Requirements

    def by_panel(self, values: Values) -> Values:
        """Values (..., M) at the nodes as those of every panel (..., K, N + 2)."""
        return by_panel(values, self.panels)


def by_panel(values: Values, panels: int) -> Values:
    """Values (..., M) at the nodes of so many panels as those of every panel (..., K, N + 2)."""
    return np.swapaxes(values.reshape(*values.shape[:-1], values.shape[-1] // panels, panels), -1, -2)


def scene_of(task: CamTask, follower: Follower, phases: Phases = "turn", denser: int = 1) -> Scene:
    """The scene of a task; ``phases`` is what of the turn is examined: all of it, or as in the textbook the rise.

    ``denser`` panels stand in place of one.

    Raises `UsageError` without loads, `NoSolutionError` where the follower leaves the cam whatever its sizes.
    """
    loads = loads_of(task, WHERE)
    spring = solve_spring(task, loads)
    widest = (WIDEST / SHARPER if follower.kind == "flat" else WIDEST) / denser
    phi, piece = (_across(each) for each in nodes(task, loads, spring, phases == "rise", widest))
    at = at_rows(task, loads, Positions(phi, piece, ()))
    sense = _from_inside(at.sense)
    load = -pressing(loads, spring, at)
    worst = int(np.argmax(load))
    if load[worst] >= 0:
        text = (
            "at phi = {phi:.5g} deg the follower leaves the cam: the forces along the lift come to {load:.5g} N, "
            "whatever S0 and r2 are"
        )
        if follower.kind == "oscillating":
            text = (
                "at phi = {phi:.5g} deg the follower leaves the cam: the moments about the pivot come to {load:.5g} "
                "N*m, whatever its sizes are"
            )
        raise NoSolutionError(
            Phrase(text, phi=np.degrees(phi[worst]), load=load[worst]),
            where=WHERE,
            value=float(load[worst]),
            limit=0.0,
            remedy="a stiffer spring or more preload",
        )
    return Scene(
        follower=follower,
        phi=phi,
        motion=at.motion,
        load=load,
        sense=sense,
        torque=driving_torque(load, at.motion),
        rows=_rows(task, loads, at, -load, sense, follower.offset),
        panels=len(phi) // len(ended().points),
        stroke=task.program.highest,
        speed=loads.speed,
        friction=loads.friction,
        spring=spring,
        guide=task.guide,
        limits=task.limits,
        requirements=task.requirements,
    )


def guided_at(scene: Scene, start: Values, roller: Values, top: Values) -> GuidedForces:
    """What stem and guide carry at the nodes with S0, r2 and H2 (B,) [m], each (B, M); of a flat face r2 is 0."""
    return guided_forces(
        scene.follower,
        scene.motion,
        scene.load,
        scene.sense,
        stroke=scene.stroke,
        friction=scene.friction,
        gap=scene.guide.gap,
        start=start[:, None],
        roller=roller[:, None],
        top=top[:, None],
    )


def mixed(scenes: Sequence[Scene]) -> Callable[[Indices], Scene]:
    """One for scenes that differ in their limits alone, as a function of which of them is meant at each of B points.

    Its limits are arrays (B,).
    """

    def differing(parts: list[Any]) -> dict[str, Values]:
        held = {each.name: [getattr(part, each.name) for part in parts] for each in fields(parts[0])}
        return {name: np.array(values) for name, values in held.items() if any(v != values[0] for v in values)}

    limits = differing([each.limits for each in scenes])
    needs = differing([each.requirements for each in scenes])

    def at(which: Indices) -> Scene:
        own: dict[str, Any] = {name: values[which] for name, values in limits.items()}
        need: dict[str, Any] = {name: values[which] for name, values in needs.items()}
        first = scenes[0]
        return replace(first, limits=replace(first.limits, **own), requirements=replace(first.requirements, **need))

    return at


def _rows(task: CamTask, loads: Loads, at: Points, force: Values, sense: Values, offset: float) -> Rows:
    """The rows at the nodes with P (M,) and the sense of the motion (M,)."""
    y, y1, y2 = at.motion[:3]
    slide, one = y1 + offset, np.ones_like(y)
    size = y * y + slide * slide
    drag = loads.friction * sense * np.abs(slide)
    growth, spin = np.stack((y1, y * y1 + slide * y2)) / force, None
    if task.turning is not None:
        omega, eps = task.turning.at(at.phi)
        growth *= (omega / loads.speed) ** 2
        spin = eps / loads.speed**2 / force
    return Rows(
        drag=drag,
        force=force,
        inverse=1 / force,
        couple=force * np.abs(slide),
        twist=task.requirements.torsion * driving_torque(-force, at.motion) ** 2,
        square=np.stack((size, 2 * y, one)),
        bend=np.stack((size + slide * y1 - y * y2, 2 * y - y2, one)),
        growth=growth,
        spin=spin,
        useful=np.stack((one, y, drag, drag * y)),
    )


def _across(values: Any) -> Any:
    """What is given panel by panel (M,), in the order of the nodes."""
    return values.reshape(-1, len(ended().points)).T.ravel()


def _from_inside(values: Values) -> Values:
    """What is constant in a panel (M,), at its ends as inside."""
    found = values.reshape(len(ended().points), -1).copy()
    found[0], found[-1] = found[1], found[-2]
    return found.ravel()
