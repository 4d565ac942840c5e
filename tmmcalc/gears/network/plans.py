"""Plan of velocities and plan of speeds of a train, with their scale factors.

*Velocities*: on the line of centres every member has a straight line through the ends of the velocities of its points,

    v(x) = v_axis + omega (x - x_axis)          tan theta = omega mu_l/mu_v

and the lines of two wheels in mesh meet at the end of the velocity of their pitch point. *Speeds*: rays from a pole at
the distance h from a line, parallel to those lines, cut off lengths there that are speeds to the scale

    mu_omega = mu_v/(mu_l h)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import atan, hypot, pi

from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.network.model import FRAME, Network
from tmmcalc.gears.network.places import Places, places
from tmmcalc.gears.network.speeds import Motion
from tmmcalc.gears.network.willis import Wheels, wheel_names
from tmmcalc.report.drawing.scales import standard_scale

LENGTH, VELOCITY = 150.0, 60.0  # [mm] room of the line of centres, and of the largest velocity
Raw = tuple[str, str, tuple[str, ...], tuple[float, float] | None, complex, complex]  # name, kind ... place, velocity
POLE = 40.0  # [mm] h, of the pole from the line of speeds


@record
class PlanPoint:
    """A point of the plan of velocities."""

    name: str = quantity("point", "O and its members for an axis, P and its wheels for a pitch point")
    kind: str = quantity("kind", "axis or pitch point")
    members: tuple[str, ...] = quantity("members", "the members that have it in common")
    x: float = quantity("x[m]", "place along the line of centres, from the first axis")
    y: float = quantity("y[m]", "place beside it; of a bevel planet the radius of its pitch point")
    velocity: float = quantity("v[m/s]", "velocity across the line of centres")
    along: float = quantity("v_along[m/s]", "velocity along it: 0 but for planets that stand beside it")
    radii: tuple[float, float] | None = quantity("r_w[m]", "of a pitch point the operating radii of both wheels")
    drawn_x: float = quantity("x_drawn[m]", "x to the scale of the plan")
    drawn_velocity: float = quantity("v_drawn[m]", "v to the scale of the plan")


@record
class PlanLine:
    """A member: its line in the plan of velocities and its ray in that of speeds."""

    member: str = quantity("member", "name of the member")
    x: float = quantity("x_axis[m]", "place of its axis along the line of centres")
    y: float = quantity("y_axis[m]", "place of its axis beside the line of centres")
    axis_velocity: float = quantity("v_axis[m/s]", "velocity of its axis across the line of centres")
    speed: float = quantity("omega[rad/s]", "speed of {member}; of a bevel planet on its own axis against its carrier")
    slope: float = quantity("theta[rad]", "angle of its line and of its ray from the line of no motion")
    ray: float = quantity("omega_drawn[m]", "length that its ray cuts off in the plan of speeds")
    centre_x: float | None = quantity("x_centre[m]", "its point at rest, along the line of centres")  # None: no turn
    centre_y: float | None = quantity("y_centre[m]", "its point at rest, beside the line of centres")

    @property
    def name(self) -> str:
        """The member, by which the line is known among those of a plan."""
        return self.member

    @derived("n[rpm]", "speed of {member} in turns a minute")
    def turns(self) -> float:
        """The speed in turns a minute."""
        return self.speed / (pi / 30)


@record
class Plans:
    """Both plans of a train."""

    length_scale: float = quantity("mu_l[m/mm]", "scale factor of lengths")
    velocity_scale: float = quantity("mu_v[(m/s)/mm]", "scale factor of velocities")
    speed_scale: float = quantity("mu_omega[(rad/s)/mm]", "scale factor of speeds")
    pole: float = quantity("h_pole[m]", "distance of the pole from the line of speeds", symbol="h")
    assumed: float | None = quantity(  # None: the modules are known
        "m_assumed[m]", "module that is taken for want of a known one; velocities are in proportion to it"
    )
    points: tuple[PlanPoint, ...]
    lines: tuple[PlanLine, ...]


def plans(
    network: Network,
    motion: Motion,
    *,
    distances: Sequence[float] | None = None,
    coaxial: Sequence[tuple[str, str]] = (),
    wheels: Wheels | None = None,
    assumed: float | None = 1e-3,
) -> Plans:
    """The plans of a train in motion, by the centre ``distances`` [m] of its meshes.

    ``assumed`` is the module [m] that distances are of where it is not known, those of all meshes if none are given.

    >>> from tmmcalc.gears.network.builder import network_of
    >>> from tmmcalc.gears.network.speeds import solve_speeds
    >>> train = network_of("AIbar", (18, 48, 114))
    >>> found = plans(train.network, solve_speeds(train.network, {"1": 22.0, "3": 0.0}))
    >>> [(each.name, round(each.velocity, 6)) for each in found.points if each.kind == "pitch point"]
    [('P_1-2', 0.198), ('P_2-3', 0.0)]
    """
    at = places(network, distances, coaxial, assumed or 1e-3)
    omega = {FRAME: 0.0, **dict(zip(network.members, motion.speeds.tolist(), strict=True))}
    moving = _Moving(network, at, omega)
    named = wheel_names(network) if wheels is None else wheels
    reach = max((abs(point.place) for point in at.pitch), default=0.0)
    reach = max([reach, *(abs(place) for place in at.axes.values())])
    raw = [*_axes(moving), *_pitch_points(moving, named)]
    fastest = max((hypot(v.real, v.imag) for *_, v in raw), default=0.0)
    mu_l, mu_v = standard_scale(reach / LENGTH), standard_scale(fastest / VELOCITY)
    mu_omega = mu_v / (mu_l * POLE)
    points = tuple(
        PlanPoint(
            name,
            kind,
            members,
            place.real,
            place.imag,
            v.imag,
            v.real,
            radii,
            1e-3 * place.real / mu_l,
            1e-3 * v.imag / mu_v,
        )
        for name, kind, members, radii, place, v in raw
    )
    lines = tuple(_line(moving, name, mu_l / mu_v, mu_omega) for name in network.members)
    return Plans(mu_l, mu_v, mu_omega, 1e-3 * POLE, assumed, points, lines)


class _Moving:
    """A train in its plane: places x + iy, velocities of turning about the normal."""

    def __init__(self, network: Network, at: Places, omega: dict[str, float]) -> None:
        self.network, self.at, self.omega = network, at, omega

    def of_axis(self, name: str) -> complex:
        """Velocity of the axis of a member: that of its place on the members that bear it."""
        bearer = self.network.bearer(name)
        return 0j if bearer == FRAME else self.of_point(bearer, self.at.axes[name])

    def bearer_of_axis(self, name: str) -> str:
        """The member, or the frame, that moves the axis of a member: one about that very axis does not."""
        bearer = self.network.bearer(name)
        while bearer != FRAME and self.at.axes[bearer] == self.at.axes[name]:
            bearer = self.network.bearer(bearer)
        return bearer

    def of_point(self, name: str, place: complex) -> complex:
        """Velocity of a point of a member that is not tilted."""
        return 0j if name == FRAME else self.of_axis(name) + 1j * self.omega[name] * (place - self.at.axes[name])


def _axes(moving: _Moving) -> Iterator[Raw]:
    """The axes with the members that turn about each; two that only meet in the plan move apart."""
    shared: dict[tuple[complex, str, str], list[str]] = {}
    for name, place in moving.at.axes.items():
        tilted = name if moving.network.tilted(name) else ""
        shared.setdefault((place, moving.bearer_of_axis(name), tilted), []).append(name)
    for names in shared.values():
        place = moving.at.axes[names[0]]
        yield f"O_{names[0]}", "axis", tuple(names), None, place, moving.of_axis(names[0])


def _pitch_points(moving: _Moving, wheels: Wheels) -> Iterator[Raw]:
    """The pitch points with the velocity that both wheels give them."""
    for point in moving.at.pitch:
        mesh, names = moving.network.meshes[point.mesh], wheels[point.mesh]
        upright = mesh.second if moving.network.tilted(mesh.first) else mesh.first
        around = point.place.real if upright != mesh.first or moving.network.tilted(mesh.second) else point.place
        yield (
            f"P_{names[0]}-{names[1]}",
            "pitch point",
            (mesh.first, mesh.second),
            point.radii,
            point.place,
            moving.of_point(upright, complex(around)),
        )


def _line(moving: _Moving, name: str, ratio: float, mu_omega: float) -> PlanLine:
    """The line of a member; ``ratio`` is mu_l/mu_v."""
    place, own, omega = moving.at.axes[name], moving.of_axis(name), moving.omega[name]
    centre = None
    if moving.network.tilted(name):
        centre = complex(place.real, -own.imag / omega) if omega else None
    elif omega:
        centre = place + 1j * own / omega
    return PlanLine(
        name,
        place.real,
        place.imag,
        own.imag,
        omega,
        atan(omega * ratio),
        1e-3 * omega / mu_omega,
        None if centre is None else centre.real,
        None if centre is None else centre.imag,
    )
