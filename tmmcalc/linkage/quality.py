"""How well the mechanism transmits: transmission and pressure angles, dead points, and their grades.

The transmission angle of a dyad is the angle between its two links (RRR), between the rod and the normal of the
guide (RRP), between the slot and the pin's circle (RPR), between the two guides (PRP, RPP); 90 degrees is
best, and the pressure angle is its complement. The regularity is the sine that divides every velocity of the
dyad: its inverse is the amplification of any error. Both are minimised over the whole range, not read
off the grid.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from tmmcalc.core.errors import SingularityError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.extrema import around, maxima, refine
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real, square
from tmmcalc.linkage.assembly import coordinate
from tmmcalc.linkage.chain import Chain, Configuration, Step
from tmmcalc.linkage.results import Extreme, Grade, GroupQuality
from tmmcalc.linkage.survey import Evaluate, Survey, alone, along_motion

SINGULAR = 1e-6  # regularity of a dead point: below it velocities have no trustworthy digits
NEARLY_SINGULAR = 0.05  # amplification above 20
POOR = math.radians(20)  # transmission angle: a warning below
MODEST = math.radians(30)  # a note below
CONSTANT = 1e-14  # a squared sine that varies less has no minimum to refine


class Measure(NamedTuple):
    """One squared sine to minimise: of the transmission angle, or of the regularity, of group ``k``.

    The margin of a dyad is the squared sine of its transmission angle, smooth through the change points too. A higher
    group has no transmission angle: of it the square of the smallest singular value of its equations is taken.
    """

    k: int
    regularity: bool
    reach: float | Real  # largest distance of the pivots of an RPR dyad [m], of one variant or of each

    def of(self, variants: Indices) -> Measure:
        """The measure of rows (m,) that are of these variants of a stack."""
        return self._replace(reach=self.reach[variants]) if isinstance(self.reach, np.ndarray) else self

    def __call__(self, chain: Chain, configuration: Configuration, x: Real) -> Real:
        """The squared sine (n,) of a configuration at the input coordinates x (n,)."""
        step, ports = chain.steps[self.k], configuration.ports[self.k]
        if not isinstance(step, Step):
            return np.broadcast_to(step.regularity(configuration.placed[self.k]) ** 2, x.shape)
        sine2 = step.dyad.margin(*ports)
        if self.regularity:
            sine2 = sine2 * square(ports[0].r - ports[1].r) / self.reach**2
        return np.broadcast_to(sine2, x.shape)


def kinds_of(chain: Chain) -> list[tuple[int, bool]]:
    """Groups and whether their regularity is meant, or their transmission: the same number but for RPR."""
    found = []
    for k, step in enumerate(chain.steps):
        found.append((k, not step.group.kind))
        if step.group.kind == "RPR":
            found.append((k, True))
    return found


def passes_clearly(chain: Chain, dense: Survey) -> bool:
    """Whether the range is far from any dead point: no squared sine is as small as it changes between two samples."""
    squares = _sampled(chain, dense)[1]
    return bool(np.all(np.min(squares, axis=2) > np.max(np.abs(np.diff(squares, axis=2)), axis=2)))


def assess(chain: Chain, dense: Survey, start: float) -> tuple[GroupQuality, ...]:
    """Transmission and regularity of every dyad over the surveyed range, which begins at ``start``."""
    measures, squares = _sampled(chain, dense)
    return assessed(chain, alone(chain), measures, dense.x[None], squares, np.array([start]), full=dense.full)[0]


def _sampled(chain: Chain, dense: Survey) -> tuple[list[Measure], Real]:
    """The measures of a chain, and their samples (M, 1, m) over the surveyed range."""
    pivots = dense.configuration.placed
    measures = [
        Measure(k, regularity, float(np.max(np.abs(pivots[k].q))) if regularity and chain.steps[k].group.kind else 0.0)
        for k, regularity in kinds_of(chain)
    ]
    squares = np.array([measure(chain, dense.configuration, dense.x) for measure in measures])
    return measures, squares.reshape(len(measures), 1, len(dense.x))


def assessed(
    chain: Chain,
    evaluate: Evaluate,
    measures: Sequence[Measure],
    x: Real,
    squares: Real,
    start: Real,
    *,
    full: bool,
) -> list[tuple[GroupQuality, ...]]:
    """Transmission and regularity of every dyad of V variants, from samples of their ``measures``.

    ``squares`` (M, V, m) stand at x (V, m), whose ranges begin at ``start`` (V,) and are ``full`` turns or not; of the
    ``chain`` is taken what is the same for all.
    """
    minima = _minima(chain, evaluate, measures, x, squares, start, full=full)
    return [
        tuple(quality_of(chain, k, measures, squares[:, v], own) for k in range(len(chain.steps)))
        for v, own in enumerate(minima)
    ]


def _minima(
    chain: Chain, evaluate: Evaluate, measures: Sequence[Measure], x: Real, squares: Real, start: Real, *, full: bool
) -> list[list[list[tuple[float, float]]]]:
    """All local minima (squared sine, place) of every measure of every variant, open ends among them.

    The least stands first; of those that rounding alone tells apart the first in place.
    """
    varies = np.ptp(squares, axis=2) > CONSTANT
    inside = squares[..., :-1] if full else squares
    owner, variant, row = np.nonzero(maxima(-inside, full) & varies[..., None])
    found: list[list[list[tuple[float, float]]]] = [[[] for _ in measures] for _ in x]
    if not owner.size:
        return found

    def squared_sine(at: Real, which: Indices) -> Real:
        def of_owner(own: Chain, configuration: Configuration, rows: Indices) -> Real:
            its = which[rows]
            every = [measure.of(variant[its])(own, configuration, at[rows]) for measure in measures]
            return np.asarray(np.array(every)[owner[its], np.arange(len(its))])

        return evaluate(at, variant[which], of_owner, 0)

    at, sine2 = refine(squared_sine, *around(x, row, full, variant))
    sampled = squares[owner, variant, row]
    better = sampled < sine2
    at, sine2 = np.where(better, x[variant, row], at), np.where(better, sampled, sine2)
    if full:
        at = along_motion(chain, at, start[variant])
    for m, v, place, value in zip(owner.tolist(), variant.tolist(), at.tolist(), sine2.tolist(), strict=True):
        found[v][m].append((max(value, 0.0) + 0.0, place))
    return [[sorted(each, key=lambda minimum: (round(minimum[0], 12), minimum[1])) for each in own] for own in found]


def quality_of(
    chain: Chain, k: int, measures: Sequence[Measure], squares: Real, minima: list[list[tuple[float, float]]]
) -> GroupQuality:
    """The quality of group ``k`` from the ``minima`` of all measures; of those without ``squares`` (M, m) tell it."""
    rows = [m for m, measure in enumerate(measures) if measure.k == k]
    angles = [Extreme(_angle(sine2), x) for sine2, x in minima[rows[0]]]
    sines = [Extreme(math.sqrt(sine2), x) for sine2, x in minima[rows[-1]]]
    constant_angle, constant_sine = (max(float(squares[m, 0]), 0.0) for m in (rows[0], rows[-1]))
    group = chain.steps[k].group
    if not group.kind:
        angles, constant_angle = [], 1.0
    return GroupQuality(
        group.name,
        (angles[0].value if angles else _angle(constant_angle)) if group.kind else None,
        angles[0].x if angles else None,
        sines[0].value if sines else math.sqrt(constant_sine),
        sines[0].x if sines else None,
        tuple(sorted((e for e in angles if e.value < MODEST), key=lambda e: e.x)),
        tuple(sorted((e for e in sines if e.value < NEARLY_SINGULAR), key=lambda e: e.x)),
    )


def _angle(sine2: float) -> float:
    """The angle [rad] of a squared sine; exactly 90 degrees where rounding alone keeps it from there."""
    return math.pi / 2 if 1 - sine2 < CONSTANT else math.asin(math.sqrt(sine2))


def check_regular(chain: Chain, qualities: tuple[GroupQuality, ...]) -> None:
    """Raise `SingularityError` if the range passes through a dead point, with all its places."""
    for step, quality in zip(chain.steps, qualities, strict=True):
        if quality.regularity >= SINGULAR:
            continue
        dead = [e.x for e in quality.singular if e.value < SINGULAR]
        places = f"at {coordinate(chain, *dead)}" if dead else "at every position"
        what, cause = "singular position", "the links of the group come to a limit position, or can go on in two ways"
        if isinstance(step, Step):
            what, cause = "dead point", step.dyad.dead_point()
        raise SingularityError(
            f"{what} {places}: {cause}; velocities are not defined "
            f"(regularity {quality.regularity:.3g}, limit {SINGULAR:g})",
            where=f"kinematics, group {quality.group}",
            value=quality.regularity,
            limit=SINGULAR,
            remedy="change a length, or analyse a range that keeps clear of it: input.start and grid.span",
        )


def grade(chain: Chain, qualities: tuple[GroupQuality, ...]) -> tuple[Grade, ...]:
    """Notes and warnings on every weak transmission and nearly singular place, with its angle and number."""
    grades = []
    for quality in qualities:
        where = Phrase("group {group}", group=quality.group)
        for near in quality.singular:
            at = coordinate(chain, near.x)
            text = Phrase(
                "nearly singular at {at}: errors and velocities are amplified {value:.4g} times",
                at=at,
                value=1 / near.value,
            )
            grades.append(Grade("warning", where, text, 1 / near.value, 1 / NEARLY_SINGULAR, name="amplification"))
        for weak in quality.weak:
            limit = 20 if weak.value < POOR else 30
            at = coordinate(chain, weak.x)
            text = Phrase(
                "transmission angle {value:.4g} deg at {at}, below {limit} deg",
                value=math.degrees(weak.value),
                at=at,
                limit=limit,
            )
            degree: Literal["note", "warning"] = "warning" if weak.value < POOR else "note"
            grades.append(Grade(degree, where, text, math.degrees(weak.value), limit, "deg", "transmission"))
        if quality.transmission is not None and quality.transmission_at is None and quality.transmission < MODEST:
            text = Phrase(
                "transmission angle {transmission:.4g} deg at every position, below 30 deg",
                transmission=math.degrees(quality.transmission),
            )
            degree = "warning" if quality.transmission < POOR else "note"
            grades.append(Grade(degree, where, text, math.degrees(quality.transmission), 30, "deg", "transmission"))
    return tuple(grades)
