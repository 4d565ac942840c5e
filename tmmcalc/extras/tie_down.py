"""Forces in the ties that hold a load on a vehicle against its inertia force along the way.

Four ties, two along each direction of the way, elevation alpha, angle beta in plan; a load of weight G2 on a fixed
cradle and, if there is one, on a sliding support. F moves the load, G presses it on the cradle; P0 is the preload.
"""

from __future__ import annotations

from math import cos
from typing import Any

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.extended import apart, widened
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record


@record
class Support:
    """The sliding support of the load, and where the load stands on it."""

    weight: float  # G_o [N]
    friction: float  # mu_s
    base: float  # L [m]
    arm: float  # b [m], of the load, which loads the support by G2 b/L
    cradle_arm: float  # a [m], which loads the cradle by G2 a/L
    diameter: float  # D [m], the inertia force acts D/2 above the bearing


@record
class Thread:
    """The thread by which ties are tightened, right- and left-handed at the two ends."""

    moment: float  # M [N*m]
    diameter: float  # d2, mean [m]
    lead: float  # lambda [rad]
    friction_angle: float  # rho' [rad]


@record
class TieDownTask:
    """A load and its ties."""

    weight: float  # G2 [N]
    factor: float  # k, inertia force over weight
    elevation: float  # alpha [rad]
    plan: float  # beta [rad]
    friction: float  # mu of the cradle
    preload: float = 0.0  # P0 [N]
    thread: Thread | None = None  # gives the preload
    support: Support | None = None


@record
class TieDown:
    """Forces of the ties."""

    push: float = quantity("F[N]", "force that moves the load", source="(7)")
    press: float = quantity("G[N]", "force that presses the load on the cradle", source="(7)")
    preload: float = quantity("P0[N]", "preload of a tie", symbol="P_0")
    force: float = quantity("R[N]", "force of a tie that is stretched, at least the preload", source="(3)")
    change: float = quantity("dR[N]", "change R - P_0 of the force of a tie")
    opposite: float = quantity("R_opposite[N]", "force P_0 - dR of a tie that slackens, 0 once it is slack")
    vertical: float = quantity("vertical[N]", "vertical load 4 P_0 sin alpha of the ties")
    balanced: float = quantity(
        "R_balanced[N]", "R by the equilibrium of all ties, in which both pairs change by dR until one is slack"
    )
    best_elevation: float = quantity("alpha_best[rad]", "elevation of the least R")
    held: str = quantity("held_by", "what holds the load")  # "friction", "all ties", "two ties"
    notes: tuple[str, ...] = ()
    error: float = 0.0  # of the forces, relative to the largest


def thread_preload(thread: Thread) -> np.floating[Any]:
    """P0 = M/(d2 tan(lambda + rho')) [N] (8), of extended numbers too.

    >>> round(float(thread_preload(Thread(30.0, 0.014701, 0.0433, 0.2049))), 2)
    8052.38
    """
    return thread.moment / (thread.diameter * np.tan(thread.lead + thread.friction_angle))


def solve_tie_down(task: TieDownTask) -> TieDown:
    """Forces of the ties by (3) with the loads of (7), and by the equilibrium of all ties.

    Raises `NoSolutionError` where the inertia tips the load off the cradle.
    """
    found = _forces(task)
    push, press, preload, force, change, vertical, balanced, best = found.tolist()
    if press <= 0:
        raise NoSolutionError(
            f"the load leaves its cradle: it presses on it by {press:.6g} N",
            where="tie_down",
            value=press,
            limit=0.0,
            remedy="tighten the ties more, or let the load stand lower",
        )
    spare = push - task.friction * press
    all_tight = spare <= 4 * cos(task.elevation) * cos(task.plan) * preload
    held = "friction" if spare <= 0 else "all ties" if all_tight else "two ties"
    return TieDown(
        push=push,
        press=press,
        preload=preload,
        force=force,
        change=change,
        opposite=max(preload - change, 0.0),
        vertical=vertical,
        balanced=balanced,
        best_elevation=best,
        held=held,
        notes=tuple(_notes(force, preload, balanced)),
        error=apart(found[:-1], _forces(widened(task))[:-1]),
    )


def _forces(task: TieDownTask) -> Values:
    """F, G, P0, R, dR, vertical, balanced, best elevation (8,), in the numbers of the task."""
    preload = task.preload if task.thread is None else thread_preload(task.thread)
    push, own = _loads(task)
    mu, sine, cosine = task.friction, np.sin(task.elevation), np.cos(task.plan)
    along = np.cos(task.elevation) * cosine
    vertical = 4 * preload * sine
    press = own + vertical
    pull = 2 * (mu * sine + along)
    force = max((push - mu * press) / pull, preload)
    spread = max(push - mu * press, 0.0) / (4 * along)  # of both pairs
    balanced = preload + spread if spread <= preload else (push - mu * own) / pull
    best = np.arctan2(mu, cosine)
    return np.array([push, press, preload, force, force - preload, vertical, balanced, best])


def _loads(task: TieDownTask) -> tuple[float, float]:
    """F, and what presses the load on its cradle without ties (7)."""
    g, k, support = task.weight, task.factor, task.support
    if support is None:
        return k * g, g
    tipped = k * g * support.diameter / (2 * support.base)
    held = support.friction * (support.weight + g * support.arm / support.base + tipped)
    return k * g - held, g * support.cradle_arm / support.base - tipped


def _notes(force: float, preload: float, balanced: float) -> list[str]:
    found = []
    if force > 2 * preload > 0:
        found.append(f"warning: R = {force:.6g} N is above 2 P0 = {2 * preload:.6g} N: the opposite ties are slack")
    if balanced > force * (1 + 1e-9):
        found.append(
            f"note: the source's (3), R = {force:.6g} N, adds R to the vertical load of the preload, which is a part "
            f"of R; in equilibrium the tie carries {balanced:.6g} N: choose it by this"
        )
    return found
