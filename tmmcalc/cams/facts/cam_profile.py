"""The documents of the profile: sizes, curvature, the largest roller and tool, the table of coordinates."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, tau

import numpy as np

from tmmcalc.cams.facts.cam_pressure import extreme_values
from tmmcalc.cams.facts.pivot import pivot_fact
from tmmcalc.cams.facts.rows import with_further, with_rows
from tmmcalc.cams.profile.columns import BEND, profile_columns
from tmmcalc.cams.profile.results import WALLS, Profile, Reach, Wall
from tmmcalc.core.columns import Column
from tmmcalc.core.quantity import keyed, keys, quantity_of
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import angle
from tmmcalc.report.sizes import quantity

STRAIGHT = 1e-9  # of 1/R0: a curvature of a straight piece


def summary(result: Profile, title: str) -> Document:
    """Facts and warnings without the table."""
    warnings = tuple(remark for remark in result.remarks if remark.startswith("warning"))
    return Document(title, tuple(_facts(result)), warnings)


def document(
    result: Profile,
    title: str,
    *,
    patterns: Sequence[str] = (),
    rows: Sequence[int] | None = None,
    everything: bool = False,
    where: str = "",
    further: Sequence[Column] = (),
) -> Document:
    """All facts and the table, its columns chosen by ``patterns``, its rows by index; ``everything`` is all in SI.

    ``where`` is the file that has the whole table, ``further`` are columns that are printed by name alone.
    """
    columns = profile_columns(result)
    if not everything:
        columns = _with_radii(result, columns, named=bool(patterns))
    told, ends = Document(title, tuple(_facts(result)), result.remarks), [0.0, 360.0]
    chosen = with_further(columns, patterns, further)
    return with_rows(told, chosen, patterns, rows, ends=ends, everything=everything, example="phi,x_*", where=where)


def _with_radii(result: Profile, columns: dict[str, np.ndarray], named: bool) -> dict[str, np.ndarray]:
    """What people read: coordinates first, then radii of curvature in place of curvature."""
    kept = {header: column for header, column in columns.items() if named or not header.startswith(("n_", "kappa"))}
    for index, bend in (("c", result.pitch_curvature), ("w", result.curvature)):
        if bend is not None:
            straight = np.abs(bend) * result.follower.base < STRAIGHT
            radii = 1e3 / np.where(straight, 1.0, bend)
            cells = ["straight" if flat else radius for radius, flat in zip(radii.tolist(), straight, strict=True)]
            kept[BEND.of(curve=index).shown("mm")[0]] = np.array(cells, object) if straight.any() else radii
    first = ("i", "phi", "x_c", "y_c", "x_w", "y_w", "rho_c", "rho_w")
    names = {header: header.partition("[")[0] for header in kept}
    order = sorted(kept, key=lambda header: first.index(names[header]) if names[header] in first else len(first))
    return {header: kept[header] for header in order}


def _facts(result: Profile) -> Iterator[Fact]:
    follower = result.follower
    text = f"R0 = {quantity(follower.base, 'm')}"
    if not result.flat:
        text += f", roller r2 = {quantity(follower.roller, 'm')}" if follower.roller else ", knife edge"
    yield Fact("base circle", text, keyed(follower, "base", "roller"))
    yield from _bend_facts(result)
    if not result.flat:
        yield _reach_fact("largest roller", "roller", result.inner_reach)
        if result.outer is not None:
            yield _reach_fact("largest roller, second wall", "roller_outer", result.outer_reach)
    yield _tool_fact(result)
    near = result.nearest
    said = f"{quantity(near.value, 'm')} at phi = {angle(degrees(near.phi))} deg"
    yield Fact("nearest to the axis", said, extreme_values(result, "nearest"))
    if result.pivot is not None:
        yield pivot_fact(result.pivot)
    if result.face is not None:
        face = result.face
        said = f"{quantity(face.left, 'm')} to the left, {quantity(face.right, 'm')} to the right of its axis; "
        said += f"length {quantity(face.length, 'm')} with margins of {quantity(face.margin, 'm')}"
        yield Fact("flat face", said, keyed(face, "left", "right", "length"))
    for wall in result.walls:
        if not wall.sound:
            yield _fault_fact(wall)


def _bend_facts(result: Profile) -> Iterator[Fact]:
    if result.flat:
        yield _radius_fact("least radius", result, "flat_least")
        return
    yield _radius_fact("convex, rho2", result, "convex")
    if result.concave is not None:
        yield _radius_fact("concave, rho1", result, "concave")
    least = f"convex {quantity(result.least_convex, 'm')}"
    values = keyed(result, "least_convex")
    if result.least_concave is None:
        least += ", nowhere concave"
    else:
        least += f", concave {quantity(result.least_concave, 'm')}"
        values |= keyed(result, "least_concave")
    yield Fact("least radii of the working profile", least, values)


def _radius_fact(label: str, result: Profile, name: str) -> Fact:
    told, place = quantity_of(Profile, name), getattr(result, name)
    side = {-1: "just before ", 0: "at ", 1: "just after "}[place.side]
    text = f"{quantity(place.value, 'm')} {side}phi = {angle(degrees(place.phi))} deg"
    return Fact(label, text, extreme_values(result, name) | {f"{told.name}_side": place.side})


def _reach_fact(label: str, key: str, limit: Reach | None) -> Fact:
    if limit is None:
        return Fact(label, "any", dict.fromkeys(keys(Reach, "distance", part=key)))
    places = [degrees(phi) for phi in limit.at]
    where = " and ".join(f"{angle(phi)} deg" for phi in places)
    why = f"a point at phi = {where}" if limit.cause == "cusp" else f"a neck between phi = {where}"
    values = keyed(limit, "distance", "cause", "at[deg]", part=key)
    return Fact(label, f"below {quantity(limit.distance, 'm')}: {why}", values)


def _tool_fact(result: Profile) -> Fact:
    most = result.largest_tool
    text = "any, the profile is convex" if most is None else quantity(most, "m")
    if result.tool_radius is not None:
        text += f"; given {quantity(result.tool_radius, 'm')}"
    return Fact("largest tool", text, keyed(result, "largest_tool", "tool_radius"))


def _fault_fact(wall: Wall) -> Fact:
    lines = [f"runs backwards for phi from {_deg(a)} to {_deg(b)} deg" for a, b in wall.loops]
    lines += [f"crosses itself at phi = {_deg(each.first)} and {_deg(each.second)} deg" for each in wall.crossings]
    values = keyed(wall, "loops[deg]", "crossed[deg]", wall=wall.name)
    return Fact(WALLS[wall.name], "\n".join(lines) or "touches itself", values)


def _deg(phi: float) -> str:
    return angle(degrees(phi - tau if phi > tau else phi))
