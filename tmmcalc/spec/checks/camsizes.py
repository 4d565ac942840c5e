"""Checks of the sizes in ``[cam]``: what is given does not settle a size twice, and can be made."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.spec.findings import Finding

from .camwritten import WrittenCam, place, written_cam
from .outline import Outline
from .values import amount

_HALF_TURN = math.pi
_NEAR = 1e-9  # of a size: by so much a limit may be missed by rounding
_START = {"translating": "start_distance", "flat": "start_distance", "oscillating": "start_angle"}
_FOLLOWS = {
    "translating": "with the offset each follows from the other",
    "flat": "under a flat face they are the same",
    "oscillating": "with centre_distance and rocker_length each follows from the other",
}


def check_settled(outline: Outline) -> Iterator[Finding]:
    """The lowest position is given once, and a rocker has a length."""
    cam = written_cam(outline)
    start = _START.get(cam.kind, "")
    if start in cam.table and "base_radius" in cam.table:
        rule = f"base_radius together with {start}: {_FOLLOWS[cam.kind]}"
        yield Finding(place("", "base_radius"), rule, "remove one of them")
    if cam.kind == "oscillating" and not {"centre_distance", "rocker_length"} & {*cam.table}:
        rule = "missing key: angles alone give a rocker no size"
        yield Finding(("cam",), rule, 'add rocker_length = "100 mm", or centre_distance')


def check_stem(outline: Outline) -> Iterator[Finding]:
    """A base circle reaches beyond the offset."""
    cam = written_cam(outline)
    base, offset = cam.amount("base_radius"), cam.amount("offset")
    if cam.kind == "translating" and base is not None and offset is not None and 0 < base <= abs(offset):
        rule = f"the base circle of {_mm(base)} does not reach the stem, whose axis is {_mm(abs(offset))} off"
        yield Finding(place("", "offset"), rule, "write a smaller offset, or a larger base_radius")


def check_triangle(outline: Outline) -> Iterator[Finding]:
    """Cam axis, pivot and roller centre make a triangle, from the lowest position to the highest."""
    cam = written_cam(outline)
    if cam.kind != "oscillating":
        return
    base, centres, rocker = (cam.amount(key) for key in ("base_radius", "centre_distance", "rocker_length"))
    if base is not None and centres is not None and rocker is not None:
        least, largest = abs(centres - rocker), centres + rocker
        if not least < base < largest:
            lengths = f"centre_distance = {_mm(centres)} and rocker_length = {_mm(rocker)}"
            rule = f"base_radius = {_mm(base)} makes no triangle with {lengths}"
            limits = f"between {_mm(least)} and {_mm(largest)}"
            yield Finding(place("", "base_radius"), rule, f"write a base radius {limits}, or other lengths")
            return
    yield from _check_swing(cam)


def _check_swing(cam: WrittenCam) -> Iterator[Finding]:
    start, swing = _start_angle(cam), cam.amount("stroke", "angle")
    if start is None or swing is None or not 0 < swing < _HALF_TURN or start + swing < _HALF_TURN * (1 - _NEAR):
        return
    ends = f"{math.degrees(start):.6g} deg and swings {math.degrees(swing):.6g} deg"
    rule = f"the rocker begins at {ends}: it would pass the line of centres"
    key = "start_angle" if "start_angle" in cam.table else "base_radius"
    yield Finding(place("", key), rule, "write a smaller one, or a smaller stroke: together they stay below 180 deg")


def _start_angle(cam: WrittenCam) -> float | None:
    """psi0 as it is given, or from the triangle."""
    if "start_angle" in cam.table:
        return cam.amount("start_angle", "angle")
    base, centres, rocker = (cam.amount(key) for key in ("base_radius", "centre_distance", "rocker_length"))
    if not base or not centres or not rocker:
        return None
    cosine = (centres**2 + rocker**2 - base**2) / (2 * centres * rocker)
    return math.acos(cosine) if -1 < cosine < 1 else None


def check_roller(outline: Outline) -> Iterator[Finding]:
    """The roller leaves room for the cam's axis; the guide stands above the follower at its highest."""
    cam = written_cam(outline)
    base, roller = _base(cam), cam.amount("roller_radius")
    if cam.kind in ("translating", "oscillating") and base is not None and roller is not None and roller >= base:
        rule = f"a roller of {_mm(roller)} covers the cam's axis: the pitch curve's base circle has {_mm(base)}"
        yield Finding(place("", "roller_radius"), rule, "write a smaller roller, or a larger base circle")
    yield from _check_guide(cam)


def _base(cam: WrittenCam) -> float | None:
    """R0, as it is given or from start distance and offset, or from the triangle."""
    if "base_radius" in cam.table:
        return cam.amount("base_radius")
    if cam.kind == "translating":
        start, offset = cam.amount("start_distance"), amount(cam.table.get("offset", 0.0), "length")
        return None if start is None or offset is None else math.hypot(start, offset)
    start, centres, rocker = _start_angle(cam), cam.amount("centre_distance"), cam.amount("rocker_length")
    if start is None or centres is None or rocker is None:
        return None
    return abs(centres - rocker * complex(math.cos(start), math.sin(start)))


def _check_guide(cam: WrittenCam) -> Iterator[Finding]:
    """The upper edge of a guide stands above the roller (or the face) at its highest."""
    guide = cam.part("guide")
    top, stroke, roller = amount(guide.get("top"), "length"), cam.amount("stroke"), cam.amount("roller_radius")
    gap = amount(guide.get("gap", 0.0), "length")
    start = cam.amount("base_radius") if cam.kind == "flat" and "base_radius" in cam.table else None
    start = cam.amount("start_distance") if start is None else start
    if cam.kind not in ("translating", "flat") or top is None or gap is None or start is None or stroke is None:
        return
    highest = start + stroke + (roller or 0.0) + gap
    if top <= highest:
        rule = f"the follower at its highest reaches {_mm(highest)}, the guide's upper edge stands at {_mm(top)}"
        yield Finding(place("guide", "top"), rule, "write a higher one")


def _mm(length: float) -> str:
    return f"{length * 1e3:.6g} mm"


CHECKS = (check_settled, check_stem, check_triangle, check_roller)
