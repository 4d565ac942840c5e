"""The document of a dyad with given outer joints: links, sliding coordinates, points, transmission, assemblies."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from tmmcalc.core.quantity import keyed, table
from tmmcalc.linkage.dyadstate import DyadAssembly, DyadState, PointState
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.numbers import angle, number


def summary(result: DyadState, title: str) -> Document:
    """The motion in facts; of a kind with two assemblies both in a table."""
    return Document(title, tuple(_facts(result)), result.notes, _view(result) if result.assemblies else None)


def _facts(result: DyadState) -> Iterator[Fact]:
    variant = "" if result.variant is None else f", variant {result.variant:+d}"
    yield Fact("dyad", f"{result.kind}{variant}", keyed(result, "kind", "variant"))
    for link in result.links:
        turning = f"omega = {number(link.omega)} rad/s, eps = {number(link.eps)} rad/s^2"
        text = f"angle {angle(degrees(link.angle))} deg\n{turning}"
        yield Fact(f"link {link.link}", text, keyed(link, "angle[deg]", "omega", "eps", link=link.link))
    for slide in result.slides:
        text = f"s = {number(1e3 * slide.s)} mm\nv = {number(slide.v)} m/s, a = {number(slide.a)} m/s^2"
        yield Fact(f"{slide.joint} joint", text, keyed(slide, joint=slide.joint))
    for point in result.points:
        yield Fact("inner pin" if point.point == "inner" else f"point {point.point}", _moved(point), _keys(point))
    text = f"{angle(degrees(result.transmission))} deg; regularity {number(result.regularity, 6)}"
    yield Fact("transmission angle", text, keyed(result, "transmission[deg]", "pressure[deg]", "regularity"))


def _keys(point: PointState) -> dict[str, float]:
    return keyed(point, point=point.point)


def _moved(point: PointState) -> str:
    """Place, velocity and acceleration; what is noise against the other component is zero."""
    pairs = ((1e3 * point.x, 1e3 * point.y), (point.vx, point.vy), (point.ax, point.ay))
    place, velocity, acceleration = (
        ", ".join(number(part, peak=max(abs(x), abs(y))) for part in (x, y)) for x, y in pairs
    )
    return f"({place}) mm\nv = ({velocity}) m/s\na = ({acceleration}) m/s^2"


def _view(result: DyadState) -> View:
    """One row an assembly."""
    pinned = ("x", "y") if result.kind[1] == "R" else ()
    shown = table(result.assemblies, DyadAssembly, "variant", "taken", "angle_a[deg]", "angle_b[deg]", *pinned)
    variant, taken, *places = shown.values()
    return View(list(shown), [[f"{each:+d}" for each in variant], ["*" if each else "" for each in taken], *places])
