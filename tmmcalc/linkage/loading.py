"""What acts on a linkage: masses, gravity, technological loads, springs, the geometry of its pairs, the drive.

Plain values, like those of `model`: the pipeline hashes them. Points are complex [m] in the axes of their link,
directions are unit vectors. Angles ``theta`` are counted from position 0 along the motion, never negative.
"""

from __future__ import annotations

import math
from typing import Literal

from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.loadlaws.law import Law
from tmmcalc.linkage.model import FRAME

Role = Literal["resistance", "drive", "neutral"]


@record
class Body:
    """Mass properties of a moving link."""

    link: int
    mass: float  # [kg]
    inertia: float  # about the centre of mass [kg*m^2]
    center: complex  # centre of mass in the link's axes [m]


@record
class Window:
    """Where a load acts; outside it is zero. One of: a stroke of an output, angles, positions."""

    stroke: Literal["working", "idle"] | None = None
    output: str | None = None  # whose stroke; None: the first output
    angles: tuple[float, float] | None = None  # theta [rad]; from > to goes over position 0
    positions: tuple[str, str] | None = None  # labels of positions


@record
class Load:
    """A technological force or moment on a link."""

    name: str
    link: int
    kind: Literal["force", "moment"]
    law: Law
    point: complex = 0j  # of a force, in the link's axes [m]
    direction: complex = 1 + 0j  # sense of a positive force, unit
    follows: int = FRAME  # the link whose axes the direction is given in; it turns with it
    window: Window | None = None  # None: always
    factor: float = 1.0
    role: Role = "resistance"  # what the user takes it for; the work tells
    against: int = FRAME  # the link that takes the opposite load, on the same line
    repeats: int = 1  # turns of the crank after which its window comes back

    @property
    def turns(self) -> int:
        """Turns of the crank after which the load repeats: those of its law and of its window."""
        return math.lcm(self.law.turns, self.repeats)


@record
class Spring:
    """A spring with a damper between two links: along the line of two points, or about a pin."""

    name: str
    kind: Literal["linear", "torsion"]
    links: tuple[int, int]
    points: tuple[complex, complex] = (0j, 0j)  # linear: the ends, in the axes of each link [m]
    stiffness: float = 0.0  # [N/m or N*m/rad]
    free: float = 0.0  # free length [m], or angle of the second link less that of the first [rad]
    damping: float = 0.0  # [N*s/m or N*m*s/rad]


@record
class Pair:
    """Friction and size of a kinematic pair."""

    joint: str
    friction: float = 0.0  # coefficient f [-]
    radius: float = 0.0  # of the pin [m], revolute
    length: float | None = None  # of the slider along the guide [m], prismatic; None: no edge reactions


@record
class Coupling:
    """How the drive acts on the input link: a moment through a coupling, or a force along a prismatic guide."""


@record
class GearDrive:
    """A gear on the crank: the mesh force acts along the line of action at the pitch point."""

    radius: float = quantity("r_w_gear[m]", "operating pitch radius of the gear on the crank")
    mesh_angle: float = quantity("alpha_w_gear[rad]", "operating pressure angle of its mesh")
    pinion: float  # direction from the crank's pivot to the centre of the pinion [rad], fixed axes
    internal: bool = False  # the gear on the crank has internal teeth
    open: str = quantity("gear_of", "open pair whose radius and angle these are; empty: as given", default="")

    @property
    def teeth(self) -> str:
        """The teeth of the open pair, ``18/60`` of ``open pair 18/60``."""
        return self.open.rpartition(" ")[2]


@record
class Loading:
    """Everything that acts on a linkage."""

    bodies: tuple[Body, ...] = ()
    gravity: complex = 0j  # [m/s^2]
    loads: tuple[Load, ...] = ()
    springs: tuple[Spring, ...] = ()
    pairs: tuple[Pair, ...] = ()
    drive: Coupling | GearDrive = Coupling()
    # anything else is a mistake made on purpose
    friction_sense: Literal["against", "along"] = "against"  # of the relative motion, in which friction acts
    inertia: Literal["counted", "left out"] = "counted"  # loads of inertia, in the reactions

    @property
    def heavy(self) -> tuple[Body, ...]:
        """The bodies that resist acceleration."""
        return tuple(body for body in self.bodies if body.mass > 0 or body.inertia > 0)

    @property
    def rubs(self) -> bool:
        """Whether any pair has friction."""
        return any(pair.friction > 0 for pair in self.pairs)
