"""What is asked of a pendulum-rotor.

The rod hangs from a spherical joint at its upper end, a runs down along it from 0 to l, v and w are its displacements
along the horizontal axes x and y. A disc sits on the lower end. Every quantity of bending stands twice, for v and w; an
axisymmetric rotor has the same in both and may spin.
"""

from __future__ import annotations

from tmmcalc.core.records import record

Pair = tuple[float, float]


@record
class Rod:
    """The elastic rod."""

    length: float  # l [m]
    density: float  # rho: mass of a metre [kg/m]
    bending: Pair  # E I_z for v, E I_y for w [N*m^2]
    radius: Pair  # radii of gyration of the section: i_z for v, i_y for w [m]
    torsion: float | None = None  # G I_p [N*m^2]; None: not known


@record
class Disc:
    """The disc on the lower end; a thin one has polar inertia 2 m r^2 and m r^2 about a diameter."""

    mass: float = 0.0  # m [kg]
    diametral: Pair = (0.0, 0.0)  # that resists the slope of v, of w [kg*m^2]
    polar: float = 0.0  # [kg*m^2]
    eccentricity: float = 0.0  # of its centre of mass [m]


@record
class Speeds:
    """Speeds of spin of the Campbell diagram."""

    low: float  # [rad/s]
    high: float
    points: int = 121


@record
class Swing:
    """Motion in time from a deflection, or of a carrier that moves."""

    duration: float  # [s]
    rows: int = 1000
    tilt: float = 0.0  # straight, about the joint, along x [rad]
    deflection: float = 0.0  # of the lower end, pulled along x by a force there [m]
    push: float = 0.0  # speed of the lower end along y, in the same shape [m/s]
    times: tuple[float, ...] = ()  # of the carrier's speeds, ascending [s]
    x: tuple[float, ...] = ()  # speeds of the carrier along x at these times, straight lines between [m/s]
    y: tuple[float, ...] = ()
    up: tuple[float, ...] = ()


@record
class Mesh:
    """Elements and the degree of the polynomials in each; None: as fine as the accuracy asks."""

    elements: int | None = None
    degree: int = 3  # 3: Hermite cubics


@record
class PendulumTask:
    """A pendulum-rotor, and what is to be found of it."""

    rod: Rod
    disc: Disc = Disc()
    pivot: float | None = 0.0  # k [N*m/rad]; None: clamped
    gravity: float = 9.81
    spin: float = 0.0  # Omega [rad/s]
    modes: int = 4
    speeds: Speeds | None = None
    swing: Swing | None = None
    mesh: Mesh = Mesh()

    @property
    def axisymmetric(self) -> bool:
        """Whether both planes of bending are the same."""
        pairs = (self.rod.bending, self.rod.radius, self.disc.diametral)
        return all(first == second for first, second in pairs)
