"""The records that the reduction stage leaves, apart from the code that makes them."""

from __future__ import annotations

from typing import Literal

from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.loading import Role
from tmmcalc.linkage.results import Extreme, Grade
from tmmcalc.machine.cycle import Cycle


@record
class Contribution:
    """One cause of reduced moment: a load, the weights, a spring, a damper, friction, a moment that balances the rest.

    ``work`` over the cycle at the mean speed; ``simpson`` the same by Simpson's rule over the positions (3.38), None
    where they are not equal steps of even number.
    """

    name: str
    kind: Literal["load", "weight", "spring", "damper", "friction", "balance"]
    role: Role | None  # what the spec takes a load for
    order: int  # of the speed that it is multiplied by
    work: float = quantity("work_{cause}[J]", "work of {cause} over the cycle")
    error: float  # estimated, of the work [J]
    simpson: float | None = quantity(
        "work_Simpson_{cause}[J]", "work of {cause} by Simpson's rule over the positions", source="(3.38)"
    )
    least: Extreme  # reduced moment [N*m] and theta [rad]
    largest: Extreme


@record
class Rods:
    """How connecting rods count, which links are such, and the inertia (n,) with them the other way."""

    how: Literal["exact", "lumped"]
    links: tuple[int, ...]
    other: Real | None


@record
class ReductionDigit:
    """What a unit in the last place of the metric and of the input coordinate does to a reduction, at most [-].

    Relative to what the errors are told against; 1 where no digit is left.
    """

    inertia: float = quantity("inertia", "relative change of the reduced inertia by the last digit of the metric")
    slope: float = quantity("slope", "relative change of its derivative by the last digit of the metric")
    moment: float = quantity("moment", "relative change of the reduced moments by the last digit of the metric")
    work: float = quantity("work", "relative change of the works by the last digit of the metric")


@record
class ReductionError:
    """Relative errors of a reduction, its data taken as exact.

    Moments are told against the largest of all causes, or a small part of what cancels in them; the slope
    against the largest sum of what the links add to it without their signs; works against the largest work of the
    magnitude of a moment.
    """

    inertia: float  # of J at the positions
    slope: float  # of dJ
    moment: float  # of all moments
    functions: float  # of all these over the cycle, in the mean
    between: float  # of all these between the positions at the worst place, and so of their extremes
    work: float  # of all works over the cycle
    last_digit: ReductionDigit | None = quantity(  # None: no more than rounding
        "last_digit", "what a unit in the last place of the metric changes", default=None
    )


@record
class Reduction:
    """Result of the reduction stage over n positions and S contributions.

    Reduced moments are algebraic, power over input speed: of a positive speed a resisting one is negative (3.34). For a
    driven slider they are forces [N], the inertia is a mass [kg].
    """

    labels: tuple[str, ...]  # (n,)
    phi: Real  # (n,) input coordinate counted from position 0 [rad or m]
    turns: bool
    whole: bool  # the motion repeats: one cycle of a crank
    speed: float  # [rad/s] or [m/s]
    contributions: tuple[Contribution, ...]  # (S,)
    moment: Real  # (S, n) [N*m]
    total: Real  # (n,) their sum [N*m]
    inertia: Real  # (n,) reduced inertia of the links [kg*m^2]
    slope: Real  # (n,) its derivative against the input coordinate [kg*m^2/rad]
    parts: Real  # (S, K, N) moments on the panels of ``cycle``, a positive one drives [N*m]
    cycle: Cycle
    idle: Cycle | None  # the same without technological loads; None if there are none
    inertia_range: tuple[Extreme, Extreme]  # least and largest reduced inertia
    rods: Literal["exact", "lumped"] = quantity(
        "rods", "how the connecting rods count: as they are, or as masses in their pins"
    )
    rod_links: tuple[int, ...]  # the links that are such rods
    other: Real | None  # (n,) inertia with the rods the other way [kg*m^2]; None without a rod
    error: ReductionError
    grades: tuple[Grade, ...]
    counters: dict[str, int]
