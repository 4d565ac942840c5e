"""What is asked of a six-bar with a dwell, in SI; sizes in parts of l_OB, the distance of the pivot O from B at dwell.

A None among the parameters is a value that the optimisation is to find.
"""

from __future__ import annotations

from dataclasses import field
from typing import Literal

from tmmcalc.core.records import record

OutputKind = Literal["slider", "rocker"]
Stroke = Literal["towards", "away"]


@record
class ThreePositions:
    """Parameters of the synthesis by three positions: turns of crank and bar BC, sizes of bar and coupler."""

    phi12: float | None = None  # crank, from position 1 to 2 [rad]
    psi0: float | None = None  # angle of B -> C in position 1 [rad]
    psi12: float | None = None  # turn of bar BC from position 1 to 2 [rad]
    psi13: float | None = None  # from position 1 to 3 [rad]
    bar: float | None = None  # l_CB
    side: float | None = None  # l_CD
    alpha: float | None = None  # from C -> A to C -> D, counter-clockwise [rad]


@record
class Lengths:
    """A linkage by its lengths: O-A-C-B at dwell is a four-bar, E the centre of the circle through three D."""

    crank: float  # l_OA
    coupler: float  # l_AC
    bar: float  # l_CB
    side: float  # l_CD
    alpha: float  # from C -> A to C -> D, counter-clockwise [rad]
    phi0: float  # angle of the crank in position 1 [rad]
    phi12: float  # crank, from position 1 to 2 [rad]
    left: bool  # whether C is to the left of A -> B


@record
class Optimum:
    """The search: weights of the criteria f1 to f5, ranges of parameters other than the usual ones, its extent."""

    weights: tuple[float, ...] = (100.0, 1.0, 1.0, 1.0, 0.1)
    ranges: dict[str, tuple[float, float]] = field(default_factory=dict)  # by name of the parameter
    population: int = 96  # candidates of a generation
    generations: int = 60  # at most
    polish: int = 150  # evaluations of Nelder's and Mead's method at the end


@record
class DwellTask:
    """A six-bar of class IV with a dwell of its slider or rocker."""

    dwell: float  # phi_B, turn of the crank during the dwell [rad]
    output: OutputKind = "slider"
    positions: ThreePositions = ThreePositions()
    lengths: Lengths | None = None  # in place of the positions
    n: float | None = None  # part of the dwell after which the output moves along the crank
    reverse: bool = False  # k = 1: the displacement counts the other way
    clockwise: bool = False  # sense of the crank
    pivot: complex | None = None  # F of a rocker, from O, in parts of l_OB
    swing: float | None = None  # of a rocker [rad], in place of F
    pivot_left: bool | None = None  # F to the left of the crank at the part n of the dwell; None: either
    exact: bool = True  # whether n and l_OF are corrected until working angle and swing are those asked for
    working_angle: float | None = None  # turn of the crank on the stroke towards the dwell [rad], in place of n
    working: Stroke = "towards"  # which stroke is the working one
    frame: float | None = None  # l_OB [m]
    stroke: float | None = None  # of a slider [m], in place of l_OB
    resistance: float = 1.0  # against the output on its working stroke [N or N*m]
    arc_steps: int = 12  # of the arc of the relative trajectory
    optimum: Optimum | None = None
