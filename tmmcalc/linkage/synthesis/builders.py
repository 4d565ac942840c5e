"""Mechanisms from sizes: the linkages that a synthesis finds, as the kinematics room reads them.

Points keep their letters: of four-bar and slider-crank A the crank's pivot, B its pin, C the end of the coupler, D the
rocker's pivot, P the coupler point; of slotted links A and C the pivots, B the block, D the end of the arm, E the
slider; of the V-engine O the crank's axis, A its pin, B the right piston, C the pin of the trailing rod, D the left
piston. The own x axis of a link runs along it, so the input coordinate is the angle of the crank.
"""

from __future__ import annotations

import cmath

from tmmcalc.core.records import record
from tmmcalc.linkage.model import FRAME, Assembly, Grid, Input, Joint, Link, Mechanism, Output


@record
class Operation:
    """Motion of the crank, positions and outputs of a mechanism."""

    speed: float  # [rad/s]
    start: float | None = None  # [rad]; None: the dead centre before the working stroke
    grid: Grid = Grid(extremes=True)
    outputs: tuple[Output, ...] = ()


@record
class FourBar:
    """Sizes of a four-bar: pivots A and D, lengths, coupler point in the axes of BC, variant of the dyad."""

    pivot: complex
    crank: float
    coupler: float
    rocker: float
    fixed: complex  # D
    point: complex | None = None
    variant: int = 1  # +1: C to the left of B -> D


@record
class SliderCrank:
    """Sizes of a slider-crank: pivot A, lengths, a point and the angle of the guide, coupler point, variant."""

    pivot: complex
    crank: float
    coupler: float
    guide: complex
    angle: float = 0.0  # [rad]
    point: complex | None = None
    variant: int = 1  # +1: C ahead of B along the guide


@record
class VEngine:
    """Sizes of a V-engine: crank, master rod with its lug, trailing rod, angle from the right to the left cylinder."""

    crank: float
    rod: float
    lug: float
    lug_angle: float  # [rad], from AB to AC
    length: float  # of the trailing rod
    angle: float  # [rad]


def _revolute(name: str, first: Link, second: Link) -> Joint:
    return Joint(name, "revolute", (first.id, second.id), (first.points[name], second.points[name]))


def _crank(sizes: FourBar | SliderCrank) -> Link:
    return Link(1, {"A": 0j, "B": complex(sizes.crank)}, "crank")


def _coupler(sizes: FourBar | SliderCrank) -> Link:
    extra = {} if sizes.point is None else {"P": sizes.point}
    return Link(2, {"B": 0j, "C": complex(sizes.coupler), **extra}, "coupler")


def four_bar(sizes: FourBar, scene: Operation) -> Mechanism:
    """The four-bar A B C D with its coupler point P."""
    frame = Link(FRAME, {"A": sizes.pivot, "D": sizes.fixed}, "frame")
    crank, coupler = _crank(sizes), _coupler(sizes)
    rocker = Link(3, {"D": 0j, "C": complex(sizes.rocker)}, "rocker")
    joints = (
        _revolute("A", frame, crank),
        _revolute("B", crank, coupler),
        _revolute("C", coupler, rocker),
        _revolute("D", frame, rocker),
    )
    return _mechanism(frame, (crank, coupler, rocker), joints, scene, {(2, 3): sizes.variant})


def slider_crank(sizes: SliderCrank, scene: Operation) -> Mechanism:
    """The slider-crank A B C with its coupler point P; the guide of the joint C0 is named by G."""
    frame = Link(FRAME, {"A": sizes.pivot, "G": sizes.guide}, "frame")
    crank, coupler = _crank(sizes), _coupler(sizes)
    slider = Link(3, {"C": 0j}, "slider")
    joints = (
        _revolute("A", frame, crank),
        _revolute("B", crank, coupler),
        _revolute("C", coupler, slider),
        _guided("C0", slider, "C", frame, sizes.guide, cmath.rect(1.0, sizes.angle)),
    )
    return _mechanism(frame, (crank, coupler, slider), joints, scene, {(2, 3): sizes.variant})


def slotted_link(crank: float, centres: float, arm: float, rod: float, guide: float, scene: Operation) -> Mechanism:
    """Slotted link about C = 0, crank about A = i ``centres``, rod DE, slider E on the line y = ``guide``."""
    frame = Link(FRAME, {"C": 0j, "A": 1j * centres, "G": 1j * guide}, "frame")
    links = (
        Link(1, {"A": 0j, "B": complex(crank)}, "crank"),
        Link(2, {"B": 0j}, "block"),
        Link(3, {"C": 0j, "D": complex(arm)}, "slotted link"),
        Link(4, {"D": 0j, "E": complex(rod)}, "connecting rod"),
        Link(5, {"E": 0j}, "slider"),
    )
    joints = (
        _revolute("A", frame, links[0]),
        _revolute("B", links[0], links[1]),
        _guided("B3", links[1], "B", links[2], 0j),
        _revolute("C", frame, links[2]),
        _revolute("D", links[2], links[3]),
        _revolute("E", links[3], links[4]),
        _guided("E0", links[4], "E", frame, 1j * guide),
    )
    return _mechanism(frame, links, joints, scene, {(2, 3): 1, (4, 5): 1})


def v_engine(sizes: VEngine, scene: Operation) -> Mechanism:
    """Crank about O = 0, master rod AB with the lug AC, trailing rod CD, both pistons on guides through O."""
    frame = Link(FRAME, {"O": 0j}, "frame")
    lug = cmath.rect(sizes.lug, sizes.lug_angle)
    links = (
        Link(1, {"O": 0j, "A": complex(sizes.crank)}, "crank"),
        Link(2, {"A": 0j, "B": complex(sizes.rod), "C": lug}, "master rod"),
        Link(3, {"B": 0j}, "right piston"),
        Link(4, {"C": 0j, "D": complex(sizes.length)}, "trailing rod"),
        Link(5, {"D": 0j}, "left piston"),
    )
    joints = (
        _revolute("O", frame, links[0]),
        _revolute("A", links[0], links[1]),
        _revolute("B", links[1], links[2]),
        _guided("B0", links[2], "B", frame, 0j),
        _revolute("C", links[1], links[3]),
        _revolute("D", links[3], links[4]),
        _guided("D0", links[4], "D", frame, 0j, cmath.rect(1.0, sizes.angle)),
    )
    return _mechanism(frame, links, joints, scene, {(2, 3): 1, (4, 5): 1}, "O")


def _guided(name: str, slider: Link, pin: str, guide: Link, through: complex, direction: complex = 1 + 0j) -> Joint:
    points = (slider.points[pin], through)
    return Joint(name, "prismatic", (slider.id, guide.id), points, (1 + 0j, direction))


def _mechanism(
    frame: Link,
    links: tuple[Link, ...],
    joints: tuple[Joint, ...],
    scene: Operation,
    variants: dict[tuple[int, int], int],
    pivot: str = "A",
) -> Mechanism:
    drive = Input(pivot, scene.speed, 0.0, scene.start)
    signs: dict[tuple[int, ...], int] = dict(variants.items())
    return Mechanism(frame, links, joints, drive, scene.outputs, scene.grid, Assembly(variants=signs))
