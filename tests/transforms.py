"""Changes of a mechanism that leave its motion the same, or change it in a known way.

    moved          the whole mechanism turned and shifted in the plane
    scaled         every length times a factor (a change of the unit of length)
    renumbered     other link numbers and joint names, in another order
    with_axes      the axes of one link laid otherwise in it
    swapped        the two links of a joint exchanged: guide and slider of a prismatic one

Each returns a new mechanism. ``coordinate_after`` in the docstring tells what the input coordinate becomes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from tmmcalc.linkage.model import FRAME, Assembly, Grid, Joint, Link, Mechanism, Output

Place = Callable[[complex], complex]


def moved(mechanism: Mechanism, turn: float, shift: complex) -> Mechanism:
    """Turn the mechanism about the origin, then shift it.

    coordinate_after: plus ``turn`` for a revolute input, unchanged for a prismatic one.
    """

    def place(p: complex) -> complex:
        return complex(p * np.exp(1j * turn) + shift)

    outputs = tuple(replace(o, direction=o.direction + turn) if o.point else o for o in mechanism.outputs)
    assembly = replace(mechanism.assembly, sketch={name: place(p) for name, p in mechanism.assembly.sketch.items()})
    laid = _relaid(mechanism, FRAME, place, turn)
    return _with_coordinate(replace(laid, outputs=outputs, assembly=assembly), turn if _turns(mechanism) else 0)


def with_axes(mechanism: Mechanism, link: int, origin: complex, turn: float) -> Mechanism:
    """Lay new axes in a link: at ``origin`` of the old ones, turned by ``turn`` against them.

    coordinate_after: plus ``turn`` if the link is a revolute input; its angle grows by ``turn`` likewise.
    """

    def place(p: complex) -> complex:
        return complex((p - origin) * np.exp(-1j * turn))

    is_input = link in mechanism.joint(mechanism.input.joint).links and _turns(mechanism)
    return _with_coordinate(_relaid(mechanism, link, place, -turn), turn if is_input else 0.0)


def scaled(mechanism: Mechanism, factor: float) -> Mechanism:
    """Multiply every length; coordinate_after: times ``factor`` for a prismatic input."""
    links = (mechanism.frame, *mechanism.links)
    sized = [Link(k.id, {name: p * factor for name, p in k.points.items()}, k.name) for k in links]
    joints = tuple(
        replace(joint, points=(joint.points[0] * factor, joint.points[1] * factor)) for joint in mechanism.joints
    )
    sketch = {name: p * factor for name, p in mechanism.assembly.sketch.items()}
    result = replace(
        mechanism,
        frame=sized[0],
        links=tuple(sized[1:]),
        joints=joints,
        assembly=replace(mechanism.assembly, sketch=sketch),
    )
    return result if _turns(mechanism) else _with_unit(result, factor)


def renumbered(
    mechanism: Mechanism,
    links: Mapping[int, int],
    joints: Mapping[str, str] | None = None,
    rng: np.random.Generator | None = None,
) -> Mechanism:
    """Give links and joints other numbers and names, those not named keep theirs; ``rng`` shuffles both."""
    number = {FRAME: FRAME} | {link.id: links.get(link.id, link.id) for link in mechanism.links}
    name = {joint.name: (joints or {}).get(joint.name, joint.name) for joint in mechanism.joints}
    new_links = [replace(link, id=number[link.id]) for link in mechanism.links]
    new_joints = [
        replace(joint, name=name[joint.name], links=(number[joint.links[0]], number[joint.links[1]]))
        for joint in mechanism.joints
    ]
    if rng is not None:
        new_links = [new_links[k] for k in rng.permutation(len(new_links))]
        new_joints = [new_joints[k] for k in rng.permutation(len(new_joints))]
    variants = {(number[a], number[b]): sign for (a, b), sign in mechanism.assembly.variants.items()}
    return replace(
        mechanism,
        links=tuple(new_links),
        joints=tuple(new_joints),
        input=replace(mechanism.input, joint=name[mechanism.input.joint]),
        outputs=tuple(_renamed(output, number, name) for output in mechanism.outputs),
        assembly=replace(mechanism.assembly, variants=variants),
    )


def swapped(mechanism: Mechanism, name: str) -> Mechanism:
    """Exchange the two links of a joint; both lines of a prismatic joint turn round, so that s stays.

    coordinate_after: unchanged. The guide's and the slider's own directions are reversed.
    """
    joint = mechanism.joint(name)
    back = -1 if joint.kind == "prismatic" else 1
    other = replace(
        joint,
        links=(joint.links[1], joint.links[0]),
        points=(joint.points[1], joint.points[0]),
        directions=(back * joint.directions[1], back * joint.directions[0]),
    )
    return replace(mechanism, joints=tuple(other if j.name == name else j for j in mechanism.joints))


def _relaid(mechanism: Mechanism, link: int, place: Place, turn: float) -> Mechanism:
    """Put the points and lines of one link through ``place``, its directions through ``turn``."""
    rotation = complex(np.exp(1j * turn))

    def link_of(k: Link) -> Link:
        return replace(k, points={n: place(p) for n, p in k.points.items()}) if k.id == link else k

    def joint_of(joint: Joint) -> Joint:
        points, directions = list(joint.points), list(joint.directions)
        for side, number in enumerate(joint.links):
            if number == link:
                points[side] = place(points[side])
                directions[side] *= rotation if joint.kind == "prismatic" else 1
        return replace(joint, points=(points[0], points[1]), directions=(directions[0], directions[1]))

    return replace(
        mechanism,
        frame=link_of(mechanism.frame),
        links=tuple(link_of(k) for k in mechanism.links),
        joints=tuple(joint_of(joint) for joint in mechanism.joints),
    )


def _renamed(output: Output, number: Mapping[int, int], name: Mapping[str, str]) -> Output:
    if output.link is not None:
        return replace(output, link=number[output.link])
    return replace(output, joint=name[output.joint]) if output.joint else output


def _turns(mechanism: Mechanism) -> bool:
    return mechanism.joint(mechanism.input.joint).kind == "revolute"


def _with_coordinate(mechanism: Mechanism, shift: float) -> Mechanism:
    """Shift the input coordinates that the mechanism names: its start and where the sketch was read."""
    start, at = mechanism.input.start, mechanism.assembly.at
    return replace(
        mechanism,
        input=replace(mechanism.input, start=None if start is None else start + shift),
        assembly=replace(mechanism.assembly, at=None if at is None else at + shift),
    )


def _with_unit(mechanism: Mechanism, factor: float) -> Mechanism:
    """Scale the lengths that a prismatic input coordinate brings."""
    given, grid, assembly = mechanism.input, mechanism.grid, mechanism.assembly
    span = None if grid.span is None else grid.span * factor
    new_grid: Grid = replace(grid, span=span, extra=tuple(x * factor for x in grid.extra))
    new_assembly: Assembly = replace(assembly, at=None if assembly.at is None else assembly.at * factor)
    new_input = replace(
        given,
        speed=given.speed * factor,
        acceleration=given.acceleration * factor,
        start=None if given.start is None else given.start * factor,
    )
    return replace(mechanism, input=new_input, grid=new_grid, assembly=new_assembly)
