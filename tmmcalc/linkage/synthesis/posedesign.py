"""One linkage that carries a body through poses as a design: simulated, measured at the poses, written."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.errors import TmmError
from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Grid, Mechanism, Output
from tmmcalc.linkage.synthesis.builders import FourBar, Operation, SliderCrank, four_bar, slider_crank
from tmmcalc.linkage.synthesis.designs import SPEED, remarks
from tmmcalc.linkage.synthesis.planar import Bars, grashof
from tmmcalc.linkage.synthesis.posed import limits
from tmmcalc.linkage.synthesis.rating import Rating
from tmmcalc.linkage.synthesis.ready import ready_spec
from tmmcalc.linkage.synthesis.results import ANGLE_ERROR, DISTANCE, TRANSMISSION, Check, Design, Precision, Size
from tmmcalc.linkage.synthesis.simulation import check
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask

DEGENERATE = 1e6  # ratio of the links beyond which there is no linkage left


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
    coupler = chain_of(mechanism, result).evaluate(rating.phi[0], order=0).motions[2]
    turned = np.asarray(coupler.u)
    precision = _precision(asked, rating, np.asarray(coupler.point(complex(bars.point[0, 0])).r), turned)
    transmission = result.qualities[0].transmission or 0.0  # refined; the rating samples it
    rating = rating._replace(transmission=np.array([transmission]))
    distance = float(precision.found.max())
    merits = {TRANSMISSION.key: math.degrees(transmission), "longest/shortest": float(rating.ratio[0])}
    merits[DISTANCE.key] = distance
    checks: tuple[Check, ...] = (check("largest distance from the points", distance, "m"),)
    if len(precision.angle_errors):
        drift = float(np.max(np.abs(precision.angle_errors)))
        merits[ANGLE_ERROR.key] = math.degrees(drift)
        checks += (check("largest error of the body's angle", drift, "rad"),)
    sizes = _sizes(bars, turned[0], asked)
    name = "slider-crank" if bars.slides else f"four-bar, {grashof(bars.lengths())[0]}"
    text = ready_spec(mechanism, task.title or f"{title}, {name}", tuple(remarks(sizes)))
    return Design(name, sizes, checks, merits, rating.defects(0, limits(task)), text, None, precision)


def _precision(asked: PoseTask, rating: Rating, reached: np.ndarray, turned: np.ndarray) -> Precision:
    """Distances from the points, and errors of the body's angle where it is asked for."""
    angles = np.zeros(0)
    if asked.angles is not None:
        wanted = np.exp(1j * (asked.angles - asked.angles[0]))
        drift = np.angle(turned * np.conj(wanted) / turned[0])
        angles = drift - _middle(drift)
    return Precision(
        unit="m",
        sense=int(rating.sense[0]),
        crank=rating.phi[0],
        wanted=np.zeros(len(reached)),
        found=np.abs(reached - asked.points),
        points=asked.points,
        reached=reached,
        angle_errors=angles,
        fine=np.zeros(0),
        error=np.zeros(0),
    )


def _middle(drift: Real) -> float:
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
    scene = Operation(sense * abs(task.crank_speed or SPEED), start, grid, outputs)
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
