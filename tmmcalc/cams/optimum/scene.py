"""What the search for the best sizes starts from: motion, load and data of one mechanism at the nodes of its phases.

None of it depends on S0, r2 or H2. A node stands in a panel of smooth motion, at a Gauss point or at an end; an end
has the limit from inside its panel.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.kernels import driving_torque, resultant
from tmmcalc.cams.forces.results import SpringFound
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.turn import WIDEST, at_rows, loads_of
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.peaks import ended
from tmmcalc.cams.program import Positions, Program
from tmmcalc.cams.task import AngleLimits, CamTask, Force, Guide, Requirements
from tmmcalc.errors import NoSolutionError
from tmmcalc.numerics.panels import panels
from tmmcalc.records import record

Phases = Literal["turn", "rise"]
WHERE = "cam_optimum"
SHARPER = 4  # panels of a flat face to one of a roller: 1/rho has a sharper peak than kappa


@record
class Scene:
    """M = K (N + 2) nodes in K panels."""

    follower: Follower  # its kind and offset alone are read
    phi: Values  # (M,) [rad]
    motion: Values  # (4, M)
    load: Values  # P_c (M,) [N]
    sense: Values  # (M,) +1 rise, -1 return, 0 dwell
    torque: Values  # -P_c S' (M,) [N*m], of all sizes alike
    panels: int  # K
    stroke: float  # h [m], of laws that overshoot the highest position
    speed: float  # omega [rad/s]
    friction: float  # f
    spring: SpringFound
    guide: Guide
    limits: AngleLimits
    requirements: Requirements


def scene_of(task: CamTask, follower: Follower, phases: Phases = "turn") -> Scene:
    """The scene of a task; ``phases`` is what of the turn is examined: all of it, or as in the textbook the rise.

    Raises `UsageError` without loads, `NoSolutionError` where the follower leaves the cam whatever its sizes.
    """
    loads = loads_of(task, WHERE)
    spring = solve_spring(task, loads)
    widest = WIDEST / SHARPER if follower.kind == "flat" else WIDEST
    phi, piece = _nodes(task.program, phases, loads.force, widest)
    at = at_rows(task, loads, Positions(phi, piece, ()))
    load = resultant(at.motion, loads.mass * loads.speed**2, spring.stiffness, spring.preload, at.force)
    worst = int(np.argmax(load))
    if load[worst] >= 0:
        raise NoSolutionError(
            f"at phi = {np.degrees(phi[worst]):.5g} deg the follower leaves the cam: the forces along the lift "
            f"come to {load[worst]:.5g} N, whatever S0 and r2 are",
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
        sense=at.sense,
        torque=driving_torque(load, at.motion),
        panels=len(phi) // len(ended().points),
        stroke=task.program.highest,
        speed=loads.speed,
        friction=loads.friction,
        spring=spring,
        guide=task.guide,
        limits=task.limits,
        requirements=task.requirements,
    )


def _nodes(program: Program, phases: Phases, force: Force, widest: float) -> tuple[Values, Indices]:
    """phi (M,) and piece of the program of every node.

    In a dwell without a force by phi everything stays: one panel stands for it.
    """
    breaks = [] if force.phi is None else np.mod(force.phi, program.starts[-1]).tolist()
    on = panels(0.0, float(program.starts[-1]), [*program.panels.edges.tolist(), *breaks], widest)
    middle = (on.edges[:-1] + on.edges[1:]) / 2
    piece = np.clip(np.searchsorted(program.edges, middle) - 1, 0, len(program.edges) - 2)
    phase = program.places[0][piece]
    kinds = np.array([each.kind for each in program.phases])[phase]
    moves = (kinds == "rise") | (kinds == "return")
    first = np.append(True, phase[1:] != phase[:-1])
    kept = kinds == "rise" if phases == "rise" else moves | first | (force.phi is not None)
    rows = np.flatnonzero(kept)
    points = ended(on.order).points
    phi = on.edges[rows, None] + on.width[rows, None] * points
    phi[:, -1] = on.edges[rows + 1]
    return phi.ravel(), np.repeat(piece[rows], len(points))
