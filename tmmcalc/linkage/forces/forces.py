"""The forces stage: reactions and drive at all positions of the cycle, and their maxima over it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

import numpy as np

from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.friction import Solution
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics, reversals
from tmmcalc.linkage.forces.kinks import kinked
from tmmcalc.linkage.forces.locking import further_solutions, refuse_locked
from tmmcalc.linkage.forces.maxima import maxima, pairs_of
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.stack import Stack, stacked
from tmmcalc.linkage.loading import GearDrive, Loading
from tmmcalc.linkage.loads.scene import Scene, compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.results import Kinematics
from tmmcalc.numerics.panels import Panels, panels

PARTS = 24  # of a turn, or of the range: no panel on which maxima are sought is wider


def solve_forces(mechanism: Mechanism, loading: Loading, kinematics: Kinematics) -> Forces:
    """Reactions in all pairs and the drive, over the positions of the kinematics and every turn of the loads' cycle.

    Raises `NoSolutionError` for self-locking, with the group and the positions, and for a load that cannot be placed.
    """
    scene = compile_scene(mechanism, loading, kinematics)
    statics = compile_statics(scene)
    theta, side, labels = _rows(statics, kinematics)
    edges = scene.edges(reversals(statics))
    dense = _panels(scene, edges)
    rows, over, solutions = _solved(statics, theta, side, labels, dense)
    places = kinked(
        dense, over.faces, lambda on: _over(statics, on).faces, lambda more: _panels(scene, [*edges, *more])
    )
    if places:
        dense = _panels(scene, [*edges, *places])
        over = _over(statics, dense)
    found = maxima(statics, dense, over)
    drive_scale = max(float(np.max(np.abs(over.drive))), float(np.max(np.abs(rows.drive)))) or 1.0
    virtual = (rows.virtual - rows.drive) / drive_scale
    return Forces(
        labels=labels,
        phi=scene.travel.phi(theta),
        theta=theta,
        turns=scene.chain.turns,
        speed=scene.travel.speed,
        pairs=tuple(pairs_of(statics, found, rows, labels)),
        reaction=rows.reaction,
        normal=rows.normal,
        couple=rows.couple,
        friction=rows.friction,
        drive=rows.drive,
        power=rows.drive * scene.travel.speed,
        mesh=rows.mesh,
        drive_kind=_drive_kind(scene),
        equilibrium=rows.equilibrium,
        virtual=virtual,
        drive_extremes=found.drive,
        power_extremes=found.power(scene.travel.speed),
        grades=further_solutions(solutions, labels),
        counters={
            "rows": len(theta),
            "dense": dense.x.size,
            "passes": max((s.passes for s in solutions.values()), default=0),
        },
        error=max(_largest(rows.equilibrium), _largest(virtual), kinematics.error.acceleration),
    )


def _largest(values: Real) -> float:
    return float(np.max(np.abs(values)))


def _drive_kind(scene: Scene) -> Literal["coupling", "gear", "slider"]:
    if not scene.chain.turns:
        return "slider"
    return "gear" if isinstance(scene.loading.drive, GearDrive) else "coupling"


def _panels(scene: Scene, edges: Iterable[float]) -> Panels:
    whole = TURN if scene.chain.turns else scene.travel.period
    return panels(0.0, scene.travel.period, edges, whole / PARTS)


def _faces(statics: Statics, dense: Panels) -> Real:
    return _over(statics, dense).faces


def _over(statics: Statics, dense: Panels) -> Stack:
    """Reactions at the points of panels."""
    theta = dense.x.ravel()
    over, solutions = stacked(statics, theta, np.ones(len(theta)))
    refuse_locked(statics, solutions, lambda at: statics.scene.travel.named(theta[at]))
    return over


def _solved(
    statics: Statics, theta: Real, side: Real, labels: tuple[str, ...], dense: Panels
) -> tuple[Stack, Stack, dict[str, Solution]]:
    """Reactions at the rows and on the panels, in one run; how friction came out at the rows."""
    n, between = len(theta), dense.x.ravel()
    everything, solutions = stacked(
        statics, np.concatenate((theta, between)), np.concatenate((side, np.ones(len(between))))
    )
    named = statics.scene.travel.named
    at_rows = {name: solution.rows(slice(n)) for name, solution in solutions.items()}
    refuse_locked(statics, at_rows, lambda at: [f"position {labels[i]}" for i in at])
    over = {name: solution.rows(slice(n, None)) for name, solution in solutions.items()}
    refuse_locked(statics, over, lambda at: named(between[at]))
    return everything.columns(slice(n)), everything.columns(slice(n, None)), at_rows


def _rows(statics: Statics, kinematics: Kinematics) -> tuple[Real, Real, tuple[str, ...]]:
    """theta (n,) of all rows, the side from which each is taken, and the labels; jumps of friction give two rows."""
    travel = statics.scene.travel
    theta, labels = travel.rows(kinematics)
    jump = _resting(statics, theta)
    jump[[0, -1]] = False
    if not jump.any():
        return theta, travel.sides(theta), labels
    twice = np.repeat(np.arange(len(theta)), np.where(jump, 2, 1))
    before = np.append(twice[1:] == twice[:-1], False)
    side = np.where(before, -1.0, travel.sides(theta[twice]))
    return theta[twice], side, tuple(labels[i] + ("-" if b else "") for i, b in zip(twice, before, strict=True))


def _resting(statics: Statics, theta: Real) -> np.ndarray:
    """Where a rubbing pair changes the sense of its sliding."""
    jump = np.zeros(len(theta), bool)
    if statics.scales:
        configuration = statics.scene.place(theta).configuration
        for joint in statics.rubbing:
            jump |= statics.sense(joint, configuration, 1.0) != statics.sense(joint, configuration, -1.0)
    return jump
