"""Methods of the forces: friction by the textbook's passes beside Newton's, largest reactions off a table of positions.

    passes      reactions, friction (3.27), (3.28) from them, reactions again; from no friction on
    Newton      on the same equations, followed from no friction on where they have further solutions

A pass takes the error by the loop gain of the group, so passes are of first order in it and never settle above one.
The largest reaction of a table is that of its nearest position: of second order in the step, of first where a load
jumps.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.accuracy.measure import Clock, Way, relative, series
from tmmcalc.accuracy.sampled import SECOND, around
from tmmcalc.accuracy.study import FLOOR, Reference, Study
from tmmcalc.accuracy.subjects import Scene
from tmmcalc.linkage.forces.forces import solve_forces
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.stack import stacked
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.plane import Real

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.cut import Cut
    from tmmcalc.linkage.forces.web import Web

PASSES = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48)
SETTLED = 400  # passes after which a group that settles at all has
COUNTS = (12, 24, 48, 96, 192, 384, 768, 1536)  # positions of a cycle
CREEPS = "a pass takes the error by the loop gain of the group; above one it never settles"


def studies(scene: Scene) -> Iterator[Study]:
    """The friction of every group that rubs, and the largest reactions of all pairs."""
    result: Forces = scene.results["forces"]
    mechanism, loading = scene.inputs
    kinematics = scene.results["kinematics"]
    statics = compile_statics(compile_scene(mechanism, loading, kinematics))
    for plan in reversed(statics.plans):
        if any(post.coefficient > 0 for post in plan.posts):
            yield _friction(statics, plan.group.name, result.theta, scene.clock)

    def exact() -> Real:
        return _largest_found(solve_forces(mechanism, loading, kinematics))

    yield _largest(statics, result, [Way("", 1.0, exact)], scene.clock)


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
        f"{SETTLED} passes where nothing moves any more ({int(still.sum())} of {len(theta)} positions), elsewhere "
        "Newton's, which one more pass moves by the error",
        max(float(np.max(moved)), FLOOR),
    )
    ways = [Way(f"{n} passes" if n > 1 else "1 pass", 0.0, partial(_passed, cut, len(theta), n)) for n in PASSES]
    return Study(
        "forces",
        f"friction in {name}",
        reference,
        (
            series("Newton", [Way("", 1.0, lambda: _by_newton(cut, len(theta)))], error, clock),
            series("passes (3.27), (3.28)", ways, error, clock, note=CREEPS),
        ),
    )


def _by_newton(cut: Cut | Web, count: int) -> Real:
    """Friction (k, n) of the joints that rub."""
    friction = cut.solve(count).friction
    return np.array([np.broadcast_to(friction[k], count) for k in cut.c])


def _passed(cut: Cut | Web, count: int, passes: int) -> Real:
    values: Real = np.zeros((len(cut.c), count))
    for _ in range(passes):
        values = _pass(cut, values)
    return values


def _pass(cut: Cut | Web, values: Real) -> Real:
    """Friction (k, n) under the reactions that friction ``values`` leave."""
    from tmmcalc.linkage.forces.friction import size_of

    found = cut.under(values).reactions
    return np.array([-c * size_of(cut.seats[k], found[k], cut.plan.posts[k].half) for k, c in cut.c.items()])


def _largest_found(result: Forces) -> Real:
    return np.array([pair.force.value for pair in result.pairs])


def _largest(statics: Statics, result: Forces, exact: list[Way], clock: Clock) -> Study:
    """|R| of every pair; those where nothing presses are left out."""
    period = float(statics.scene.travel.period)

    def reactions(theta: Real, side: Real) -> Real:
        return np.abs(stacked(statics, np.clip(theta, 0.0, period), side, checked=False)[0].reaction)

    def tabled(count: int) -> Real:
        return np.asarray(np.max(reactions(period * np.arange(count + 1) / count, np.ones(count + 1)), axis=1))

    true = np.array([np.max(reactions(*around(pair.force.x))[j]) for j, pair in enumerate(result.pairs)])
    size = np.where(true > FLOOR * np.max(true), true, np.inf)

    def error(found: Real) -> float:
        return max(float(np.max(np.abs(found - true) / size)), FLOOR)

    ways = [Way(f"{n} positions", 1 / n, partial(tabled, n)) for n in COUNTS]
    return Study(
        "forces",
        "largest reactions",
        Reference("places ever closer to every maximum, by the equations themselves", result.error),
        (
            series("extremes on panels", exact, error, clock, note="all of the stage, with its positions"),
            series("table of n positions", ways, error, clock, expected=2.0, note=SECOND),
        ),
    )
