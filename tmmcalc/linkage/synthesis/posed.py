"""Linkages that carry a body through poses, from its two points that are pinned: built, rated, ranked, written."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.errors import TmmError
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Grid, Mechanism, Output
from tmmcalc.linkage.plane import Plane, Real
from tmmcalc.linkage.synthesis.builders import FourBar, Scene, SliderCrank, four_bar, slider_crank
from tmmcalc.linkage.synthesis.designs import SPEED, remarks
from tmmcalc.linkage.synthesis.planar import Bars, bars_of, grashof
from tmmcalc.linkage.synthesis.rating import Asked as Limits
from tmmcalc.linkage.synthesis.rating import Rating, rate
from tmmcalc.linkage.synthesis.ready import ready_spec
from tmmcalc.linkage.synthesis.results import Design, Precision, Size
from tmmcalc.linkage.synthesis.simulation import check
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask

POOR = math.radians(20)  # least transmission angle without a defect, if none is asked for
DEGENERATE = 1e6  # ratio of the links beyond which there is no linkage left
CHUNK = 2000  # linkages rated at once
MERGED = 0.01  # designs whose sizes differ by less are one in the list
RULE = "fewest defects; then the greatest least transmission angle"


def pinned(places: Plane, turn: Plane, z1: Plane, c1: Plane, z2: Plane, c2: Plane | None) -> tuple[Bars, Plane, Plane]:
    """Linkages of pins z1, z2 (m,) about c1, c2 (m,), or with z2 on a line; and the places (m, n) of both pins.

    ``places`` (n,) and ``turn`` (m, n) or (1, n) are the poses.
    """
    b, c = places + turn * z1[:, None], places + turn * z2[:, None]
    along = z2 - z1
    length = np.maximum(np.abs(along), 1e-300)
    point = -z1 * np.conj(along) / length
    if c2 is None:
        far = np.argmax(np.abs(c - c[:, :1]), axis=1)
        way = c[np.arange(len(c)), far] - c[:, 0]
        way = way / np.maximum(np.abs(way), 1e-300)
        way = np.where((way.real < -1e-12) | ((np.abs(way.real) <= 1e-12) & (way.imag < 0)), -way, way)
        end, rocker, guide = c[:, 0], np.ones(len(c)), way
    else:
        end, rocker, guide = np.asarray(c2, complex), np.abs(c[:, 0] - c2), np.ones(len(c), complex)
    parts = (c1, np.abs(b[:, 0] - c1), length, end, rocker, guide, point, np.ones(len(c)))
    return bars_of([np.asarray(part)[:, None] for part in parts], c2 is None), b, c


def best_first(designs: list[Design]) -> list[Design]:
    """Designs by the rule: fewest defects, then the greatest least transmission angle."""
    return sorted(designs, key=lambda design: (len(design.defects), -design.merits["transmission_min[deg]"]))


def limits(task: SynthesisTask) -> Limits:
    """What `Rating` is asked."""
    asked: PoseTask = task.asked
    return Limits(asked.full_turn, task.transmission or POOR, asked.largest_ratio)


def ranked(task: SynthesisTask, bars: Bars, b: Plane, c: Plane, keep: int = 40) -> list[tuple[Bars, Rating]]:
    """The best of many linkages, each alone with its rating, near copies left out."""
    kept: list[tuple[Bars, Rating, float, float]] = []
    for low in range(0, len(b), CHUNK):
        rows = np.arange(low, min(low + CHUNK, len(b)))
        part, rating = rate(bars.rows(rows), b[rows], c[rows])
        count = rating.faults(limits(task))
        order = np.lexsort((-rating.transmission, count))[: 4 * keep]
        kept += [
            (
                part.rows(np.array([k])),
                Rating(*(value[[k]] for value in rating)),
                float(count[k]),
                -float(rating.transmission[k]),
            )
            for k in order
        ]
    kept.sort(key=lambda each: each[2:])
    found: list[tuple[Bars, Rating]] = []
    for part, rating, *_ in kept:
        if all(_apart(part, other) for other, _ in found):
            found.append((part, rating))
        if len(found) == keep:
            break
    return found


def _apart(one: Bars, other: Bars) -> bool:
    mine, yours = (np.array([part.pivot, part.end, part.crank + 0j, part.coupler + 0j]) for part in (one, other))
    return bool(np.max(np.abs(mine - yours)) > MERGED * np.max(np.abs(mine)))


def designed(task: SynthesisTask, bars: Bars, rating: Rating, title: str) -> Design | None:
    """The design of one linkage, simulated; None if its mechanism does not run through the positions."""
    asked: PoseTask = task.asked
    if rating.ratio[0] > DEGENERATE:
        return None
    mechanism = _mechanism(task, bars, rating)
    try:
        result = solve_kinematics(mechanism)
    except TmmError:
        return None
    x = rating.phi[0]
    motions = chain_of(mechanism, result).evaluate(x, order=0).motions
    reached = np.asarray(motions[2].point(complex(bars.point[0, 0])).r)
    distance = np.abs(reached - asked.points)
    turned = np.asarray(motions[2].u)
    angles = np.zeros(0)
    if asked.angles is not None:
        wanted = np.exp(1j * (asked.angles - asked.angles[0]))
        drift = np.angle(turned * np.conj(wanted) / turned[0])
        angles = drift - body_drift(drift)
    precision = Precision(
        unit="m",
        crank=x,
        wanted=np.zeros(len(x)),
        found=distance,
        points=asked.points,
        reached=reached,
        angle_errors=angles,
        fine=np.zeros(0),
        error=np.zeros(0),
    )
    transmission = result.qualities[0].transmission or 0.0  # refined; the rating samples it
    rating = rating._replace(transmission=np.array([transmission]))
    merits = {"transmission_min[deg]": math.degrees(transmission), "longest/shortest": float(rating.ratio[0])}
    merits["error_max[mm]"] = 1e3 * float(distance.max())
    checks = [check("largest distance from the points", float(distance.max()), "m", None)]
    if len(angles):
        merits["angle_error_max[deg]"] = math.degrees(float(np.max(np.abs(angles))))
        checks.append(check("largest error of the body's angle", float(np.max(np.abs(angles))), "rad", None))
    sizes = _sizes(bars, turned[0], asked)
    defects = (*rating.defects(0, limits(task)), *_outside(asked, bars))
    name = "slider-crank" if bars.slides else f"four-bar, {grashof(bars.lengths())[0]}"
    text = ready_spec(mechanism, task.title or f"{title}, {name}", tuple(remarks(sizes)))
    return Design(name, sizes, tuple(checks), merits, defects, text, None, precision)


def _outside(asked: PoseTask, bars: Bars) -> Iterator[str]:
    """A fit may put its pivots anywhere: outside the region they are a defect."""
    pivots = (bars.pivot,) if bars.slides else (bars.pivot, bars.end)
    for at in (complex(pivot[0, 0]) for pivot in pivots):
        if asked.region is not None and not _inside(at, *asked.region):
            yield f"region: a fixed pivot stands at ({1e3 * at.real:.6g}, {1e3 * at.imag:.6g}) mm, outside"


def _inside(at: complex, low: complex, high: complex) -> bool:
    return low.real <= at.real <= high.real and low.imag <= at.imag <= high.imag


def body_drift(drift: Real) -> float:
    """Constant part of the error of the body's angle: where it stands on the coupler is free."""
    return float((drift.max() + drift.min()) / 2)


def _mechanism(task: SynthesisTask, bars: Bars, rating: Rating) -> Mechanism:
    """Over a turn where the crank turns fully, else from the first to the last position."""
    phi, sense = rating.phi[0], float(rating.sense[0])
    start, along = float(phi[0]), sense * (phi - phi[0])
    turns = bool(rating.turns[0])
    extra = tuple(float(a) for a in np.sort(along) if a > 0)
    grid = Grid(task.positions, span=None if turns else float(along.max()), extra=extra)
    if not rating.order[0] and not turns:
        low, high = float(np.min(sense * phi)), float(np.max(sense * phi))
        start, grid = sense * low, Grid(task.positions, span=high - low)
    outputs = (Output("P", 0.0, label="Px"), Output("P", math.pi / 2, label="Py"))
    scene = Scene(sense * abs(task.crank_speed or SPEED), start, grid, outputs)
    pivot, end, point = (complex(part[0, 0]) for part in (bars.pivot, bars.end, bars.point))
    crank, coupler, rocker = (float(part[0, 0]) for part in (bars.crank, bars.coupler, bars.rocker))
    sign = int(bars.sign[0, 0])
    if bars.slides:
        angle = float(np.angle(bars.guide[0, 0]))
        return slider_crank(SliderCrank(pivot, crank, coupler, end, angle, point, sign), scene)
    return four_bar(FourBar(pivot, crank, coupler, rocker, end, point, sign), scene)


def _sizes(bars: Bars, turned: complex, asked: PoseTask) -> tuple[Size, ...]:
    pivot, end, point = (complex(part[0, 0]) for part in (bars.pivot, bars.end, bars.point))
    sizes = [
        Size("x_A", pivot.real, "m", "crank's pivot"),
        Size("y_A", pivot.imag, "m", "crank's pivot"),
        Size("a", float(bars.crank[0, 0]), "m", "crank AB"),
        Size("b", float(bars.coupler[0, 0]), "m", "coupler BC"),
    ]
    if bars.slides:
        sizes += [
            Size("x_G", end.real, "m", "a point of the guide"),
            Size("y_G", end.imag, "m", "a point of the guide"),
            Size("gamma", float(np.angle(bars.guide[0, 0])), "rad", "direction of the guide"),
        ]
    else:
        sizes += [
            Size("c", float(bars.rocker[0, 0]), "m", "rocker DC"),
            Size("x_D", end.real, "m", "rocker's pivot"),
            Size("y_D", end.imag, "m", "rocker's pivot"),
        ]
    sizes += [Size("p", point.real, "m", "P along BC from B"), Size("q", point.imag, "m", "P to the left of BC")]
    if asked.angles is not None:
        angle = float(np.angle(np.exp(1j * asked.angles[0]) / turned))
        sizes.append(Size("body", angle, "rad", "the body's axis from BC"))
    return tuple(sizes)
