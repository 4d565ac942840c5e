"""The splitting of a higher group into dyads: one link is taken out, one angle is tried (textbook method).

Without a binary link the rest of the group has one freedom. With the angle of one of its links given, the others are
dyads, solved one after another; the angle is right where the pins of the removed link stand at its length:

    C ---3--- B          link 4 = DE removed, the angle of link 2 tried:
    |         |          D from the triangle of link 2, the dyad 3, 5 between C and F gives E
    2         5          g = |DE| - l_4 = 0
    |         |
    D ---4--- E          (outer pins: A of link 2, F of link 5)

The signs of the dyads are no invariants of the assembly: a dyad may pass its dead point while the group is regular.
So all signs are tried at every position.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import NamedTuple

from tmmcalc.core.errors import StructureError, UsageError
from tmmcalc.linkage.chain import Step, step_of
from tmmcalc.linkage.dyads.base import Element, element
from tmmcalc.linkage.model import FRAME, Input, Joint, Link, Mechanism
from tmmcalc.linkage.structure import Group, solve_structure


class Split(NamedTuple):
    """A group split into dyads."""

    removed: int  # binary link with two pins
    pins: tuple[complex, complex]  # of the removed link, in its own axes
    freed: tuple[Element, Element]  # the same pins on the links that it joined
    trial: int  # link whose angle is tried
    pivot: tuple[Element, Element]  # its outer pin on itself, and on the source chain
    variants: tuple[tuple[Step, ...], ...]  # the dyads with all combinations of their signs

    @property
    def length(self) -> float:
        """Distance [m] of the pins of the removed link."""
        return abs(self.pins[1] - self.pins[0])

    @property
    def dyads(self) -> tuple[Group, ...]:
        """The dyads, in order."""
        return tuple(step.group for step in self.variants[0])


def split_of(mechanism: Mechanism, group: Group) -> Split:
    """The first way to split a group; raises `UsageError` if there is none.

    Links with high numbers are removed first, angles of links with low numbers are tried first.
    """
    joints = [mechanism.joint(name) for name in (*group.inner, *group.outer)]
    for removed in reversed(group.links) if not group.drive else ():
        pins = [joint for joint in joints if removed in joint.links]
        rest = [joint for joint in joints if removed not in joint.links]
        if len(pins) != 2 or any(joint.kind == "prismatic" for joint in pins):
            continue
        for pivot in rest:
            trial = next((k for k in pivot.links if k in group.links), FRAME)
            if pivot.name in group.outer and pivot.kind == "revolute":
                dyads = _dyads(group, rest, pivot, removed)
                if dyads:
                    return _split(mechanism, (removed, trial), pins, pivot, dyads)
    raise UsageError(
        "the group cannot be split into dyads by removing one binary link with two pins and trying one angle",
        where=f"--method splitting, group {group.name}",
        remedy="leave --method out: the equations of all its loops are solved at once",
    )


def _dyads(group: Group, joints: list[Joint], pivot: Joint, removed: int) -> tuple[Group, ...]:
    """The groups behind a trial link, the source chain taken as one frame; empty if one of them is no dyad."""
    ends = {k: k if k in group.links else FRAME for joint in joints for k in joint.links}
    held = [replace(joint, links=(ends[joint.links[0]], ends[joint.links[1]])) for joint in joints]
    links = tuple(Link(k) for k in group.links if k != removed)
    try:
        found = solve_structure(Mechanism(Link(FRAME), links, tuple(held), Input(pivot.name, 1.0))).groups
    except StructureError:
        return ()
    return found if all(one.kind for one in found) else ()


def _split(
    mechanism: Mechanism, links: tuple[int, int], pins: list[Joint], pivot: Joint, dyads: tuple[Group, ...]
) -> Split:
    removed, trial = links
    own = [element(joint, removed).point for joint in pins]
    freed = [element(joint, joint.other(removed)) for joint in pins]
    signs = product((1, -1), repeat=len(dyads))
    variants = tuple(tuple(step_of(mechanism, group, k) for group, k in zip(dyads, row, strict=True)) for row in signs)
    outer = element(pivot, trial), element(pivot, pivot.other(trial))
    return Split(removed, (own[0], own[1]), (freed[0], freed[1]), trial, outer, variants)
