"""What rounding leaves of the flanks, the limits of the roller, the handover and the efficiency of a drive."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

import numpy as np

from tmmcalc.cams.indexing.efficiency import against_terms, aiding_terms, cut
from tmmcalc.cams.indexing.flanks import Drive, Flank, FlankName
from tmmcalc.cams.indexing.results import Cam, FlankTable, PressureReached
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.rounding import APART, FLOOR, MARGIN, Errors, chosen, nearer, relative, root_error
from tmmcalc.cams.wide import wide

NEAR = 1e-12  # of the step: an angle between two pieces of the law


def indexing_errors(drive: Drive, k: Values, cam: Cam, roller: float, frictions: tuple[float, float]) -> Errors:
    """Estimates of points, curvature, angles, efficiency at the rows k (n,), and of limits and ends of the flanks."""
    exact = wide(drive)
    a, b = (_table(Flank(exact, _name(each.name)), k, each, roller) for each in (cam.a, cam.b))
    errors = {name: max(a[name], b[name]) for name in a}
    errors["efficiency"] = _efficiency(exact, k, cam, frictions)
    errors["limits"] = max([_reached(exact, cam.run_up), _reached(exact, cam.run_out), *_convex(exact, cam)])
    return errors | {"ends": max(MARGIN * max(_ends(exact, cam, roller)), FLOOR)}


def _table(flank: Flank, k: Values, found: FlankTable, roller: float) -> Errors:
    which = chosen(len(k), found.curvature, found.pressure)
    at = wide(k[which])
    here, size = flank.frame(at), float(np.max(found.radius))
    pitch = flank.roller(at) * np.exp(-1j * flank.drive.step * at)
    working = flank.follower.placed(here.offset(wide(roller)))
    angle, straight = found.pressure[which], flank.pressure(at)
    straight = straight + pi * np.round((angle - straight) / pi)  # the angle of a line: at 90 deg either sign
    return {
        "points": max(relative(found.pitch[which], pitch, size), relative(found.working[which], working, size)),
        "curvature": relative(found.curvature[which], here.bend, float(np.max(np.abs(found.curvature)))),
        "pressure": relative(angle, straight, float(np.max(np.abs(found.pressure)))),
    }


def _efficiency(drive: Drive, k: Values, cam: Cam, frictions: tuple[float, float]) -> float:
    """Absolute, of the flank that drives."""
    which = chosen(len(k), cam.efficiency.against)
    at, table = wide(k[which]), cam.efficiency
    worst = FLOOR
    for formula, found in ((against_terms, table.against), (aiding_terms, table.aiding)):
        for flank, own in ((Flank(drive, "A"), at <= cam.handover.part), (Flank(drive, "B"), at > cam.handover.part)):
            true, _ = cut(*formula(flank.pressure(at), flank.rise_angle(at), *frictions))
            worst = max(worst, relative(found[which][own], true[own], 1.0))
    return worst


def _both(drive: Drive, k: float) -> tuple[Values, Indices]:
    """The place before and after a break of the law."""
    at = wide(np.array([k, k]))
    return at, drive.law.piece(at + NEAR * np.array([-1.0, 1.0]))


def _reached(drive: Drive, found: PressureReached) -> float:
    at, _ = _both(drive, found.part)
    return nearer([found.largest], np.abs(Flank(drive, _name(found.flank)).pressure(at)))


def _convex(drive: Drive, cam: Cam) -> Iterator[float]:
    """Of the least convex radii of both flanks."""
    for name, limit in zip(("A", "B"), cam.roller_limits, strict=False):
        if limit.radius is not None and limit.part is not None:
            yield nearer([limit.radius], 1 / Flank(drive, _name(name)).curvature(*_both(drive, limit.part)))


def _ends(drive: Drive, cam: Cam, roller: float) -> Iterator[float]:
    """By how much k_m and k_w are off."""
    front, axis = Flank(drive, "A"), np.exp(0.5j * wide(drive.step))
    part = cam.handover.part
    yield root_error(lambda k: front.polar(k) - drive.step * (k - 0.5), part, _apart(part))
    if cam.working_part != part:
        yield root_error(lambda k: (front.points(k, roller) * axis).imag, cam.working_part, _apart(cam.working_part))


def _apart(part: float) -> float:
    """A distance for differences that stays within the step."""
    return min(APART, (1 - part) / 4) or APART


def _name(name: str) -> FlankName:
    return "A" if name == "A" else "B"
