"""The shapes of moving links in their own axes: plates and bars through the joints, slots, slider blocks.

A link with three or more joints off one line is a plate; else a bar. The line of a guide reaches as far as its
slider goes. A named point off all that is drawn to by a bar of its own.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.linkage.model import Joint, Link, Mechanism
from tmmcalc.linkage.pictures.cycle import LinkageMotion
from tmmcalc.linkage.pins import Pin

Segment = tuple[complex, complex]


@record
class SliderOutline:
    """A slider: its centre and direction in the axes of its link, and its joint."""

    joint: Joint
    centre: complex
    direction: complex


@record
class LinkOutline:
    """What is drawn of a moving link, in its own axes [m]."""

    link: int
    plate: tuple[complex, ...]  # corners, counter-clockwise; empty for a bar
    bars: tuple[Segment, ...]
    slots: tuple[Segment, ...]  # lines that sliders of other links run on: drawn beneath the blocks
    blocks: tuple[SliderOutline, ...]

    @property
    def segments(self) -> tuple[Segment, ...]:
        """All lines of the link, edges of its plate included."""
        edges = tuple(zip(self.plate, (*self.plate[1:], *self.plate[:1]), strict=True))
        return (*edges, *self.bars, *self.slots)

    @property
    def corners(self) -> tuple[complex, ...]:
        """Ends of all lines, and the centres of the blocks."""
        return (*(p for segment in self.segments for p in segment), *(b.centre for b in self.blocks))


def bodies(mechanism: Mechanism, pins: tuple[Pin, ...], cycle: LinkageMotion, reach: float) -> tuple[LinkOutline, ...]:
    """The shapes of all moving links; slots go ``reach`` [m] beyond the sliders' ends."""
    return tuple(_body(mechanism, link, pins, cycle, reach) for link in mechanism.links)


def centre_of_block(joint: Joint, pins: tuple[Pin, ...]) -> complex:
    """Where a slider block is drawn, in the axes of its link: at the line's point, or at a pin on the line."""
    link, q, e = joint.links[0], joint.points[0], joint.directions[0]
    own = [pin.at[link] for pin in pins if link in pin.at and pin.joints]
    on_line = [p for p in own if abs(((p - q) / e).imag) <= 1e-9 * (1 + abs(p - q))]
    return q if q in own or not on_line else min(on_line, key=lambda p: abs(p - q))


def travel(joint: Joint, pins: tuple[Pin, ...], cycle: LinkageMotion) -> tuple[float, float]:
    """How far the centre of the block goes along the guide, from the guide's point [m]."""
    shift = ((centre_of_block(joint, pins) - joint.points[0]) / joint.directions[0]).real
    s = cycle.slide(joint.name) + shift
    return float(s.min()), float(s.max())


def _body(mechanism: Mechanism, link: Link, pins: tuple[Pin, ...], cycle: LinkageMotion, reach: float) -> LinkOutline:
    own = [pin for pin in pins if link.id in pin.at]
    sliding = [j for j in mechanism.joints if j.kind == "prismatic" and link.id in j.links]
    blocks = tuple(
        SliderOutline(j, centre_of_block(j, pins), j.directions[0]) for j in sliding if j.links[0] == link.id
    )
    vertices = [pin.at[link.id] for pin in own if pin.joints]
    vertices += [b.centre for b in blocks if b.centre not in vertices]
    named = [pin.at[link.id] for pin in own if not pin.centre]
    slots = tuple(_slot(j, named, *travel(j, pins, cycle), reach) for j in sliding if j.links[1] == link.id)
    plate, bars = _solid(vertices)
    body = LinkOutline(link.id, plate, bars, slots, blocks)
    return _beneath(_tied(body, vertices, named))


def _slot(joint: Joint, named: list[complex], low: float, high: float, reach: float) -> Segment:
    """The line of a guide: the slider's travel, lengthened to the named points on the line."""
    q, e = joint.points[1], joint.directions[1]
    turned = [(p - q) / e for p in named]
    on_line = [z.real for z in turned if abs(z.imag) <= 1e-9 * (1 + abs(z))]
    return q + min([low - reach, *on_line]) * e, q + max([high + reach, *on_line]) * e


def _solid(vertices: list[complex]) -> tuple[tuple[complex, ...], tuple[Segment, ...]]:
    """A plate for points off one line, a bar for points on one, nothing for a single point."""
    points = sorted(set(vertices), key=lambda z: (z.real, z.imag))
    if len(points) < 2:
        return (), ()
    first = points[0]
    last = max(points, key=lambda z: abs(z - first))
    if all(_distance(p, (first, last))[0] <= 1e-9 * abs(last - first) for p in points):
        return (), ((first, last),)
    return _hull(points), ()


def _hull(points: list[complex]) -> tuple[complex, ...]:
    """Convex hull of points sorted by x, then y, counter-clockwise (monotone chain)."""

    def half(ordered: list[complex]) -> list[complex]:
        chain: list[complex] = []
        for p in ordered:
            while len(chain) > 1 and ((chain[-1] - chain[-2]).conjugate() * (p - chain[-1])).imag <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return (*half(points), *half(points[::-1]))


def _tied(body: LinkOutline, vertices: list[complex], named: list[complex]) -> LinkOutline:
    """Join slots and loose points to the rest of the link by bars."""
    bars = list(body.bars)
    solid = [*LinkOutline(body.link, body.plate, body.bars, (), ()).segments, *((v, v) for v in vertices)]
    for slot in body.slots:
        if solid and not any(_touch(slot, segment) for segment in solid):
            vertex = min(vertices, key=lambda v: _distance(v, slot)[0])
            bars.append((vertex, _distance(vertex, slot)[1]))
        solid.append(slot)
    for p in named:
        distance, foot = min((_distance(p, segment) for segment in solid), default=(0.0, p), key=lambda d: d[0])
        if distance > 1e-9 and not _inside(p, body.plate):
            bars.append((foot, p))
        if not solid:
            solid.append((p, p))
    return LinkOutline(body.link, body.plate, tuple(bars), body.slots, body.blocks)


def _beneath(body: LinkOutline) -> LinkOutline:
    """A bar that lies along a slot of its link belongs to it, and runs beneath the blocks too."""
    along = tuple(b for b in body.bars if any(_parallel(b, s) for s in body.slots))
    bars = tuple(b for b in body.bars if b not in along)
    return LinkOutline(body.link, body.plate, bars, body.slots + along, body.blocks)


def _parallel(bar: Segment, slot: Segment) -> bool:
    """Whether a bar lies on the line of a slot."""
    along = slot[1] - slot[0]
    return along != 0 and all(abs(((p - slot[0]) * along.conjugate()).imag) <= 1e-9 * abs(along) for p in bar)


def _distance(p: complex, segment: Segment) -> tuple[float, complex]:
    """Distance of a point from a segment, and the nearest point of it."""
    a, b = segment
    if a == b:
        return abs(p - a), a
    t = float(np.clip(((p - a) / (b - a)).real, 0.0, 1.0))
    foot = a + t * (b - a)
    return abs(p - foot), foot


def _touch(one: Segment, other: Segment) -> bool:
    ends = [_distance(p, other)[0] for p in one] + [_distance(p, one)[0] for p in other]
    if min(ends) <= 1e-9:
        return True
    return _side(one, other) and _side(other, one)


def _side(line: Segment, other: Segment) -> bool:
    """Whether the ends of the other segment lie on both sides of the line."""
    a, b = line
    first, second = (((b - a).conjugate() * (p - a)).imag for p in other)
    return first * second < 0


def _inside(p: complex, plate: tuple[complex, ...]) -> bool:
    if not plate:
        return False
    corners = np.array(plate)
    edges = np.roll(corners, -1) - corners
    return bool(np.all((edges.conjugate() * (p - corners)).imag >= 0))
