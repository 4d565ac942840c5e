"""Forces in the ties that hold a load on a vehicle against its inertia force along the way.

Four ties, two along each direction of the way, elevation alpha, angle beta in plan; a load of weight G2 on a fixed
cradle and, if there is one, on a sliding support. F moves the load, G presses it on the cradle; P0 is the preload.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos
from typing import Any

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, Said, held
from tmmcalc.core.numerics.extended import apart, widened
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

ROWS = 100  # equal steps of the table over k
PAST = 1.2  # of the largest k of interest, to which it goes


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
    section: float | None = None  # of a tie [m^2]
    strength: float | None = None  # yield stress of a tie [Pa]


@record
class Thresholds:
    """Values of k, the inertia force over the weight, at which something begins; None: it never does."""

    slip: float | None = quantity("k_slip", "friction alone no longer holds the load")
    slack: float | None = quantity("k_slack", "the opposite ties are slack, R by equilibrium is 2 P0")
    source_slip: float | None = quantity("k_slip_3", "R by (3) is P0", source="(3)")
    source_slack: float | None = quantity("k_slack_3", "R by (3) is 2 P0", source="(3)")
    yielding: float | None = quantity("k_yield", "a stretched tie yields, by equilibrium")
    tipping: float | None = quantity("k_tip", "the load leaves its cradle")


@record
class TieDown:
    """Forces of the ties."""

    factor: float = quantity("k", "inertia force over weight")
    push: float = quantity("F[N]", "force that moves the load", source="(7)")
    press: float = quantity("G[N]", "force that presses the load on the cradle", source="(7)")
    preload: float = quantity("P0[N]", "preload of a tie", symbol="P_0")
    force: float = quantity(
        "R[N]",
        "approximate force of a stretched tie, as if all ties pressed the load down as before; at least the preload",
        source="(3)",
    )
    change: float = quantity("dR[N]", "change R - P_0 of the force of a tie")
    opposite: float = quantity("R_opposite[N]", "force P_0 - dR of a tie that slackens, 0 once it is slack")
    vertical: float = quantity("vertical[N]", "vertical load 4 P_0 sin alpha of the ties")
    balanced: float = quantity(
        "R_balanced[N]", "R by the equilibrium of all ties, in which both pairs change by dR until one is slack"
    )
    best_elevation: float = quantity("alpha_best[rad]", "elevation of the least R")
    held: str = quantity("held_by", "what holds the load")  # "friction", "all ties", "two ties"
    stress: float | None = quantity("sigma[Pa]", "stress of a stretched tie, R by equilibrium over its section")
    safety: float | None = quantity("safety", "yield stress of a tie over its stress, R by equilibrium")
    thresholds: Thresholds
    labels: tuple[str, ...]
    k: Values = quantity("k[-]", "inertia force over weight")  # (n,)
    forces: Values = quantity("R[N]", "force of a stretched tie by (3)")  # (n,)
    balance: Values = quantity("R_balanced[N]", "force of a stretched tie by equilibrium")  # (n,)
    slackening: Values = quantity("R_opposite_balanced[N]", "force of an opposite tie by equilibrium")  # (n,)
    notes: tuple[Said, ...] = ()
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
    push, press, preload, force, change, vertical, balanced, _, best = found.tolist()
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
    stress = None if task.section is None else balanced / task.section
    safety = None if stress is None or task.strength is None or stress <= 0 else task.strength / stress
    limits = thresholds(task)
    k = _range(task.factor, limits)
    course = np.array([_forces(replace(task, factor=float(each))) for each in k])
    return TieDown(
        factor=task.factor,
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
        stress=stress,
        safety=safety,
        thresholds=Thresholds(*(None if each is None else float(each) for each in limits)),
        labels=tuple(map(str, range(len(k)))),
        k=k,
        forces=course[:, 3],
        balance=course[:, 6],
        slackening=course[:, 7],
        notes=tuple(_notes(force, preload, balanced, safety)),
        error=_error(task, found, limits),
    )


def thresholds(task: TieDownTask) -> tuple[Any, ...]:
    """The values of `Thresholds`, each a root of an equation that is linear in k, in the numbers of the task.

    R is 2 P0 where F - mu G = 4 P0 cos alpha cos beta.
    """
    preload = _preload(task)
    mu, sine = task.friction, np.sin(task.elevation)
    along = np.cos(task.elevation) * np.cos(task.plan)
    pull = 2 * (mu * sine + along)
    vertical = 4 * preload * sine
    held, rise = unheld(task)

    def reached(spare: Any) -> Any:
        return (spare + held) / rise if rise > 0 else None

    yielding = None
    if task.section is not None and task.strength is not None:
        most = task.section * task.strength
        tight = 4 * along * (most - preload)
        yielding = reached(tight if most <= 2 * preload else pull * most - mu * vertical) if most > preload else 0.0
    own, fall = _pressing(task)
    tipping = (own + vertical) / fall if fall > 0 else None
    slack, first = reached(4 * along * preload), reached(0.0)
    return first, slack, reached(pull * preload), reached(2 * pull * preload), yielding, tipping


def unheld(task: TieDownTask) -> tuple[Any, Any]:
    """F0 and F1 [N] of what friction does not hold, F - mu G = k F1 - F0."""
    push, one_push = (_loads(replace(task, factor=factor))[0] for factor in (0.0, 1.0))
    own, fall = _pressing(task)
    vertical = 4 * _preload(task) * np.sin(task.elevation)
    return task.friction * (own + vertical) - push, one_push - push + task.friction * fall


def _pressing(task: TieDownTask) -> tuple[Any, Any]:
    """What presses the load on its cradle without ties and without inertia, and by how much less it is with k = 1."""
    own, one_own = (_loads(replace(task, factor=factor))[1] for factor in (0.0, 1.0))
    return own, own - one_own


def _range(factor: float, limits: tuple[Any, ...]) -> Values:
    """Values of k for a table: from 0 beyond all that begins, which are among them, up to where the load tips."""
    *rest, tipping = limits
    begin = [float(each) for each in rest if each is not None]
    end = PAST * max([factor, *begin]) or 1.0
    if tipping is not None:
        end = min(end, float(tipping))
    return np.unique([*(end * np.arange(ROWS + 1) / ROWS), *(each for each in begin if 0 < each < end)])


def _error(task: TieDownTask, found: Values, limits: tuple[Any, ...]) -> float:
    """Forces and thresholds again in extended precision."""
    wide = widened(task)
    pairs = zip(limits, thresholds(wide), strict=True)
    missed = [apart(one, other) for one, other in pairs if one is not None and other is not None and one]
    return max(apart(found[:-1], _forces(wide)[:-1]), *missed, 0.0)


def _preload(task: TieDownTask) -> Any:
    return task.preload if task.thread is None else thread_preload(task.thread)


def _forces(task: TieDownTask) -> Values:
    """F, G, P0, R, dR, vertical, balanced, opposite, best elevation (9,), in the numbers of the task."""
    preload = _preload(task)
    push, own = _loads(task)
    mu, sine, cosine = task.friction, np.sin(task.elevation), np.cos(task.plan)
    along = np.cos(task.elevation) * cosine
    vertical = 4 * preload * sine
    press = own + vertical
    pull = 2 * (mu * sine + along)
    force = max((push - mu * press) / pull, preload)
    spread = max(push - mu * press, 0.0) / (4 * along)  # of both pairs
    balanced = preload + spread if spread <= preload else (push - mu * own) / pull
    opposite = max(preload - spread, 0.0)
    best = np.arctan2(mu, cosine)
    return np.array([push, press, preload, force, force - preload, vertical, balanced, opposite, best])


def _loads(task: TieDownTask) -> tuple[float, float]:
    """F, and what presses the load on its cradle without ties (7)."""
    g, k, support = task.weight, task.factor, task.support
    if support is None:
        return k * g, g
    tipped = k * g * support.diameter / (2 * support.base)
    held = support.friction * (support.weight + g * support.arm / support.base + tipped)
    return k * g - held, g * support.cradle_arm / support.base - tipped


def _notes(force: float, preload: float, balanced: float, safety: float | None) -> list[Said]:
    found: list[Said] = []
    if safety is not None and safety < 1:
        text = "the ties yield: their yield stress is {value:.4g} of their stress by equilibrium"
        found.append(held("warning", text, safety, 1.0, name="safety"))
    if force > 2 * preload > 0:
        text = "R = {value:.6g} N is above 2 P0 = {limit:.6g} N: the opposite ties are slack"
        found.append(held("warning", text, force, 2 * preload, "N", name="R"))
    if balanced > force * (1 + 1e-9):
        found.append(
            Phrase(
                "note: the source's (3), R = {force:.6g} N, adds R to the vertical load of the preload, which is "
                "a part of R; in equilibrium the tie carries {balanced:.6g} N: choose it by this",
                force=force,
                balanced=balanced,
            )
        )
    return found
