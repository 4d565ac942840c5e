"""What is asked of a contour, and the names of its lines."""

from __future__ import annotations

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.wheel import Wheel

LINES: dict[str, tuple[str, str]] = {  # key -> (number in the textbook's figures, what it is)
    "undercut1": ("2", "limit of undercut of wheel 1"),
    "undercut2": ("10", "limit of undercut of wheel 2"),
    "tolerated1": ("1", "undercut of wheel 1 reaches the active flank"),
    "tolerated2": ("11", "undercut of wheel 2 reaches the active flank"),
    "interference1": ("3", "tip of wheel 2 cuts into the fillet of wheel 1"),
    "interference2": ("3", "tip of wheel 1 cuts into the fillet of wheel 2"),
    "contact_ratio": ("5", "least contact ratio"),
    "thickness1": ("9", "least tip thickness of wheel 1"),
    "thickness2": ("9'", "least tip thickness of wheel 2"),
    "tip1": ("", "tip circle of wheel 1 is its reference circle"),
    "tip2": ("", "tip circle of wheel 2 is its reference circle"),
}


@record
class Task:
    """Two wheels, whose shifts are not read, and the least values that their mesh must reach."""

    first: Wheel
    second: Wheel
    contact_ratio: float = 1.0  # eps_min, transverse
    thickness: tuple[float, float] = (0.0, 0.0)  # s_a,min of both tips in the normal section, in normal modules
    fillet: Shape = "ellipse"  # section of the tip rounding across helical teeth, on which undercut depends

    def __post_init__(self) -> None:
        """Refuse wheels that cannot mesh and limits without sense."""
        one, two = self.first, self.second
        if one.helix != two.helix or one.rack != two.rack:
            raise UsageError(
                "the wheels of a pair have one rack and helix angles of one size",
                where="blocking contour",
                remedy="give both wheels the same rack and the same helix angle",
            )
        if self.contact_ratio < 0 or min(self.thickness) < 0:
            raise UsageError(
                "the least contact ratio and tip thickness are not negative",
                where="blocking contour",
                value=min(self.contact_ratio, *self.thickness),
                limit=0.0,
                remedy="contact ratio 1.0 to 1.2, tip thickness 0 to 0.4 of the module",
            )

    def wheels(self, x1: float, x2: float) -> tuple[Wheel, Wheel]:
        """The wheels with these shifts."""
        one, two = self.first, self.second
        return Wheel(one.teeth, x1, one.helix, one.rack), Wheel(two.teeth, x2, two.helix, two.rack)
