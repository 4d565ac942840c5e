"""Methods of the forces: friction by the textbook's passes beside Newton's, largest reactions off a table of positions.

    passes      reactions, friction (3.27), (3.28) from them, reactions again; from no friction on
    Newton      on the same equations, followed from no friction on where they have further solutions

A pass takes the error by the loop gain of the group, so passes are of first order in it and never settle above one.
The largest reaction of a table is that of its nearest position: of second order in the step, of first where a load
jumps. All methods start from the linkage and its loads, and end with the largest reactions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.studies.measure import Clock, Way, relative, series
from tmmcalc.core.studies.sampled import COUNTS, of_positions, on_edges, summit
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import FLOOR, Reference, Study
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics, reversals
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.loads.scene import compile_scene

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.dyad import DyadEquilibrium
    from tmmcalc.linkage.forces.group import GroupEquilibrium

    Equilibrium = DyadEquilibrium | GroupEquilibrium

PASSES = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48)
SETTLED = 400  # passes after which a group that settles at all has
EXTENDED = float(np.finfo(np.longdouble).eps)
CREEPS = "a pass takes the error by the loop gain of the group; above one it never settles"


def studies(scene: Scene) -> Iterator[Study]:
    """The friction of every group that rubs, and the largest reactions of all pairs."""
    result: Forces = scene.results["forces"]
    mechanism, loading = scene.inputs
    kinematics = scene.results["kinematics"]

    def compiled() -> Statics:
        return compile_statics(compile_scene(mechanism, loading, kinematics))

    statics = compiled()
    for plan in reversed(statics.plans):
        if any(post.coefficient > 0 for post in plan.posts):
            yield _friction(statics, plan.group.name, result.theta, scene.clock)

    def exact() -> Real:
        return _largest_found(solve_forces(mechanism, loading, kinematics))

    yield _largest(compiled, result, Way("", None, exact), scene.clock)


def _friction(statics: Statics, name: str, theta: Real, clock: Clock) -> Study:
    """At the positions of the stage, none of them at a reversal."""
    cut = statics.cut_out(name, statics.scene.place(theta), 1.0)
    best = _by_newton(cut, len(theta))
    settled = _passed(cut, len(theta), SETTLED)
    moved = np.abs(_pass(cut, best) - best) / float(np.max(np.abs(best), initial=FLOOR))
    still = np.max(np.abs(_pass(cut, settled) - settled), axis=0) <= 4 * FLOOR * np.max(np.abs(settled), axis=0)
    exact = np.where(still, settled, best)

    def error(found: Real) -> float:
        return relative(found, exact)

    reference = Reference(
        f"{SETTLED} passes where nothing moves any more ({int(still.sum())} of {len(theta)} positions)"
        + ("" if still.all() else ", elsewhere Newton's own, which one more pass moves by the error"),
        max(float(np.max(moved)), FLOOR),
    )
    ways = [Way(f"{n} passes" if n > 1 else "1 pass", None, partial(_passed, cut, len(theta), n)) for n in PASSES]
    return Study(
        "forces",
        f"friction in {name}",
        reference,
        (
            series("Newton", [Way("", None, lambda: _by_newton(cut, len(theta)))], error, clock),
            series("passes (3.27), (3.28)", ways, error, clock, note=CREEPS),
        ),
    )


def _by_newton(cut: Equilibrium, count: int) -> Real:
    """Friction (k, n) of the joints that rub."""
    friction = cut.solve((count,)).friction
    return np.array([np.broadcast_to(friction[k], count) for k in cut.c])


def _passed(cut: Equilibrium, count: int, passes: int) -> Real:
    values: Real = np.zeros((len(cut.c), count))
    for _ in range(passes):
        values = _pass(cut, values)
    return values


def _pass(cut: Equilibrium, values: Real) -> Real:
    """Friction (k, n) under the reactions that friction ``values`` leave."""
    from tmmcalc.linkage.forces.friction import size_of

    found = cut.under(values).reactions
    return np.array([-c * size_of(cut.seats[k], found[k], cut.plan.posts[k].half) for k, c in cut.c.items()])


def _largest_found(result: Forces) -> Real:
    return np.array([pair.force.value for pair in result.pairs])


def _largest(compiled: Callable[[], Statics], result: Forces, exact: Way, clock: Clock) -> Study:
    """|R| of every pair; those where nothing presses are left out."""
    statics = compiled()
    period = float(statics.scene.travel.period)

    def tabled(count: int) -> Real:
        theta = period * np.arange(count + 1) / count
        return np.asarray(np.max(_reactions(compiled(), theta, 1.0), axis=1))

    edges = np.array([0.0, *statics.scene.edges(reversals(statics)), period])

    def reached(theta: Real) -> Real:
        inside = np.clip(on_edges(theta, edges), 0.0, period)
        return np.maximum(_reactions(statics, inside, 1.0), _reactions(statics, inside, -1.0))

    true = summit(reached, period, [pair.force.x for pair in result.pairs])
    size = np.where(true.values > FLOOR * np.max(true.values), true.values, np.inf)

    def error(found: Real) -> float:
        return relative(found / size, true.values / size, 1.0)

    own = EXTENDED if true.values.dtype == np.longdouble else result.error
    ways = [Way(f"{n} positions", 1 / n, partial(tabled, n)) for n in COUNTS]
    return Study(
        "forces",
        "largest reactions",
        Reference("ever finer positions about the largest, by the equations themselves", max(own, true.short)),
        (
            series("extremes on panels", [exact], error, clock, note="with the positions of the stage"),
            of_positions("table of n positions", ways, error, clock),
        ),
    )


def _reactions(statics: Statics, theta: Real, side: float) -> Real:
    """|R| (J, n) of every pair from one side, in the precision of theta (n,)."""
    found = statics.solve(statics.scene.place(theta, side), side).reactions
    return np.array([np.broadcast_to(np.abs(found[j.name].wrench.force), theta.shape) for j in statics.joints])
