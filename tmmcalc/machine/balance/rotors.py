"""Balancing of rigid rotors: static in one plane, dynamic in two, the bearing loads left and the verdict.

Unbalances are complex static moments U = m r exp(i angle) [kg*m] in axes that turn with the rotor, each in its plane z.
At the speed omega they load the bearings with forces U omega^2 that turn with the rotor, so that the
largest and the root mean square of a load are its modulus. One plane takes the resultant sum U away, two planes
the couple sum z U as well.
"""

from __future__ import annotations

import cmath
import sys
from collections.abc import Sequence

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.machine.balance.grades import grade_reached, permissible_unbalance, shared
from tmmcalc.machine.balance.weights import in_planes

WHERE = "rotor"
ROUNDING = 2 * sys.float_info.epsilon  # of every moment of an unbalance in a sum


@record
class Unbalance:
    """A mass off the axis, in axes of the rotor; a drilled hole is a negative mass."""

    mass: float  # [kg]
    radius: float  # [m]
    angle: float  # [rad]
    position: float  # of its plane, z [m]

    @property
    def moment(self) -> complex:
        """Static moment U [kg*m]."""
        return self.mass * cmath.rect(self.radius, self.angle)


@record
class Rotor:
    """A rigid rotor on two bearings. Raises `UsageError` without mass, or for bearings in one plane."""

    mass: float  # [kg]
    center: float  # plane of the centre of mass, z [m]
    bearings: tuple[float, float]  # planes of the bearings A and B, z [m]
    speed: float  # highest service speed [rad/s]
    unbalances: tuple[Unbalance, ...] = ()

    def __post_init__(self) -> None:
        """Refuse what cannot be balanced."""
        if not self.mass > 0 or self.bearings[0] == self.bearings[1]:
            text = f"mass {self.mass:g} kg, bearings at {self.bearings[0]:g} and {self.bearings[1]:g} m"
            raise UsageError(text, where=WHERE, value=self.mass, remedy="give a positive mass and two bearing planes")


@record
class RotorState:
    """Unbalance of a rotor, with or without corrections, and what the bearings feel."""

    resultant: complex  # sum of U [kg*m]
    couple: complex  # sum of (z - center) U [kg*m^2]
    eccentricity: float = quantity("eccentricity[m]", "shift of the centre of mass", symbol="e", header="e[m]")
    equivalent: tuple[complex, complex]  # U in the bearing planes [kg*m]
    loads: tuple[complex, complex]  # forces of the rotor on bearings A and B, in axes of the rotor [N]

    @derived("A[N]", "load of bearing A, which turns with the rotor")
    def load_a(self) -> float:
        """Its size."""
        return abs(self.loads[0])

    @derived("B[N]", "load of bearing B, which turns with the rotor")
    def load_b(self) -> float:
        """Its size."""
        return abs(self.loads[1])


@record
class RotorVerdict:
    """Whether the residual unbalance of both bearing planes keeps a grade."""

    grade: float = quantity("grade[mm/s]", "balance quality grade that is asked for", symbol="G")
    permissible: float = quantity("U_per[kg*m]", "permissible residual unbalance")
    allowed: tuple[float, float]  # for the planes of bearings A and B [kg*m]
    residual: tuple[float, float]  # |U| there [kg*m]
    passed: bool
    value: float = quantity("e omega[mm/s]", "speed of the centre of mass about the axis")
    reached: float | None  # best standard grade of the resultant; None: worse than all
    message: str

    @derived("U_per_A[kg*m]", "permissible residual unbalance in the plane of bearing A")
    def allowed_a(self) -> float:
        """Its part of U_per."""
        return self.allowed[0]

    @derived("U_per_B[kg*m]", "permissible residual unbalance in the plane of bearing B")
    def allowed_b(self) -> float:
        """Its part of U_per."""
        return self.allowed[1]

    @derived("A_part[%]", "unbalance in the plane of bearing A over the permissible one")
    def part_a(self) -> float:
        """In per cent."""
        return 100 * self.residual[0] / self.allowed[0]

    @derived("B_part[%]", "unbalance in the plane of bearing B over the permissible one")
    def part_b(self) -> float:
        """In per cent."""
        return 100 * self.residual[1] / self.allowed[1]


@record
class RotorBalance:
    """A rotor before balancing, after static balancing and after balancing in two planes."""

    before: RotorState
    static: RotorState
    dynamic: RotorState
    static_moment: complex  # correction in one plane [kg*m]
    static_plane: float  # z [m]
    moments: tuple[complex, complex]  # corrections in two planes [kg*m]
    planes: tuple[float, float]  # z [m]
    error: float = 0.0  # estimated, of loads and corrections, relative to the largest or to that of one unbalance


def resultant(unbalances: Sequence[Unbalance]) -> complex:
    """Sum of U [kg*m]; zero where the rotor is statically balanced."""
    return sum((u.moment for u in unbalances), 0j)


def couple(unbalances: Sequence[Unbalance], about: float = 0.0) -> complex:
    """Sum of (z - about) U [kg*m^2]."""
    return sum(((u.position - about) * u.moment for u in unbalances), 0j)


def equivalent(unbalances: Sequence[Unbalance], planes: tuple[float, float]) -> tuple[complex, complex]:
    """The two unbalances in ``planes`` [m] that act as all of them together [kg*m]."""
    return in_planes(resultant(unbalances), couple(unbalances), planes)


def static_correction(unbalances: Sequence[Unbalance]) -> complex:
    """Static moment [kg*m] that brings the centre of mass onto the axis, in any one plane."""
    return -resultant(unbalances)


def two_plane_correction(unbalances: Sequence[Unbalance], planes: tuple[float, float]) -> tuple[complex, complex]:
    """Static moments [kg*m] in two planes that take resultant and couple away.

    Raises `UsageError` if the planes coincide.
    """
    first, second = equivalent(unbalances, planes)
    return -first, -second


def correction(moment: complex, position: float, radius: float) -> Unbalance:
    """The correction as a mass at the radius [m]; raises `UsageError` unless the radius is positive."""
    if not radius > 0:
        text = f"correction radius {radius:g} m"
        raise UsageError(text, where=WHERE, value=radius, limit=0.0, remedy="radii are positive")
    return Unbalance(abs(moment) / radius, radius, cmath.phase(moment), position)


def state(rotor: Rotor, corrections: Sequence[Unbalance] = ()) -> RotorState:
    """Unbalance and bearing loads of the rotor with these corrections, as designed or as made."""
    every = (*rotor.unbalances, *corrections)
    total = resultant(every)
    planes = equivalent(every, rotor.bearings)
    w2 = rotor.speed * rotor.speed
    return RotorState(
        resultant=total,
        couple=couple(every, rotor.center),
        eccentricity=abs(total) / rotor.mass,
        equivalent=planes,
        loads=(planes[0] * w2, planes[1] * w2),
    )


def rotor_balance(rotor: Rotor, planes: tuple[float, float], static_plane: float | None = None) -> RotorBalance:
    """Corrections in one plane (by default that of the centre of mass) and in two, and what either leaves."""
    plane = rotor.center if static_plane is None else static_plane
    one = static_correction(rotor.unbalances)
    two = two_plane_correction(rotor.unbalances, planes)
    unit = [correction(moment, z, 1.0) for moment, z in zip(two, planes, strict=True)]
    return RotorBalance(
        before=state(rotor),
        static=state(rotor, [correction(one, plane, 1.0)]),
        dynamic=state(rotor, unit),
        static_moment=one,
        static_plane=plane,
        moments=two,
        planes=planes,
        error=max(_rounding(rotor.unbalances, at) for at in (planes, rotor.bearings)),
    )


def _rounding(unbalances: Sequence[Unbalance], planes: tuple[float, float]) -> float:
    """What rounding leaves of the equivalents in two planes, relative to the larger one or that of one unbalance.

    Moments about z = 0 are large where the planes are far from it, and where they are near one another.
    """
    low, span = planes[0], abs(planes[1] - planes[0])
    summed = sum(abs(u.moment) * (1 + (abs(u.position) + abs(low)) / span) for u in unbalances)
    alone = [max(map(abs, equivalent([u], planes))) for u in unbalances]
    largest = max([*map(abs, equivalent(unbalances, planes)), *alone], default=0.0)
    return ROUNDING * summed / largest if largest else 0.0


def verdict(rotor: Rotor, now: RotorState, grade: float) -> RotorVerdict:
    """Whether the rotor keeps balance quality grade ``grade`` [mm/s] in the planes of both bearings.

    Raises `UsageError` for a grade that is not positive or a rotor that stands still.
    """
    permissible = permissible_unbalance(grade, rotor.mass, rotor.speed)
    allowed = shared(permissible, rotor.center, rotor.bearings)
    residual = (abs(now.equivalent[0]), abs(now.equivalent[1]))
    worst = max((r / a, name) for r, a, name in zip(residual, allowed, "AB", strict=True))
    passed = worst[0] <= 1.0
    value, reached = grade_reached(now.eccentricity, rotor.speed)
    message = (
        f"G {grade:g}: the residual unbalance of bearing plane {worst[1]} is {worst[0]:.3g} of the permissible one, "
        f"which it {'keeps' if passed else 'exceeds'}"
    )
    return RotorVerdict(grade, permissible, allowed, residual, passed, value, reached, message)
