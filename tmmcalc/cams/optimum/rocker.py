"""The smallest mechanism with a rocker: what the stage leaves of it, why there is none, what looser limits buy."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.optimum.contour import WINDOW, contour
from tmmcalc.cams.optimum.margins import SLACK
from tmmcalc.cams.optimum.plane import RockerPlane
from tmmcalc.cams.optimum.relaxation import limit_of, loosened, relaxed
from tmmcalc.cams.optimum.results import ACTIVE, Choice, Contour, Corner, Relaxation
from tmmcalc.cams.optimum.rockerleast import least_centres
from tmmcalc.cams.optimum.rockershapes import scanned, shapes, triangle
from tmmcalc.cams.optimum.rockersizes import (
    ANGLE,
    NUMBERS,
    PIVOT,
    RockerScene,
    Sizes,
    judge_rocker,
    rocker_choice,
    start_angle,
)
from tmmcalc.cams.optimum.rockersteps import FoundSteps, search_steps
from tmmcalc.cams.optimum.scene import WHERE
from tmmcalc.cams.task import Optimum
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.core.records import record

SOFT = 1e-6  # margin of the least mechanism that is still kept
REMEDIES = {
    2: "roller_friction, roller_inertia",
    3: "convex_radius",
    4: "concave_radius, allow_concave",
    5: "pin_pressure, roller_ratio",
    6: "bending, deflection, span",
    9: "contact, width",
    10: "pressure_angle, pressure_angle_return",
    11: "pivot_radius",
}


@record
class Smallest:
    """The mechanisms of the least l0."""

    least: Values  # (4,) l2, R0, r2, l0 of any sizes
    steps: FoundSteps


def smallest(of: RockerScene, asked: Optimum) -> Smallest:
    """The least l0 of any sizes and in whole steps; raises `NoSolutionError` where no sizes keep all constraints."""
    starts = scanned(of, asked)
    if not starts.shape[1]:
        raise _refusal(of, asked)
    least = least_centres(of, asked, starts)
    margin = judge_rocker(of, Sizes(*least[:, None])).margin[:, 0]
    free = least if margin[0] > ACTIVE else least_centres(of, asked, starts, rolls=False)
    if np.min(margin) < -SOFT:
        numbers = tuple(number for number, m in zip(NUMBERS, margin, strict=True) if m < -SOFT)
        raise _slipping(of, free) if 2 in numbers else _refused(of, least, numbers)
    return Smallest(least, search_steps(of, asked, float(free[3])))


def _refusal(of: RockerScene, asked: Optimum) -> NoSolutionError:
    """The error where no shape of any size keeps what it has to."""
    ratio, _ = shapes(of)
    if not ratio.size:
        limits = of.scene.limits
        text = "no rocker of any length keeps the pressure angle of {rise:g} deg"
        if limits.back is not None:
            text = (
                "no rocker of any length keeps the pressure angle of {rise:g} deg on the rise and {back:g} deg on the "
                "return"
            )
        return NoSolutionError(
            Phrase(text, rise=np.degrees(limits.rise), back=np.degrees(limits.back or 0.0)),
            where=WHERE,
            value=None,
            limit=limits.rise,
            remedy="a larger pressure_angle in [cam.limits], longer phases, a smaller stroke",
        )
    without = replace(asked, rocker_lengths=None, centre_distances=None)
    wider = scanned(of, without) if asked != without else np.empty((4, 0))
    if wider.shape[1]:
        l2, _, _, l0 = 1e3 * wider[:, 0]
        return NoSolutionError(
            Phrase(
                "the ranges of [cam.optimum] leave no sizes; without them the least is near l0 = {l0:.4g} mm with "
                "l2 = {l2:.4g} mm",
                l0=l0,
                l2=l2,
            ),
            where=WHERE,
            remedy="wider centre_distances or rocker_lengths",
        )
    sizes = _nearest(of)
    margin = judge_rocker(of, Sizes(*sizes[:, None])).margin[:, 0]
    return _refused(of, sizes, tuple(number for number, m in zip(NUMBERS, margin, strict=True) if m < -SLACK))


def _slipping(of: RockerScene, sizes: Values) -> NoSolutionError:
    """The error where the roller slips wherever all other constraints are kept, of which ``sizes`` are the smallest."""
    choice = rocker_choice(of, four(sizes))
    grown = next(each.value or 0.0 for each in choice.checks if each.number == 2)
    return NoSolutionError(
        Phrase(
            "constraint 2 (roller without slip) leaves none of the sizes that keep all others; at the smallest of "
            "these, l0 = {l0:.4g}, l2 = {l2:.4g}, R0 = {start:.4g}, r2 = {roller:.4g} mm, D = {grown:.4g} against 1",
            l0=1e3 * choice.height,
            l2=1e3 * choice.length,
            start=1e3 * choice.start,
            roller=1e3 * choice.roller,
            grown=grown,
        ),
        where=WHERE,
        value=grown,
        limit=1.0,
        remedy=f"look at {REMEDIES[2]}, the preload of the spring, the speed",
    )


def _nearest(of: RockerScene) -> Values:
    """Sizes (4,) of many whose least margin is largest."""
    ratio, angle = shapes(of)
    found: Values = np.empty(4)
    best = -np.inf
    for centres in np.geomspace(0.02, 5.0, 9):
        for part in (0.1, 0.25, 0.45):
            sizes = triangle(ratio, angle, np.full(len(ratio), centres))
            sizes = sizes._replace(roller=part * sizes.base)
            least = np.min(judge_rocker(of, sizes).margin, axis=0)
            k = int(np.argmax(least))
            if least[k] > best:
                found, best = np.stack(sizes)[:, k], float(least[k])
    return found


def _refused(of: RockerScene, sizes: Values, numbers: tuple[int, ...]) -> NoSolutionError:
    """The error of constraints that the nearest sizes break."""
    l2, base, r2, l0 = sizes.tolist()
    checks = {each.number: each for each in rocker_choice(of, (l2, base, r2, l0)).checks}
    broken = [checks[number] for number in numbers if checks[number].value is not None]
    said = [
        Phrase(
            "{number} {check}: {symbol} = {value:.4g} against {limit:.4g} {unit}",
            number=each.number,
            check=each.name,
            symbol=each.symbol,
            value=each.value,
            limit=each.limit or 0.0,
            unit=each.unit,
        )
        for each in broken
    ]
    return NoSolutionError(
        Phrase(
            "no sizes of a cam with a rocker keep all constraints; nearest is l0 = {l0:.4g}, l2 = {l2:.4g}, "
            "R0 = {base:.4g}, r2 = {roller:.4g} mm, with {broken}",
            l0=1e3 * l0,
            l2=1e3 * l2,
            base=1e3 * base,
            roller=1e3 * r2,
            broken=listed(said, "; ") or "constraints that exclude each other",
        ),
        where=WHERE,
        value=broken[0].value if broken else None,
        limit=broken[0].limit if broken else None,
        remedy="look at " + "; ".join(REMEDIES[each.number] for each in broken or checks.values() if each.number > 1),
    )


def rocker_contour(of: RockerScene, found: Smallest) -> Contour:
    """The region of R0 and r2 at l0 and l2 of the best step point."""
    l2, _, _, l0 = found.steps.sizes[:, 0].tolist()
    beside = np.flatnonzero(found.steps.sizes[0] == l2)
    plane, (base, roller) = RockerPlane(of, l2, l0), found.steps.sizes[1:3, beside]
    made = contour(plane, (base, plane.beyond(base, roller)))
    outlines = [replace(each, roller=plane.roller(each.start, each.roller)) for each in made.outlines]
    outlines = [replace(each, corners=tuple(_corner(plane, corner) for corner in each.corners)) for each in outlines]
    curves = [replace(each, roller=plane.roller(each.start, each.roller)) for each in made.curves]
    seen = np.concatenate([each.roller for each in outlines])
    room = WINDOW * float(np.ptp(seen))
    window = (*made.window[:2], max(float(seen.min()) - room, 0.0), float(seen.max()) + room)
    return Contour(made.height, tuple(outlines), tuple(curves), window)


def _corner(plane: RockerPlane, corner: Corner) -> Corner:
    at = np.array([corner.start]), np.array([corner.roller])
    return replace(corner, roller=float(plane.roller(*at)[0]))


def rocker_relaxations(of: RockerScene, asked: Optimum, least: Values) -> Iterator[Relaxation]:
    """Every active constraint of the mechanism of any sizes, relaxed by 1 % and to the next preferred number."""
    choice = rocker_choice(of, four(least))
    for number in choice.active:
        limit = _limit(of, choice, number)
        if limit is None:
            continue
        key, before, way, unit = limit
        for preferred in (False, True):
            after = loosened(before, way, preferred)
            height = float(least_centres(_relaxed(of, key, after), asked, least[:, None])[3])
            yield Relaxation(number, key, unit, before, after, preferred, height, choice.height - height)


def four(sizes: Values) -> tuple[float, float, float, float]:
    """l2, R0, r2, l0 [m] of an array (4,)."""
    l2, base, r2, l0 = sizes.tolist()
    return l2, base, r2, l0


def _limit(of: RockerScene, choice: Choice, number: int) -> tuple[str, float, int, str] | None:
    """The limit behind a constraint: its key in the spec, its value, and which way is looser."""
    if number == ANGLE:
        limits = of.scene.limits
        check = next(each for each in choice.checks if each.number == ANGLE)
        on_return = limits.back is not None and check.limit == limits.back != limits.rise
        return ("pressure_angle_return" if on_return else "pressure_angle", check.limit or 0.0, 1, "rad")
    if number == PIVOT:
        return ("pivot_radius", of.pivot, -1, "m") if of.pivot else None
    return limit_of(of.scene, number)


def _relaxed(of: RockerScene, key: str, value: float) -> RockerScene:
    """The scene with another limit; one angle for both phases stays one."""
    scene, limits = of.scene, of.scene.limits
    if key == "pivot_radius":
        return replace(of, pivot=value, friction=of.friction * value / of.pivot)
    if key == "pressure_angle_return":
        return replace(of, scene=replace(scene, limits=replace(limits, back=value)))
    if key == "pressure_angle":
        back = value if limits.back == limits.rise else limits.back
        return replace(of, scene=replace(scene, limits=replace(limits, rise=value, back=back)))
    return replace(of, scene=relaxed(scene, key, value))


def follower_of(follower: Follower, choice: Choice) -> Follower:
    """The rocker with the sizes of a choice."""
    one = (np.array([size]) for size in (choice.length, choice.start, choice.roller, choice.height))
    angle, _ = start_angle(Sizes(*one))
    return replace(follower, start=float(angle[0]), roller=choice.roller, centres=choice.height, rocker=choice.length)
