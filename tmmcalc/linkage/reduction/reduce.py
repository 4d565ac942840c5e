"""The reduction stage: reduced moments of every load, weights, springs and friction, reduced inertia, work per cycle.

All are sampled on panels whose edges lie at every jump of a load and every reversal of friction, so that work over
the cycle is exact to rounding. Friction is taken at the mean speed, with the loads of inertia in the reactions
(textbook 3.3.1.6).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.friction import Solution
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics, reversals
from tmmcalc.linkage.forces.locking import refuse_locked
from tmmcalc.linkage.forces.verification import friction_power
from tmmcalc.linkage.loading import Load, Loading
from tmmcalc.linkage.loads.scene import Scene, compile_scene
from tmmcalc.linkage.loads.sources import Place, Source
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.reduction.inertia import lumped, reduced_inertia, rods_of
from tmmcalc.linkage.reduction.results import Contribution, Reduction
from tmmcalc.linkage.results import Extreme, Grade, Kinematics
from tmmcalc.machine.cycle import Cycle
from tmmcalc.numerics.panels import Panels, panels, resolved
from tmmcalc.numerics.roots import Indices

TOLERANCE = 1e-13  # of the panels: last coefficients against the largest value
OPEN_PANELS = 12  # first panels of a range that is not a turn


class Causes(NamedTuple):
    """What is reduced: the sources of the scene, merged by name, and friction."""

    scene: Scene
    statics: Statics
    names: tuple[tuple[str, str, int], ...]  # name, kind, order of every contribution but friction

    @property
    def orders(self) -> Indices:
        """Order in the speed of every contribution (S,), friction included."""
        return np.array([order for _, _, order in self.names] + [0] * bool(self.statics.scales))

    def moments(self, place: Place, side: Real | float = 1.0) -> tuple[Real, dict[str, Solution]]:
        """Reduced moments (S, n) per power of the speed, along the motion; and how the friction came out."""
        sense = self.scene.travel.sense
        rows = np.zeros((len(self.orders), len(place.theta)))
        for source in self.scene.sources:
            k = self.names.index((source.name, source.kind, source.order))
            rows[k] += _power(source, place) * (sense if source.order == 0 else 1.0)
        if not self.statics.scales:
            return rows, {}
        state = self.statics.solve(place, side)
        rows[-1] = sense * sum(friction_power(self.statics, state, place).values())
        return rows, state.solutions


def _power(source: Source, place: Place) -> Real:
    return np.asarray(sum(action.power(place.configuration) for action in source.actions(place)))


def solve_reduction(mechanism: Mechanism, loading: Loading, kinematics: Kinematics, rods: str = "exact") -> Reduction:
    """Reduced moments and inertia over the cycle; ``rods`` is "exact" or "lumped" (static lumping of rods).

    Raises `NoSolutionError` for self-locking, and for a load that cannot be placed.
    """
    links = rods_of(mechanism, loading)
    static = lumped(mechanism, loading, links)
    taken = replace(loading, bodies=static) if rods == "lumped" else loading
    scene = compile_scene(mechanism, taken, kinematics)
    causes = _causes(scene)
    dense, values, tail = _resolved(causes)
    cycle, parts = _cycle(causes, dense, values, max(tail, kinematics.error.velocity))
    theta, labels = scene.travel.rows(kinematics)
    moment, inertia, slope = _at_positions(causes, theta, labels)
    contributions = tuple(_contribution(causes, k, dense, parts[k], theta, moment[k]) for k in range(len(parts)))
    least, largest = dense.extremes(cycle.inertia)
    other = reduced_inertia(static, scene.place(theta).configuration, len(theta))[0] if links else None
    return Reduction(
        labels=labels,
        phi=scene.travel.phi(theta),
        turns=scene.chain.turns,
        whole=scene.travel.whole,
        speed=scene.travel.speed,
        contributions=contributions,
        moment=moment,
        total=moment.sum(axis=0),
        inertia=inertia,
        slope=slope,
        parts=parts,
        cycle=cycle,
        idle=_idle(scene, kinematics.error.velocity),
        inertia_range=(Extreme(*least), Extreme(*largest)),
        lumped=other,
        rods=links,
        grades=_grades(contributions, loading.loads),
        counters={"panels": dense.count, "points": dense.x.size},
    )


def _causes(scene: Scene) -> Causes:
    names = tuple(dict.fromkeys((s.name, s.kind, s.order) for s in scene.sources))
    return Causes(scene, compile_statics(scene), names)


def _idle(scene: Scene, error: float) -> Cycle | None:
    """The cycle without technological loads, whose friction is less too; None if there are none."""
    kept = tuple(source for source in scene.sources if source.kind != "load")
    if len(kept) == len(scene.sources):
        return None
    causes = _causes(scene._replace(sources=kept, angles=(), knots=()))
    dense, values, tail = _resolved(causes)
    return _cycle(causes, dense, values, max(tail, error))[0]


def _resolved(causes: Causes) -> tuple[Panels, Real, float]:
    """Panels that resolve J, dJ and all moments, their values (2 + S, K, N), and the largest tail."""
    scene = causes.scene
    first = panels(
        0.0,
        scene.travel.period,
        scene.edges(reversals(causes.statics)),
        TURN / 12 if scene.chain.turns else scene.travel.period / OPEN_PANELS,
    )
    sample = _sampler(causes)
    scale = np.max(np.abs(sample(first.x.ravel())), axis=1)
    scale[1] = scale[0]
    scale[2:] = np.max(scale[2:], initial=0.0)
    return resolved(sample, first, TOLERANCE, np.where(scale > 0, scale, 1.0))


def _sampler(causes: Causes) -> Callable[[Real], Real]:
    def sample(theta: Real) -> Real:
        place = causes.scene.place(theta)
        moments, solutions = causes.moments(place)
        refuse_locked(causes.statics, solutions, lambda rows: causes.scene.travel.named(theta[rows]))
        inertia, slope = reduced_inertia(causes.scene.loading.bodies, place.configuration, len(theta))
        return np.vstack((inertia, slope * causes.scene.travel.sense, moments))

    return sample


def _cycle(causes: Causes, dense: Panels, values: Real, error: float) -> tuple[Cycle, Real]:
    """The cycle that the machine room takes, and the moments of all contributions at the mean speed (S, K, N)."""
    speed = abs(causes.scene.travel.speed)
    orders = causes.orders
    rows = values[2:]
    positional, viscous, quadratic = (rows[orders == order].sum(axis=0) for order in (0, 1, 2))
    cycle = Cycle(dense, values[0], values[1], positional, viscous, quadratic, speed, error)
    return cycle, rows * (speed**orders)[:, None, None]


def _at_positions(causes: Causes, theta: Real, labels: tuple[str, ...]) -> tuple[Real, Real, Real]:
    """Algebraic moments (S, n) at the mean speed, inertia and its derivative against the input coordinate."""
    scene = causes.scene
    speed, sense = abs(scene.travel.speed), scene.travel.sense
    place = scene.place(theta)
    moments, solutions = causes.moments(place, scene.travel.sides(theta))
    refuse_locked(causes.statics, solutions, lambda at: [f"position {labels[i]}" for i in at])
    orders = causes.orders
    inertia, slope = reduced_inertia(scene.loading.bodies, place.configuration, len(theta))
    return sense * moments * (speed**orders)[:, None], inertia, slope


def _contribution(causes: Causes, k: int, dense: Panels, part: Real, theta: Real, nodes: Real) -> Contribution:
    name, kind, order = causes.names[k] if k < len(causes.names) else ("friction", "friction", 0)
    role = next((load.role for load in causes.scene.loading.loads if kind == "load" and load.name == name), None)
    sense = causes.scene.travel.sense
    least, largest = dense.extremes(sense * part)
    return Contribution(
        name,
        kind,  # type: ignore[arg-type]  # the kinds of sources, and friction
        role,
        order,
        float(dense.total(part)),
        simpson(theta, sense * nodes),
        Extreme(*least),
        Extreme(*largest),
    )


def simpson(x: Real, y: Real) -> float | None:
    """Simpson's rule (3.38); None unless the steps are equal and even in number."""
    steps = np.diff(x)
    if len(steps) % 2 or np.ptp(steps) > 1e-9 * steps[0]:
        return None
    return float(steps[0] / 3 * (y[0] + y[-1] + 4 * y[1:-1:2].sum() + 2 * y[2:-2:2].sum()))


def _grades(contributions: tuple[Contribution, ...], loads: tuple[Load, ...]) -> tuple[Grade, ...]:
    """A resistance that drives, or a drive that resists, is likely a wrong sign."""
    grades = []
    for c in contributions:
        wrong = (c.role == "resistance" and c.work > 0) or (c.role == "drive" and c.work < 0)
        if wrong:
            does = "drives" if c.work > 0 else "resists"
            text = (
                f"is called a {c.role} but {does}: {c.work:+.6g} J a cycle; turn its direction or its sign, or its role"
            )
            grades.append(Grade("warning", f"load {c.name}", text))
    return tuple(grades)
