"""Largest and least values over the turn of all that the constraints limit, at many choices of S0, r2 and H2 at once.

The formulas are those of forces and strength, multiplied out by the speed v of the pitch curve: with S = S0 + y,
T = S' + e, P = -P_c and q from the roller up to the guide,

    v^2 = S^2 + T^2,   sin(theta) = T/v,   R = P v/u,   u = S - sense f |T| (1 + 2 q/l)

so that v^2, u and the numerators of kappa and A are the same few rows over the turn for all sizes, each times a number
that the sizes give: products of small matrices. The limits do not enter: `margins` sets these values against them.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tmmcalc.cams.forces.formulas import Mask, guide_length, protrusion
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.peaks import Crest, crest, peak
from tmmcalc.cams.optimum.scene import Scene

FUNCTIONS = ("-kappa", "kappa", "-A/R", "A/R", "-1/R", "-1/M_E^2", "-(1 - kappa r2)/R", "|M_T|", "|N1|")
SIGNS = np.array([[-1.0], [1.0]])  # of the two rows of a least and a largest value
LEAST_SHARE = 0.25  # of the functions: what all of them read takes as much room
CACHED = 48_000  # values of a function at a time: more would not stay in the cache
NEXT_TO_NONE = 1e-9  # strokes: the lever of a contact at the axis, so that its forces stay finite


class Extremes(NamedTuple):
    """Extremes over the turn at B choices of sizes; what a limit without data would need is 0."""

    works: Mask  # (B,) the guide has length and the follower jams nowhere
    smooth: Mask  # (B,) the profile has no cusp
    curvature: Values  # (2, B) least and largest kappa of the pitch curve [1/m]
    growth: Values  # (2, B) least and largest A/R [m/N] of the slip function
    contact: Values  # (B,) R [N]
    edge: Values  # (B,) |N1| [N]
    moment: Values  # (B,) of the stem at the lower edge [N*m]
    reduced: Values  # (B,) M_E of the shaft [N*m]
    pressed: Values  # (B,) R/(1 - kappa r2) [N], of which the contact stress is a root


def extremes(scene: Scene, start: Values, roller: Values, top: Values, wanted: Mask | None = None) -> Extremes:
    """The extremes at S0, r2, H2 (B,) [m]; those that are not ``wanted`` (9, B) of FUNCTIONS mean nothing."""
    wanted = np.ones((len(FUNCTIONS), len(start)), bool) if wanted is None else wanted
    own = blocks(scene, len(start), np.count_nonzero(wanted) / max(wanted.size, 1))
    parts = [_block(scene, start[part], roller[part], top[part], wanted[:, part]) for part in own]
    works = np.concatenate([part for part, _ in parts])
    best, _ = peak(Crest(*map(np.concatenate, zip(*(on for _, on in parts), strict=True))))
    ends, high = np.cumsum([len(on.node) for _, on in parts])[:-1], np.full(wanted.shape, -1.0)
    for part, values in zip(own, np.split(best, ends), strict=True):
        high[:, part][wanted[:, part]] = values
    smooth, contact = high[6] < 0, 1 / np.abs(high[4])
    return Extremes(
        works=works & (high[4] < 0),
        smooth=smooth,
        curvature=high[:2] * SIGNS,
        growth=high[2:4] * SIGNS,
        contact=contact,
        edge=high[8],
        moment=high[7],
        reduced=1 / np.sqrt(np.abs(high[5])),
        pressed=np.where(smooth, -1 / np.where(smooth, high[6], -1.0), contact),
    )


def blocks(scene: Scene, count: int, share: float = 1.0) -> list[slice]:
    """Parts of so many choices, each few enough; ``share`` of the functions is wanted of them."""
    size = max(int(CACHED / max(share, LEAST_SHARE)) // len(scene.phi), 1)
    return [slice(i, i + size) for i in range(0, max(count, 1), size)]


def pitch(scene: Scene, start: Values) -> tuple[Values, Values]:
    """1/v [1/m] and kappa [1/m] (5.35) of the pitch curve (B, M) at S0 (B,)."""
    power = np.stack((np.ones_like(start), start, start * start), axis=1)
    slow = 1 / np.sqrt(power @ scene.rows.square)
    return slow, (power @ scene.rows.bend) * slow * slow * slow


def spun(scene: Scene, start: Values, roller: Values) -> Values:
    """A [m] of the roller (B, M) at S0 and r2 (B,), with the machine's speed as in the strength."""
    rows, (slow, _) = scene.rows, pitch(scene, start)
    found: Values = (np.stack((start, np.ones_like(start)), axis=1) @ rows.growth) * slow
    if rows.spin is not None:
        found += rows.spin * (1 / slow - roller[:, None])
    return found * rows.force


def _block(scene: Scene, start: Values, roller: Values, top: Values, wanted: Mask) -> tuple[Mask, Crest]:
    """Where few enough choices work at the nodes (B,), and the crests of the `_functions`."""
    length = guide_length(top, start, scene.stroke, roller, scene.guide.gap)
    room = length > 0
    inverse = np.where(room, 1 / np.where(room, length, 1.0), 0.0)
    reach = room + 2 * (scene.stroke + roller + scene.guide.gap) * inverse
    useful = np.stack((start, np.ones_like(start), -reach, 2 * inverse), axis=1) @ scene.rows.useful
    works = room & (np.min(useful, axis=1) > 0)
    if not works.all():  # forces as without friction, so that they stay finite
        free = np.maximum(np.abs(start[:, None] + scene.motion[0]), NEXT_TO_NONE * scene.stroke)
        useful = np.where(useful > 0, useful, free)
    found = _functions(scene, start, roller[:, None], inverse[:, None], useful, wanted)
    return works, crest(scene.by_panel(found))


def _functions(scene: Scene, start: Values, roller: Values, inverse: Values, useful: Values, wanted: Mask) -> Values:
    """FUNCTIONS (m, M), each of the choices for which it is ``wanted`` (9, B).

    R has a pole where the follower jams, 1/R has none.
    """
    rows, (slow, kappa) = scene.rows, pitch(scene, start)
    count = np.count_nonzero(wanted, axis=1)
    found = np.empty((int(count.sum()), kappa.shape[1]))
    at = np.split(found, np.cumsum(count)[:-1])
    low, high, _, grow, force, shaft, press, guide = (_chosen(each) for each in (*wanted[:7], wanted[7] | wanted[8]))
    at[1][...] = kappa[high]
    np.negative(kappa[low], out=at[0])
    growth = np.matmul(np.stack((start, np.ones_like(start)), axis=1)[grow], rows.growth, out=at[3])
    growth *= useful[grow]
    growth *= slow[grow]
    growth *= slow[grow]
    if rows.spin is not None:
        growth += rows.spin * useful[grow] * (1 - roller[grow] * slow[grow])
    np.negative(growth, out=at[2])
    slow *= useful
    slow *= rows.inverse
    np.negative(slow[force], out=at[4])
    bent = kappa[press]
    bent *= roller[press]
    bent -= 1
    np.multiply(slow[press], bent, out=at[6])
    square = slow[shaft]
    square *= square
    np.divide(square, -(((scene.requirements.span or 1.0) / 4) ** 2) - rows.twist * square, out=at[5])
    across = rows.couple / useful[guide]
    moment = across * protrusion(scene.motion, scene.stroke, roller[guide], scene.guide.gap)
    stem, edge = (_chosen(wanted[k, guide]) for k in (7, 8))
    at[7][...] = moment[stem]
    np.multiply(moment[edge], inverse[guide][edge], out=at[8])
    at[8] += across[edge]
    return found


def _chosen(wanted: Mask) -> Any:
    """The rows that are wanted; of all of them no copy is needed."""
    return slice(None) if wanted.all() else np.flatnonzero(wanted)
