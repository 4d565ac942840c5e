"""Rotating slotted link with a rod and a slider, the crank longer than the line of centres (r > L).

      A                    A straight above C, the guide y = e' to the right of C
      |` . r               e' = 0: the slotted link has turned by half a turn between the extremes, so
    L |    ` B             L = r cos(alpha_x/2), R = S/2, l = R/sin(nu_max)
      C-----/--D           e' not 0: R of the stroke, then L of the time ratio, each as the root of
           ` . l           the exact relation; l = (R + |e'|)/sin(nu_max)
-------------[E]---
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.designs import ClosedForm, closed_form
from tmmcalc.linkage.synthesis.results import PRESSURE, Size, Synthesis
from tmmcalc.linkage.synthesis.slottedpost import checked, checks
from tmmcalc.linkage.synthesis.strokes import TURN, overlap
from tmmcalc.linkage.synthesis.task import RotatingTask, SynthesisTask

RULE = "the shortest line of centres"
KIND = "rotating_slotted_link"
SAMPLES = 2000  # of a size between which roots are sought


def solve(task: SynthesisTask) -> Synthesis:
    """All rotating slotted links with the stroke and time ratio asked for; raises `NoSolutionError` if none is."""
    asked: RotatingTask = task.asked
    arms = _arms(asked)
    found = [(arm, rod, ratio) for arm, rod in arms for ratio in _ratios(asked, arm, rod)]
    if not found:
        raise NoSolutionError(
            f"no slotted link that turns round has this stroke and K = {asked.time_ratio:g}"
            + (f" with the guide {1e3 * asked.guide:.6g} mm off its pivot" if asked.guide else ""),
            where=f"synthesis.{KIND}",
            value=asked.time_ratio,
            limit=1.0,
            remedy="ask for K > 1, a smaller guide offset, or a larger pressure angle",
        )
    designs = [_closed(task, asked, *each) for each in sorted(found, key=lambda each: each[2])]
    return closed_form(task, KIND, RULE, designs)


def _rod(asked: RotatingTask, arm: Real) -> Real:
    if asked.rod is not None:
        return np.full_like(arm, asked.rod)
    return (arm + abs(asked.guide)) / math.sin(asked.pressure or math.nan)


def _arms(asked: RotatingTask) -> list[tuple[float, float]]:
    """Arms R with their rods l that give the stroke: S/2, but for an offset guide."""
    if asked.guide == 0:
        arm = asked.stroke / 2
        rod = float(_rod(asked, np.array([arm]))[0])
        return [(arm, rod)] if rod > arm else []

    def residual(arm: Real) -> Real:
        rod, e = _rod(asked, arm), abs(asked.guide)
        far, near = (rod + arm - e) * (rod + arm + e), (rod - arm - e) * (rod - arm + e)
        inside = rod > arm + e
        return np.where(inside, np.sqrt(np.maximum(far, 0)) - np.sqrt(np.maximum(near, 0)), 4 * arm) - asked.stroke

    arms = _roots(residual, asked.stroke / 2 * np.linspace(1e-4, 1.0 + 1e-9, SAMPLES))
    pairs = [(float(arm), float(_rod(asked, np.array([arm]))[0])) for arm in arms]
    return [(arm, rod) for arm, rod in pairs if rod > arm + abs(asked.guide)]


def _ratios(asked: RotatingTask, arm: float, rod: float) -> list[float]:
    """L/r of the time ratio: the crank turns by alpha_p while the slotted link goes from extreme to extreme."""
    e = asked.guide
    if e == 0:
        value = math.cos(math.pi / (asked.time_ratio + 1))
        return [value] if value > 0 else []
    far, near = math.asin(e / (rod + arm)), math.pi + math.asin(e / (rod - arm))

    def residual(x: Real) -> Real:
        return crank_angle(near, x) - crank_angle(far, x) - (math.pi + overlap(asked.time_ratio))

    return [float(x) for x in _roots(residual, np.linspace(1e-6, 1 - 1e-6, SAMPLES))]


def crank_angle(theta: float, x: Real) -> Real:
    """Angle of the crank [rad] about A = i L with the slotted link at ``theta``, for L = x r; continuous in theta.

    The ray from C at theta meets the crank's circle once, for C lies inside it.
    """
    along = x * np.sin(theta) + np.sqrt(1 - (x * np.cos(theta)) ** 2)  # C to B, in cranks
    local = along * np.exp(1j * theta) - 1j * x
    return theta + np.angle(local * np.exp(-1j * theta))


def _roots(f: Callable[[Real], Real], x: Real) -> Real:
    values = f(x)
    change = np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))
    return bracketed(lambda at, which: f(at), x[change], x[change + 1])


def _closed(task: SynthesisTask, asked: RotatingTask, arm: float, rod: float, ratio: float) -> ClosedForm:
    crank = asked.crank if asked.crank is not None else (asked.centres or math.nan) / ratio
    centres = asked.centres if asked.centres is not None else crank * ratio
    post = checked(task, (crank, centres, arm, rod, asked.guide))
    found = post.simulation
    second = (found.first + found.working) % TURN
    sizes = (
        Size("r", crank, "m", "crank AB"),
        Size("L", centres, "m", "line of centres CA"),
        Size("R", arm, "m", "arm CD of the slotted link"),
        Size("l", rod, "m", "connecting rod DE"),
        Size("e", asked.guide, "m", "guide over the pivot C"),
        Size("psi", overlap(asked.time_ratio), "rad", "overlap angle"),
        Size("phi_zero", found.first, "rad", "crank at the far end of the stroke"),
        Size("phi_second", second, "rad", "crank at the near end of the stroke"),
    )
    merits = {PRESSURE.key: math.degrees(post.pressure), "L/r": centres / crank}
    return ClosedForm("rotating slotted link", sizes, tuple(checks(asked, post)), merits, post.mechanism, found)
