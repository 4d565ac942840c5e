"""Motion generation: a four-bar or slider-crank whose coupler passes through n poses.

The pins are body points whose places lie on circles (or, of a slider, on a line): any points of two or three poses,
those of a curve of four, up to four real points of five (see `burmester`). More poses are met in the least squares.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.errors import NoSolutionError
from tmmcalc.linkage.plane import Plane
from tmmcalc.linkage.synthesis.burmester import Poses, centres, circle_points, curve_points, line_points
from tmmcalc.linkage.synthesis.designs import CLOSED
from tmmcalc.linkage.synthesis.planar import Bars
from tmmcalc.linkage.synthesis.posed import RULE, best_first, designed, pinned, ranked
from tmmcalc.linkage.synthesis.posefit import fitted
from tmmcalc.linkage.synthesis.rating import Rating
from tmmcalc.linkage.synthesis.results import Design, Synthesis
from tmmcalc.linkage.synthesis.task import PoseTask, SynthesisTask
from tmmcalc.progress import tell

MOST = {False: 5, True: 4}  # poses that are met exactly, by whether it slides
DYADS = 100  # pins that are paired, of each kind
REACH = 3.0  # pins and pivots stand within so many spreads of the poses


def solve(task: SynthesisTask) -> Synthesis:
    """The linkages that guide the body; raises `NoSolutionError` if none does."""
    asked: PoseTask = task.asked
    assert asked.angles is not None
    slides = asked.mechanism == "slider_crank"
    exact = len(asked.points) <= MOST[slides]
    tell(0.0, "pins of the body")
    designs = _designs(task, _exact(task, slides)) if exact else []
    designs = best_first([design for design in designs if error_of(design, spread(asked.points)) < CLOSED])
    met = bool(designs)
    if not met and (not exact or asked.region is None):
        designs = _designs(task, fitted(task))
        designs.sort(key=lambda design: (len(design.defects), design.merits["error_max[mm]"]))
    if not designs:
        linkage, count = asked.mechanism.replace("_", "-"), len(asked.points)
        raise NoSolutionError(
            f"no {linkage} was found that guides the body through the {count} poses",
            where="synthesis.motion",
            value=float(count),
            remedy="change a pose, leave region out, or give one pose less",
        )
    shown = tuple(designs[: task.solutions])
    residual = max(error_of(design, 1.0) for design in shown) if met else 0.0
    counters = {"designs": len(designs)}
    rule = RULE if met else "fewest defects; then the least distance from the points"
    return Synthesis("motion", rule, shown, residual, tuple(_notes(asked, exact, met, shown)), counters)


def _designs(task: SynthesisTask, found: list[tuple[Bars, Rating]]) -> list[Design]:
    return [design for bars, rating in found if (design := designed(task, bars, rating, "motion generator"))]


def spread(points: Plane) -> float:
    """Largest distance of the points from their middle [m]."""
    return float(np.max(np.abs(points - points.mean()))) or 1.0


def error_of(design: Design, unit: float) -> float:
    """Largest error of a design: of angles in rad, of places in units."""
    found = design.precision
    assert found is not None
    angles = float(np.max(np.abs(found.angle_errors))) if len(found.angle_errors) else 0.0
    return max(float(found.found.max()) / unit, angles)


def _exact(task: SynthesisTask, slides: bool) -> list[tuple[Bars, Rating]]:
    asked: PoseTask = task.asked
    assert asked.angles is not None
    poses = Poses(asked.points, asked.angles - asked.angles[0])
    rng = np.random.default_rng(task.seed)
    z, c = _pins(poses, rng)
    good = _within(asked, c, z)
    z, c = z[good][:DYADS], c[good][:DYADS]
    turn = np.exp(1j * poses.angles)[None, :]
    if slides:
        lines = _line_pins(poses, rng)
        i, j = (rows.ravel() for rows in np.meshgrid(np.arange(len(z)), np.arange(len(lines)), indexing="ij"))
        bars, b, ends = pinned(poses.points, turn, z[i], c[i], lines[j], None)
    else:
        i, j = (rows.ravel() for rows in np.meshgrid(np.arange(len(z)), np.arange(len(z)), indexing="ij"))
        i, j = i[i != j], j[i != j]
        bars, b, ends = pinned(poses.points, turn, z[i], c[i], z[j], c[j])
    lengths = bars.lengths()
    sound = lengths.max(axis=0) <= asked.largest_ratio * np.maximum(lengths.min(axis=0), 1e-300)
    if not sound.any() and len(sound):
        sound[:] = lengths.min(axis=0) > 1e-9 * lengths.max(axis=0)
    return ranked(task, bars.rows(sound), b[sound], ends[sound]) if len(sound) else []


def _pins(poses: Poses, rng: np.random.Generator) -> tuple[Plane, Plane]:
    """Body points on circles, and the centres."""
    n, unit = len(poses.points), spread(poses.points)
    if n == 5:
        return circle_points(poses)
    if n == 4:
        z = curve_points(poses, REACH * unit, 48)
        z = z[rng.permutation(len(z))]
        return z, centres(poses, z)
    z = np.asarray(REACH / 2 * unit * (rng.normal(size=6 * DYADS) + 1j * rng.normal(size=6 * DYADS)))
    if n == 3:
        return z, centres(poses, z)
    places = poses.places(z)
    along = places[:, 1] - places[:, 0]
    return z, (places[:, 0] + places[:, 1]) / 2 + 1j * along * rng.normal(size=len(z))


def _line_pins(poses: Poses, rng: np.random.Generator) -> Plane:
    """Body points on lines."""
    if len(poses.points) > 2:
        return line_points(poses, DYADS)
    unit = spread(poses.points)
    return np.asarray(REACH / 2 * unit * (rng.normal(size=DYADS) + 1j * rng.normal(size=DYADS)))


def _within(asked: PoseTask, centre: Plane, z: Plane) -> np.ndarray:
    """Which pivots stand where they may; without a region those not too far away."""
    if asked.region is not None:
        low, high = asked.region
        inside = (centre.real >= low.real) & (centre.real <= high.real)
        return np.asarray(inside & (centre.imag >= low.imag) & (centre.imag <= high.imag))
    if len(asked.points) >= 5:
        return np.ones(len(z), bool)
    far = 2 * REACH * spread(asked.points)
    return np.asarray(np.abs(centre - asked.points.mean()) < far) & (np.abs(z) < far)


def _notes(asked: PoseTask, exact: bool, met: bool, designs: tuple[Design, ...]) -> Iterator[str]:
    count = len(asked.points)
    if met:
        yield f"note: {count} poses are met exactly"
    elif exact:
        yield f"warning: no linkage meets the {count} poses exactly: they are met in the least squares"
    else:
        yield f"note: {count} poses are more than can be met exactly: they are met in the least squares"
    if designs[0].defects:
        yield f"warning: the best design has a defect: {'; '.join(designs[0].defects)}"
