"""The records that a synthesis leaves: designs with their sizes, checks, defects and ready specs, best first."""

from __future__ import annotations

import math

from tmmcalc.core.notes import Said
from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import Quantity, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.synthesis.dwell.results import Dwell

SAME = "the same"  # meaning of a size that is another coordinate of the one before


@record
class Size:
    """One size of a design: ``unit`` is m, rad or - for a number."""

    symbol: str
    value: float
    unit: str
    meaning: str

    @property
    def told(self) -> Quantity:
        """What the size is for programs."""
        return Quantity("{symbol}[{unit}]", self.meaning).of(
            symbol=self.symbol, unit="" if self.unit == "-" else self.unit
        )


@record
class Check:
    """One quantity of the simulated mechanism beside its target.

    ``residual`` is relative to the target, or absolute where that is zero; None without a target.
    """

    name: str
    achieved: float = quantity("achieved[{unit}]", "value of the simulated mechanism")
    unit: str  # m, rad or - for a number
    target: float | None = quantity("target[{unit}]", "value that was asked for", default=None)
    residual: float | None = quantity("residual", "difference of the two, relative to the target", default=None)


def check_key(name: str) -> str:
    """The name of a check in the documents.

    >>> check_key("stroke h")
    'check_stroke_h'
    """
    return f"check_{name.replace(' ', '_')}"


@record
class StrokeTimes:
    """Times, angles and mean speeds of the two strokes at a constant speed of the crank."""

    crank_speed: float = quantity("omega[rad/s]", "angular velocity of the crank")
    time_ratio: float  # K
    stroke: float  # S, or the swing 2 phi
    unit: str  # of the stroke, m or rad
    period: float = quantity("t[s]", "time of the cycle")
    working_time: float = quantity("t_p[s]", "time of the working stroke")
    idle_time: float = quantity("t_x[s]", "time of the idle stroke")
    working_speed: float = quantity("{letter}_p[{unit}/s]", "mean speed of the working stroke")
    idle_speed: float = quantity("{letter}_x[{unit}/s]", "mean speed of the idle stroke")
    mean_speed: float = quantity("{letter}_mean[{unit}/s]", "mean speed 2 S/t over the cycle")
    working_angle: float = quantity("alpha_p[rad]", "angle of the crank over the working stroke")
    idle_angle: float = quantity("alpha_x[rad]", "angle of the crank over the idle stroke")
    overlap: float  # psi [rad]

    @property
    def rpm(self) -> float:
        """Turns of the crank a minute."""
        return self.crank_speed * 30 / math.pi


@record
class Precision:
    """What was wanted at the n points, and what the simulated mechanism does there."""

    unit: str  # of the output, rad or m
    sense: int = quantity("sense", "of the crank from the first point on, +1 counter-clockwise")
    crank: Real = quantity("crank[rad]", "angle of the crank")  # (n,)
    wanted: Real = quantity("wanted[{unit}]", "output; of a path the distance 0 from the point")  # (n,)
    found: Real = quantity("found[{unit}]", "output of the simulated mechanism")  # (n,)
    points: Plane = quantity("points[m]", "places of the coupler point that were wanted")  # (n,) empty for a function
    reached: Plane = quantity("reached[m]", "places that it reaches")  # (n,)
    angle_errors: Real = quantity("angle_errors[rad]", "errors of the angle of the coupler")  # (n,) or none
    fine: Real  # (m,) angles of the crank over the range of a function [rad]; empty for a path
    error: Real  # (m,) error of the output there [rad or m]


# figures of merit of designs
TRANSMISSION = Quantity("transmission_min[deg]", "smallest transmission angle")
PRESSURE = Quantity("pressure_max[deg]", "largest pressure angle")
STRUCTURAL_ERROR = Quantity("structural_error[{unit}]", "error of the output over the range of the function")
DISTANCE = Quantity("error_max[m]", "largest distance from the points")
ANGLE_ERROR = Quantity("angle_error_max[deg]", "largest error of the body's angle")


@record
class Design:
    """One linkage that answers the task."""

    name: str = quantity("name", "name of the linkage")
    sizes: tuple[Size, ...]
    checks: tuple[Check, ...]
    merits: dict[str, float]  # figures of merit by their keys
    defects: tuple[str, ...] = quantity("defects", "what is wrong with the linkage")
    spec: str  # the ready spec, TOML
    times: StrokeTimes | None = None
    precision: Precision | None = None
    dwell: Dwell | None = None  # of a six-bar with a dwell

    def size(self, symbol: str) -> float:
        """The size of this symbol in SI; raises KeyError if there is none."""
        return {size.symbol: size.value for size in self.sizes}[symbol]

    def check(self, name: str) -> Check:
        """The check of this name; raises KeyError if there is none."""
        return {check.name: check for check in self.checks}[name]


@record
class SearchStep:
    """A step of a search."""

    run: int = quantity("round", "round of starts, or fit")
    number: int = quantity("step", "iteration or generation, from 0")
    linkages: int = quantity("linkages", "linkages that are iterated; of generations, linkages tried so far")
    best: float = quantity("best", "least value so far of what is made least")


@record
class Synthesis:
    """All designs that are listed, the best first."""

    kind: str = quantity("kind", "kind of the synthesis")
    rule: str = quantity("rule", "rule of the order of the designs")
    designs: tuple[Design, ...]
    residual: float = quantity("residual", "largest residual against any target")
    notes: tuple[Said, ...] = ()
    counters: dict[str, int] = quantity("counters", "counts of the search", default_factory=dict)
    course: tuple[SearchStep, ...] = quantity("course", "steps of the search", default_factory=tuple)
    error: float | None = None  # of the sizes, of lengths relative to the longest; None: no equations settle them
    among: tuple[Design, ...] = ()  # where one alone is left: those that it was taken from

    @property
    def best(self) -> Design:
        """The first of the designs."""
        return self.designs[0]
