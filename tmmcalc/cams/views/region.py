"""Where the axis of a cam with a roller may stand, as a page moves it: the pressure angle seen from there.

The velocity of the follower by the angle of the cam, turned by 90 degrees, is laid off from the centre C of the roller,
to K: S' across the stem, l2 psi' along the rocker. The line from the axis to K leans from the direction in which the
follower goes by the pressure angle; an axis in the region keeps it within its limits all over the turn.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.pictures.rockers import Placed
from tmmcalc.cams.pictures.zone import swept_of
from tmmcalc.cams.synthesis.results import Synthesis
from tmmcalc.cams.synthesis.translatingsizes import lines_of, region_of
from tmmcalc.cams.views.motion import CamInMotion
from tmmcalc.core.plane import Plane
from tmmcalc.report.moving import BLUE, FRAME, GREEN, Angle, Body, Driver, Layer, Mark, Spot, View

FAR = 5.0  # of S0: how deep the region is drawn
BELOW = 0.5  # of the base circle: what is shown under its centre
AROUND = 0.12  # of its size: what is shown around all


def region_of_axis(made: CamInMotion, result: Synthesis) -> Iterator[View]:
    """The region with the construction of the pressure angle over the turn; that of a flat face is another one."""
    if result.region is None or not len(result.region.x) or made.profile.flat:
        return
    laid = laid_off(made)
    content = np.concatenate((laid, made.seat, [-BELOW * made.follower.base * 1j, made.pivot]))
    box = boxed(content)
    ray = np.unwrap(np.angle(laid))
    theta = np.angle(laid / made.upward)
    start = np.unwrap(np.angle(made.upward))
    still = made.still(0.0)
    bodies = (
        Body("region", still, still, still, tuple(_static(made, result, laid))),
        Body("ray", still, still, made.traced(ray), (Mark("line", (0j, complex(2 * np.abs(laid).max()))),)),
        Body("end", made.traced(laid.real), made.traced(laid.imag), still, ()),
        *made.shown_alone(),
    )
    angle = Angle("theta", "end", made.traced(start), made.traced(start + theta), "cam_pressure.theta")
    yield shown_region(made, box)._replace(
        bodies=bodies,
        spots=(
            Spot("O", FRAME, 0j, "pin"),
            *((Spot("A", FRAME, made.pivot, "pin"),) if made.rocks else ()),
            Spot("C", "centre", 0j, "point"),
            Spot("K", "end", 0j, "point"),
        ),
        layers=(Layer("pressure", "Pressure angle", "deg", (), angles=(angle,)),),
        front=((Mark("pivot", (made.pivot, -1j)),) if made.rocks else ()),
    )


def boxed(content: Plane) -> tuple[complex, complex]:
    """Lower left and upper right corner of what is shown, with air around all."""
    low, high = complex(content.real.min(), content.imag.min()), complex(content.real.max(), content.imag.max())
    around = AROUND * max((high - low).real, (high - low).imag) * (1 + 1j)
    return low - around, high + around


def shown_region(made: CamInMotion, box: tuple[complex, complex]) -> View:
    """The view of a region over the turn of the cam, which moves it; without what is shown."""
    return View(
        name="cam_region",
        title="Admissible places of the cam's axis",
        symbol="φ",
        unit="deg",
        values=made.profile.positions.degrees,
        whole=True,
        column="phi[deg]",
        steps=(),
        box=box,
        bodies=(),
        frame=(),
        spots=(),
        driver=Driver("cam_profile", 1.0, 0.0),
    )


def laid_off(made: CamInMotion) -> Complex:
    """The ends K (n,) of the turned velocities [m]."""
    follower = made.follower
    if not made.rocks:
        return np.asarray(made.seat + follower.sense * made.motion[1])
    arm = follower.rocker * (1 - follower.assembly * made.motion[1])
    return np.asarray(made.pivot + arm * np.exp(1j * made.arm))


def _static(made: CamInMotion, result: Synthesis, laid: Complex) -> Iterator[Mark]:
    """The region, the curve of the ends, the base circle of the cam that is taken."""
    for kind, points in _areas(made, result):
        yield Mark(
            "gear" if kind == "region" else "hole", tuple(points.tolist()), tone=GREEN if kind == "region" else 0
        )
    yield Mark("pitch", (0j,), made.follower.base)
    yield Mark("line", (*laid.tolist(), complex(laid[0])), tone=BLUE)


def _areas(made: CamInMotion, result: Synthesis) -> Iterator[tuple[str, Plane]]:
    """The region; with a rocker what of it lies so that the cam would sweep over the pivot."""
    follower = made.follower
    if not made.rocks:
        region = region_of(lines_of(made.task), (0.0, FAR * follower.start))
        yield "region", follower.sense * (follower.offset - region.x) + 1j * (follower.start - region.y)
        return
    assert result.region is not None
    placed = Placed(result)
    yield "region", placed.at((result.region.x + 1j * result.region.y) / follower.rocker)
    swept = swept_of(made.task, result)
    if swept is not None:
        yield "swept", placed.at(swept[1])
