"""Which point of a turning link is seen from which other one: the terms of the vector equations (textbook 2.7).

    v_B = v_A + v_BA        a_B = a_A + a_BA^n + a_BA^t        (2.31)-(2.33), from the attachment point of the group

Of the guide of a slider it is the point that coincides with the slider's pin.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tmmcalc.linkage.instant import turning_links
from tmmcalc.linkage.model import Joint, Mechanism
from tmmcalc.linkage.pins import Pin
from tmmcalc.linkage.structure import Group, Structure


class Turning(NamedTuple):
    """A link that turns: the point of it that is seen, and the one that it is seen from."""

    link: int
    base: Pin
    head: Pin
    joint: str = ""  # a prismatic joint: the point of its guide is meant that coincides with the slider's pin

    @property
    def name(self) -> str:
        """The point seen: ``B``, or of a guide 3 ``A3``, where the pin A of its slider is now."""
        return f"{self.head.name}{self.link}" if self.joint else self.head.name


def turnings(mechanism: Mechanism, structure: Structure, pins: Sequence[Pin]) -> tuple[Turning, ...]:
    """The turning links of every group in the order of assembly, each once; a crank comes last."""
    turning, found = turning_links(mechanism), list[Turning]()
    for group in structure.groups:
        found += _of_dyad(mechanism, group, turning, pins) if group.kind else _of_higher(group, turning, pins)
    return (*found, *_of_crank(mechanism, structure, pins))


def slider_pin(joint: Joint, pins: Sequence[Pin]) -> Pin:
    """The point of a slider that is compared with its guide: its pin, else a point of its line."""
    own = [pin for pin in pins if joint.links[0] in pin.at]
    pivots = [pin for pin in own if pin.joints]
    there = [pin for pin in own if pin.at[joint.links[0]] == joint.points[0]]
    candidates = [pin for pin in there if pin.joints] or pivots or there
    return candidates[0] if candidates else Pin(joint.name, {joint.links[0]: joint.points[0]}, ())


def _of_dyad(mechanism: Mechanism, group: Group, turning: set[int], pins: Sequence[Pin]) -> Iterator[Turning]:
    """From the attachment point of each link to the inner joint."""
    inner = mechanism.joint(group.inner[0])
    for link, outer in zip(group.links, map(mechanism.joint, group.outer), strict=True):
        if link not in turning or outer.kind != "revolute":
            continue
        base = _pin_of(outer, pins)
        if inner.kind == "revolute":
            yield Turning(link, base, _pin_of(inner, pins))
        elif link == inner.links[1]:
            yield Turning(link, base, slider_pin(inner, pins), inner.name)


def _of_higher(group: Group, turning: set[int], pins: Sequence[Pin]) -> Iterator[Turning]:
    """From the attachment point of each link, or its first pin, to its next pin."""
    outer = set(group.outer)
    for link in group.links:
        own = [pin for pin in pins if link in pin.at and pin.joints]
        own.sort(key=lambda pin: not outer & set(pin.joints))
        if link in turning and len(own) > 1:
            yield Turning(link, own[0], own[1])


def _of_crank(mechanism: Mechanism, structure: Structure, pins: Sequence[Pin]) -> Iterator[Turning]:
    """From the pivot of a crank to its pin."""
    drive = mechanism.joint(mechanism.input.joint)
    if drive.kind != "revolute":
        return
    link, pivot = structure.input_link, _pin_of(drive, pins)
    own = [pin for pin in pins if link in pin.at and pin is not pivot and pin.joints]
    if own:
        yield Turning(link, pivot, own[0])


def _pin_of(joint: Joint, pins: Sequence[Pin]) -> Pin:
    return next(pin for pin in pins if joint.name in pin.joints)
