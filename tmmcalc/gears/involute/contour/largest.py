"""Point E: where the contact ratio of a region is largest."""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.involute.contour.bounds import cuts
from tmmcalc.gears.involute.contour.frame import Frame, Sums
from tmmcalc.gears.involute.contour.joined import Region
from tmmcalc.gears.involute.contour.trace import Part
from tmmcalc.gears.model import Values

ZOOM = 65  # points of a round that narrows a maximum
ROUNDS = 6
ASIDE = np.array([-1e-7, 1e-7])  # [rad] from a place that may be a maximum by itself
COARSE = 0.02  # by which the points of a part may miss its largest contact ratio
LEVEL = 1e-13  # of a contact ratio that grows no more


def largest_contact_ratio(frame: Frame, region: Region, strict: bool) -> tuple[float, float, float]:
    """x1, x2 and eps_alpha of the largest contact ratio of a region of the strict or the tolerated contour."""
    tops = [float(np.max(_best(frame, part.low, part.high, frame.sums(part.angles))[1])) for part in region.parts]
    close = (part for part, top in zip(region.parts, tops, strict=True) if top > max(tops) - COARSE)
    return max((_largest(frame, part, strict) for part in close), key=lambda found: found[2])


def _best(frame: Frame, low: Values, high: Values, sums: Sums) -> tuple[Values, Values]:
    """x1 and eps_alpha - eps_min (n,) of the best split between low and high."""
    x1 = np.clip(frame.best_split(sums), low, high)
    return x1, frame.overlap(sums, x1)[0]


def _largest(frame: Frame, part: Part, strict: bool) -> tuple[float, float, float]:
    """Of one part: on every line of constant sum the split of equal tip pressure angles, or the end next to it."""

    def looked(w: Values) -> tuple[Values, Values]:
        found = cuts(frame, w, part.branch, tolerated=not strict)
        low, high, _, _ = found.ends(strict)
        x1, ratio = _best(frame, low, high, found.sums)
        return x1, np.where(low <= high, ratio, -np.inf)

    w = part.angles
    x1, ratio = _best(frame, part.low, part.high, frame.sums(w))
    k = int(np.argmax(ratio))
    if 0 < k < w.size - 1 and np.all(looked(w[k] + ASIDE)[1] < ratio[k]):
        w, x1, ratio, k = w[k : k + 1], x1[k : k + 1], ratio[k : k + 1], 0  # a corner
    for _ in range(ROUNDS):
        if k in (0, w.size - 1) or ratio[k] - min(ratio[k - 1], ratio[k + 1]) < LEVEL:
            break
        w = np.linspace(w[k - 1], w[k + 1], ZOOM)
        x1, ratio = looked(w)
        k = int(np.argmax(ratio))
    sums = frame.sums(w)
    return float(x1[k]), float(sums.total[k] - x1[k]), float(ratio[k]) + frame.task.contact_ratio
