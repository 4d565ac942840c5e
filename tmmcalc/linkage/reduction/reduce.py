"""The reduction stage: reduced moments of every load, weights, springs and friction, reduced inertia, work per cycle.

All are sampled on panels whose edges lie at every jump of a load, every reversal and every kink of friction, so that
work over the cycle is exact to rounding. Friction is taken at the mean speed, with the loads of inertia in the
reactions (textbook 3.3.1.6).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from tmmcalc.errors import NoSolutionError
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.kinetostatics import Statics, reversals
from tmmcalc.linkage.forces.kinks import cut, kinks
from tmmcalc.linkage.loading import Load, Loading
from tmmcalc.linkage.loads.scene import Scene, compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.reduction.causes import Causes, Sample, causes_of
from tmmcalc.linkage.reduction.inertia import lumped, reduced_inertia, rods_of
from tmmcalc.linkage.reduction.results import Contribution, Reduction, ReductionError, Rods
from tmmcalc.linkage.reduction.rounding import Solved, estimate
from tmmcalc.linkage.reduction.signs import wrong_signs
from tmmcalc.linkage.results import Extreme, Kinematics
from tmmcalc.machine.cycle import Cycle
from tmmcalc.numerics.panels import Panels, panels, resolved
from tmmcalc.numerics.peaks import peaks
from tmmcalc.numerics.simpson import simpson

Flags = NDArray[np.bool_]

TOLERANCE = 1e-11  # of the panels: last coefficients against the largest value
SLIGHT = 1e-4  # part of the most that a moment could be: the tolerance of it is rounding
SAMPLED = 33  # places at which that most is taken
PARTS = 24  # of a turn, or of the range: no first panel is wider
QUARTERS = np.array([0.25, 0.5, 0.75])  # that a panel which resolves nothing is cut in
ROUNDS = 4  # of cutting: two kinks between the same points show one after the other


def solve_reduction(mechanism: Mechanism, loading: Loading, kinematics: Kinematics, rods: str = "exact") -> Reduction:
    """Reduced moments and inertia over the cycle; ``rods`` is "exact" or "lumped" (static lumping of rods).

    Raises `NoSolutionError` for self-locking, and for a load that cannot be placed.
    """
    links = rods_of(mechanism, loading)
    static = lumped(mechanism, loading, links) if links else loading.bodies
    taken = replace(loading, bodies=static) if rods == "lumped" else loading
    scene = compile_scene(mechanism, taken, kinematics)
    causes = causes_of(scene)
    theta, labels = scene.travel.rows(kinematics)
    nodes, first, sample, breaks = _first(causes, theta, labels)
    dense, values, tail, stuck, scale = _resolved(causes, first, sample, breaks)
    found = Solved(theta, scene.travel.sides(theta), nodes, dense, values, tail)
    beside = loading.bodies if rods == "lumped" else static
    other = reduced_inertia(beside, scene.place(theta).configuration, len(theta))[0] if links else None
    error, errors = estimate(causes, found, scale, kinematics.error)
    how = Rods("lumped" if rods == "lumped" and links else "exact", links, other)
    return reduction_of(causes, (theta, labels, nodes), (dense, values), error, how, errors, stuck=stuck)


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
    works = dense.total(parts) if len(parts) else np.empty(0)
    errors = error.work * dense.total(np.abs(parts)) if errors is None else errors
    return Reduction(
        labels=labels,
        phi=scene.travel.phi(theta),
        turns=scene.chain.turns,
        whole=scene.travel.whole,
        speed=scene.travel.speed,
        contributions=tuple(
            Contribution(
                name=name,
                kind=cast(Any, kind),
                role=_role(loading.loads, name) if kind == "load" else None,
                order=order,
                work=float(works[k]),
                error=float(errors[k]),
                simpson=simpson(theta, scene.travel.sense * moment[k]),
                least=ranges[k][0],
                largest=ranges[k][1],
            )
            for k, (name, kind, order) in enumerate(causes.names)
        ),
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


def solve_back(
    mechanism: Mechanism, loading: Loading, kinematics: Kinematics, rods: str = "exact"
) -> tuple[Cycle, Cycle | None]:
    """The cycle of the input turned back, and that without loads: the same angles and loads, the friction turned round.

    A positive moment still drives forwards; the quadratic part is that of a positive speed. Raises `NoSolutionError`
    where the linkage locks itself backwards.
    """
    taken = replace(loading, bodies=lumped(mechanism, loading, rods_of(mechanism, loading)))
    scene = compile_scene(mechanism, taken if rods == "lumped" else loading, kinematics)
    causes = _turned_back(causes_of(scene))
    try:
        _, first, sample, breaks = _first(causes, np.empty(0), ())
        dense, values, tail, stuck, _ = _resolved(causes, first, sample, breaks)
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

    def back(statics: Statics) -> Statics:
        travel = statics.scene.travel
        return statics._replace(scene=statics.scene._replace(travel=travel._replace(speed=-travel.speed)))

    quiet = causes.quiet
    return causes._replace(statics=back(causes.statics), quiet=back(quiet) if quiet is not None else None)


def _role(loads: tuple[Load, ...], name: str) -> Any:
    return next(load.role for load in loads if load.name == name)


def _first(causes: Causes, theta: Real, labels: tuple[str, ...]) -> tuple[Sample, Panels, Sample, list[float]]:
    """Everything at the positions and on the first panels, in one run; places of jumps and bends."""
    scene, n = causes.scene, len(theta)
    breaks, turning = scene.breaks(reversals(causes.statics))
    on = _panels(scene, [*breaks, *turning])
    between = on.x.ravel()

    def named(rows: NDArray[np.intp]) -> list[str]:
        at_rows, beyond = rows[rows < n], rows[rows >= n] - n
        return [f"position {labels[i]}" for i in at_rows] or scene.travel.named(between[beyond])

    side = np.concatenate((scene.travel.sides(theta), np.ones(len(between))))
    everything = causes.sampled(np.concatenate((theta, between)), side, named)
    return everything.columns(slice(n)), on, everything.columns(slice(n, None)), [*breaks, *turning]


def _resolved(
    causes: Causes, on: Panels, sample: Sample, breaks: list[float]
) -> tuple[Panels, Real, float, bool, float]:
    """Panels that resolve J, dJ and all moments, their values (3 + S, K, N), the largest tail.

    Besides whether idle sticks, and what the moments at the mean speed were measured against.
    """
    scales, scale = _scales(causes, sample)
    for _ in range(ROUNDS):
        rough = _rough(on, sample, scales)
        quarters = on.edges[:-1][rough, None] + on.width[rough, None] * QUARTERS
        finer = cut(on, [*kinks(on, sample.faces), *kinks(on, sample.pins), *quarters.flat], breaks)
        if not finer.fresh.any():
            break
        on, sample = finer.panels, sample.with_cut(finer, causes.along(finer.theta))
    samples, waiting = [sample], [sample]  # the first panels are sampled already

    def rows(theta: Real) -> Real:
        if waiting:
            return waiting.pop().rows
        samples.append(causes.along(theta))
        return samples[-1].rows

    return *resolved(rows, on, TOLERANCE, scales), any(sample.stuck for sample in samples), scale


def _rough(on: Panels, sample: Sample, scales: Real) -> Flags:
    """Panels (K,) that do not resolve a function yet; each counts by what it adds to an integral."""
    rows = sample.rows
    tails = on.tail(rows.reshape(len(rows), *on.x.shape)) / scales[:, None]
    return np.max(tails, axis=0) * on.width > TOLERANCE * np.max(on.width)


def _panels(scene: Scene, edges: Iterable[float]) -> Panels:
    whole = TURN if scene.chain.turns else scene.travel.period
    return panels(0.0, scene.travel.period, edges, whole / PARTS)


def _scales(causes: Causes, sample: Sample) -> tuple[Real, float]:
    """What the tails of J, dJ and all moments (3 + S,) are measured against: J, J a radian, the largest moment [N*m].

    Moments count at the mean speed. Those that are nothing beside the most that they could be are rounding, which no
    panel resolves.
    """
    inertia, powers = float(np.max(sample.inertia)), causes.powers
    most = SLIGHT * causes.most(np.linspace(0.0, causes.scene.travel.period, SAMPLED))
    largest = np.max(np.abs(sample.moments), axis=1, initial=0.0) * powers
    moment = max(float(np.max(largest, initial=most)), float(np.max(np.abs(sample.idle))))
    travel = causes.scene.travel
    slope = inertia if travel.turns else inertia * TURN / travel.period  # a length has no radian of its own
    scales = np.array([inertia, slope, moment, *moment / np.where(powers > 0, powers, 1.0)])
    return np.where(scales > 0, scales, 1.0), moment


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
