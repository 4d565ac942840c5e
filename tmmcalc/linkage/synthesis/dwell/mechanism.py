"""A six-bar of the synthesis as the mechanism that the kinematics and forces rooms read.

Points keep their letters: O, A, C, D, B, E, and F of a rocker. Own axes: of the crank along OA, of the coupler from A
along AC, of bar CB from C, of bar DE from D, of the slider from B along u, of the rocker from F along FB.
"""

from __future__ import annotations

import cmath
import math
from typing import Literal

from tmmcalc.core.records import record
from tmmcalc.linkage.loading import Load, Loading
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.model import FRAME, Assembly, Grid, Input, Joint, Link, Mechanism, Output
from tmmcalc.linkage.synthesis.dwell.linkages import Linkages


@record
class Setting:
    """What a mechanism has besides its sizes: scale, motion of the crank, positions, sense of the resistance."""

    scale: float  # l_OB [m]
    speed: float  # of the crank [rad/s]
    positions: int
    growing: bool  # whether S grows on the working stroke


def mechanism_of(linkages: Linkages, setting: Setting) -> Mechanism:
    """The mechanism of one linkage (1,), its crank in position 1 at the start, positions 2 and 3 added to the grid."""
    points = _points(linkages, setting.scale)
    frame = Link(FRAME, {"O": 0j, **({"F": points["F"]} if linkages.rocks else {"G": points["B"]})}, "frame")
    links = (*_bars(linkages, setting.scale), _output(linkages, points))
    ends = {"O": (-1, 0), "A": (0, 1), "C": (1, 2), "D": (1, 3), "B": (2, 4), "E": (3, 4)}
    every = (*links, frame)
    joints = tuple(_revolute(name, every[one], every[two]) for name, (one, two) in ends.items())
    last = _revolute("F", frame, links[4]) if linkages.rocks else _guided(linkages, points["B"])
    sense = math.copysign(1.0, setting.speed)
    resistance: Literal["negative", "positive"] = "negative" if setting.growing else "positive"
    output = Output(link=5, resistance=resistance) if linkages.rocks else Output(joint="S", resistance=resistance)
    phi0 = float(linkages.phi0[0])
    extra = sorted(float(sense * turn) % (2 * math.pi) for turn in linkages.turns[1:, 0])
    return Mechanism(
        frame,
        links,
        (*joints, last),
        Input("O", setting.speed, 0.0, phi0),
        (output,),
        Grid(setting.positions, extra=tuple(extra), extremes=True),
        Assembly(sketch={name: points[name] for name in ("C", "D", "B", "E")}, at=phi0),
    )


def loading_of(linkages: Linkages, resistance: float, growing: bool) -> Loading:
    """The resistance of the output against its motion on the working stroke; massless links."""
    value = -resistance if growing else resistance
    if linkages.rocks:
        return Loading(loads=(Load("resistance", 5, "moment", Constant(value)),))
    return Loading(loads=(Load("resistance", 5, "force", Constant(value), 0j, 1 + 0j, follows=5),))


def _points(linkages: Linkages, scale: float) -> dict[str, complex]:
    """Places of all points at dwell, in position 1 [m]."""
    a = complex(linkages.crank[0] * cmath.exp(1j * linkages.phi0[0]))
    turn = cmath.exp(1j * linkages.theta0[0])
    c, d = a + turn * linkages.coupler[0], a + turn * linkages.d[0]
    points = {"A": a, "C": c, "D": d, "B": 1 + 0j, "E": linkages.e[0], "F": linkages.output[0]}
    return {name: scale * complex(at) for name, at in points.items()}


def _bars(linkages: Linkages, scale: float) -> tuple[Link, ...]:
    """The links 1 to 4."""
    crank, coupler, bar, rod = (
        scale * complex(v[0]) for v in (linkages.crank, linkages.coupler, linkages.bar, linkages.rod)
    )
    return (
        Link(1, {"O": 0j, "A": crank}, "crank"),
        Link(2, {"A": 0j, "C": coupler, "D": scale * complex(linkages.d[0])}, "coupler"),
        Link(3, {"C": 0j, "B": bar}, "bar CB"),
        Link(4, {"D": 0j, "E": rod}, "bar DE"),
    )


def _output(linkages: Linkages, points: dict[str, complex]) -> Link:
    """Link 5."""
    b, e, f = points["B"], points["E"], points["F"]
    if not linkages.rocks:
        return Link(5, {"B": 0j, "E": (e - b) / complex(linkages.output[0])}, "slider")
    along = (b - f) / abs(b - f)
    return Link(5, {"F": 0j, "B": complex(abs(b - f)), "E": (e - f) / along}, "rocker")


def _revolute(name: str, first: Link, second: Link) -> Joint:
    return Joint(name, "revolute", (first.id, second.id), (first.points[name], second.points[name]))


def _guided(linkages: Linkages, b: complex) -> Joint:
    return Joint("S", "prismatic", (5, FRAME), (0j, b), (1 + 0j, complex(linkages.output[0])))
