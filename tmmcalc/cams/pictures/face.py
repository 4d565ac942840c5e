"""The picture of a flat-faced follower: the radius S0 + F with what convexity asks (figure 5.34), the contact on it."""

from __future__ import annotations

from collections.abc import Callable
from math import degrees

import numpy as np
from matplotlib.figure import SubFigure

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.synthesis.results import Convexity
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.curves import bottom, frame, mark
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.style import CURVES, INK, MARK

TICKS = 25


def draw_convexity(sheet: SubFigure, task: CamTask, found: Convexity, follower: Follower) -> Callable[[], None]:
    """Lay two diagrams out: radius of the profile and of what it is made; place of the contact on the face."""
    upper, lower = sheet.subplots(2, 1, height_ratios=[1.8, 1.0], sharex=True)
    dense = task.program.panels.halved()
    y, y1, y2, _ = (with_limits(dense, row.reshape(dense.x.shape)) for row in task.program.at(dense.x.ravel()))
    phi, rho = np.degrees(places(dense)), 1e3 * (follower.start + y + y2)
    upper.plot(phi, rho, linewidth=1.4, zorder=4, **CURVES[0])
    frame(upper, "radius of the profile $\\rho = S_0 + F$, mm", phi, True, TICKS)
    upper.axhline(1e3 * follower.start, color=INK, linewidth=0.8, linestyle=(0, (8, 2, 1.5, 2)))
    upper.axhline(1e3 * found.limit, color=MARK, linewidth=1.1, linestyle=(0, (6, 2)))
    upper.fill_between(phi, 0, 1e3 * found.limit, color=MARK, alpha=0.15, linewidth=0)
    upper.set_ylim(min(0.0, 1.15 * float(rho.min())) - 0.03 * float(rho.max()), 1.12 * float(rho.max()))
    sign = -follower.sense  # the contact stands to the left on the rise of a clockwise cam
    place = sign * 1e3 * y1
    lower.plot(phi, place, linewidth=1.4, zorder=4, **CURVES[2])
    frame(lower, "contact on the face, mm\n(positive to the right)", phi, True, TICKS)
    for reach in (-found.left, found.right):
        lower.axhline(1e3 * reach, color=MARK, linewidth=1.1, linestyle=(0, (6, 2)))
    bottom([upper, lower], True)

    def finish() -> None:
        labels = Labels(upper)
        labels.avoid(phi + 1j * rho, 1.0)
        at = complex(degrees(found.least.phi), 1e3 * found.radius)
        mark(upper, labels, at, CURVES[0], 6)
        edge = float(phi[-1])
        labels.put(
            f"$S_0$ = {signed(1e3 * follower.start, 6)}",
            [complex(0.8 * edge, 1e3 * follower.start)],
            size=8.5,
            prefer=1j,
        )
        text = f"$r_m$ = {signed(1e3 * found.limit, 5)}: $S_0 \\geq r_m - F_{{min}}$ = {signed(1e3 * found.needed, 6)}"
        labels.put(text, [complex(0.8 * edge, 1e3 * found.limit)], size=8.5, prefer=1j, color=MARK)
        labels = Labels(lower)
        labels.avoid(phi + 1j * place, 1.0)
        for reach, word in ((-found.left, "left"), (found.right, "right")):
            text = f"{word} {signed(1e3 * abs(reach), 6)}"
            labels.put(text, [complex(0.8 * edge, 1e3 * reach)], size=8, prefer=-1j if reach > 0 else 1j, color=MARK)

    return finish
