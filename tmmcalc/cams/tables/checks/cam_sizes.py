"""Checks of the sizes in ``[cam]``: what is given does not settle a size twice, and can be made."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.cams.tables.checks.written_cam import WrittenCam, place, written_cam
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.values import amount

_HALF_TURN = math.pi
_NEAR = 1e-9  # of a size: by so much a limit may be missed by rounding
_SIZES = ("start_angle", "base_radius", "centre_distance", "rocker_length")  # of a rocker: an angle, three lengths


def check_settled(outline: Outline) -> Iterator[Finding]:
    """The lowest position is given once, and a rocker has a length."""
    cam = written_cam(outline)
    both = {"start_distance", "base_radius"} <= {*cam.table}
    if cam.kind == "flat" and both:
        rule = "base_radius together with start_distance: under a flat face they are the same"
        yield Finding(place("", "base_radius"), rule, "remove one of them")
    if cam.kind == "translating" and both and "offset" in cam.table:
        rule = "base_radius together with start_distance and offset: two of the three give the third"
        yield Finding(place("", "base_radius"), rule, "remove one of them")
    if cam.kind == "oscillating" and {*_SIZES} <= {*cam.table}:
        rule = f"{' and '.join(_SIZES)} together: three of the four give the fourth"
        yield Finding(place("", "base_radius"), rule, "remove one of them")
    if cam.kind == "oscillating" and not {*_SIZES[1:]} & {*cam.table}:
        rule = "missing key: angles alone give a rocker no size"
        yield Finding(("cam",), rule, 'add rocker_length = "100 mm", or centre_distance')


def check_stem(outline: Outline) -> Iterator[Finding]:
    """A base circle reaches beyond the offset, and to the lowest roller centre."""
    cam = written_cam(outline)
    base, offset, start = cam.amount("base_radius"), cam.amount("offset"), cam.amount("start_distance")
    if cam.kind == "translating" and base is not None and start is not None and "offset" not in cam.table:
        if base < start * (1 - _NEAR):
            rule = f"a base circle of {_mm(base)} does not reach the roller centre {_mm(start)} above the cam's axis"
            yield Finding(place("", "base_radius"), rule, "write a larger one, or a smaller start_distance")
        return
    if cam.kind == "translating" and base is not None and offset is not None and 0 < base <= abs(offset):
        rule = f"the base circle of {_mm(base)} does not reach the stem, whose axis is {_mm(abs(offset))} off"
        yield Finding(place("", "offset"), rule, "write a smaller offset, or a larger base_radius")


def check_triangle(outline: Outline) -> Iterator[Finding]:
    """Cam axis, pivot and roller centre make a triangle, from the lowest position to the highest."""
    cam = written_cam(outline)
    if cam.kind != "oscillating":
        return
    base, centres, rocker = (cam.amount(key) for key in _SIZES[1:])
    if "start_angle" not in cam.table and base is not None and centres is not None and rocker is not None:
        least, largest = abs(centres - rocker), centres + rocker
        if not least * (1 + _NEAR) < base < largest * (1 - _NEAR):
            lengths = f"centre_distance = {_mm(centres)} and rocker_length = {_mm(rocker)}"
            rule = f"base_radius = {_mm(base)} makes no triangle with {lengths}"
            limits = f"between {_mm(least)} and {_mm(largest)}"
            yield Finding(place("", "base_radius"), rule, f"write a base radius {limits}, or other lengths")
            return
    yield from _check_height(cam)
    yield from _check_swing(cam)


def _check_height(cam: WrittenCam) -> Iterator[Finding]:
    """With its start angle one side of the triangle leaves a least base circle."""
    base, start = cam.amount("base_radius"), cam.amount("start_angle", "angle")
    sides = [side for key in _SIZES[2:] if (side := cam.amount(key)) is not None]
    if base is None or start is None or len(sides) != 1 or not 0 < start < _HALF_TURN:
        return
    height = sides[0] * math.sin(start) if start < _HALF_TURN / 2 else sides[0]
    if base < height * (1 - _NEAR) or (start >= _HALF_TURN / 2 and base <= height):
        rule = f"base_radius = {_mm(base)} makes no triangle with a start angle of {math.degrees(start):.6g} deg"
        yield Finding(place("", "base_radius"), rule, f"write more than {_mm(height)}")


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
    base, centres, rocker = (cam.amount(key) for key in _SIZES[1:])
    if not base or not centres or not rocker:
        return None
    cosine = (centres**2 + rocker**2 - base**2) / (2 * centres * rocker)
    return math.acos(cosine) if -1 < cosine < 1 else None


def check_roller(outline: Outline) -> Iterator[Finding]:
    """The roller leaves room for the cam's axis, a groove for the tool; the guide stands above the follower."""
    cam = written_cam(outline)
    base, roller = _base(cam), cam.amount("roller_radius")
    if cam.kind in ("translating", "oscillating") and base is not None and roller is not None and roller >= base:
        rule = f"a roller of {_mm(roller)} covers the cam's axis: the pitch curve's base circle has {_mm(base)}"
        yield Finding(place("", "roller_radius"), rule, "write a smaller roller, or a larger base circle")
    tool, groove = cam.amount("tool_radius"), cam.closure == "groove"
    if groove and cam.kind != "flat" and tool is not None and roller and tool > roller * (1 + _NEAR):
        rule = f"a tool of {_mm(tool)} does not fit into the groove of a roller of {_mm(roller)}"
        yield Finding(place("", "tool_radius"), rule, f"write {_mm(roller)} or less")
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
