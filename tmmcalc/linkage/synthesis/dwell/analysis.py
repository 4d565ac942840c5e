"""The analysis of one six-bar: the kinematics room on its mechanism, forces, cross-checks, all in SI."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.synthesis.dwell.exact import Figures
from tmmcalc.linkage.synthesis.dwell.linkages import Linkages
from tmmcalc.linkage.synthesis.dwell.mechanism import loading_of
from tmmcalc.linkage.synthesis.dwell.motion import Unknowns, pose
from tmmcalc.linkage.synthesis.dwell.positions import motion_of
from tmmcalc.linkage.synthesis.dwell.relative import accuracy, arc_of, branch_of, gamma, reach
from tmmcalc.linkage.synthesis.dwell.results import Agreement, BarForce, CrossCheck, Dwell, DwellMotion, Largest, Slots
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.turn import TURN, Turn, along, place
from tmmcalc.linkage.synthesis.dwell.unitforces import unit_forces

FINE = 360  # parts of a turn for drawing
SLOT = 361  # places of a branch of Gamma
# Largest values: the name, what it is, and its unit on a slider and on a rocker.
MAXIMA = (
    ("S'", "ds", "m", "-"),
    ("S''", "dds", "m", "-"),
    ("f3", "f3", "N", "N"),
    ("f4", "f4", "N", "N"),
    ("R21", "r21", "N", "N"),
    ("N", "normal", "N", ""),
    ("delta", "delta", "rad", "rad"),
)


def analysed(asked: DwellTask, turn: Turn, found: Figures, mechanism: Mechanism, scale: float) -> Dwell:
    """The analysis of the linkage of a turn, built with l_OB = ``scale`` [m]."""
    linkages, sense = turn.linkages, math.copysign(1.0, mechanism.input.speed)
    kinematics = solve_kinematics(mechanism)
    theta = kinematics.trace.angle[kinematics.trace.link_ids.index(2)]
    length = 1.0 if linkages.rocks else scale
    state = Unknowns(theta, kinematics.s[0] / length, *(np.zeros_like(theta),) * 4)
    state = state._replace(ds=kinematics.ds[0] / length, dds=kinematics.dds[0] / length)
    motion = motion_of(asked, linkages, kinematics.labels, np.abs(kinematics.phi), kinematics.x, state, scale)
    fine = np.linspace(0.0, TURN, FINE + 1)
    degrees = tuple(str(k) for k in range(FINE + 1))
    turned = sense * fine
    drawn = motion_of(asked, linkages, degrees, fine, linkages.phi0 + turned, along(turn, turned), scale)
    strokes = [_along(asked, window) for window in found.strokes]
    return Dwell(
        asked.output,
        found.stroke * length,
        found.dwell[0] * length,
        found.dwell[0] / found.stroke,
        asked.dwell,
        tuple(linkages.turns[:, 0].tolist()),
        tuple(_extremes(asked, found, length)),
        strokes[0],
        strokes[1],
        tuple(_maxima(asked, found, scale)),
        tuple(float(part[0]) for part in found.criteria),
        tuple(_bar_forces(asked, found)),
        float(found.criteria.cost(asked.optimum.weights)[0]) if asked.optimum is not None else None,
        motion,
        drawn,
        slots(linkages, scale),
        *cross_check(turn, asked.arc_steps),
        agreement(asked, turn, found, mechanism, kinematics, motion, scale),
    )


def _along(asked: DwellTask, window: tuple[Real, Real]) -> tuple[float, float]:
    """A window of the turn, counted along the motion of the crank."""
    low, high = (float(end[0]) for end in window)
    return (TURN - high, TURN - low) if asked.clockwise else (low, high)


def _place(asked: DwellTask, at: float) -> float:
    return (TURN - at) % TURN if asked.clockwise else at


def _extremes(asked: DwellTask, found: Figures, length: float) -> list[Largest]:
    unit = "m" if asked.output == "slider" else "rad"
    reversals = [Largest("S", value * length, unit, _place(asked, at)) for value, at in found.reversals]
    return sorted(reversals, key=lambda each: each.at)


def _maxima(asked: DwellTask, found: Figures, scale: float) -> list[Largest]:
    rocks = asked.output == "rocker"
    factors = {"m": scale, "rad": 1.0, "-": 1.0, "N": asked.resistance / (scale if rocks else 1.0)}
    listed = []
    for name, key, slides, turns in MAXIMA:
        unit = turns if rocks else slides
        if unit:
            value, at = found.largest[key]
            listed.append(Largest(name, factors[unit] * value, unit, _place(asked, at)))
    return listed


def _bar_forces(asked: DwellTask, found: Figures) -> Iterator[BarForce]:
    """The bars where they are loaded most, of the working stroke first."""
    for stroke, bars in zip(("working", "idle"), found.bars, strict=True):
        for peak, name in zip(bars, ("CB", "DE"), strict=True):
            (first, second), (one, other) = (
                [float(np.ravel(each)[0]) for each in pair] for pair in (peak.forces.arms, peak.forces.pulls)
            )
            force = float(np.ravel(getattr(peak.forces, peak.bar))[0])
            x, y = (tuple(getattr(pin, part) for pin in peak.pins) for part in ("real", "imag"))
            yield BarForce(name, stroke, _place(asked, peak.at), force, (first, second), (one, other), x, y)


def slots(linkages: Linkages, scale: float) -> Slots:
    """Both branches of Gamma [m], where the four-bar BCDE closes around it."""
    first = linkages.crank * np.exp(1j * linkages.phi0) + np.exp(1j * linkages.theta0) * linkages.coupler
    psi0 = float(np.angle(first - 1)[0])
    own = branch_of(linkages)
    low, high = reach(linkages, psi0)
    psi = (low + high) / 2 - (high - low) / 2 * np.cos(np.pi * np.linspace(0.0, 1.0, SLOT))
    return Slots(*(scale * gamma(linkages, psi, branch) for branch in (own, -own)))


def cross_check(turn: Turn, steps: int) -> tuple[CrossCheck | None, str]:
    """The method of the relative trajectory against the exact motion, or why it does not apply."""
    try:
        arc = arc_of(turn.linkages)
        found = accuracy(turn, steps)
    except NoSolutionError as fault:
        return None, fault.message
    return CrossCheck(
        found.steps, found.uniform, found.cosine, *arc.course.bar(np.array([arc.first, arc.last])).tolist()
    ), ""


def agreement(
    asked: DwellTask,
    turn: Turn,
    found: Figures,
    mechanism: Mechanism,
    kinematics: Kinematics,
    motion: DwellMotion,
    scale: float,
) -> Agreement:
    """The two closures and the two equations of equilibrium against the kinematics and forces rooms."""
    linkages = turn.linkages
    length = 1.0 if linkages.rocks else scale
    own = along(turn, kinematics.x - linkages.phi0)
    moved = [_gap(of * length, by) for of, by in ((own.s, motion.s), (own.ds, motion.ds), (own.dds, motion.dds))]
    unit = unit_forces(linkages, kinematics.x, own.theta, own.s)
    bars = asked.resistance / (scale if linkages.rocks else 1.0)
    room = solve_forces(mechanism, loading_of(linkages, asked.resistance, True), kinematics)
    n, names = len(kinematics.x), [joint.name for joint in mechanism.joints]
    at = pose(linkages, kinematics.x, own.theta, own.s)
    e3, e4 = (at.c - at.b) / linkages.bar, (at.d - at.e) / linkages.rod
    wanted: dict[str, Plane] = {"A": unit.r12, "C": -unit.f3 * e3, "D": -unit.f4 * e4}
    forces = [_gap(bars * force, room.reaction[names.index(name)][:n]) for name, force in wanted.items()]
    if not linkages.rocks:
        forces.append(_gap(bars * unit.normal, room.normal[names.index("S")][:n]))
        forces.append(_gap(asked.resistance * scale * unit.couple, room.couple[names.index("S")][:n]))
    forces.append(_gap(motion.moment, room.drive[:n]))
    rests = [float(np.max(np.abs(place(turn, at).s))) for at in linkages.turns[1:]]
    virtual = _gap(asked.resistance * motion.ds, motion.moment)
    return Agreement(max(moved), max(forces), virtual, max(rests) / found.stroke)


def _gap(one: Plane | Real, other: Plane | Real) -> float:
    """Largest difference against the largest value."""
    return float(np.max(np.abs(one - other)) / (np.max(np.abs(other)) or 1.0))
