"""Boundary and initial value problems y' = f(x, y) on panels by Radau IIA collocation, stiff or not.

Every panel carries the polynomial that meets the equation at its Radau points; `numerics.newton` solves for all of
them. Panels that do not resolve the solution are cut where the equations bend, graded towards their start where a stiff
layer hides in it, or halved, until the last Legendre coefficients of the solution are at rounding level.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.numerics.newton import TINY, Ends, Measure, Rates, State, newton
from tmmcalc.core.numerics.panels import NARROWEST, Panels, Values
from tmmcalc.core.numerics.radau import Radau, radau
from tmmcalc.core.records import record

TOLERANCE = 2e-13  # of the last Legendre coefficients, relative
ROUGH = 1e-2  # Newton step before the first look at the panels
CLOSE = 1e-13  # Newton step that would come next, relative
PASSES = 60
PANELS = 2000  # beyond them the solution is given up: its roughness is that of rounding, or of the equations
STIFF = 16.0  # decay over a panel above which its start may hide a layer
ON_EDGE = NARROWEST / 16  # of the range: a bend this near to an edge counts as marked
SNAP = 0.05  # of the panel: an edge so near to a bend moves there
LAYER = 2.0  # decay over the first panel of a graded layer
LAST, BEFORE = slice(-3, None), slice(-6, -3)  # coefficients whose fall tells what is left out

System = Callable[[Panels], Rates]
"""The equations at the Radau points of panels."""
Kinks = Callable[[Values, Values], Values]
"""x and watched functions (K, N) and (w, K, N) at the Radau points -> places (any number,) where f is not smooth."""


def periodic(m: int) -> Ends:
    """Conditions of a periodic solution of m states."""
    return Ends(-np.eye(m), np.eye(m), np.zeros(m))


def initial(y: Values) -> Ends:
    """Conditions of a solution that starts from ``y`` (m,)."""
    return Ends(np.eye(len(y)), np.zeros((len(y), len(y))), y)


@record
class Orbit:
    """A solution on its panels."""

    panels: Panels
    y: Values  # (m, K, N) at the Gauss points
    edges: Values  # (m, K + 1)
    monodromy: Values  # (m, m) dy(end)/dy(start)
    trace: float  # integral of the trace of df/dy: the logarithm of the determinant of the exact monodromy
    error: float  # last coefficients, the largest: what the panels do not resolve
    missing: Values  # (m, K) estimated relative error of the states within every panel
    iterations: int  # Newton steps on all meshes
    passes: int  # meshes


def solve(
    system: System,
    first: Panels,
    guess: Values,
    *,
    ends: Ends | None = None,
    floor: Values | None = None,
    typical: Values | None = None,
    kinks: Kinks | None = None,
    fixed: Values | None = None,
    tolerance: float = TOLERANCE,
    passes: int = PASSES,
    noise: Values | None = None,
) -> Orbit:
    """Solution that meets ``ends`` (by default a periodic one), from a ``guess`` (m, K, N) at the Gauss points.

    States stay above their ``floor`` (m,); a state with a finite floor is resolved relative to its value, another to
    its largest, or to its ``typical`` size (m,) if that is larger. ``kinks`` tells where the equations bend as the
    solution stands: panels are cut there first, and of such cuts those that are not ``fixed`` edges (by default the
    first ones) move along. ``noise`` (m,) are changes of the states that f cannot tell from none, beside rounding.
    Raises `AccuracyError` if Newton's method does not converge, or ``passes`` meshes do not resolve the solution.
    """
    scheme, m = radau(first.order), len(guess)
    closing = periodic(m) if ends is None else ends
    scale = Measure(np.full(m, -np.inf) if floor is None else floor, np.zeros(m) if typical is None else typical)
    now, state, steps = first, _first(scheme, guess), 0
    for passed in range(1, passes + 1):
        rates, step = system(now), np.inf
        for target in (ROUGH, CLOSE):
            settled = newton(scheme, now.width, rates, closing, state, scale, target, step)
            state, step, steps = settled.state, settled.step, steps + settled.iterations
            look = _look(scheme, now, state, rates(state.y), scale, kinks, np.zeros(m) if noise is None else noise)
            rough = look.rough(now, tolerance, target == CLOSE)
            if rough.any():
                break
        else:
            missing = look.missing + settled.next
            error = float(np.max(look.measure)) + settled.next + 4 * EPS
            return _orbit(scheme, now, state, look.jacobian, settled.monodromy, error, missing, steps, passed)
        if now.count > PANELS or passes == 1:  # who asks for one mesh alone cuts it by himself
            break
        finer = _refined(now, rough, look, first.edges if fixed is None else fixed)
        now, state = finer, _moved(scheme, now, state, finer)
    raise AccuracyError(
        f"{now.count} panels do not resolve the solution",
        where="collocation",
        value=float(np.max(look.measure)),
        limit=tolerance,
    )


class _Look(NamedTuple):
    """What a solution on a mesh looks like."""

    jacobian: Values  # (m, m, K, N)
    measure: Values  # (K,) last coefficients on every panel, relative: what it leaves unresolved
    missing: Values  # (m, K) estimated sum of those that it leaves out, of every state
    bends: Values  # places where the equations bend (any number,)

    def rough(self, mesh: Panels, tolerance: float, close: bool) -> NDArray[np.bool_]:
        """Panels (K,) to be cut; with a ``close`` solution also those with a bend before their first point."""
        span, rough = mesh.edges[-1] - mesh.edges[0], self.measure > tolerance
        if close:
            hidden = self.bends[_off_edges(mesh, self.bends) > ON_EDGE * span]
            rough[np.searchsorted(mesh.edges, hidden) - 1] = True
        return rough & (mesh.width > NARROWEST * span)


def _look(
    scheme: Radau,
    mesh: Panels,
    state: State,
    at: tuple[Values, Values, Values],
    scale: Measure,
    kinks: Kinks | None,
    noise: Values,
) -> _Look:
    """How a state with its rates ``at`` the points is resolved."""
    f, jacobian, watched = at
    x = mesh.edges[:-1, None] + mesh.width[:, None] * scheme.points
    bends = kinks(x, watched) if kinks else np.empty(0)
    return _Look(jacobian, *_roughness(scheme, mesh, state, f, jacobian, watched, scale, noise), bends)


def _first(scheme: Radau, guess: Values) -> State:
    y = guess @ scheme.from_gauss.T
    start = y[:, 0] @ scheme.start
    return State(start, y - start[:, None, None])


def _roughness(
    scheme: Radau,
    mesh: Panels,
    state: State,
    f: Values,
    jacobian: Values,
    watched: Values,
    scale: Measure,
    noise: Values,
) -> tuple[Values, Values]:
    """Last coefficients (K,) of states, rates and watched functions, relative, and what is missing of states (m, K).

    The watched functions count with the first state.
    """
    y = state.y
    size = np.max(scale.sizes(y), axis=2)
    # states carry the rounding of their largest, rates that times the stiffness: neither is a reason to refine
    rounding = EPS * np.max(np.abs(y), axis=(1, 2)) + noise
    last = scheme.coefficients[LAST].T
    missed = np.abs(_missed(scheme, state))
    states = (np.max(np.abs(state.rise @ last), axis=2) + missed - 8 * rounding[:, None]) / size
    sway = np.max(np.einsum("abkn,b->akn", np.abs(jacobian), rounding), axis=2)
    rates = (np.max(np.abs(f @ last), axis=2) / 4 - 2 * sway) * mesh.width / size
    largest = np.max(np.abs(watched), axis=(1, 2))
    others = np.max(np.abs(watched @ last), axis=2) / np.where(largest > 0, largest, 1.0)[:, None]
    missing = np.maximum(np.maximum(states, rates), 0.0) * _beyond(scheme, state.rise)
    missing[0] = np.max(np.concatenate((missing[:1], others * _beyond(scheme, watched))), axis=0)
    return np.max(np.concatenate((states, rates, others)), axis=0), missing


def _beyond(scheme: Radau, values: Values) -> Values:
    """All coefficients that are left out over the last three (..., K), if they go on falling as they do; 1 at most.

    A factor on last ones that are told otherwise (those of rates, what a start misses), and from the last six alone,
    where `Panels.left_out` takes half the rule: a stiff layer falls slowly first.
    """
    last, before = (
        np.max(np.abs(values @ scheme.coefficients[part].T), axis=-1, initial=0.0) for part in (LAST, BEFORE)
    )  # a rule of few points has none before the last
    fall = np.minimum(last / np.maximum(before, TINY), 1.0)
    return np.minimum(fall / np.maximum(1 - np.cbrt(fall), fall), 1.0)


def _missed(scheme: Radau, state: State) -> Values:
    """How far (m, K) the start of every panel is off the polynomial through its points: there a layer shows."""
    return state.before - state.rise @ scheme.start


def _off_edges(mesh: Panels, places: Values) -> Values:
    """Distance of places (any number,) from the nearest edge."""
    k = np.clip(np.searchsorted(mesh.edges, places), 1, mesh.count)
    return np.minimum(np.abs(places - mesh.edges[k - 1]), np.abs(mesh.edges[k] - places))


def _refined(mesh: Panels, rough: NDArray[np.bool_], look: _Look, fixed: Values) -> Panels:
    """The mesh with its rough panels cut: at bends, or towards their start where a layer may hide in it, or in half.

    An edge that marked a bend before moves along with it, unless it is ``fixed``.
    """
    least = NARROWEST * (mesh.edges[-1] - mesh.edges[0])
    rates = np.abs(np.linalg.eigvals(look.jacobian[:, :, rough].transpose(2, 3, 0, 1)))
    decay = np.max(rates, axis=(1, 2)) * mesh.width[rough]
    halvings = np.where(decay > STIFF, np.minimum(np.log2(decay / LAYER), np.log2(mesh.width[rough] / least)), 1.0)
    stays = np.ones(mesh.count + 1, bool)
    cuts = []
    for k, count in zip(np.flatnonzero(rough), halvings, strict=True):
        low, high = mesh.edges[k], mesh.edges[k + 1]
        bent = look.bends[(look.bends > low) & (look.bends < high)]
        near = [i for i in (k, k + 1) if np.any(np.abs(bent - mesh.edges[i]) < SNAP * (high - low))]
        moving = [i for i in near if mesh.edges[i] not in fixed]
        stays[moving] = False
        if bent.size and (moving or np.min(_off_edges(mesh, bent)) > least):
            cuts.append(bent)
        else:
            cuts.append(low + (high - low) * 0.5 ** np.arange(1, max(int(np.ceil(count)), 1) + 1))
    # several bends may stand at one place
    return Panels(np.unique(np.concatenate((mesh.edges[stays], *cuts))), mesh.order)


def _moved(scheme: Radau, mesh: Panels, state: State, finer: Panels) -> State:
    """The state interpolated on a finer mesh."""
    parent = np.searchsorted(mesh.edges, (finer.edges[:-1] + finer.edges[1:]) / 2) - 1
    t = (finer.edges[:-1] - mesh.edges[parent])[:, None] + finer.width[:, None] * scheme.points
    t /= mesh.width[parent, None]
    matrix = scheme.interpolation(t.ravel()).reshape(*t.shape, -1)
    return State(state.start, np.einsum("kij,akj->aki", matrix, state.rise[:, parent]))


def _orbit(
    scheme: Radau,
    mesh: Panels,
    state: State,
    jacobian: Values,
    monodromy: Values,
    error: float,
    missing: Values,
    iterations: int,
    passes: int,
) -> Orbit:
    base = state.start[:, None, None]
    rise = state.rise @ scheme.to_gauss.T + _missed(scheme, state)[..., None] * scheme.nodal
    edges = np.concatenate((state.before, state.rise[:, -1:, -1]), axis=1)
    trace = np.einsum("aakn,n,k->", jacobian, scheme.primitive[-1], mesh.width)
    y, ends = base + rise, state.start[:, None] + edges
    return Orbit(mesh, y, ends, monodromy, float(trace), error, missing, iterations, passes)
