"""Checks of ``[cam]``: phases that fill a turn, keys and units that the kind of follower has, how it is closed."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from tmmcalc.cams.tables.checks.written_cam import A_FOLLOWER, WrittenCam, place, written_cam
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.phrases import show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.values import bare_number, check_bare_speed

TURN = 2 * math.pi
_MOVING = ("rise", "return_angle")
SHORTEST = math.radians(1e-3)  # of a phase that moves: a shorter one is no part of a turn in panels
_PHASES = ("rise", "high_dwell", "return_angle")
_LONGEST_BARE = 2.0  # m: a larger bare stroke is in mm
_ROLLER = ("translating", "oscillating")
_STEM = ("translating", "flat")
_ROCKER = ("oscillating",)


class _Use(NamedTuple):
    """Which kinds of follower have a key, what the others lack, and what to write instead."""

    kinds: tuple[str, ...]
    lack: str
    remedy: str = "remove it"


_NO_ROLLER = _Use(_ROLLER, "there is no roller")
_NO_ROCKER = _Use(_ROCKER, "there is no rocker")
_NO_PRESSURE = _Use(_ROLLER, "under a flat face the pressure angle is 0 everywhere")
_NO_HOLLOW = _Use(_ROLLER, "under a flat face all is convex")
_NO_WIRE = _Use(_STEM, "a rocker's spring turns, the rules are those of a coil spring that is pressed")
_USES: dict[tuple[str, str], _Use] = {
    ("", "start_distance"): _Use(_STEM, "a rocker begins at an angle", 'write start_angle = "30 deg"'),
    ("", "start_angle"): _Use(_ROCKER, "a stem begins at a distance", 'write start_distance = "50 mm"'),
    ("", "offset"): _Use(("translating",), "only a roller on a stem has one"),
    ("", "roller_radius"): _NO_ROLLER,
    ("", "centre_distance"): _NO_ROCKER,
    ("", "rocker_length"): _NO_ROCKER,
    ("", "rocker_turn"): _NO_ROCKER,
    ("", "face_margin"): _Use(("flat",), "there is no flat face"),
    ("", "guide"): _Use(_STEM, "a rocker has no guide"),
    ("optimum", "heights"): _Use(_STEM, "a rocker has no guide", "write centre_distances, of l0"),
    ("optimum", "height_step"): _Use(_STEM, "a rocker has no guide", "write step, of all its lengths"),
    ("optimum", "centre_distances"): _Use(_ROCKER, "there is no rocker", "write heights, of H2"),
    ("optimum", "rocker_lengths"): _NO_ROCKER,
    ("limits", "pressure_angle"): _NO_PRESSURE,
    ("limits", "pressure_angle_return"): _NO_PRESSURE,
    ("limits", "concave_radius"): _NO_HOLLOW,
    ("limits", "allow_concave"): _NO_HOLLOW,
    ("loads", "mass"): _Use(_STEM, "a rocker has a moment of inertia", 'write inertia = "1e-4 kg*m^2"'),
    ("loads", "inertia"): _Use(_ROCKER, "a stem has a mass", 'write mass = "0.2 kg"'),
    ("loads", "gravity"): _Use(_STEM, "the weight of a rocker is a moment", "add it to force and force_return"),
    ("loads", "friction"): _Use(_STEM, "a rocker has no guide", "write pivot_friction and pivot_radius"),
    ("loads", "pivot_friction"): _Use(_ROCKER, "a stem has no pivot", "write friction, of the guide"),
    ("loads", "pivot_radius"): _Use(_ROCKER, "a stem has no pivot"),
    ("spring", "wire"): _NO_WIRE,
    ("spring", "coil"): _NO_WIRE,
    ("spring", "shear_modulus"): _NO_WIRE,
    ("spring", "shear_stress"): _NO_WIRE,
    ("spring", "dead_coils"): _NO_WIRE,
    **{
        ("requirements", key): _NO_ROLLER
        for key in (
            "rolling_arm",
            "roller_friction",
            "pin_friction",
            "pin",
            "pin_pressure",
            "pin_ratio",
            "roller_ratio",
            "roller_density",
            "roller_inertia",
        )
    },
    ("requirements", "guide_pressure"): _Use(_STEM, "a rocker has no guide"),
}

# Quantities that are linear on a stem, of rotation on a rocker.
_UNITS = {
    ("", "stroke"): ("length", "angle"),
    ("loads", "force"): ("force", "moment"),
    ("loads", "force_return"): ("force", "moment"),
    ("spring", "stiffness"): ("stiffness", "torsional stiffness"),
    ("spring", "preload"): ("force", "moment"),
    ("spring", "deflection"): ("length", "angle"),
    ("spring", "least_contact"): ("force", "moment"),
    ("elastic", "stiffness"): ("stiffness", "torsional stiffness"),
    ("elastic", "mass"): ("mass", "inertia"),
}


def check_phases(outline: Outline) -> Iterator[Finding]:
    """Rise, high dwell and return fit into a turn."""
    cam = written_cam(outline)
    angles = [0.0 if phase not in cam.table else cam.amount(phase, "angle") for phase in _PHASES]
    for phase, angle in zip(_PHASES, angles, strict=True):
        if phase in _MOVING and angle is not None and 0 < angle < SHORTEST:
            rule = f"{show(cam.table[phase])} is no phase of a cam; one that moves takes {math.degrees(SHORTEST):g} deg"
            yield Finding(place("", phase), f"{rule} or more", 'write "120 deg", for example')
    known = [angle for angle in angles if angle is not None]
    if len(known) == len(_PHASES) and min(known) >= 0 and sum(known) > TURN * (1 + 1e-12):
        last = next(phase for phase in reversed(_PHASES) if phase in cam.table)
        rule = f"rise, high dwell and return together take {math.degrees(sum(known)):.10g} deg, more than a turn"
        yield Finding(place("", last), rule, "write angles that add up to 360 deg or less; the rest is the low dwell")


def check_rows(outline: Outline) -> Iterator[Finding]:
    """Rows of the tables are counted once; a speed in rpm says so."""
    cam = written_cam(outline)
    if "steps" in cam.table and "step" in cam.table:
        rule = "steps and step together: rows are equal steps of the moving phases, or of the turn"
        yield Finding(place("", "steps"), rule, "keep one of them")
    yield from check_bare_speed(cam.table.get("speed"), place("", "speed"))


def check_keys(outline: Outline) -> Iterator[Finding]:
    """Every key is one that the kind of follower has."""
    cam = written_cam(outline)
    for (part, key), use in _USES.items():
        if cam.kind and cam.kind not in use.kinds and key in cam.part(part):
            yield Finding(place(part, key), f"{key} of {A_FOLLOWER[cam.kind]}: {use.lack}", use.remedy)


def check_units(outline: Outline) -> Iterator[Finding]:
    """Quantities are linear on a stem, of rotation on a rocker."""
    cam = written_cam(outline)
    if not cam.kind:
        return
    for (part, key), dimensions in _UNITS.items():
        value = cam.part(part).get(key)
        needed = dimensions[cam.kind == "oscillating"]
        found = dimension_of(value)
        if found in dimensions and found != needed:
            noun = DIMENSIONS[needed].noun
            rule = f"{show(value)} is {DIMENSIONS[found].noun}; {key} of {A_FOLLOWER[cam.kind]} is {noun}"
            yield Finding(place(part, key), rule, f'write {noun}, such as "{DIMENSIONS[needed].example}"')
    yield from _check_bare_stroke(cam)


def _check_bare_stroke(cam: WrittenCam) -> Iterator[Finding]:
    """A stroke in mm or in degrees says so, and a rocker swings less than half a turn."""
    bare, written = bare_number(cam.table.get("stroke")), cam.table.get("stroke")
    if cam.kind != "oscillating":
        if bare is not None and bare >= _LONGEST_BARE:
            rule = f"{show(written)} without a unit is in m"
            yield Finding(place("", "stroke"), rule, f'write "{bare:g} mm" or "{bare:g} m"')
        return
    swing = cam.amount("stroke", "angle") if bare is None else bare
    if swing is None or swing < math.pi:
        return
    if bare is not None:
        yield Finding(place("", "stroke"), f"{show(written)} without a unit is in radians", f'write "{bare:g} deg"')
    else:
        yield Finding(place("", "stroke"), f"{show(written)} is half a turn or more", "a rocker swings less")


def check_closure(outline: Outline) -> Iterator[Finding]:
    """A groove guides a roller on both sides, and needs no spring."""
    cam = written_cam(outline)
    if cam.closure != "groove":
        return
    if cam.kind == "flat":
        rule = 'closure = "groove" of a flat-faced follower: a groove guides a roller'
        yield Finding(place("", "closure"), rule, 'write closure = "force"')
    if cam.kind in _ROLLER and cam.amount("roller_radius") == 0:
        rule = "a knife edge in a groove: a groove is as wide as its roller"
        yield Finding(place("", "roller_radius"), rule, 'write roller_radius = "10 mm", or closure = "force"')
    if cam.has("spring"):
        rule = '[cam.spring] together with closure = "groove": the groove keeps the follower on the cam'
        yield Finding(place("spring"), rule, "remove it")


CHECKS = (check_phases, check_rows, check_keys, check_units, check_closure)
