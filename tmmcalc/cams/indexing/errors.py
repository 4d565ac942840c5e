"""What rounding leaves of the flanks, the limits of the roller, the handover and the efficiency of a drive."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

import numpy as np

from tmmcalc.cams.indexing.efficiency import against_terms, aiding_terms, cut
from tmmcalc.cams.indexing.flanks import Drive, Flank, FlankName
from tmmcalc.cams.indexing.results import Cam, FlankTable, PressureReached
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.profile.offsets import frame
from tmmcalc.cams.rounding import APART, FLOOR, MARGIN, Errors, chosen, crest, nearer, relative, root_error, slopes
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import EPS

SAMPLES = 33  # of a law, for its size
NEAR = 1e-12  # of the step: an angle between two pieces of the law


def indexing_errors(drive: Drive, k: Values, cam: Cam, roller: float, frictions: tuple[float, float]) -> Errors:
    """Estimates of points, curvature, angles, efficiency at the rows k (n,), and of limits and ends of the flanks."""
    exact = wide(drive)
    a, b = (_table(Flank(exact, _name(each.name)), k, each, roller) for each in (cam.a, cam.b))
    errors = {name: max(a[name], b[name]) for name in a}
    errors["efficiency"] = _efficiency(exact, k, cam, frictions)
    astray = list(_ends(exact, cam, roller))
    angles = [_reached(exact, each, cam.handover.part, astray[0]) for each in (cam.run_up, cam.run_out)]
    return errors | {"limits": max([*angles, *_convex(exact, cam)]), "ends": max(MARGIN * max(astray), FLOOR)}


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


def _reached(drive: Drive, found: PressureReached, end: float, astray: float) -> float:
    """Of an angle that stands at k_m as well by what that is astray."""
    flank, (at, _) = Flank(drive, _name(found.flank)), _both(drive, found.part)
    missed = nearer([found.largest], np.abs(flank.pressure(at)))
    if found.part != end:
        return missed
    _, slope, _ = slopes(flank.pressure, end, _apart(end))
    return missed + MARGIN * abs(slope) * astray / found.largest


def _convex(drive: Drive, cam: Cam) -> Iterator[float]:
    """Of the least convex radii of both flanks."""
    names: tuple[FlankName, FlankName] = ("A", "B")
    for name, limit in zip(names, cam.roller_limits, strict=False):
        if limit.radius is not None and limit.part is not None:
            flank, gap = Flank(drive, name), float(np.min(np.abs(drive.law.breaks - limit.part)))
            if gap < NEAR or limit.part == cam.handover.part:
                missed = nearer([limit.radius], 1 / flank.curvature(*_both(drive, limit.part)))
            else:
                missed = relative([limit.radius], [1 / crest(flank.curvature, limit.part, min(APART, gap / 4))[0]])
            yield missed + _of_law(flank, limit.part) * limit.radius


def _of_law(flank: Flank, part: float) -> float:
    """By how much a rounding of the law moves the curvature [1/m]: its coefficients are off, in wide as well."""
    here, sizes = flank.motion(np.array([part])), np.max(np.abs(flank.motion(np.linspace(0, 1, SAMPLES))), axis=1)
    moved = here + EPS * np.diag(sizes)[:, :3] * np.array(
        [0.0, 1.0, 1.0]
    )  # beta itself ends at beta_m whatever the law
    phi = np.full(3, flank.drive.step * part)
    return float(np.sum(np.abs(frame(flank.follower, phi, moved).bend - flank.curvature(np.array([part])))))


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
