"""The profiles of all wheels of a project: points, roll angles and radii of curvature, in metres."""

from __future__ import annotations

from math import cos, sin, tan

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.extended import EPS
from tmmcalc.core.quantity import quantities
from tmmcalc.gears.meshing.halftooth import Half, ProfilePart, half_tooth
from tmmcalc.gears.meshing.members import Toothed, members
from tmmcalc.gears.meshing.profiles import Profiles, WheelProfile
from tmmcalc.gears.meshing.results import Pairs

FEWEST = 3  # points of a curve
SHARE = 5  # arcs and straight lines have so many times fewer


def solve_profiles(found: Pairs, points: int = 50) -> Profiles:
    """Half a tooth of every wheel, ``points`` on its fillet and as many on its involute.

    A wheel that cannot have a profile is told in the remarks. Raises `UsageError` for fewer than 3 points.
    """
    _check_points(points)
    wheels: list[WheelProfile] = []
    remarks: list[str] = []
    for member in members(found):
        profile, told = profile_of(member, points)
        wheels += [profile] if profile is not None else []
        remarks += told
    return Profiles(tuple(wheels), tuple(remarks))


def _check_points(points: int) -> None:
    if points < FEWEST:
        raise UsageError(
            f"{points} points are too few for a curve",
            where="profile",
            value=points,
            limit=FEWEST,
            remedy=f"at least {FEWEST}",
        )


def profile_of(member: Toothed, points: int) -> tuple[WheelProfile | None, tuple[str, ...]]:
    """Half a tooth of one wheel, None if it cannot have a profile; and what is to be said about it."""
    _check_points(points)
    try:
        half = half_tooth(member)
    except NoSolutionError as error:
        return None, (
            Phrase(
                "wheel {label} has no profile: {message}; {remedy}",
                label=member.label,
                message=error.message,
                remedy=error.remedy,
            ),
        )
    remarks = (Phrase("wheel {label} is {remark}", label=member.label, remark=half.remark),) if half.remark else ()
    return _profile(member, half, points), remarks


def _profile(member: Toothed, half: Half, points: int) -> WheelProfile:
    m = member.module
    each = [_sampled(part, points) for part in half.parts]
    places = np.concatenate([part.curve.point(at) for part, at in zip(half.parts, each, strict=True)])
    roll = np.concatenate([part.roll(at) for part, at in zip(half.parts, each, strict=True)])
    return WheelProfile(
        pair=member.pair,
        wheel=member.name,
        kind=member.shape,
        teeth=0 if member.shape == "rack" else member.wheel.teeth,
        shift=0.0 if member.shape == "rack" else member.shift,
        module=m,
        tip=m * half.tip,
        root=m * half.root,
        base=m * half.base,
        form=m * half.form,
        undercut=half.undercut,
        part=np.repeat([part.name for part in half.parts], [len(at) for at in each]),
        roll=roll,
        x=m * places.real,
        y=m * places.imag,
        radius=m * np.concatenate([part.radius(at) for part, at in zip(half.parts, each, strict=True)]),
        half_angle=_half_angle(member),
        centre=_centre(member),
        rolls=half.rolls,
        fillet_least_radius=m * half.least_radius,
        join=m * half.join,
        error=_error(member, half, roll, places),
    )


def _error(member: Toothed, half: Half, roll: np.ndarray, places: np.ndarray) -> float:
    """What roundings leave: of the radius, of the angles that turn it (psi, alpha_t, phi), and where curves join."""
    radius = np.abs(places)
    turned = 0.0 if member.shape == "rack" else abs(_half_angle(member)) + tan(member.wheel.transverse_angle)
    return float((np.max(EPS * radius * (1 + turned + np.abs(roll))) + half.join) / np.max(radius))


def _half_angle(member: Toothed) -> float:
    """psi [rad]; of a ring what its space leaves."""
    if member.shape == "rack":
        return 0.0
    half = float(member.wheel.half_angle)
    return member.half_pitch - half if member.shape == "ring" else half


def _centre(member: Toothed) -> tuple[float, float]:
    """x_1S, y_1S [m] from the point of the straight flank on the rolling line (4.85)."""
    if member.shape != "external":
        return 0.0, 0.0
    wheel, cut = member.wheel, member.wheel.section
    height = float(wheel.shift) - wheel.rack.straight
    across = height * tan(cut.angle) - cut.radius * cos(cut.angle)
    return member.module * across, member.module * (height + cut.radius * sin(cut.angle))


def _sampled(part: ProfilePart, points: int) -> np.ndarray:
    """Parameters in equal steps: of the normal's direction on a fillet, of the roll angle on an involute."""
    count = points if part.kind == "curve" else max(points // SHARE, 2)
    return np.linspace(part.curve.start, part.curve.end, count)


def profile_columns(found: Profiles) -> dict[str, np.ndarray]:
    """The points of all wheels, one wheel after the other: the table profile.csv."""
    counts = np.array([len(wheel.x) for wheel in found.wheels], int)
    told = quantities(WheelProfile)
    columns = {
        "pair": np.repeat([wheel.pair for wheel in found.wheels], counts),
        "wheel": np.repeat([wheel.wheel for wheel in found.wheels], counts),
    }
    for name in ("part", "roll", "x", "y", "radius"):
        parts = [getattr(wheel, name) for wheel in found.wheels]
        columns[told[name].key] = np.concatenate(parts) if parts else np.zeros(0)
    named = any(wheel.pair for wheel in found.wheels)
    return columns if named else {header: column for header, column in columns.items() if header != "pair"}
