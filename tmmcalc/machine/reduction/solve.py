"""The reduction stage: reduced moments of every load, weights, springs and friction, reduced inertia, work per cycle.

All are sampled on panels whose edges lie at every jump of a load, every reversal and every kink of friction, so that
work over the cycle is exact to rounding. Friction is taken at the mean speed, with the loads of inertia in the
reactions (textbook 3.3.1.6).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.numerics.peaks import peaks
from tmmcalc.core.numerics.simpson import simpson
from tmmcalc.core.plane import Real
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.loads.scene import Scene, compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Extreme, Kinematics
from tmmcalc.machine.attached import Attached, common_turns, with_attached
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.reduction.causes import Causes, Sample, causes_of
from tmmcalc.machine.reduction.errors import Solved, estimate
from tmmcalc.machine.reduction.inertia import lumped, reduced_inertia, rods_of
from tmmcalc.machine.reduction.panels import reduced
from tmmcalc.machine.reduction.results import Contribution, Reduction, ReductionError, Rods
from tmmcalc.machine.reduction.signs import wrong_signs


def solve_reduction(
    mechanism: Mechanism,
    loading: Loading,
    kinematics: Kinematics,
    rods: str = "exact",
    attached: Sequence[Attached] = (),
) -> Reduction:
    """Reduced moments and inertia over the cycle; ``rods`` is "exact" or "lumped" (static lumping of rods).

    What is ``attached`` to the input link beside the linkage counts with it, and the cycle is a whole number of the
    turns after which it repeats. Raises `NoSolutionError` for self-locking, and for a load that cannot be placed.
    """
    links = rods_of(mechanism, loading)
    static = lumped(mechanism, loading, links) if links else loading.bodies
    taken = replace(loading, bodies=static) if rods == "lumped" else loading
    scene = compile_scene(mechanism, taken, kinematics, common_turns(attached))
    causes = causes_of(scene)
    theta, labels = scene.travel.rows(kinematics)
    nodes, dense, values, (tail, stuck, scale) = reduced(causes, theta, labels)
    found = Solved(theta, scene.travel.sides(theta), nodes, dense, values, tail)
    beside = loading.bodies if rods == "lumped" else static
    other = reduced_inertia(beside, scene.place(theta).configuration, len(theta))[0] if links else None
    error, errors = estimate(causes, found, scale, kinematics)
    how = Rods("lumped" if rods == "lumped" and links else "exact", links, other)
    alone = reduction_of(causes, (theta, labels, nodes), (dense, values), error, how, errors, stuck=stuck)
    return with_attached(alone, attached)


def reduction_of(
    causes: Causes,
    at: tuple[Real, tuple[str, ...], Sample],
    over: tuple[Panels, Real],
    error: ReductionError,
    rods: Rods,
    errors: Real | None = None,
    *,
    stuck: bool,
) -> Reduction:
    """The result from theta (n,), labels and samples of the positions, and the values (3 + S, K, N) on panels.

    ``errors`` (S,) are those of the works [J]; None: told by ``error``.
    ``stuck``: friction locks the linkage without its loads, so that it has no idle run.
    """
    scene, loading, (theta, labels, nodes), (dense, values) = causes.scene, causes.scene.loading, at, over
    cycle, parts, idle = _cycles(causes, dense, values, error.functions)
    moment = scene.travel.sense * nodes.moments * causes.powers[:, None]
    inertia_range, ranges = _ranges(scene, cycle, parts)
    errors = error.work * dense.total(np.abs(parts)) if errors is None else errors
    simple = [simpson(theta, scene.travel.sense * row) for row in moment]
    works = list(zip(dense.total(parts).tolist(), errors.tolist(), simple, strict=True)) if len(parts) else []
    return Reduction(
        labels=labels,
        phi=scene.travel.phi(theta),
        turns=scene.chain.turns,
        whole=scene.travel.whole,
        speed=scene.travel.speed,
        contributions=tuple(_contributions(causes, works, ranges)),
        moment=moment,
        total=moment.sum(axis=0),
        inertia=nodes.inertia,
        slope=nodes.slope * scene.travel.sense,
        parts=parts,
        cycle=cycle,
        idle=idle if causes.loaded and not stuck else None,
        inertia_range=inertia_range,
        rods=rods.how,
        rod_links=rods.links,
        other=rods.other,
        error=error,
        grades=(*scene.grades, *wrong_signs(scene.travel, causes.names, loading.loads, dense, parts)),
        counters={"panels": dense.count, "points": dense.x.size},
    )


def _contributions(
    causes: Causes, works: list[tuple[float, float, float | None]], ranges: list[tuple[Extreme, Extreme]]
) -> Iterator[Contribution]:
    """The records of all causes, from the work of each with its error and that by Simpson's rule, and its extremes."""
    roles = {load.name: load.role for load in causes.scene.loading.loads}
    for (name, kind, order), (work, error, simple), (least, largest) in zip(causes.names, works, ranges, strict=True):
        yield Contribution(
            name=name,
            kind=cast(Any, kind),
            role=roles[name] if kind == "load" else None,
            order=order,
            work=work,
            error=error,
            simpson=simple,
            least=least,
            largest=largest,
        )


def solve_back(
    mechanism: Mechanism, loading: Loading, kinematics: Kinematics, rods: str = "exact", turns: int = 1
) -> tuple[Cycle, Cycle | None]:
    """The cycle of the input turned back, and that without loads: the same angles and loads, the friction turned round.

    A positive moment still drives forwards; the quadratic part is that of a positive speed. Raises `NoSolutionError`
    where the linkage locks itself backwards.
    """
    taken = replace(loading, bodies=lumped(mechanism, loading, rods_of(mechanism, loading)))
    scene = compile_scene(mechanism, taken if rods == "lumped" else loading, kinematics, turns)
    causes = _turned_back(causes_of(scene))
    try:
        _, dense, values, (tail, stuck, _) = reduced(causes, np.empty(0), ())
    except NoSolutionError as error:
        raise NoSolutionError(
            f"turned back, the input is held by friction: {error.message}",
            where=error.where,
            value=error.value,
            limit=error.limit,
            remedy='less friction, or standstill = "stop"',
        ) from error
    cycle, _, idle = _cycles(causes, dense, values, max(tail, kinematics.error.velocity))
    return cycle, idle if causes.loaded and not stuck else None


def _turned_back(causes: Causes) -> Causes:
    """The causes with reactions and friction of the same angles passed at the opposite speed."""
    travel = causes.statics.scene.travel
    scene = causes.statics.scene._replace(travel=travel._replace(speed=-travel.speed))
    return causes._replace(statics=causes.statics._replace(scene=scene))


def _cycles(causes: Causes, dense: Panels, values: Real, error: float) -> tuple[Cycle, Real, Cycle]:
    """The cycle for the machine room, moments of all contributions at the mean speed (S, K, N), the idle cycle."""
    speed, rows = abs(causes.scene.travel.speed), values[3:]
    loads = np.array([kind == "load" for _, kind, _ in causes.names], dtype=bool)
    rubs = np.array([kind == "friction" for _, kind, _ in causes.names], dtype=bool)

    def cycle(taken: NDArray[np.bool_], further: Real | float) -> Cycle:
        orders = (rows[taken & (causes.orders == order)].sum(axis=0) for order in (0, 1, 2))
        positional, viscous, quadratic = orders
        return Cycle(dense, values[0], values[1], positional + further, viscous, quadratic, speed, error)

    return cycle(loads | ~loads, 0.0), rows * causes.powers[:, None, None], cycle(~loads & ~rubs, values[2])


def _ranges(scene: Scene, cycle: Cycle, parts: Real) -> tuple[tuple[Extreme, Extreme], list[tuple[Extreme, Extreme]]]:
    """Least and largest of the inertia, and of every algebraic moment."""
    rows = np.concatenate((cycle.inertia[None], scene.travel.sense * parts))
    found, at = peaks(cycle.panels, np.concatenate((-rows, rows)))
    low, high = np.split(np.arange(2 * len(rows)), 2)
    pairs = [
        (Extreme(-float(found[a]), float(at[a])), Extreme(float(found[b]), float(at[b])))
        for a, b in zip(low, high, strict=True)
    ]
    return pairs[0], pairs[1:]
