"""What is asked of a manipulator: the arm, the gripper's path or the joints' motion, limits and obstacles.

Points have two coordinates [m] for an arm in its vertical plane (x, y upwards), three for one with a turning base
(x, y, z upwards).
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

ArmKind = Literal["spherical", "cylindrical", "angular"]
Place = tuple[float, ...]  # 2 or 3 coordinates [m]


class Joint(NamedTuple):
    """A joint coordinate: its name, those of its derivatives by the time, and whether it is an angle."""

    name: str
    rate: str
    acceleration: str
    turns: bool


BASE = Joint("psi", "omega_1", "eps_1", True)
_ELEVATION = Joint("phi_2", "omega_2", "eps_2", True)
JOINTS: dict[str, tuple[Joint, ...]] = {
    "spherical": (_ELEVATION, Joint("l_3", "v_3", "a_3", False)),
    "cylindrical": (Joint("h", "v_h", "a_h", False), Joint("r", "v_r", "a_r", False)),
    "angular": (_ELEVATION, Joint("phi_3", "omega_3", "eps_3", True)),
}
ELBOW = Joint("elbow", "omega_elbow", "eps_elbow", True)


@record
class Arm:
    """The arm and where its shoulder is.

    ``spherical``: elevation phi_2 and extension l_3. ``cylindrical``: height h and reach r. ``angular``: directions
    phi_2 of the upper arm and phi_3 of the forearm, from the elbow to the gripper. ``elbow`` is +1 with the elbow to
    the left of the line from the shoulder to the gripper (up, where the gripper is in front of it), -1 to the right.
    """

    kind: ArmKind = quantity("arm", "kind of the arm")
    spatial: bool = False  # with the base rotation psi
    upper: float = quantity("upper_arm[m]", "length of the upper arm", default=0.0)
    forearm: float = quantity("forearm[m]", "length of the forearm", default=0.0)
    elbow: int = 1
    height: float = quantity("height[m]", "height of the shoulder above the origin", default=0.0)

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joint coordinates."""
        return (*((BASE,) if self.spatial else ()), *JOINTS[self.kind])

    @property
    def ranged(self) -> tuple[Joint, ...]:
        """What has a range: the joints, and between two links the angle of the elbow, which is no coordinate."""
        return (*self.joints, *((ELBOW,) if self.kind == "angular" else ()))

    @property
    def dimensions(self) -> int:
        """Coordinates of a point."""
        return 3 if self.spatial else 2


@record
class ArcRoute:
    """A circular arc past a zone: by radius and side K, +1 with the centre to the left of the line start to end.

    In space "left" is n x d with the normal n and the direction d of the line.
    """

    start: Place
    end: Place
    radius: float  # [m]
    side: int
    normal: Place = (0.0, 0.0, 1.0)


@record
class ArcThrough:
    """A circular arc from start to end through a point between them."""

    start: Place
    via: Place
    end: Place


@record
class PolyRoute:
    """Straight lines through points; corners are stops, or rounded by arcs of ``corner`` [m]."""

    points: tuple[Place, ...]
    corner: float = 0.0


Route = ArcRoute | ArcThrough | PolyRoute


@record
class Drive:
    """Limits of the gripper's motion along its path."""

    acceleration: float  # a_m: of the tangential acceleration [m/s^2]
    speed: float | None = None  # v_m [m/s]; None: the duration settles it
    normal: float | None = None  # of the normal acceleration [m/s^2]
    total: float | None = None  # of both together [m/s^2]
    duration: float | None = None  # T [s]


@record
class PathTask:
    """The inverse problem: the gripper follows a route."""

    route: Route
    drive: Drive


@record
class JointMove:
    """A joint that goes from rest to rest by the time-optimal law, or stays where it is."""

    name: str
    start: float  # [rad or m]
    end: float
    speed: float | None = None  # [rad/s or m/s]
    acceleration: float | None = None


@record
class LawTask:
    """The direct problem with a law for each joint; together: the quicker ones take the time of the slowest."""

    moves: tuple[JointMove, ...]
    together: bool = True


@record
class TableTask:
    """The direct problem with a table: joint coordinates (J, m) at times (m,), smooth between, at rest at both ends."""

    t: Values
    q: Values


@record
class Obstacle:
    """A polygon [m], counter-clockwise or not; in space a prism over it between two heights."""

    name: str
    corners: tuple[complex, ...]
    low: float = 0.0
    high: float = 0.0


@record
class JointLimit:
    """The range of a joint coordinate [rad or m]; None: open."""

    name: str
    low: float | None
    high: float | None


@record
class ManipulatorTask:
    """Everything that is asked."""

    arm: Arm
    motion: PathTask | LawTask | TableTask
    limits: tuple[JointLimit, ...] = ()
    obstacles: tuple[Obstacle, ...] = ()
    check_arm: bool = True  # whether the arm itself keeps clear of the obstacles
    steps: int = 24
