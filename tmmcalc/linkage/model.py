"""What the linkage room reads: links, joints, the input, the outputs, the grid.

Plane vectors are complex numbers x + iy [m]. Every link has axes of its own; the points of a link and
the lines of its prismatic joints are constants in them (the *metric*). Link 0 is the frame, its axes
are the fixed axes. The angle of a link is the angle of its own x axis with the fixed x axis,
counter-clockwise positive.

A prismatic joint is two lines that coincide, one fixed in each link:

        guide link                      slider link
        o----------->  line             o----------->  line
        q_g      e_g                    q_s      e_s

The directions coincide as well, so the joint holds the relative angle of the two links constant. Its
coordinate s is the distance from q_g to q_s along the common direction.

These are plain values: the pipeline hashes them to know when a stored result is still valid.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from typing import Literal

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

FRAME = 0


@record
class Link:
    """A rigid link: its number and the points fixed on it, in its own axes [m]."""

    id: int
    points: dict[str, complex] = field(default_factory=dict)
    name: str = ""


@record
class Joint:
    """A lower pair of two links.

    Revolute: ``points`` are the pin in the axes of ``links[0]`` and of ``links[1]`` [m].
    Prismatic: ``links`` are the slider and the guide link; ``points`` a point of the line on each [m];
    ``directions`` the unit direction of the line in the axes of each.
    """

    name: str
    kind: Literal["revolute", "prismatic"]
    links: tuple[int, int]
    points: tuple[complex, complex]
    directions: tuple[complex, complex] = (1 + 0j, 1 + 0j)

    def other(self, link: int) -> int:
        """The link that it joins with this one."""
        return self.links[1 - self.links.index(link)]


@record
class Input:
    """The input link, by its joint with the frame, and its motion; or a driven length between two moving links.

    Revolute: the coordinate is the angle of the input link [rad]; prismatic: the coordinate of the joint [m].
    """

    joint: str
    speed: float  # mean speed [rad/s] or [m/s], not zero; positive counter-clockwise
    acceleration: float = 0.0  # [rad/s^2] or [m/s^2]
    start: float | None = None  # coordinate of position 0; None: the dead centre before the working stroke
    given: bool = True  # False: no speed is asked for, that of 1 makes the rates those by the input coordinate


@record
class Output:
    """The coordinate whose displacement S, velocity and acceleration the project asks for. One of:

    ``point`` measured along ``direction`` [rad]; the angle of ``link``; the coordinate of prismatic ``joint``.
    ``label`` names it in columns and messages.
    """

    point: str | None = None
    direction: float = 0.0
    link: int | None = None
    joint: str | None = None
    resistance: Literal["positive", "negative"] | None = None  # sense of the useful resistance along the coordinate
    label: str | None = None

    @property
    def name(self) -> str:
        """Name used in columns and messages: the label, or else the point, the joint, or the link number."""
        return self.label or self.point or self.joint or str(self.link)


@record
class Grid:
    """Positions of the input: ``positions`` equal steps over ``span``, or ``working`` + ``idle`` steps.

    ``extra`` lists additional positions, counted from position 0; ``extremes`` adds the dead centres of all outputs.
    """

    positions: int = 24
    working: int | None = None
    idle: int | None = None
    span: float | None = None  # [rad] or [m]; None: one full turn
    extra: tuple[float, ...] = ()
    extremes: bool = False


@record
class Assembly:
    """Which of the assembly variants: a sketch (approximate points [m]), or signs by group.

    ``variants`` maps the two link numbers of a dyad, in the order that defines its sign, to +1 or -1, and the links of
    a higher group to the number of its assembly among all there are at that input coordinate, from 1 on.
    ``at`` is the input coordinate at which the sketch was read; None: position 0.
    """

    sketch: dict[str, complex] = field(default_factory=dict)
    variants: dict[tuple[int, ...], int] = field(default_factory=dict)
    at: float | None = None


@record
class Mechanism:
    """A planar linkage with one input: the whole input of the structure and kinematics stages."""

    frame: Link
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    input: Input
    outputs: tuple[Output, ...] = ()
    grid: Grid = Grid()
    assembly: Assembly = Assembly()

    def __post_init__(self) -> None:
        """Refuse numbers and names that mean two things, and joints of links that do not exist."""
        links, joints = [FRAME, *(link.id for link in self.links)], [joint.name for joint in self.joints]
        _check_once("links", links)
        _check_once("joints", joints)
        for joint in self.joints:
            for k in joint.links:
                if k not in links:
                    raise _unknown(f"joint {joint.name} is at link {k}, which does not exist", "links", links)
        if self.input.joint not in joints:
            raise _unknown(f"the input is at joint {self.input.joint}, which does not exist", "joints", joints)

    def link(self, number: int) -> Link:
        """Return the link with this number; the frame is link 0."""
        return self.frame if number == FRAME else next(link for link in self.links if link.id == number)

    def joint(self, name: str) -> Joint:
        """Return the joint with this name."""
        return next(joint for joint in self.joints if joint.name == name)


def _check_once(what: str, keys: Sequence[int | str]) -> None:
    """Every link has a number, and every joint a name, of its own."""
    if len(set(keys)) < len(keys):
        twice = next(key for key in keys if keys.count(key) > 1)
        number = "the number" if what == "links" else "the name"
        frame = ", the frame's" if twice == FRAME else ""
        raise UsageError(f"two {what} have {number} {twice}{frame}", where=f"mechanism.{what}", remedy="rename one")


def _unknown(message: str, what: str, keys: Sequence[int | str]) -> UsageError:
    return UsageError(message, where="mechanism", remedy=f"the {what} are: {', '.join(map(str, keys))}")
