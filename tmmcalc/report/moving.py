"""What a page moves: bodies with their poses over an input, points of them, vectors at these points.

Texts are English, or a `Phrase` of `tmmcalc.core.notes`; the page says them in each language, by ``[names]``.

A view is what a room says of a stage whose scene moves, in metres or other true units; how it is drawn on a screen the
page knows. Over the n solved places of the input everything has a value and its rate by the input, so that between two
places a pose is a cubic that fits both: rigid bodies stay rigid, whatever the step.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Literal, NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real

FRAME = ""  # the body that stands still
TONES = BLUE, ORANGE, GREEN, PURPLE, OLIVE = (1, 2, 3, 4, 5)  # numbers of colours

Kind = Literal[
    "plate",  # a filled polygon: its corners
    "bar",  # a main line
    "slot",  # a main line that a block of another body runs on, beneath it
    "block",  # a slider: its centre, its direction
    "weld",  # bars that are one body: the corner, the directions of both
    "pivot",  # a hatched support of a pin: the pin, the direction downwards
    "guide",  # a hatched line that blocks run along: its ends, the outward direction
    "sleeve",  # a block that stands: its centre, its direction, the outward direction
    "cross",  # a point of the frame
    "circle",  # a main line: the centre; with its radius
    "pitch",  # a circle that is thought: the centre; with its radius
    "outline",  # a closed main line
    "line",  # a thin line
    "zone",  # a filled polygon where nothing may be
    "range",  # a closed dashed line: what may be reached
    "axis",  # a thin line of dashes and dots
    "base",  # a dashed circle: the centre; with its radius
    "gear",  # a filled polygon: a toothed wheel, or a part of one whose other edges are out of sight
    "flank",  # a part of its edge that works
    "cog",  # a toothed wheel that is thought: the centre, the middle of a tooth on its pitch circle; with the teeth
    "rim",  # a ring like it: the centre, the middle of a tooth, a point of the outer circle; with the teeth
    "spoke",  # a line that shows how a circle turns
    "dot",  # a filled point
    "sense",  # an arrow along a circle: its centre, where it begins; with the angle that it goes through [rad]
    "hole",  # a polygon that is cut out of a plate: its corners
    "roller",  # a circle that hides what is behind it: the centre; with its radius
    "wall",  # a hatched line that a rod slides along: its ends, the outward direction
    "held",  # a circle hatched outside: the centre; with its radius
]

SpotKind = Literal["pin", "mass", "point", "word"]  # a word has no sign, its name alone

SpanKind = Literal[
    "bar",  # a main line
    "line",  # a thin line
    "tube",  # a guide that a bar runs in
    "rope",  # a thin line that is taut
    "spring",  # a line that winds
    "shadow",  # a pale line
]


class Mark(NamedTuple):
    """Something drawn of a body, in its own axes."""

    kind: Kind
    points: tuple[complex, ...]
    size: float = 0.0  # radius [m], or what its kind says
    tone: int = 0  # number of its colour, from 1; 0: that of ink


class Track(NamedTuple):
    """Values (n,) over the input, and their rates by it."""

    values: Real
    rates: Real


class Body(NamedTuple):
    """A rigid body: the track of its origin [m], and of the angle of its axes [rad]."""

    name: str
    x: Track
    y: Track
    angle: Track
    marks: tuple[Mark, ...]
    number: str = ""  # in its ring
    beside: tuple[complex, ...] = ()  # where that may stand, in its axes, the best first
    on: str = FRAME  # in whose axes its tracks are
    there: tuple[float, float] | None = None  # between which places of the input it is there; None: always


class Spot(NamedTuple):
    """A named point of a body."""

    name: str
    body: str  # `FRAME` or the name of a body
    at: complex  # in its axes [m]
    kind: SpotKind
    path: bool = False  # whether it goes along a path that is shown


class Span(NamedTuple):
    """A line through points of bodies whose distances may change: a spring, a rod that is seen aslant.

    Each point is the name of a body, or `FRAME`, and a place in its axes [m].
    """

    kind: SpanKind
    points: tuple[tuple[str, complex], ...]


class Arrow(NamedTuple):
    """A vector at a spot: its sign, and the columns of its projections, as ``kinematics.vx_B``."""

    sign: str
    spot: str
    x: str
    y: str
    sense: int = 1  # -1: against the columns


class Vector(NamedTuple):
    """A vector at the origin of a body that no column tells, in the unit of its layer, in the axes of the frame.

    What jumps has ``places`` of its own, as a stage has rows: the nearest of them counts.
    """

    sign: str
    body: str
    x: Track
    y: Track
    places: Real | None = None  # (n,) of the input, where they are others than those of the view


class Angle(NamedTuple):
    """An angle at the origin of a body: directions of its legs [rad], the column of its value."""

    sign: str
    body: str
    start: Track
    end: Track
    column: str  # as ``cam_pressure.theta``


class Layer(NamedTuple):
    """Vectors and angles that are shown together."""

    name: str
    title: str
    unit: str
    arrows: tuple[Arrow, ...]
    vectors: tuple[Vector, ...] = ()
    tone: int = 0  # number of their colour, from 1; 0: by the place of the layer
    angles: tuple[Angle, ...] = ()
    hidden: bool = False  # until it is asked for


class Edge(NamedTuple):
    """A vector of a plan from one vertex to another: its sign, its kind, by which it has its colour."""

    tail: int
    head: int
    sign: str
    kind: str


class Plan(NamedTuple):
    """A plan of vectors at every place: vertices (n,) with their names, the vectors between them.

    ``places`` are those of the input, where they are others than those of the view.
    """

    name: str
    title: str
    unit: str
    vertices: tuple[tuple[str, Plane], ...]
    edges: tuple[Edge, ...]
    places: Real | None = None
    note: str = ""


class Centre(NamedTuple):
    """A point that moves by itself, as an instant centre: NaN where there is none."""

    name: str
    at: Plane  # (n,) [m]


class Handle(NamedTuple):
    """What the input is moved by: a body that turns about a place, or slides."""

    body: str
    pivot: complex | None = None


class Reading(NamedTuple):
    """A number that is told beside the scene: its name, sign and unit, its values over the input."""

    name: str
    sign: str
    unit: str
    value: Track
    there: tuple[float, float] | None = None  # between which places of the input it has a value; None: always


class Stop(NamedTuple):
    """A place of the input that is marked: a dead centre, an end."""

    title: str
    at: float


class Driver(NamedTuple):
    """Another view whose input moves that of this one: so many times it, less what that is where this one begins."""

    view: str
    ratio: float
    begin: float  # in the unit of both


class View(NamedTuple):
    """A scene that moves."""

    name: str
    title: str
    symbol: str  # of the input
    unit: str
    values: Real  # (n,) of the input, in this unit, from one end to the other
    whole: bool  # whether its end is its beginning
    column: str  # the header of the input in the tables of stages, ``phi[deg]``; empty: in none, all is exact
    steps: tuple[tuple[str, float], ...]  # places to step to, label and input, where the spec has no positions
    box: tuple[complex, complex]  # lower left and upper right corner of all that moves [m]
    bodies: tuple[Body, ...]
    frame: tuple[Mark, ...]
    spots: tuple[Spot, ...]
    handle: Handle | None = None
    layers: tuple[Layer, ...] = ()
    centres: tuple[Centre, ...] = ()
    plans: Callable[[], Iterable[Plan]] = tuple  # made where they are shown
    stops: tuple[Stop, ...] = ()
    shown: tuple[str, ...] = ()  # columns whose diagrams stand beside it at first
    spans: tuple[Span, ...] = ()
    note: str = ""  # what is told of how it is drawn
    stages: tuple[str, ...] = ()  # whose tables go along its input; empty: all that have its column
    reach: tuple[tuple[float, float], ...] = ()  # where it assembles, counted as the input; empty: everywhere
    readings: tuple[Reading, ...] = ()
    seconds: float = 4.0  # that the whole travel takes when it plays
    driver: Driver | None = None
    front: tuple[Mark, ...] = ()  # of the frame, before all that moves
    nudge: float | None = None  # how far a press of an arrow key moves the input; None: 1/360 of the travel


def seconds_of(duration: float) -> float:
    """How long a motion over the time plays: as long as it lasts, if that can be watched."""
    return min(max(duration, 2.0), 12.0)


def track_of(values: Real | float, rates: Real | float, count: int) -> Track:
    """A track from arrays (n,) or single values."""
    return Track(np.broadcast_to(np.asarray(values, float), count), np.broadcast_to(np.asarray(rates, float), count))
