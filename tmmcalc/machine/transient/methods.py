"""The methods of integration, their default tolerances, and how much of it their steps leave behind."""

from __future__ import annotations

from typing import Literal, NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

MethodName = Literal["auto", "merson", "rk4", "collocation", "RK45", "DOP853", "LSODA", "Radau", "BDF"]


class Habit(NamedTuple):
    """How a method with step control uses its tolerance; measured on closed solutions."""

    tolerance: float  # of one step that leaves some 1e-9 of the speeds: the default
    left: float  # error of the speeds after s steps, over the tolerance times the root of s
    implicit: bool = False  # takes the Jacobian
    multistep: bool = False  # begins with short steps, interpolates as well as it integrates


HABITS = {
    "merson": Habit(1e-10, 1.0),
    "collocation": Habit(1e-8, 1e-3, implicit=True),  # its estimate is of order 7, its error of order 13
    "RK45": Habit(1e-10, 1.0),
    "DOP853": Habit(1e-10, 1.0),
    "LSODA": Habit(1e-9, 3.0, implicit=True, multistep=True),
    "Radau": Habit(1e-8, 0.1, implicit=True),  # its estimate is of third order, its error of fifth
    "BDF": Habit(1e-9, 10.0, implicit=True, multistep=True),
}
SWINGING = Habit(1e-11, 10.0)  # Kutta-Merson with more unknowns than one mass has: its errors add up
FIXED = ("merson", "rk4")
METHODS = ("auto", "rk4", *HABITS)


def habit(name: str, unknowns: int) -> Habit:
    """The habit of a method with step control for a drive of so many unknowns."""
    return SWINGING if name == "merson" and unknowns > 2 else HABITS[name]


@record
class Method:
    """How the motion is integrated.

    ``auto`` picks by stiffness. ``merson`` takes fixed steps if a ``step`` [s] is given, and controls them otherwise;
    ``rk4`` needs a step; ``collocation`` and the methods of scipy control theirs. The ``tolerance`` of one step is
    relative to the largest speed, moment and energy of the drive, and to one radian.
    """

    name: MethodName = "auto"
    step: float | None = None
    tolerance: float | None = None  # None: that of the method
    budget: int = 500_000  # evaluations of the equations after which the run is given up
    error: float = 0.0  # relative error of the speeds that is asked for in place of a tolerance; 0: none
    compared: bool = True  # find the error by a second run; False: guess it

    def __post_init__(self) -> None:
        """Refuse what is not a method."""
        if self.name not in METHODS:
            raise UsageError(
                f"there is no method {self.name!r}", where="transient motion", remedy="methods: " + ", ".join(METHODS)
            )
        if self.step is not None and self.name not in FIXED:
            raise UsageError(
                f"{self.name} controls its steps itself, it takes no step of {self.step:g} s",
                where="transient motion",
                value=self.step,
                remedy="leave the step out, or take merson or rk4",
            )
        if (self.name == "rk4" and self.step is None) or (self.step is not None and not 0 < self.step < float("inf")):
            raise UsageError(
                f"{self.name} with the step {self.step}",
                where="transient motion",
                value=self.step,
                remedy="give a positive step [s]; the textbook takes 0.01 to 0.04 s",
            )
        if self.tolerance is not None and not 1e-13 <= self.tolerance <= 1e-2:
            raise UsageError(
                f"the tolerance is {self.tolerance:g}",
                where="transient motion",
                value=self.tolerance,
                remedy="between 1e-13 and 1e-2, or none for that of the method",
            )
