"""Flat-faced follower: S0 by the convexity of the profile, the reach of the face.

rho = S0 + F, F = dS + S'', may nowhere be less than r_m (5.95 to 5.97); at a jump of S'' both limits count. The contact
stands at -S' from the follower's axis, so the face reaches max S' on one side and max(-S') on the other.
"""

from __future__ import annotations

from typing import Any

from tmmcalc.cams.pressure.angle import Extreme
from tmmcalc.cams.synthesis.results import Convexity
from tmmcalc.cams.task import CamTask
from tmmcalc.core.notes import Said, held


def flat_sizes(task: CamTask) -> tuple[float, str, Convexity]:
    """S0 [m], what decides it, and what convexity asks; a given S0 is kept."""
    program, asked, limits = task.program, task.asked, task.limits
    dense = program.panels.halved()
    y, y1, y2, _ = program.at(dense.x.ravel()).reshape(4, *dense.x.shape)
    least = Extreme(*dense.extremes(y + y2)[0])
    back, rise = (value for value, _ in dense.extremes(y1))
    needed = limits.convex - least.value
    given = asked.start if asked.start is not None else asked.base
    start, governs = (needed, "convexity") if needed >= limits.shaft else (limits.shaft, "shaft")
    if given is not None:
        start, governs = given, "given"
    sides = rise + asked.margin, -back + asked.margin
    left, right = sides if asked.sense > 0 else sides[::-1]
    return (
        start,
        governs,
        Convexity(least, limits.convex, needed, start + least.value, left, right, asked.margin),
    )


def remarks(found: Convexity, start: float, shaft: float) -> list[Said]:
    """Warnings of a given S0."""
    notes: list[Said] = []
    if found.radius <= 0:
        text = (
            "with S0 = {value:.6g} mm rho falls to {radius:.6g} mm at phi = {phi}: the profile has a cusp or a loop "
            "that the face cannot follow; S0 of at least {limit:.6g} mm is needed"
        )
        words: dict[str, Any] = {"radius": 1e3 * found.radius, "phi": _deg(found.least.phi)}
        notes.append(held("warning", text, start, found.needed, "m", shown="mm", name="S0", **words))
    elif start < found.needed * (1 - 1e-12):
        text = (
            "rho falls to {value:.6g} mm at phi = {phi}, below the limit of {limit:.6g} mm; S0 of at least "
            "{needed:.6g} mm is needed"
        )
        words = {"phi": _deg(found.least.phi), "needed": 1e3 * found.needed}
        notes.append(held("warning", text, found.radius, found.limit, "m", shown="mm", name="rho_min", **words))
    if start < shaft * (1 - 1e-12):
        text = "S0 = {value:.6g} mm does not clear the shaft of {limit:.6g} mm"
        notes.append(held("warning", text, start, shaft, "m", shown="mm", name="S0"))
    return notes


def _deg(phi: float) -> str:
    return f"{phi * 57.29577951308232:.6g} deg"
