"""The forces stage: reactions and drive at all positions of the cycle, and their maxima over it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.mesh import Mesh, laid
from tmmcalc.core.numerics.panels import Panels
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.forces.errors import last_digit
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics, reversals
from tmmcalc.linkage.forces.maxima import ForceFunctions, force_functions, maxima, pairs_of
from tmmcalc.linkage.forces.refinement import PARTS, Sample, resolved, sample_of
from tmmcalc.linkage.forces.results import Forces, Mean
from tmmcalc.linkage.forces.stack import Stack, stacked
from tmmcalc.linkage.loading import GearDrive, Loading
from tmmcalc.linkage.loads.scene import Scene, compile_scene
from tmmcalc.linkage.loads.travel import EDGE
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Grade, Kinematics

if TYPE_CHECKING:
    from tmmcalc.linkage.forces.friction import Solution

Flags = NDArray[np.bool_]
Named = Callable[[NDArray[np.intp]], list[str]]
Seen = list[tuple[Real, "dict[str, Solution]"]]  # angles (n,) and how friction came out there; empty if nothing rubs

ROUNDING = 1e-15
MARGIN = 4.0  # what stays in equilibrium may still be wrong, by the condition of a group


def solve_forces(mechanism: Mechanism, loading: Loading, kinematics: Kinematics) -> Forces:
    """Reactions in all pairs and the drive, over the positions of the kinematics and every turn of the loads' cycle.

    Raises `NoSolutionError` for self-locking, with the group and the positions, and for a load that cannot be placed.
    """
    scene = compile_scene(mechanism, loading, kinematics)
    statics = compile_statics(scene)
    breaks, turning = scene.breaks(reversals(statics))
    theta, side, labels = rows_of(scene, kinematics, np.sort(turning))
    period = scene.travel.period
    on = laid(period, np.array([[*breaks, *turning]]), (TURN if scene.chain.turns else period) / PARTS)
    n, between, named = len(theta), on.x.ravel(), scene.travel.named
    found, friction = stacked(statics, np.append(theta, between), np.append(side, np.ones(len(between))))
    rows, over = found.columns(slice(n)), found.columns(slice(n, None))
    seen: Seen = []
    at_rows, on_panels = ({k: one.rows(part) for k, one in friction.items()} for part in (slice(n), slice(n, None)))
    _noted(statics, seen, theta, at_rows, lambda at: [f"position {labels[i]}" for i in at])
    _noted(statics, seen, between, on_panels, lambda at: named(between[at]))

    def sampled(new: Mesh) -> Sample:
        theta = new.x.ravel()
        more, solutions = stacked(statics, theta, np.ones(len(theta)), checked=False)
        _noted(statics, seen, theta, solutions, lambda at: named(theta[at]))
        return sample_of(new, (statics, more))

    mesh, values, clear = resolved(on, sample_of(on, (statics, over)), sampled, period)
    functions = force_functions(statics, values)
    grades = (*scene.grades, *_grades(scene, seen, labels))
    passes = max((s.passes for _, solutions in seen[:1] for s in solutions.values()), default=0)
    error = _amplified(seen, kinematics.error.acceleration)
    over_panels, digit = (mesh.panels_of(0)[0], functions, bool(clear[0])), last_digit(statics, theta, side, kinematics)
    return forces_of(statics, rows, theta, labels, over_panels, error, passes, grades, digit)


def forces_of(
    statics: Statics,
    rows: Stack,
    theta: Real,
    labels: tuple[str, ...],
    over: tuple[Panels, ForceFunctions, bool],
    error: float,
    passes: int,
    grades: tuple[Grade, ...],
    digit: float | None = None,
) -> Forces:
    """The result from the reactions in the ``rows`` at theta (n,) and ``over`` panels, which are resolved or not.

    ``error`` is what the loads of inertia leave of theirs in the reactions, ``digit`` what the last of the data does.
    """
    scene, (dense, functions, resolved) = statics.scene, over
    found = maxima(statics, dense, functions, resolved)
    largest = max(_largest(functions.drive), _largest(rows.drive)) or 1.0
    virtual = (rows.virtual - rows.drive) / largest
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
        gear=scene.loading.drive if isinstance(scene.loading.drive, GearDrive) else None,
        equilibrium=rows.equilibrium,
        virtual=virtual,
        drive_extremes=found.drive,
        power_extremes=found.power(scene.travel.speed),
        power_mean=_mean_power(dense, functions.drive, scene.travel.speed),
        grades=grades,
        counters={"rows": len(theta), "dense": dense.x.size, "passes": passes},
        error=MARGIN * max(_largest(rows.equilibrium), _largest(virtual), error),
        last_digit=digit,
    )


def _mean_power(on: Panels, drive: Real, speed: float) -> Mean:
    """Mean power of the drive (K, N) over the motion; what a panel leaves out of the drive it may leave out of it."""
    span = float(on.edges[-1] - on.edges[0])
    left_out = float(on.tail(drive) @ on.width) + ROUNDING * float(on.total(np.abs(drive)))
    return Mean(float(on.total(drive)) * speed / span, left_out * abs(speed) / span)


def _amplified(seen: Seen, error: float) -> float:
    """What an error of the loads of inertia, and rounding, becomes where friction is near to locking."""
    factors = (_largest(s.amplification) for _, solutions in seen for s in solutions.values())
    return max(error, ROUNDING) * max(factors, default=1.0)


def _grades(scene: Scene, seen: Seen, labels: tuple[str, ...]) -> tuple[Grade, ...]:
    """What friction does near to locking and beyond; the positions are what was seen first."""
    if not seen:
        return ()
    from tmmcalc.linkage.forces.locking import further_solutions, magnified

    return (*further_solutions(seen, labels, scene.travel.named), *magnified(seen, scene.travel.named))


def _noted(statics: Statics, seen: Seen, theta: Real, solutions: dict[str, Solution], named: Named) -> None:
    """Keep how friction came out at theta (n,), which ``named`` words by row; raise if it locks the linkage there."""
    if not solutions:
        return
    from tmmcalc.linkage.forces.locking import refuse_locked  # only what rubs needs it

    refuse_locked(statics, solutions, named)
    seen.append((theta, solutions))


def _largest(values: Real) -> float:
    return float(np.max(np.abs(values)))


def _drive_kind(scene: Scene) -> Literal["coupling", "gear", "slider"]:
    if not scene.chain.turns:
        return "slider"
    return "gear" if isinstance(scene.loading.drive, GearDrive) else "coupling"


def rows_of(scene: Scene, kinematics: Kinematics, turning: Real) -> tuple[Real, Real, tuple[str, ...]]:
    """theta (n,) of all rows, the side from which each is taken, and the labels.

    Friction jumps where a rubbing pair turns back, at ``turning`` (m,): a position there gives two rows.
    """
    theta, labels = scene.travel.rows(kinematics)
    jump = _at(theta, turning)
    jump[[0, -1]] = False
    if not jump.any():
        return theta, scene.travel.sides(theta), labels
    twice = np.repeat(np.arange(len(theta)), np.where(jump, 2, 1))
    before = np.append(twice[1:] == twice[:-1], False)
    names = list(labels)
    for i in reversed(np.flatnonzero(jump).tolist()):
        names.insert(i, f"{names[i]}-")
    return theta[twice], np.where(before, -1.0, scene.travel.sides(theta[twice])), tuple(names)


def _at(theta: Real, places: Real) -> Flags:
    """Which of theta (n,) stand at one of the ascending places (m,)."""
    if not places.size:
        return np.zeros(len(theta), bool)
    after = np.searchsorted(places, theta)
    to_last = np.abs(places[np.minimum(after, places.size - 1)] - theta)
    return np.minimum(np.abs(places[after - 1] - theta), to_last) < EDGE
