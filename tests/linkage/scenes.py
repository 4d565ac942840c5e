"""Small mechanisms built by hand, with all lengths free: the scenes of the linkage tests."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tmmcalc.linkage.model import Assembly, Grid, Input, Joint, Link, Mechanism, Output

CONFIGS = Path(__file__).parents[2] / "configs"


def polar(length: float, angle: float) -> complex:
    """The vector of this length at this angle [rad]."""
    return complex(length * np.cos(angle), length * np.sin(angle))


def pin(name: str, one: int, two: int, at_one: complex = 0, at_two: complex = 0) -> Joint:
    return Joint(name, "revolute", (one, two), (complex(at_one), complex(at_two)))


def slide(
    name: str, slider: int, guide: int, through: complex = 0, angle: float = 0, at: complex = 0, own: float = 0
) -> Joint:
    """A prismatic joint; ``through`` and ``angle`` lay the line in the guide, ``at`` and ``own`` in the slider."""
    lines = polar(1, own) if own else 1 + 0j, polar(1, angle) if angle else 1 + 0j
    return Joint(name, "prismatic", (slider, guide), (complex(at), complex(through)), lines)


def bar(number: int, **points: complex) -> Link:
    return Link(number, {name: complex(place) for name, place in points.items()})


def four_bar(l1: float, l2: float, l3: float, c: complex, variant: int = 1) -> Mechanism:
    """O and C on the frame, crank OA = l1, coupler AB = l2, rocker CB = l3; its angle is the output."""
    return Mechanism(
        Link(0, {"O": 0j, "C": complex(c)}),
        (bar(1, O=0, A=l1), bar(2, A=0, B=l2), bar(3, C=0, B=l3)),
        (pin("O", 0, 1), pin("A", 1, 2, l1), pin("B", 2, 3, l2, l3), pin("C", 0, 3, c)),
        Input("O", 1.0, start=0.0),
        (Output(link=3),),
        assembly=Assembly(variants={(2, 3): variant}),
    )


def crank_slider(l1: float, l2: float, e: float = 0.0, variant: int = 1) -> Mechanism:
    """Crank OA = l1, rod AB = l2, the slider B on the line y = e; x of B is the output."""
    return Mechanism(
        Link(0, {"O": 0j}),
        (bar(1, O=0, A=l1), bar(2, A=0, B=l2), bar(3, B=0)),
        (pin("O", 0, 1), pin("A", 1, 2, l1), pin("B", 2, 3, l2), slide("B0", 3, 0, 1j * e)),
        Input("O", 1.0, start=0.0),
        (Output(point="B"),),
        assembly=Assembly(variants={(2, 3): variant}),
    )


def slotted(l0: float, l1: float, h: float = 0.0, variant: int = 1) -> Mechanism:
    """Crank OA = l1 about O = (0, l0), block 2 on the slotted link 3 about the origin, slot at the offset h."""
    return Mechanism(
        Link(0, {"O": 1j * l0, "B": 0j}),
        (bar(1, O=0, A=l1), bar(2, A=0), bar(3, B=0, K=2 * (l0 + l1))),
        (pin("O", 0, 1, 1j * l0), pin("A", 1, 2, l1), slide("A3", 2, 3, 1j * h), pin("B", 0, 3)),
        Input("O", 1.0, start=0.0),
        (Output(link=3),),
        assembly=Assembly(variants={(2, 3): variant}),
    )


def yoke(l1: float, angle: float = np.pi / 2) -> Mechanism:
    """Crank OA = l1 with block 2 in the slot of the yoke 3, which slides along x; the slot stands at ``angle``."""
    return Mechanism(
        Link(0, {"O": 0j}),
        (bar(1, O=0, A=l1), bar(2, A=0), bar(3, D=0)),
        (pin("O", 0, 1), pin("A", 1, 2, l1), slide("A3", 2, 3, 0, angle), slide("D0", 3, 0)),
        Input("O", 1.0, start=0.0),
        (Output(joint="D0"),),
    )


def trammel(l1: float, beta: float) -> Mechanism:
    """Slider 2 in the slot of link 1, which turns about O, pinned at A to slider 3 on a fixed guide (PRP)."""
    return Mechanism(
        Link(0, {"O": 0j}),
        (bar(1, O=0), bar(2, A=0), bar(3, A=0)),
        (pin("O", 0, 1), slide("A1", 2, 1), pin("A", 2, 3), slide("A0", 3, 0, 1j * l1, beta)),
        Input("O", 1.0, start=0.0),
        (Output(joint="A0"),),
    )


def driven_rod(l: float, h: float, span: float) -> Mechanism:
    """Slider 1 driven along x carries the pin A of rod 2 = l, whose end B slides on the line x = h (RRP)."""
    return Mechanism(
        Link(0),
        (bar(1, A=0), bar(2, A=0, B=l), bar(3, B=0)),
        (slide("A0", 1, 0), pin("A", 1, 2), pin("B", 2, 3, l), slide("B0", 3, 0, h, np.pi / 2)),
        Input("A0", 1.0, start=0.0),
        (Output(point="B", direction=np.pi / 2),),
        Grid(positions=12, span=span),
    )


def with_grid(mechanism: Mechanism, **changes: Any) -> Mechanism:
    return replace(mechanism, grid=replace(mechanism.grid, **changes))


def with_input(mechanism: Mechanism, **changes: Any) -> Mechanism:
    return replace(mechanism, input=replace(mechanism.input, **changes))


def with_output(mechanism: Mechanism, **what: Any) -> Mechanism:
    return replace(mechanism, outputs=(Output(**what),))


def full_turn(mechanism: Mechanism, start: float = 0.0, positions: int = 24) -> Mechanism:
    return with_grid(with_input(mechanism, start=start), positions=positions)


def part(mechanism: Mechanism, low: float, high: float, positions: int = 24) -> Mechanism:
    """Analyse the input range [low, high] only."""
    return with_grid(with_input(mechanism, start=low), positions=positions, span=high - low)


def shaper(**grid: Any) -> Mechanism:
    """The shaper of configs/shaper.toml as plain values."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.project import load_spec

    return with_grid(to_linkage(load_spec(CONFIGS / "shaper.toml").mechanism), **grid)


def drag_link() -> Mechanism:
    """A double crank whose coupler drives a dyad: link 4 goes round once a turn and swings back a little in it."""
    base = four_bar(1.27837932, 0.50740938, 1.44296838, 0.3)
    p, f = 0.25370469 - 0.78925084j, 0.39438614 - 0.62552408j
    return replace(
        base,
        frame=Link(0, {"O": 0j, "C": 0.3 + 0j, "F": f}),
        links=(
            base.links[0],
            bar(2, A=0, B=0.50740938, P=p),
            base.links[2],
            bar(4, P=0, D=1.05554775),
            bar(5, F=0, D=1.38401037),
        ),
        joints=(*base.joints, pin("P", 2, 4, p), pin("D", 4, 5, 1.05554775, 1.38401037), pin("F", 0, 5, f)),
        outputs=(Output(link=4),),
        assembly=Assembly(variants={(2, 3): 1, (4, 5): -1}),
    )
