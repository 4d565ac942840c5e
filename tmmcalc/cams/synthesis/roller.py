"""The roller: how large it may be, and which rule bounds it.

0.4 R0, 0.7 rho2       the rule of practice; rho2 is the least radius of the convex parts of the pitch curve
rho2 - r_m             the profile keeps a radius that can be made (5.39); equal to rho2 it has a cusp
R0 - r1                the roller clears the shaft
rho1 - r_m             the second wall of a groove keeps such a radius in the concave parts of the pitch curve
"""

from __future__ import annotations

from collections.abc import Iterator
from math import floor

import numpy as np

from tmmcalc.cams.follower import Follower, contact_path, curvature
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import Extreme
from tmmcalc.cams.program import levelled
from tmmcalc.cams.synthesis.results import RollerChoice, RollerRule
from tmmcalc.cams.task import CamTask
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, Said, held
from tmmcalc.core.numerics.panels import resolved

OF_BASE, OF_CONVEX = 0.4, 0.7
STEP = 1e-3  # [m] rollers come in whole millimetres
NEAR = 1e-9


def bends(task: CamTask, follower: Follower) -> tuple[Extreme, Extreme]:
    """Least and largest curvature [1/m] of the pitch curve, both limits at jumps counted."""
    program = task.program

    def kappa(phi: Values) -> Values:
        return curvature(contact_path(follower, phi, program.at(phi)))[None]

    dense, values, _ = resolved(kappa, program.panels.halved())
    low, high = dense.extremes(levelled(values[0]))
    return Extreme(*low), Extreme(*high)


def choose(task: CamTask, follower: Follower) -> RollerChoice:
    """The roller of the follower, given or by the rules, rounded down to a whole millimetre where it has one.

    Raises `NoSolutionError` if no roller fits.
    """
    low, high = bends(task, follower)
    convex = Extreme(1 / high.value, high.phi)  # a closed curve is convex somewhere
    concave = Extreme(-1 / low.value, low.phi) if low.value * follower.base < -NEAR else None
    limits, asked = task.limits, task.asked
    rules = [
        RollerRule("0.4 R0", OF_BASE * follower.base),
        RollerRule("0.7 rho2", OF_CONVEX * convex.value),
        RollerRule("rho2 - r_m", convex.value - limits.convex),
    ]
    if limits.shaft > 0:
        rules.append(RollerRule("R0 - r1", follower.base - limits.shaft))
    if asked.closure == "groove" and concave is not None:
        rules.append(RollerRule("rho1 - r_m, second wall", concave.value - limits.convex))
    least = min(rules, key=lambda rule: rule.value)
    if asked.roller is not None:
        return RollerChoice(asked.roller, least.name, tuple(rules), convex, concave)
    if least.value <= 0:
        raise NoSolutionError(
            f"no roller fits: {least.name} = {1e3 * least.value:.6g} mm",
            where="cam_synthesis",
            value=least.value,
            limit=0.0,
            remedy="a larger base_radius or start_distance, a smaller convex_radius or shaft_radius",
        )
    return RollerChoice(rounded(least.value), least.name, tuple(rules), convex, concave)


def rounded(radius: float) -> float:
    """Down to a whole millimetre; below one as it is.

    >>> rounded(0.0187), rounded(0.0004)
    (0.018, 0.0004)
    """
    whole = floor(radius / STEP * (1 + NEAR))
    return whole / 1e3 if whole else radius


def remarks(task: CamTask, follower: Follower, found: RollerChoice) -> list[Said]:
    """Warnings of a roller that is too large or too small for its pitch curve."""
    limits, r2 = task.limits, found.radius
    notes: list[Said] = [*_of_wall("profile", "rho2", r2, found.convex, limits.convex)]
    if task.asked.closure == "groove" and found.concave is not None:
        notes += _of_wall("second wall", "rho1", r2, found.concave, limits.convex)
    if follower.base - r2 < limits.shaft * (1 - NEAR):
        text = "R0 - r2 = {value:.6g} mm does not clear the shaft of {limit:.6g} mm"
        notes.append(held("warning", text, follower.base - r2, limits.shaft, "m", shown="mm", name="R0 - r2"))
    if found.concave is None:
        return notes
    phi = np.degrees(found.concave.phi)
    if not limits.allow_concave:
        notes.append(Phrase("warning: the profile is concave at phi = {phi:.6g} deg, which is not allowed", phi=phi))
    elif found.concave.value + r2 < limits.concave * (1 - NEAR):
        text = (
            "the concave part at phi = {phi:.6g} deg has a radius of {value:.6g} mm: a tool of {limit:.6g} mm does not "
            "reach into it"
        )
        numbers = (found.concave.value + r2), limits.concave, "m"
        notes.append(held("note", text, *numbers, shown="mm", name="rho_concave", phi=phi))
    return notes


def _of_wall(wall: str, symbol: str, r2: float, bend: Extreme, least: float) -> Iterator[Said]:
    """A warning where the roller leaves a wall no radius, or less than can be made, at its sharpest place."""
    at = Phrase("at phi = {phi:.6g} deg", phi=np.degrees(bend.phi))
    if r2 >= bend.value * (1 - NEAR):
        text = "the roller of {value:.6g} mm undercuts the {wall}: {symbol} = {limit:.6g} mm {at}"
        yield held("warning", text, r2, bend.value, "m", shown="mm", name="r2", wall=wall, symbol=symbol, at=at)
    elif r2 > (bend.value - least) * (1 + NEAR):
        text = "the roller of {roller:.6g} mm leaves the {wall} a radius of {value:.6g} mm {at}, below {limit:.6g} mm"
        numbers = (bend.value - r2), least, "m"
        yield held("warning", text, *numbers, shown="mm", name="rho_min", roller=1e3 * r2, wall=wall, at=at)
