"""N1 and sigma_H along r2 at the chosen S0 and H2 (fig. 5.30), with the radii at which they pass their limits."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.margins import Judged, judge
from tmmcalc.cams.optimum.results import Choice, Section
from tmmcalc.cams.optimum.scene import Scene
from tmmcalc.core.numerics.roots import bracketed

POINTS = 121
SOUND = -10.0  # margins below it are those of a guide that is none, or of a cusp


def section_of(scene: Scene, chosen: Choice) -> Section:
    """Up to where there is no guide left or the profile has a cusp; among the radii are r2 chosen and the limits."""
    need, guide = scene.requirements, scene.guide
    edge = None
    if need.guide_pressure is not None and guide.land is not None and guide.stem is not None:
        edge = 2 * guide.land * guide.stem * need.guide_pressure
    room = chosen.height - chosen.start - scene.stroke - scene.guide.gap
    roller = np.sort(np.append(room * np.arange(1, POINTS + 1) / (POINTS + 1), chosen.roller))
    found = _along(scene, chosen, roller)
    sound = np.all(found.margin > SOUND, axis=0)
    roller, known = roller[sound], [(found.edge[sound], edge), (found.stress[sound], need.contact)]
    places = [
        _passed(scene, chosen, roller, values / limit - 1, which)
        for which, (values, limit) in enumerate(known)
        if limit is not None
    ]
    roller = np.sort(np.concatenate((roller, *places)))
    found = _along(scene, chosen, roller)
    return Section(chosen.start, chosen.height, roller, found.edge, found.stress, edge, need.contact)


def _along(scene: Scene, chosen: Choice, roller: Values) -> Judged:
    return judge(scene, np.full(len(roller), chosen.start), roller, np.full(len(roller), chosen.height))


def _passed(scene: Scene, chosen: Choice, roller: Values, excess: Values, which: int) -> Values:
    """Radii (m,) at which |N1| (0) or sigma_H (1) passes its limit, which it exceeds by the part ``excess`` at some."""
    rows = np.flatnonzero(np.signbit(excess[1:]) != np.signbit(excess[:-1]))

    def over(at: Values, _: Indices) -> Values:
        found = _along(scene, chosen, at).margin[-2:]
        return -found[which]

    low, high, before, after = roller[rows], roller[rows + 1], excess[rows], excess[rows + 1]
    guess = low + (high - low) * before / (before - after)
    return bracketed(over, low, high, known=(before, after, guess))
