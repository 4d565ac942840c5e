"""The lowest mechanism with a flat-faced follower (section 5.8.4): the chart of H2 and S0, and whole steps.

Convexity asks for S0 >= r_m - F_min, F = dS + S'', whatever H2 (5.97). The pressure in the guide asks for a length l:
R = P/(1 - 2 f S'/l) and |N1| = R |S'|/l, so that |N1| <= N at an angle of the cam means l >= P |S'|/N + 2 f S', and
l* is the largest of that over the turn. H2 = S0 + h + gap + l is least with both (fig. 5.37). Shaft, stem and contact
may ask for more of S0 or of l.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import pi

import numpy as np

from tmmcalc.cams.forces.formulas import GuidedForces
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.checks import closure
from tmmcalc.cams.optimum.guidelength import NEVER, TALL, Held, Range, masked, solved
from tmmcalc.cams.optimum.margins import SLACK
from tmmcalc.cams.optimum.peaks import crest, largest, peak
from tmmcalc.cams.optimum.relaxation import bought
from tmmcalc.cams.optimum.results import NAMES, Check, Choice, FlatChart, Level, Relaxation
from tmmcalc.cams.optimum.scene import WHERE, Scene, guided_at
from tmmcalc.cams.strength.formulas import (
    BAD,
    ROUNDING,
    WHOLE,
    allowed_square,
    flat_radius,
    flat_stress,
    guide_pressure,
    reduced_moment,
    shaft_by_stiffness,
    shaft_by_strength,
    stem_moment,
    stem_stress,
    unused,
    whole,
)
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase

STRETCH = (20.0, 0.2)  # S0 is looked for so many strokes above the least, or so far [m]
FIRST, NODES, ROUNDS = 41, 13, 17  # of the search for the lowest S0 of any size: it ends at rounding


def chart(scene: Scene) -> FlatChart:
    """S0_min, l* and H2_min. Raises `UsageError` without the data of the guide."""
    need, guide = scene.requirements, scene.guide
    if need.guide_pressure is None or guide.stem is None or guide.land is None:
        raise UsageError(
            "the length of the guide follows from the pressure in it, whose data are not given",
            where=WHERE,
            remedy="give guide_pressure in [cam.requirements], stem_radius and land in [cam.guide]",
        )
    limit = need.guide_pressure * 2 * guide.land * guide.stem
    slide = scene.motion[1]
    convexity = -(scene.motion[0] + scene.motion[2])
    length = -scene.load * np.abs(slide) / limit + 2 * scene.friction * slide
    on = crest(scene.by_panel(np.stack((convexity, length))))
    value, place = peak(on)
    ends = scene.by_panel(scene.phi)[on.panel]
    phi = (ends[:, 0] + place * (ends[:, -1] - ends[:, 0])).tolist()
    start = max(scene.limits.convex + float(value[0]), 0.0)
    height = start + scene.stroke + guide.gap + float(value[1])
    return FlatChart(start, -float(value[0]), phi[0], float(value[1]), phi[1], height, scene.stroke, guide.gap)


def lengths(scene: Scene) -> Callable[[Values], Range]:
    """Lengths of the guide that constraints 6 to 9 leave, as a function of S0 (B,)."""
    need, guide = scene.requirements, scene.guide
    force, slide = -scene.load, scene.motion[1]
    lever, couple = 2 * scene.friction * slide, force * np.abs(slide)

    def held(limit: Values) -> Range:
        """R <= limit."""
        return solved(lever, 1 - force / np.maximum(limit, NEVER), scene.panels)

    every = held(np.full((1, 1), np.inf))
    if need.guide_pressure is not None and guide.stem is not None and guide.land is not None:
        pressed = couple / (need.guide_pressure * 2 * guide.land * guide.stem)
        every = every.meet(solved(lever + pressed, np.ones((1, len(slide))), scene.panels))
    if need.bending is not None and guide.stem is not None:
        limit = need.bending * pi * guide.stem**3 / 4
        every = every.meet(solved(lever, 1 - couple[None] / limit, scene.panels))

    def at(start: Values) -> Range:
        found = every.meet(_shafted(scene, start, held))
        if need.contact is None or need.width is None:
            return found
        radius = np.maximum(flat_radius(scene.motion, start[:, None]), 0.0)
        return found.meet(held(allowed_square(need.contact, need.width, need.modulus) * radius))

    return at


def _shafted(scene: Scene, start: Values, held: Held) -> Range:
    """Constraint 6, S0 >= r1* in whole mm: once for every whole mm."""
    need = scene.requirements
    size = np.floor(start / WHOLE + ROUNDING).astype(int)
    least = int(size.min())
    seen = np.flatnonzero(np.bincount(size - least))
    radius, limit = WHOLE * (least + seen[:, None]), np.full((1, 1), np.inf)
    if need.span is not None and need.deflection is not None:
        limit = radius**4 * 12 * pi * need.young * need.deflection / need.span**3
    if need.span is not None and need.bending is not None:
        square = (pi * need.bending * radius**3 / 4) ** 2 - need.torsion * scene.torque**2
        limit = np.minimum(limit, 4 / need.span * np.sqrt(np.maximum(square, 0.0)))
    on = held(np.broadcast_to(limit, (len(seen), limit.shape[1])))
    return on.of(np.searchsorted(seen, size - least)).meet(masked(start >= scene.limits.shaft * (1 - SLACK)))


def lowest(scene: Scene) -> tuple[float, float]:
    """S0 and H2 of the lowest mechanism of any size.

    Raises `NoSolutionError` if no S0 keeps shaft, stem and contact stress within their limits.
    """
    seen = chart(scene)
    base = scene.stroke + scene.guide.gap
    low, high = seen.least_start, seen.least_start + max(STRETCH[0] * scene.stroke, STRETCH[1])
    side, start, top = low + (high - low) * np.linspace(0, 1, FIRST) ** 2, low, TALL
    ranges = lengths(scene)
    for _ in range(ROUNDS):
        found = ranges(side)
        height = np.where(found.some, side + base + found.least, TALL)
        best = int(np.argmin(height))
        if height[best] >= TALL:
            raise _none(scene, high)
        start, top = float(side[best]), float(height[best])
        side = np.linspace(side[max(best - 1, 0)], side[min(best + 1, len(side) - 1)], NODES)
    return start, top


def _by_length(scene: Scene, start: float, height: float) -> Check:
    """The constraint of least margin among those that the length of the guide decides."""
    checks = (each for each in choice_of(scene, start, height).checks if each.number > 3 and each.judged)
    return min(checks, key=lambda each: each.margin)


def steps(scene: Scene, step: float, height_step: float) -> tuple[float, Values, int, tuple[Level, ...]]:
    """The least H2 in whole steps, all S0 (n,) that have it, how many were looked at, the heights that were tried."""
    seen = chart(scene)
    base = scene.stroke + scene.guide.gap
    far = seen.least_start + max(STRETCH[0] * scene.stroke, STRETCH[1])
    side = step * np.arange(max(int(np.ceil(seen.least_start / step - ROUNDING)), 1), int(far / step) + 1)
    found = lengths(scene)(side)
    first = np.ceil((side + base + found.least) / height_step - ROUNDING)
    last = np.floor((side + base + found.most) / height_step + ROUNDING)
    course: list[Level] = []
    for level in np.sort(np.unique(first[found.some & (first <= last)])).tolist():
        top = level * height_step
        rows = side[found.some & (first <= level) & (last >= level)].tolist()
        worst = [_by_length(scene, each, top) for each in rows]
        good = [each for each, check in zip(rows, worst, strict=True) if check.margin >= -SLACK]
        best = max(worst, key=lambda check: check.margin)
        course.append(Level(top, len(rows), len(rows), len(good), best.margin, best.number))
        if good:
            return top, np.array(good), len(side), tuple(course)
    raise _none(scene, far)


def _none(scene: Scene, far: float) -> NoSolutionError:
    """No S0: what is broken at the largest one."""
    broken = [each for each in choice_of(scene, far, far + 11 * scene.stroke).checks if each.margin < 0]
    names = [
        Phrase(
            "{number} {check} ({value:.4g} against {limit:.4g} {unit})",
            number=each.number,
            check=each.name,
            value=each.value,
            limit=each.limit,
            unit=each.unit,
        )
        for each in broken
    ]
    return NoSolutionError(
        Phrase(
            "no S0 up to {far:.4g} mm keeps all constraints; at that are broken: {names}",
            far=1e3 * far,
            names=names or "none",
        ),
        where=WHERE,
        remedy="looser limits of these, or a wider face",
    )


def choice_of(scene: Scene, start: float, height: float) -> Choice:
    """The sizes with all constraints of a flat face; 2, 4 and 5 are those of a roller."""
    need, guide = scene.requirements, scene.guide
    on = _carried(scene, start, height)
    radius = flat_radius(scene.motion, np.full((1, 1), start))
    works, convex = bool(np.all(on.works)), bool(np.all(radius > 0))
    peak = _peak(scene, on.contact)
    strong = stiff = 0.0
    if need.span is not None and need.bending is not None:
        moment = _peak(scene, reduced_moment(on.contact, scene.torque, need.span, need.torsion))
        strong = float(shaft_by_strength(moment, need.bending))
    if need.span is not None and need.deflection is not None:
        stiff = float(shaft_by_stiffness(peak, need.span, need.young, need.deflection))
    shaft = max(float(whole(max(strong, stiff))), scene.limits.shaft)
    least = scene.limits.convex + _peak(scene, -(scene.motion[:1] + scene.motion[2:3]))
    rows = [_check(3, "S0", start, ">=", least, "m"), _check(6, "S0", start, ">=", shaft, "m", works=works)]
    if guide.stem is not None:
        moments = stem_moment(scene.follower, scene.motion, on.contact, on.sine, on.protrusion)
        bent = float(stem_stress(_peak(scene, moments), guide.stem))
        rows.append(_check(7, "sigma_F", bent, "<=", need.bending, "Pa", works=works))
        if guide.land is not None:
            pressed = float(guide_pressure(_peak(scene, np.abs(on.lower)), guide.land, guide.stem))
            rows.append(_check(8, "p", pressed, "<=", need.guide_pressure, "Pa", works=works))
    if need.width is not None:
        stress = _peak(scene, flat_stress(on.contact, radius, need.width, need.modulus)[0])
        rows.append(_check(9, "sigma_H", stress, "<=", need.contact, "Pa", works=works and convex))
    length = height - start - scene.stroke - guide.gap
    return Choice(start, 0.0, height, length, (closure(scene), *rows))


def largest_force(scene: Scene, choice: Choice) -> float:
    """Largest R [N]."""
    return _peak(scene, _carried(scene, choice.start, choice.height).contact)


def _carried(scene: Scene, start: float, height: float) -> GuidedForces:
    return guided_at(scene, *np.array([[start], [0.0], [height]]))


def _peak(scene: Scene, values: Values) -> float:
    return float(largest(scene.by_panel(values.reshape(1, -1)))[0])


def _check(
    number: int, symbol: str, value: float, relation: str, limit: float | None, unit: str, *, works: bool = True
) -> Check:
    if limit is None:
        return Check(number, NAMES[number], symbol, None, relation, None, unit, 1.0)
    margin = float(unused(value, limit)) if relation == "<=" else float(unused(limit, value))
    return Check(number, NAMES[number], symbol, value, relation, limit, unit, margin if works else BAD)


def relaxations(scene: Scene, least: Choice) -> Iterator[Relaxation]:
    """Every active constraint of the lowest mechanism, relaxed."""
    return bought(scene, least, lambda others: [lowest(each)[1] for each in others])
